#include "run.hpp"

#include "claim.hpp"
#include "losses.hpp"
#include "symbols.hpp"
#include "typeset.hpp"

namespace denhartog::derivation {

using nlohmann::json;

namespace {

std::string word(Role role) {
    switch (role) {
    case Role::both: return "both";
    case Role::printed: return "printed";
    case Role::shipped: return "shipped";
    case Role::observation: return "observation";
    default: return "step";
    }
}

std::string word(Departure departure) {
    switch (departure) {
    case Departure::scan: return "scan";
    case Departure::misprint: return "misprint";
    case Departure::substance: return "substance";
    case Departure::convention: return "convention";
    default: return "none";
    }
}

json as_object(const std::vector<std::pair<std::string, std::string>>& values) {
    json object = json::object();
    for (const auto& [name, value] : values) object[name] = value;
    return object;
}

/// The verdict in a word. What the text has observed and a search has not refuted is `measured`; its witness has the worst case.
std::string verdict_of(const Claim& claim, const Result& result) {
    if (result.verdict == Verdict::proved && claim.approximation) return "approximation";
    const bool searched = claim.role == Role::observation && result.verdict == Verdict::unknown && !result.witness.empty();
    return searched ? "measured" : to_string(result.verdict);
}

/// A claim that the ledger sees: where it speaks of several refuted equations, each has a loss of its own.
std::vector<ClaimResult> results_of(const Claim& claim, const Result& result) {
    ClaimResult entry;
    entry.id = claim.id;
    entry.equations = claim.equations;
    entry.role = word(claim.role);
    entry.verdict = verdict_of(claim, result);
    entry.what = claim.title;
    entry.assumptions = claim.assumptions;
    entry.departure = word(claim.departure);
    entry.correction_latex = claim.correction;
    entry.witness = as_object(result.witness);
    if (result.verdict != Verdict::refuted || claim.role != Role::printed) return {entry};
    std::vector<ClaimResult> entries;
    for (const std::string& equation : claim.equations) {
        entry.equations = {equation};
        entry.id = claim.equations.size() == 1 ? claim.id : claim.id + "/" + equation;
        entry.loss.reset();
        entry.consequence.clear();
        if (const std::optional<Loss> loss = loss_of(equation)) {
            entry.loss = loss->on_paper;
            entry.consequence = sentence(*loss);
        }
        entries.push_back(entry);
    }
    return entries;
}

json record_of(const Claim& claim, const Result& result) {
    json steps = json::array(), witness = json::array();
    for (const Step& step : result.steps) {
        steps.push_back({{"text", plain_sentence(step.text)}, {"latex", step.latex}});
        if (step.text.find('$') != std::string::npos) steps.back()["text_latex"] = step.text;
    }
    for (const auto& [name, value] : result.witness)
        witness.push_back({{"name", name}, {"name_latex", latex_of_name(name)}, {"value", value}});
    return {{"claim", claim.id},
            {"equation", claim.equations.front()},
            {"equations", claim.equations},
            {"title", claim.title},
            {"assumptions", claim.assumptions},
            {"steps", steps},
            {"witness", witness},
            {"verdict", verdict_of(claim, result)},
            {"milliseconds", result.milliseconds}};
}

} // namespace

Run run_claims(const std::function<void(const std::string&)>& progress) {
    Run run;
    run.record = json::array();
    MutantCount all;
    long with_mutants = 0, number = 0;
    for (const Claim& claim : claims()) {
        progress(std::to_string(++number) + "/" + std::to_string(claims().size()) + " " + claim.id);
        const Result result = decide(claim);
        for (ClaimResult& entry : results_of(claim, result)) run.claims.push_back(std::move(entry));
        run.record.push_back(record_of(claim, result));
        const bool needed = claim.role != Role::printed && claim.role != Role::observation;
        if (needed && result.verdict != Verdict::proved)
            run.faults.push_back("claim " + claim.id + " is needed and " + to_string(result.verdict));
        if (claim.role == Role::observation && result.verdict == Verdict::unknown && result.witness.empty())
            run.faults.push_back("observation " + claim.id + " was neither decided nor searched");
        if (result.verdict != Verdict::proved || !claim.kernel) continue;
        const MutantCount count = mutate(claim);
        ++with_mutants;
        if (count.refuted == 0) run.faults.push_back("claim " + claim.id + " has no mutated twin that is refuted");
        all.refuted += count.refuted;
        all.without_value += count.without_value;
        all.unknown += count.unknown;
        all.proved += count.proved;
        all.holes.insert(all.holes.end(), count.holes.begin(), count.holes.end());
    }
    run.mutants = {{"claims", with_mutants},         {"refuted", all.refuted}, {"without_value", all.without_value},
                   {"unknown", all.unknown},         {"proved", all.proved},   {"holes", all.holes}};
    for (const std::string& hole : all.holes) run.faults.push_back("mutated twin not refuted: " + hole);
    return run;
}

json to_json(const std::vector<ClaimResult>& claims) {
    json list = json::array();
    for (const ClaimResult& c : claims)
        list.push_back({{"id", c.id},
                        {"equations", c.equations},
                        {"role", c.role},
                        {"verdict", c.verdict},
                        {"what", c.what},
                        {"assumptions", c.assumptions},
                        {"departure", c.departure},
                        {"correction_latex", c.correction_latex},
                        {"witness", c.witness},
                        {"loss", c.loss ? json(*c.loss) : json()},
                        {"consequence", c.consequence}});
    return list;
}

std::vector<ClaimResult> claims_from_json(const json& list) {
    std::vector<ClaimResult> claims;
    for (const json& c : list) {
        ClaimResult claim;
        claim.id = c.at("id");
        claim.equations = c.at("equations").get<std::vector<std::string>>();
        claim.role = c.at("role");
        claim.verdict = c.at("verdict");
        claim.what = c.at("what");
        claim.assumptions = c.at("assumptions").get<std::vector<std::string>>();
        claim.departure = c.at("departure");
        claim.correction_latex = c.at("correction_latex");
        claim.witness = c.at("witness");
        if (!c.at("loss").is_null()) claim.loss = c.at("loss").get<double>();
        claim.consequence = c.at("consequence");
        claims.push_back(std::move(claim));
    }
    return claims;
}

} // namespace denhartog::derivation

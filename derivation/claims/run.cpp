#include "derivation/claims/run.hpp"

#include <map>

#include "derivation/observations/losses.hpp"

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

/// A claim that the ledger sees: where it speaks of several refuted equations, each has a loss of its own.
std::vector<ClaimResult> results_of(const Claim& claim, const json& record, const std::string& same_as) {
    ClaimResult entry;
    entry.id = claim.id;
    entry.equations = claim.equations;
    entry.role = word(claim.role);
    entry.verdict = record.at("verdict");
    entry.kind = record.at("kind");
    entry.by_equation = record.at("by_equation").get<std::map<std::string, std::string>>();
    entry.refines = claim.refines;
    entry.same_as = same_as;
    entry.what = claim.title;
    entry.assumptions = claim.assumptions;
    entry.departure = word(claim.departure);
    const std::string printed = record.at("correction");
    entry.correction_latex = printed.empty() ? claim.correction : printed;
    entry.correction_by = printed.empty() ? "hand" : "run";
    entry.thresholds = thresholds_from_json(record.value("thresholds", json::array()));
    for (const json& value : record.at("witness")) entry.witness[value.at("name").get<std::string>()] = value.at("value");
    if (entry.verdict != "refuted" || claim.role != Role::printed) return {entry};
    std::vector<ClaimResult> entries;
    for (const std::string& equation : claim.equations) {
        entry.equations = {equation};
        entry.id = claim.equations.size() == 1 ? claim.id : claim.id + "/" + equation;
        entry.loss.reset();
        entry.consequence.clear();
        if (const std::optional<Loss> loss = loss_of(equation)) {
            entry.loss = loss->worst();
            entry.consequence = sentence(*loss);
        }
        entries.push_back(entry);
    }
    return entries;
}

/// The claim before it on the same form that says the same; empty where none does.
std::string first_of_its_kind(std::map<std::string, std::string>& said, const Claim& claim, const std::string& fingerprint) {
    if (fingerprint.empty()) return {};
    const auto [place, fresh] = said.try_emplace(fingerprint, claim.id);
    return fresh ? "" : place->second;
}

/// Why a claim makes the run fail, its twins aside; nothing where it does not.
std::vector<std::string> faults_of(const Claim& claim, const json& finding) {
    const std::string verdict = finding.at("record").at("verdict"), fault = finding.at("fault");
    std::vector<std::string> faults;
    if (!fault.empty()) faults.push_back("claim " + claim.id + " was not decided: " + fault);
    const bool needed = claim.role != Role::printed && claim.role != Role::observation;
    if (needed && verdict != "proved" && verdict != "approximation" && verdict != "argued")
        faults.push_back("claim " + claim.id + " is needed and " + verdict);
    if (claim.role == Role::observation && verdict == "unknown")
        faults.push_back("observation " + claim.id + " was neither decided nor searched");
    if (claim.role == Role::printed && verdict == "unknown")
        faults.push_back("claim " + claim.id + " on a printed equation was neither proved nor refuted");
    return faults;
}

} // namespace

Run run_of(const std::vector<Claim>& claims, const Findings& findings) {
    Run run;
    run.record = json::array();
    long with_mutants = 0, without = 0; // of the claims that are not refuted
    std::map<std::string, long> counts{{"refuted", 0}, {"without_value", 0}, {"idle", 0}, {"unknown", 0}, {"proved", 0}};
    json holes = json::array();
    std::map<std::string, std::string> said; // fingerprint -> the first claim with it
    for (const Claim& claim : claims) {
        const json& finding = findings.at(claim.id);
        json record = finding.at("record");
        const std::string same_as = first_of_its_kind(said, claim, finding.at("fingerprint"));
        record["same_as"] = same_as;
        for (ClaimResult& entry : results_of(claim, record, same_as)) run.claims.push_back(std::move(entry));
        run.record.push_back(std::move(record));
        for (std::string& fault : faults_of(claim, finding)) run.faults.push_back(std::move(fault));
        const json& twins = finding.at("twins");
        if (twins.is_null()) {
            if (finding.value("why_no_twin", "").empty())
                run.faults.push_back("claim " + claim.id + " is proved and has neither a mutated twin nor a reason why not");
            const std::string verdict = finding.at("record").at("verdict");
            if (claim.role != Role::observation && verdict != "refuted") ++without;
            continue;
        }
        ++with_mutants;
        for (auto& [what, count] : counts) count += twins.at(what).get<long>();
        if (twins.at("refuted") == 0) run.faults.push_back("claim " + claim.id + " has no mutated twin that is refuted");
        for (const json& hole : twins.at("holes")) holes.push_back(hole);
    }
    for (const json& hole : holes) run.faults.push_back("mutated twin not refuted: " + hole.get<std::string>());
    run.mutants = counts;
    run.mutants["claims"] = with_mutants;
    run.mutants["claims_without"] = without;
    run.mutants["holes"] = holes;
    return run;
}

json to_json(const std::vector<ClaimResult>& claims) {
    json list = json::array();
    for (const ClaimResult& c : claims)
        list.push_back({{"id", c.id},
                        {"equations", c.equations},
                        {"role", c.role},
                        {"verdict", c.verdict},
                        {"by_equation", c.by_equation},
                        {"kind", c.kind},
                        {"refines", c.refines},
                        {"same_as", c.same_as},
                        {"what", c.what},
                        {"assumptions", c.assumptions},
                        {"departure", c.departure},
                        {"correction_latex", c.correction_latex},
                        {"correction_by", c.correction_by},
                        {"witness", c.witness},
                        {"thresholds", thresholds_to_json(c.thresholds)},
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
        claim.by_equation = c.at("by_equation").get<std::map<std::string, std::string>>();
        claim.kind = c.at("kind");
        claim.refines = c.at("refines").get<std::vector<std::string>>();
        claim.same_as = c.at("same_as");
        claim.what = c.at("what");
        claim.assumptions = c.at("assumptions").get<std::vector<std::string>>();
        claim.departure = c.at("departure");
        claim.correction_latex = c.at("correction_latex");
        claim.correction_by = c.at("correction_by");
        claim.witness = c.at("witness");
        claim.thresholds = thresholds_from_json(c.at("thresholds"));
        if (!c.at("loss").is_null()) claim.loss = c.at("loss").get<double>();
        claim.consequence = c.at("consequence");
        claims.push_back(std::move(claim));
    }
    return claims;
}

} // namespace denhartog::derivation

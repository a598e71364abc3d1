#include "derivation/claims/findings.hpp"

#include <iomanip>
#include <ostream>

#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/workers.hpp"
#include "derivation/typeset/typeset.hpp"

namespace denhartog::derivation {

using nlohmann::json;

namespace {

/// The verdict in a word. What the text has observed and a search has not refuted is `measured`; its witness has the worst case.
std::string verdict_of(const Claim& claim, const Result& result) {
    if (result.verdict == Verdict::proved && result.kind == "argument") return "argued";
    if (result.verdict == Verdict::proved && claim.approximation) return "approximation";
    const bool searched = claim.role == Role::observation && result.verdict == Verdict::unknown && !result.witness.empty();
    return searched ? "measured" : to_string(result.verdict);
}

json record_of(const Claim& claim, const Result& result) {
    json steps = json::array(), witness = json::array();
    for (const Step& step : result.steps) {
        steps.push_back({{"text", plain_sentence(step.text)}, {"latex", step.latex}});
        if (step.text.find('$') != std::string::npos) steps.back()["text_latex"] = step.text;
    }
    for (const auto& [name, value] : result.witness)
        witness.push_back({{"name", name}, {"name_latex", latex_of_name(name)}, {"value", value}});
    json by_equation = json::object();
    for (const auto& [equation, verdict] : result.by_equation) by_equation[equation] = to_string(verdict);
    return {{"claim", claim.id},
            {"equation", claim.equations.front()},
            {"equations", claim.equations},
            {"title", claim.title},
            {"assumptions", claim.assumptions},
            {"steps", steps},
            {"witness", witness},
            {"verdict", verdict_of(claim, result)},
            {"kind", result.kind},
            {"by_equation", by_equation},
            {"correction", result.correction},
            {"milliseconds", result.milliseconds},
            {"thresholds", thresholds_to_json(result.thresholds)}};
}

/// Why a claim has no twin; empty where it ought to have one.
std::string why_no_twin(const Claim& claim, const Result& result) {
    if (result.verdict == Verdict::refuted) return "refuted: nothing is proved of which a twin could be proved as well";
    if (claim.role == Role::observation)
        return "an observation: decided by a search with its witness, or by claims that have twins";
    return result.why_no_twin;
}

json finding_of(const Claim& claim) {
    const Result result = decide(claim);
    json finding{{"record", record_of(claim, result)},
                 {"fingerprint", result.fingerprint},
                 {"twins", nullptr},
                 {"fault", ""},
                 {"why_no_twin", why_no_twin(claim, result)}};
    if (result.altered > 0)
        finding["twins"] = {{"refuted", result.altered}, {"without_value", 0}, {"idle", 0}, {"unknown", 0}, {"proved", 0},
                            {"holes", json::array()}};
    if (result.verdict == Verdict::proved && claim.kernel) {
        const MutantCount twins = mutate(claim);
        finding["twins"] = {{"refuted", twins.refuted}, {"without_value", twins.without_value},
                            {"idle", twins.idle},       {"unknown", twins.unknown},
                            {"proved", twins.proved},   {"holes", twins.holes}};
    }
    return finding;
}

/// One line of a claim, e.g. `proved         (A.7)   A.7/velocity, 34 mutated twins refuted`.
void tell(const Claim& claim, const json& finding, std::ostream& out) {
    out << std::left << std::setw(15) << finding.at("record").at("verdict").get<std::string>() << std::setw(12)
        << finding.at("record").at("kind").get<std::string>() << std::setw(8) << "(" + claim.equations.front() + ")" << claim.id;
    if (const json& twins = finding.at("twins"); !twins.is_null())
        out << ", " << twins.at("refuted").get<long>() << " mutated twins refuted";
    if (const std::string fault = finding.at("fault"); !fault.empty()) out << ": " << fault;
    out << std::endl;
}

} // namespace

Findings findings_of(const std::vector<Claim>& claims, Findings known, std::size_t workers, std::ostream& out) {
    std::vector<const Claim*> open;
    for (const Claim& claim : claims)
        if (!known.contains(claim.id)) open.push_back(&claim);
    const auto task = [&open](std::size_t i) { return finding_of(*open[i]).dump(); };
    in_processes(open.size(), workers, task, [&](std::size_t i, const Delivery& delivery) {
        json& finding = known[open[i]->id];
        finding = delivery.fault.empty() ? json::parse(delivery.text)
                                         : json{{"record", record_of(*open[i], {})},
                                                {"fingerprint", ""},
                                                {"twins", nullptr},
                                                {"fault", delivery.fault},
                                                {"why_no_twin", "not decided"}};
        tell(*open[i], finding, out);
    });
    return known;
}

} // namespace denhartog::derivation

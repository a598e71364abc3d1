#include "derivation/ledger/ledger_summary.hpp"

#include <map>

namespace denhartog::derivation {

using ledger::Json;

const std::vector<std::string>& verdict_words() {
    static const std::vector<std::string> words = {"not_applicable", "definition", "assumption", "proved",
                                                   "approximation",  "unknown",    "illegible",  "refuted"};
    return words;
}

const std::vector<std::string>& departure_words() {
    static const std::vector<std::string> words = {"none", "scan", "convention", "misprint", "substance"};
    return words;
}

bool aside(const ClaimResult& claim) { return claim.role == "step" || claim.role == "observation"; }

namespace {

/// Counts of the refuted observations of the text: those refuted at any threshold for a vague word, and at the one chosen.
Json refuted_observations(const std::vector<ClaimResult>& claims) {
    int whatever = 0, at_ours = 0;
    for (const ClaimResult& claim : claims)
        if (claim.id.ends_with("/text") && claim.verdict == "refuted")
            ++(refuted_whatever_the_threshold(claim.thresholds) ? whatever : at_ours);
    return {{"whatever_the_threshold", whatever}, {"at_a_threshold_of_ours", at_ours}};
}

} // namespace

Json summary_of(const Json& entries, const std::vector<ClaimResult>& claims, bool tests_ran) {
    Json summary = {{"equations", entries.size()}};
    for (const char* key : {"printed", "shipped"}) {
        summary[key] = Json::object();
        for (const std::string& verdict : verdict_words()) summary[key][verdict] = 0;
    }
    summary["departure"] = Json::object();
    for (const std::string& departure : departure_words()) summary["departure"][departure] = 0;
    for (const char* key : {"refuted", "illegible", "refuted_without_loss", "refuted_steps"}) summary[key] = Json::array();
    int with_function = 0, with_test = 0;
    for (const Json& entry : entries) {
        for (const char* key : {"printed", "shipped", "departure"}) {
            Json& count = summary[key][entry.at(key).get<std::string>()];
            count = (count.is_null() ? 0 : count.get<int>()) + 1;
        }
        for (const char* verdict : {"refuted", "illegible"})
            if (entry.at("printed") == verdict) summary[verdict].push_back(entry.at("equation"));
        if (entry.at("printed") == "refuted" && entry.at("loss").is_null())
            summary["refuted_without_loss"].push_back(entry.at("equation"));
        with_function += !entry.at("functions").empty();
        with_test += !entry.at("tests").empty();
    }
    std::map<std::string, int> decided, observations, kinds;
    for (const ClaimResult& claim : claims) {
        ++(claim.id.ends_with("/text") ? observations : decided)[claim.verdict];
        ++kinds[claim.same_as.empty() ? claim.kind : "repeated"];
        if (aside(claim) && claim.verdict == "refuted") summary["refuted_steps"].push_back(claim.id);
    }
    summary["claims"] = decided;
    summary["observations"] = observations;
    summary["refuted_observations"] = refuted_observations(claims);
    summary["kinds"] = kinds;
    summary["with_function"] = with_function;
    summary["with_test"] = tests_ran ? Json(with_test) : Json();
    return summary;
}

} // namespace denhartog::derivation

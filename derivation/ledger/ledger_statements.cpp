#include "derivation/ledger/ledger_statements.hpp"

#include <algorithm>
#include <set>

namespace denhartog::derivation {

using ledger::Json;

namespace {

/// From the best to the worst.
const std::vector<std::string> words = {"proved", "argued", "measured", "refuted at a threshold of ours", "refuted"};

std::string word_of(const ClaimResult& claim) {
    if (claim.verdict == "approximation") return "proved"; // of the order that the claim says
    if (claim.verdict != "refuted" || refuted_whatever_the_threshold(claim.thresholds)) return claim.verdict;
    return "refuted at a threshold of ours";
}

/// The claims that a row names by an id.
std::vector<const ClaimResult*> claims_named(const std::vector<ClaimResult>& claims, const std::string& id) {
    std::vector<const ClaimResult*> found;
    for (const ClaimResult& claim : claims)
        if (claim.id == id || (claim.id.starts_with(id + "/") && !claim.id.ends_with("/text"))) found.push_back(&claim);
    return found;
}

std::string worse_word(const std::string& a, const std::string& b) {
    const auto rank = [](const std::string& word) { return std::find(words.begin(), words.end(), word) - words.begin(); };
    return rank(a) < rank(b) ? b : a;
}

/// Whether an equation's statement, or how it is read, has a symbol.
bool has_symbol(const Json& equations, const std::string& number, const std::string& symbol) {
    return std::ranges::any_of(equations, [&](const Json& row) {
        return row.at("equation") == number && row.at("statement").get<std::string>().find(symbol) != std::string::npos;
    });
}

/// Whether a figure draws one of some equations.
bool draws(const std::vector<nlohmann::json>& figures, const std::string& figure, const Json& any_of) {
    return std::ranges::any_of(figures, [&](const nlohmann::json& record) {
        const auto drawn = record.at("equations").get<std::vector<std::string>>();
        const auto is_drawn = [&](const std::string& equation) { return std::ranges::find(drawn, equation) != drawn.end(); };
        return record.at("name").get<std::string>().starts_with(figure) &&
               std::ranges::any_of(any_of.get<std::vector<std::string>>(), is_drawn);
    });
}

/// True if all equations that are meant have the property that a reference is about, and one of those cited has not.
template <class Has>
bool is_slip(const Json& cited, const Json& meant, const Has& has) {
    return std::ranges::all_of(meant, has) && !std::ranges::all_of(cited, has);
}

std::string verdict_on_reference(const Json& reference, const Json& equations, const std::vector<nlohmann::json>& figures) {
    if (!reference.contains("figures"))
        return is_slip(reference.at("cited"), reference.at("meant"),
                       [&](const Json& number) { return has_symbol(equations, number, reference.at("symbol")); })
                   ? "slip of reference"
                   : "none";
    if (figures.empty()) return "not decided";
    return is_slip(reference.at("figures"), reference.at("meant_figures"),
                   [&](const Json& figure) { return draws(figures, figure, reference.at("any_of")); })
               ? "slip of reference"
               : "none";
}

/// The reference that was meant, e.g. `(2), (3) are meant`.
std::string meant_text(const Json& reference) {
    const bool of_figures = reference.contains("figures");
    std::string text;
    for (const Json& each : reference.at(of_figures ? "meant_figures" : "meant"))
        text += (text.empty() ? "" : ", ") + (of_figures ? each.get<std::string>() : "(" + each.get<std::string>() + ")");
    return text + (reference.at(of_figures ? "meant_figures" : "meant").size() == 1 ? " is meant" : " are meant");
}

} // namespace

Statements join_statements(const Json& rows, const std::vector<ClaimResult>& claims, const Json& equations,
                           const std::vector<nlohmann::json>& figures) {
    Statements all;
    all.rows = Json::array();
    all.counts = Json::object();
    std::set<std::string> named;
    for (const Json& row : rows) {
        const std::string statement = row.at("statement");
        Json entry = {{"section", row.at("section")},
                      {"statement", statement},
                      {"verdict", ""},
                      {"claims", Json::array()},
                      {"remark", row.value("remark", row.value("assumed", row.value("left", "")))}};
        std::string verdict = row.contains("left") ? "not decided" : row.contains("assumed") ? "assumption" : "";
        for (const Json& id : row.value("claims", Json::array())) {
            const std::vector<const ClaimResult*> found = claims_named(claims, id);
            if (found.empty())
                all.faults.push_back("the statement '" + statement + "' names the claim " + id.get<std::string>() +
                                     ", which is none");
            std::string word;
            for (const ClaimResult* claim : found) {
                named.insert(claim->id);
                word = word.empty() ? word_of(*claim) : worse_word(word, word_of(*claim));
            }
            entry["claims"].push_back({{"id", id}, {"verdict", word}});
            verdict = verdict.empty() ? word : worse_word(verdict, word);
        }
        if (row.contains("reference")) {
            verdict = verdict_on_reference(row.at("reference"), equations, figures);
            entry["remark"] = meant_text(row.at("reference"));
            if (verdict == "none")
                all.faults.push_back("the statement '" + statement + "' is said to be a slip of reference and is none");
        }
        if (verdict.empty()) all.faults.push_back("the statement '" + statement + "' is decided by nothing and does not say why");
        entry["verdict"] = verdict;
        Json& count = all.counts[verdict];
        count = (count.is_null() ? 0 : count.get<int>()) + 1;
        all.rows.push_back(std::move(entry));
    }
    for (const ClaimResult& claim : claims)
        if (claim.id.ends_with("/text") && !named.contains(claim.id))
            all.faults.push_back("the observation " + claim.id + " stands in no row of statements.json");
    return all;
}

} // namespace denhartog::derivation

#include "derivation/ledger/ledger_audit.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace denhartog::derivation {

using nlohmann::json;

namespace {

bool decides_the_equation(const json& claim) {
    const std::string role = claim.at("role");
    return role != "step" && role != "observation" && !claim.contains("same_as");
}

bool is_proof_of_a_kind(const json& claim) {
    const std::string kind = claim.value("kind", "");
    return kind == "derived" || kind == "refinement";
}

std::string kinds_of(const json& entry) {
    std::map<std::string, int> count;
    for (const json& claim : entry.at("claims"))
        if (decides_the_equation(claim)) ++count[claim.value("kind", "")];
    std::string text;
    for (const auto& [kind, n] : count) text += (text.empty() ? "" : ", ") + std::to_string(n) + " " + kind;
    return text.empty() ? "none: " + entry.at("kind").get<std::string>() : text;
}

/// The assumptions among the equations that an equation rests on, however far; itself, if it is one.
void add_premises(const std::map<std::string, const json*>& entries, const std::string& equation, std::set<std::string>& met,
                  std::vector<std::string>& premises) {
    if (!met.insert(equation).second) return;
    const json& entry = *entries.at(equation);
    if (entry.at("kind") == "assumption") premises.push_back(equation);
    for (const json& ground : entry.at("rests_on")) add_premises(entries, ground, met, premises);
}

/// The claims that say where the form holds that is in use.
std::vector<const json*> claims_in_use(const json& entry) {
    const bool shipped = entry.at("shipped") != "not_applicable";
    std::vector<const json*> list;
    for (const json& claim : entry.at("claims")) {
        const bool of_use = claim.at("role") == "both" || claim.at("role") == (shipped ? "shipped" : "printed");
        if (of_use && decides_the_equation(claim) && is_proof_of_a_kind(claim)) list.push_back(&claim);
    }
    return list;
}

/// The numbers of masses that some assumptions name: `N = 2`, `N = 2 modes`, `N = 1 to 4`.
std::set<std::string> numbers_of_masses(const json& claim) {
    std::set<std::string> found;
    for (const std::string assumption : claim.at("assumptions"))
        if (assumption.starts_with("N = ")) found.insert(assumption.substr(4, assumption.find(" modes") - 4));
    return found;
}

/// Whether a proved step adds one more mode, or one more mass, to any number of them.
bool goes_on_to_every_number(const json& entry) {
    return std::ranges::any_of(entry.at("claims"), [](const json& claim) {
        return claim.at("verdict") == "proved" && std::ranges::any_of(claim.at("assumptions"), [](const json& assumption) {
                   return assumption.get<std::string>().starts_with("any number of");
               });
    });
}

std::string masses_of(const json& entry, const std::vector<const json*>& claims) {
    std::set<std::string> numbers;
    bool of_every = false; // a derived claim that names no number of masses speaks of one mode, or of any number of masses
    for (const json* claim : claims) {
        const std::set<std::string> named = numbers_of_masses(*claim);
        of_every = of_every || (named.empty() && claim->at("kind") == "derived");
        numbers.insert(named.begin(), named.end());
    }
    if (numbers.empty()) return {};
    std::string listed;
    for (const std::string& n : numbers) listed += (listed.empty() ? "" : ", ") + n;
    if (goes_on_to_every_number(entry)) return "every number of masses, by the step of the sum (whole for N = " + listed + ")";
    return "N = " + listed + (of_every ? " in some of its claims" : " only");
}

void add_new(std::vector<std::string>& list, const std::string& item) {
    if (!item.empty() && std::ranges::find(list, item) == list.end()) list.push_back(item);
}

std::string joined_by(const std::vector<std::string>& list, const std::string& between, const std::string& open = "",
                      const std::string& close = "") {
    std::string text;
    for (const std::string& item : list) text += (text.empty() ? "" : between) + open + item + close;
    return text;
}

/// The assumptions of a claim without the number of masses.
std::string domain_of_claim(const json& claim) {
    std::vector<std::string> list;
    for (const std::string assumption : claim.at("assumptions"))
        if (!assumption.starts_with("N = ")) list.push_back(assumption);
    std::ranges::sort(list); // the same whatever their order in the claim
    return joined_by(list, ", ");
}

} // namespace

std::vector<AuditRow> audit_of(const json& entries) {
    std::map<std::string, const json*> by_number;
    for (const json& entry : entries) by_number[entry.at("equation")] = &entry;
    std::vector<AuditRow> rows;
    for (const json& entry : entries) {
        AuditRow row;
        row.equation = entry.at("equation");
        row.kinds = kinds_of(entry);
        row.printed = entry.at("printed");
        row.shipped = entry.at("shipped");
        std::set<std::string> met;
        add_premises(by_number, row.equation, met, row.premises);
        std::ranges::sort(row.premises, [](const std::string& a, const std::string& b) {
            return a.size() != b.size() ? a.size() < b.size() : a < b;
        });
        const std::vector<const json*> in_use = claims_in_use(entry);
        for (const json* claim : in_use) add_new(row.domains, domain_of_claim(*claim));
        row.masses = masses_of(entry, in_use);
        for (const json& claim : entry.at("claims"))
            if (claim.at("verdict") == "argued" && claim.at("role") == "step") row.argued.push_back(claim.at("id"));
        row.typed = entry.at("correction") != "" && entry.at("correction_by") == "hand";
        rows.push_back(std::move(row));
    }
    return rows;
}

std::string remaining(const AuditRow& row) {
    std::vector<std::string> parts;
    if (!row.premises.empty()) parts.push_back("premises " + joined_by(row.premises, ", ", "(", ")"));
    if (!row.domains.empty()) parts.push_back("claims made where " + joined_by(row.domains, ", or where "));
    if (!row.masses.empty()) parts.push_back(row.masses);
    if (!row.argued.empty()) parts.push_back("argued beside it: " + joined_by(row.argued, ", "));
    if (row.typed) parts.emplace_back("the formula shown as what holds was typed by a person");
    return parts.empty() ? "nothing" : joined_by(parts, "; ");
}

std::string audit_summary(const std::vector<AuditRow>& rows) {
    std::set<std::string> premises;
    long few_masses = 0, argued = 0, typed = 0;
    for (const AuditRow& row : rows) {
        premises.insert(row.premises.begin(), row.premises.end());
        few_masses += row.masses.ends_with(" only");
        argued += !row.argued.empty();
        typed += row.typed;
    }
    std::vector<std::string> ordered(premises.begin(), premises.end());
    std::ranges::sort(
        ordered, [](const std::string& a, const std::string& b) { return a.size() != b.size() ? a.size() < b.size() : a < b; });
    return "All rests on the paper's assumptions " + joined_by(ordered, ", ", "(", ")") + ". Of " + std::to_string(rows.size()) +
           " equations " + std::to_string(few_masses) + " are decided for a few masses only, " + std::to_string(argued) +
           " have a step that a person argued (it decides no equation), and of " + std::to_string(typed) +
           " the formula shown as what holds was typed by a person.";
}

std::string audit_markdown(const std::vector<AuditRow>& rows) {
    std::string text = "| equation | claims by kind | as printed | as shipped | what remains assumed |\n|---|---|---|---|---|\n";
    for (const AuditRow& row : rows) {
        std::string assumed;
        for (const char c : remaining(row)) assumed += c == '|' ? std::string("\\|") : std::string(1, c);
        text += "| (" + row.equation + ") | " + row.kinds + " | " + row.printed + " | " + row.shipped + " | " + assumed + " |\n";
    }
    return text;
}

} // namespace denhartog::derivation

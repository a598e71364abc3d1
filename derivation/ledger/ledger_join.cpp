#include "derivation/ledger/ledger_join.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "derivation/ledger/ledger_summary.hpp"

namespace denhartog::derivation {

using ledger::Json;

namespace {

const std::vector<std::string>&verdicts = verdict_words(), &departures = departure_words();
const std::set<std::string> roles = {"both", "printed", "shipped", "step", "observation"};
const std::set<std::string> claim_kinds = {"derived", "refinement", "restated", "consequence", "argument", "observation"};

std::size_t rank(const std::vector<std::string>& words, const std::string& word) {
    return std::find(words.begin(), words.end(), word) - words.begin();
}

std::string worse(const std::vector<std::string>& words, const std::string& a, const std::string& b) {
    return rank(words, a) < rank(words, b) ? b : a;
}

bool has(const std::vector<std::string>& list, const std::string& item) {
    return std::find(list.begin(), list.end(), item) != list.end();
}

/// Everything the parts say of one equation.
struct Gathered {
    std::vector<const ClaimResult*> printed; ///< claims on the printed form
    std::vector<const ClaimResult*> shipped; ///< claims on what is shipped
    bool function = false;                   ///< whether a formula is shipped
    int paper_functions = 0;                 ///< how many formulas are in the paper's own form
    std::string unproved = "unknown"; ///< what it is without a proof: definition or assumption, which have nothing to prove
};

using Faults = std::vector<std::string>;

void check_claims(const std::vector<ClaimResult>& claims, Faults& faults) {
    std::set<std::string> ids;
    for (const ClaimResult& claim : claims) {
        const std::string name = "claim " + claim.id;
        if (!ids.insert(claim.id).second) faults.push_back(name + " is there twice");
        if (claim.equations.empty()) faults.push_back(name + " speaks of no equation");
        for (const std::string& equation : claim.equations)
            if (!has(ledger::equation_numbers(), equation))
                faults.push_back(name + " speaks of equation " + equation + ", which is not in the paper");
        if (claim.verdict == "measured") {
            if (claim.role != "observation" || claim.witness.empty())
                faults.push_back(name + " is measured and no observation that says what was searched");
        } else if (claim.verdict == "argued") {
            if (!aside(claim)) faults.push_back(name + " is argued and no step");
        } else if (!has(verdicts, claim.verdict)) {
            faults.push_back(name + " has the verdict " + claim.verdict + ", which is no verdict");
        }
        if (!has(departures, claim.departure))
            faults.push_back(name + " has the departure " + claim.departure + ", which is none");
        if (!roles.contains(claim.role)) faults.push_back(name + " has the role " + claim.role + ", which is no role");
        if (!claim_kinds.contains(claim.kind)) faults.push_back(name + " has the kind " + claim.kind + ", which is none");
        if (claim.verdict == "unknown") faults.push_back(name + " is unknown");
        if (claim.loss && !std::isfinite(*claim.loss)) faults.push_back(name + " has a loss that is not finite");
    }
}

/// Verdict of a claim on one equation.
std::string verdict_on(const ClaimResult& claim, const std::string& equation) {
    const auto found = claim.by_equation.find(equation);
    return found == claim.by_equation.end() ? claim.verdict : found->second;
}

Json claim_entry(const ClaimResult& claim, const std::string& equation) {
    Json entry = {{"id", claim.id},     {"role", claim.role},
                  {"kind", claim.kind}, {"verdict", verdict_on(claim, equation)},
                  {"what", claim.what}, {"assumptions", claim.assumptions}};
    if (!claim.same_as.empty()) entry["same_as"] = claim.same_as;
    if (!claim.witness.empty()) entry["witness"] = claim.witness;
    if (!claim.thresholds.empty()) entry["thresholds"] = thresholds_to_json(claim.thresholds);
    if (claim.loss && std::isfinite(*claim.loss)) entry["loss"] = *claim.loss;
    return entry;
}

/// Equations with a claim that derives them, on what is shipped.
std::set<std::string> derived_equations(const std::vector<ClaimResult>& claims) {
    std::set<std::string> found;
    for (const ClaimResult& claim : claims)
        if (claim.kind == "derived" && !aside(claim) && claim.verdict != "refuted" && claim.same_as.empty())
            found.insert(claim.equations.begin(), claim.equations.end());
    return found;
}

/// True if a claim is a proof: it derives its equations or refines a derived formula, and no other claim has said the same.
bool is_proof(const ClaimResult& claim, const std::set<std::string>& derived) {
    if (claim.kind == "derived" || !claim.same_as.empty()) return claim.same_as.empty();
    return claim.kind == "refinement" && !claim.refines.empty() &&
           std::ranges::all_of(claim.refines, [&](const std::string& equation) { return derived.contains(equation); });
}

/// Worst verdict of claims on an equation. What is not refuted and has no proof among them stays what it is without one.
std::string worst(const std::vector<const ClaimResult*>& claims, const std::string& equation, const Gathered& all,
                  const std::set<std::string>& derived) {
    std::string found = "not_applicable";
    for (const ClaimResult* claim : claims) found = worse(verdicts, found, verdict_on(*claim, equation));
    if (found == "refuted" || found == "unknown") return found;
    const bool proof = std::ranges::any_of(claims, [&](const ClaimResult* c) { return is_proof(*c, derived); });
    return proof ? found : all.unproved;
}

std::string printed_verdict(const Gathered& all, const std::string& equation, const std::set<std::string>& derived) {
    if (all.printed.empty()) return all.unproved;
    const std::string found = worst(all.printed, equation, all, derived);
    const bool scan = std::ranges::all_of(all.printed, [](const ClaimResult* c) { return c->departure == "scan"; });
    return found == "refuted" && scan ? "illegible" : found;
}

std::string shipped_verdict(const Gathered& all, const Json& entry, const std::set<std::string>& derived) {
    if (!all.shipped.empty()) return worst(all.shipped, entry.at("equation"), all, derived);
    return !all.function ? "not_applicable" : entry.at("printed") == "refuted" ? "unknown" : all.unproved;
}

/// Departure, correction, witness, loss and consequence of the printed form.
void judge_printed(Json& entry, const Gathered& all, const std::string& name, Faults& faults) {
    std::string departure = entry.at("departure");
    const bool refuted = entry.at("printed") == "refuted" || entry.at("printed") == "illegible";
    std::string refuted_as = "none";
    for (const ClaimResult* claim : all.printed) {
        departure = worse(departures, departure, claim->departure);
        const std::string verdict = verdict_on(*claim, entry.at("equation"));
        if (verdict == "refuted") refuted_as = worse(departures, refuted_as, claim->departure);
        if (!claim->correction_latex.empty() && (verdict == "refuted" || !refuted)) {
            entry["correction"] = claim->correction_latex;
            entry["correction_by"] = claim->correction_by;
        }
        const bool decisive = verdict == (refuted ? Json("refuted") : entry.at("printed"));
        if (entry.at("witness").empty() && decisive) entry["witness"] = claim->witness;
        if (claim->loss && std::isfinite(*claim->loss))
            entry["loss"] = entry.at("loss").is_null() ? *claim->loss : std::max(entry.at("loss").get<double>(), *claim->loss);
        if (!claim->consequence.empty())
            entry["consequence"] =
                (entry.at("consequence") == "" ? "" : entry.at("consequence").get<std::string>() + "; ") + claim->consequence;
    }
    entry["departure"] = departure;
    if (!refuted) {
        const std::string printed = entry.at("printed");
        if (entry.at("loss").is_null() && printed != "unknown") entry["loss"] = 0.0;
        return;
    }
    if (refuted_as == "none") faults.push_back("the printed form of " + name + " is refuted, but its departure is not said");
    if (entry.at("correction") == "") faults.push_back("the printed form of " + name + " is refuted without a correction");
    if (!(entry.at("printed") == "illegible" && all.unproved != "unknown") && entry.at("shipped") != "proved" &&
        entry.at("shipped") != "approximation")
        faults.push_back("the printed form of " + name + " is refuted and no correction is proved");
}

void judge_verdicts(const Json& entry, const Gathered& all, const std::string& name, Faults& faults) {
    const std::string printed = entry.at("printed");
    const std::string shipped = entry.at("shipped");
    if (printed == "unknown")
        faults.push_back(name + (all.printed.empty() ? " has no verdict" : " is unknown as printed: no claim derives it"));
    if (shipped == "unknown")
        faults.push_back(
            name + (all.shipped.empty() ? " has a formula and no claim on it" : " is unknown as shipped: no claim derives it"));
    if (shipped == "refuted") faults.push_back(name + " is refuted as shipped");
}

void add_functions(Json& entry, const std::vector<FunctionEntry>& functions, Gathered& all) {
    entry["as_printed"] = Json::array();
    Json users = Json::array();
    for (const FunctionEntry& function : functions) {
        if (function.equation != entry.at("equation")) continue;
        Json found = {{"name", function.name}, {"file", function.file}, {"line", function.line}};
        if (function.name.find("::paper::") != std::string::npos)
            entry["functions"].insert(entry["functions"].begin() + all.paper_functions++, std::move(found));
        else if (is_formula(function))
            entry["functions"].push_back(std::move(found));
        else
            (is_as_printed(function) ? entry["as_printed"] : users).push_back(std::move(found));
    }
    all.function = !entry.at("functions").empty();
    for (Json& user : users) entry["functions"].push_back(std::move(user));
}

void add_tests(Json& entry, const LedgerParts& parts, const Gathered& all, const std::string& name, Faults& faults) {
    entry["tests_failed"] = Json::array();
    std::map<std::string, bool> passed; // a test that ran twice passed only if it did so both times
    for (const TestRun& run : parts.results.runs)
        if (has(run.equations, entry.at("equation"))) {
            const auto [place, fresh] = passed.try_emplace(run.name, run.passed);
            if (!fresh) place->second = place->second && run.passed;
        }
    for (const auto& [test, good] : passed) entry[good ? "tests" : "tests_failed"].push_back(test);
    if (parts.results.found && all.function && entry.at("tests").empty())
        faults.push_back(name + " has a formula and no test that ran and passed");
}

void check_tests(const LedgerParts& parts, Faults& faults) {
    if (!parts.results.found) return;
    for (const TestRun& run : parts.results.runs)
        if (!run.passed) faults.push_back("test '" + run.name + "' failed");
    for (const DeclaredTest& test : parts.declared) {
        const bool ran = std::any_of(parts.results.runs.begin(), parts.results.runs.end(), [&](const TestRun& run) {
            return run.name == test.name || run.name.starts_with(test.name + " - "); // the latter: a test over types
        });
        std::string tags;
        for (const std::string& equation : test.equations) {
            tags += (tags.empty() ? "eq:" : ", eq:") + equation;
            if (!has(ledger::equation_numbers(), equation))
                faults.push_back("test '" + test.name + "' is tagged eq:" + equation + ", which is not in the paper");
        }
        if (!ran) faults.push_back("test '" + test.name + "' tagged " + tags + " did not run");
    }
}

} // namespace

JoinedLedger join_ledger(const LedgerParts& parts) {
    JoinedLedger joined;
    Faults& faults = joined.faults;
    check_claims(parts.claims, faults);
    for (const FunctionEntry& function : parts.functions)
        if (!has(ledger::equation_numbers(), function.equation))
            faults.push_back(function.name + " (" + function.file + ":" + std::to_string(function.line) + ") is tagged eq{" +
                             function.equation + "}, which is not in the paper");
    check_tests(parts, faults);
    joined.entries = Json::array();
    std::set<std::string> present, derived = derived_equations(parts.claims);
    for (const Json& row : parts.rows) {
        Json entry = ledger::entry_without_run(row);
        const std::string number = entry.at("equation");
        const std::string name = "equation " + number;
        Gathered all;
        if (entry.at("kind") == "definition" || entry.at("kind") == "assumption") all.unproved = entry.at("kind");
        add_functions(entry, parts.functions, all);
        for (const ClaimResult& claim : parts.claims) {
            if (!has(claim.equations, number)) continue;
            entry["claims"].push_back(claim_entry(claim, number));
            if (claim.role == "printed" || claim.role == "both") all.printed.push_back(&claim);
            if (claim.role == "shipped" || claim.role == "both") all.shipped.push_back(&claim);
        }
        entry["printed"] = printed_verdict(all, number, derived);
        entry["shipped"] = shipped_verdict(all, entry, derived);
        judge_verdicts(entry, all, name, faults);
        judge_printed(entry, all, name, faults);
        if (!all.function && entry.at("no_function") == "")
            faults.push_back(name + " has neither a formula nor a reason why not");
        if (all.function && entry.at("no_function") != "") faults.push_back(name + " has a formula and a reason why it has none");
        add_tests(entry, parts, all, name, faults);
        present.insert(number);
        joined.entries.push_back(std::move(entry));
    }
    for (const std::string& number : ledger::equation_numbers())
        if (!present.contains(number)) faults.push_back("equation " + number + " has no row");
    ledger::fill_used_by(joined.entries);
    joined.summary = summary_of(joined.entries, parts.claims, parts.results.found);
    joined.summary["perhaps_scan"] = Json::array();
    for (const Json& row : parts.rows)
        if (row.contains("perhaps_scan") &&
            std::ranges::find(joined.summary.at("refuted"), row.at("equation")) != joined.summary.at("refuted").end())
            joined.summary["perhaps_scan"].push_back(row.at("equation"));
    return joined;
}

} // namespace denhartog::derivation

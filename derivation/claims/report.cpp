#include "derivation/claims/report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iomanip>
#include <sstream>
#include <stdexcept>

#include "derivation/claims/threshold.hpp"
#include "derivation/ledger/ledger_audit.hpp"
#include "derivation/ledger/ledger_kernel.hpp"
#include "derivation/ledger/ledger_scenes.hpp"

namespace denhartog::derivation {

using nlohmann::json;

namespace {

std::string scientific(double x) {
    std::ostringstream out;
    out << std::setprecision(2) << std::scientific << x;
    return out.str();
}

std::string three_digits(double x) {
    std::ostringstream out;
    out << std::setprecision(3) << x;
    return out.str();
}

/// Whole digits on which two routes agree.
int digits_agreed(double error) { return error > 0 ? static_cast<int>(std::floor(-std::log10(error))) : 99; }

std::string counts(const json& counted) {
    std::string text;
    for (const auto& [word, number] : counted.items())
        if (number != 0) text += (text.empty() ? "" : ", ") + std::to_string(number.get<long>()) + " " + word;
    return text;
}

/// Counts the verdicts on the observations of the text, the refuted ones by what refutes them.
std::string observation_counts(const json& summary) {
    const json& refuted = summary.at("refuted_observations");
    return counts(summary.at("observations")) + "; of those refuted " + refuted.at("whatever_the_threshold").dump() +
           " whatever the threshold, " + refuted.at("at_a_threshold_of_ours").dump() + " at a threshold of ours";
}

/// The verdict on an observation, with what its vague words were taken to be.
std::string observed(const json& claim, const std::string& mark) {
    const std::string verdict = claim.at("verdict");
    const std::vector<Threshold> thresholds = thresholds_from_json(claim.value("thresholds", json::array()));
    std::string text = mark + verdict + mark;
    if (verdict == "refuted" && refuted_whatever_the_threshold(thresholds)) text += " whatever the threshold";
    std::string taken;
    for (const Threshold& threshold : thresholds) taken += (taken.empty() ? "" : "; ") + sentence(threshold);
    return taken.empty() ? text : text + " (" + taken + ")";
}

/// Equations with brackets, one after the other.
std::string listed(const json& equations) {
    std::string text;
    for (const json& equation : equations) text += (text.empty() ? "(" : ", (") + equation.get<std::string>() + ")";
    return text.empty() ? "none" : text;
}

std::string loss_text(const json& entry) {
    return entry.at("loss").is_null() ? "no loss to measure" : "loss " + scientific(entry.at("loss"));
}

std::string mutants_text(const json& m) {
    std::ostringstream text;
    text << m.at("refuted") << " of "
         << m.at("refuted").get<long>() + m.at("without_value").get<long>() + m.at("idle").get<long>() +
                m.at("unknown").get<long>() + m.at("proved").get<long>()
         << " mutated twins of " << m.at("claims") << " claims refuted, " << m.at("without_value")
         << " without a value (division by zero), " << m.at("idle") << " idle in a special case, " << m.at("unknown")
         << " unknown, " << m.at("proved") << " wrongly proved; " << m.at("claims_without")
         << " more claims have none and say why";
    return text.str();
}

/// A value of a witness; a double written in 17 digits, in as few as give it back.
std::string value_text(const json& value) {
    if (!value.is_string()) return value.dump();
    const std::string text = value;
    if (text.find('.') == std::string::npos) return text;
    char* end = nullptr;
    const double x = std::strtod(text.c_str(), &end);
    char in_17_digits[40];
    std::snprintf(in_17_digits, sizeof in_17_digits, "%.17g", x);
    return in_17_digits == text ? json(x).dump() : text;
}

/// A claim's witness in one line.
std::string witness_text(const json& witness) {
    std::string text;
    for (const auto& [name, value] : witness.items()) text += (text.empty() ? "" : ", ") + name + " = " + value_text(value);
    return text;
}

/// Observations of the paper's text, gathered from the equations they belong to; the refuted ones first.
std::vector<json> observations(const json& entries) {
    std::vector<json> found;
    for (const json& entry : entries)
        for (const json& claim : entry.at("claims")) {
            if (!claim.at("id").get<std::string>().ends_with("/text")) continue;
            const bool known = std::ranges::any_of(found, [&](const json& other) { return other.at("id") == claim.at("id"); });
            if (!known) found.push_back(claim);
        }
    std::stable_partition(found.begin(), found.end(), [](const json& claim) { return claim.at("verdict") == "refuted"; });
    return found;
}

/// A row of the table of statements.
std::string statement_row(const json& row) {
    std::string by;
    for (const json& claim : row.at("claims")) {
        const std::string id = claim.at("id"), verdict = claim.at("verdict");
        by += (by.empty() ? "`" : ", `") + id + "`" + (verdict == row.at("verdict") ? "" : " (" + verdict + ")");
    }
    const std::string remark = row.at("remark");
    std::string statement;
    for (const char c : row.at("statement").get<std::string>()) statement += c == '|' ? std::string("\\|") : std::string(1, c);
    return "| " + row.at("section").get<std::string>() + " | " + statement + " | " + row.at("verdict").get<std::string>() +
           " | " + by + (by.empty() || remark.empty() ? "" : "; ") + remark + " |\n";
}

} // namespace

std::string summary_text(const ReportParts& p) {
    std::ostringstream out;
    out << "Ledger: " << p.summary.at("equations") << " numbered equations\n"
        << "  as printed: " << counts(p.summary.at("printed")) << "\n"
        << "  as shipped: " << counts(p.summary.at("shipped")) << "\n"
        << "  departures: " << counts(p.summary.at("departure")) << "\n"
        << "  claims:     " << counts(p.summary.at("claims")) << "\n"
        << "  by kind:    " << counts(p.summary.at("kinds")) << "\n"
        << "  statements: " << counts(p.statement_counts) << "\n"
        << "  the text:   " << observation_counts(p.summary) << "\n"
        << "  mutants:    " << mutants_text(p.mutants) << "\n"
        << "  kernel:     " << kernel_sentence(p.entries) << "\n\n"
        << audit_summary(audit_of(p.entries)) << "\n\nRefuted as printed:\n";
    for (const json& entry : p.entries)
        if (entry.at("printed") == "refuted")
            out << "  (" << entry.at("equation").get<std::string>() << ") " << entry.at("departure").get<std::string>() << ", "
                << loss_text(entry) << "; shipped form " << entry.at("shipped").get<std::string>()
                << "\n      holds: " << entry.at("correction").get<std::string>() << "\n      "
                << scene_markdown(entry.at("scene")) << "\n";
    out << "\nIllegible in the text at hand, where what stands there cannot be meant: " << listed(p.summary.at("illegible"))
        << "\n\nObservations of the text:\n";
    for (const json& claim : observations(p.entries))
        out << "  " << observed(claim, "") << ": " << claim.at("what").get<std::string>() << "\n";
    out << "\nClosed form against second witness, largest relative difference:\n";
    for (const json& group : p.agreement)
        out << "  " << std::left << std::setw(34) << group.at("group").get<std::string>() << std::right << std::setw(5)
            << group.at("scenes").get<long>() << " scenes   double " << scientific(group.at("double").at("worst"))
            << "   50 digits " << scientific(group.at("50 digits").at("worst")) << (group.at("agrees") ? "" : "   RED") << "\n";
    out << "\n";
    for (const json& fault : p.faults) out << "RED: " << fault.get<std::string>() << "\n";
    out << (p.faults.empty() ? "All green.\n" : std::to_string(p.faults.size()) + " red.\n");
    return out.str();
}

std::string report_markdown(const ReportParts& p) {
    std::ostringstream out;
    out << "# What the derivation found\n\nWritten by `./verify paper`.\n\n"
        << "| | |\n|---|---|\n| numbered equations | " << p.summary.at("equations") << " |\n| as printed | "
        << counts(p.summary.at("printed")) << " |\n| as shipped | " << counts(p.summary.at("shipped")) << " |\n| departures | "
        << counts(p.summary.at("departure")) << " |\n| claims | " << counts(p.summary.at("claims")) << " |\n| claims by kind | "
        << counts(p.summary.at("kinds")) << " |\n| observations of the text | " << observation_counts(p.summary)
        << " |\n| mutated twins | " << mutants_text(p.mutants) << " |\n| kernel of Coq | " << kernel_sentence(p.entries)
        << " |\n\n";
    if (!p.faults.empty()) {
        out << "## Red\n\n";
        for (const json& fault : p.faults) out << "- " << fault.get<std::string>() << "\n";
        out << "\n";
    }
    out << "## Stand-ins\n\nThese shipped functions compare numbers, sum a series or reduce an argument. The proofs take them by "
           "what they compute without rounding; every other function in a proof is the shipped text.\n\n"
           "| function | header | stands for |\n|---|---|---|\n";
    for (const json& s : p.stand_ins)
        out << "| `" << s.at("name").get<std::string>() << "` | `" << s.at("header").get<std::string>() << "` | $"
            << s.at("theorem").get<std::string>() << "$ |\n";
    out << "\n";
    out << "## Illegible\n\nThe text at hand is a scan. What stands there in these equations cannot be meant, and says nothing "
           "of the "
           "printed paper: "
        << listed(p.summary.at("illegible")) << ". Whoever has the paper can tell: see `in_print` in docs/ledger/README.md.\n\n"
        << "## Refuted as printed\n\n";
    for (const json& entry : p.entries) {
        if (entry.at("printed") != "refuted") continue;
        out << "### (" << entry.at("equation").get<std::string>() << "), Section " << entry.at("section").get<std::string>()
            << ": " << entry.at("departure").get<std::string>() << "\n\nPrinted:\n\n$$"
            << entry.at("statement").get<std::string>() << "$$\n\nHolds (" << entry.at("shipped").get<std::string>() << "):\n\n$$"
            << entry.at("correction").get<std::string>() << "$$\n\nWitness: " << witness_text(entry.at("witness")) << "\n\n";
        const std::string consequence = entry.value("consequence", "");
        out << scene_markdown(entry.at("scene")) << ".\n\n"
            << "Coded as printed: " << (consequence.empty() ? "no loss to measure" : consequence) << ".\n\n";
    }
    out << "## Observations of the text\n\n"
           "Where the text has a vague word, a number of ours stands for it: the number taken, and the number from which on "
           "nothing "
           "was found that refutes the statement. Refuted whatever the threshold are those that no number which leaves the "
           "statement "
           "a meaning would save. What is called largest was found at the places that are named with the observation; between "
           "them "
           "it may be larger.\n\n";
    for (const json& claim : observations(p.entries))
        out << "- " << observed(claim, "**") << ": " << claim.at("what").get<std::string>() << ". "
            << witness_text(claim.value("witness", json::object())) << "\n";
    out << "\n## What the text says\n\nEvery statement of the paper's text that is neither a definition nor a description of a "
           "method, "
           "in the words of this project, with the worst verdict of the claims that decide it: "
        << counts(p.statement_counts) << ".\n\n| section | statement | verdict | decided by |\n|---|---|---|---|\n";
    for (const json& row : p.statements) out << statement_row(row);
    out << "\n## Closed form against second witness\n\nLargest difference of displacements, initial values, amplitudes "
           "(relative) and "
           "phase (radians).\n\n| system | scenes | double | 50 digits | worst scene in double |\n|---|---|---|---|---|\n";
    for (const json& group : p.agreement)
        out << "| " << group.at("group").get<std::string>() << " | " << group.at("scenes") << " | "
            << scientific(group.at("double").at("worst")) << " | " << scientific(group.at("50 digits").at("worst")) << " | "
            << group.at("double").at("scene").get<std::string>() << " |\n";
    const std::vector<AuditRow> audit = audit_of(p.entries);
    out << "\n## What remains assumed\n\n" << audit_summary(audit) << "\n\n" << audit_markdown(audit);
    out << "\n## All equations\n\n| equation | section | kind | printed | shipped | departure | claims "
           "|\n|---|---|---|---|---|---|---|\n";
    for (const json& entry : p.entries)
        out << "| (" << entry.at("equation").get<std::string>() << ") | " << entry.at("section").get<std::string>() << " | "
            << entry.at("kind").get<std::string>() << " | " << entry.at("printed").get<std::string>() << " | "
            << entry.at("shipped").get<std::string>() << " | " << entry.at("departure").get<std::string>() << " | "
            << entry.at("claims").size() << " |\n";
    return out.str();
}

std::string status_markdown(const ReportParts& p) {
    std::ostringstream out;
    out << "| | |\n|---|---|\n| numbered equations | " << p.summary.at("equations") << " |\n| as printed | "
        << counts(p.summary.at("printed")) << " |\n| as shipped | " << counts(p.summary.at("shipped")) << " |\n| departures | "
        << counts(p.summary.at("departure")) << " |\n| statements of the text | " << counts(p.statement_counts)
        << " |\n| observations of the text | " << observation_counts(p.summary) << " |\n| mutated twins | "
        << mutants_text(p.mutants) << " |\n| refuted as printed | ";
    out << listed(p.summary.at("refuted")) << " |\n| illegible in the text at hand | " << listed(p.summary.at("illegible"));
    long scenes = 0;
    double in_double = 0, in_50 = 0;
    for (const json& group : p.agreement) {
        scenes += group.at("scenes").get<long>();
        in_double = std::max(in_double, group.at("double").at("worst").get<double>());
        in_50 = std::max(in_50, group.at("50 digits").at("worst").get<double>());
    }
    out << " |\n| closed form against second witness | " << scenes << " of the paper's scenes: " << digits_agreed(in_double)
        << " digits in double, " << digits_agreed(in_50) << " in 50 digits |\n";
    return out.str();
}

namespace {

/// The entry of an equation.
const json& entry_of(const ReportParts& p, const std::string& equation) {
    const auto found = std::ranges::find_if(p.entries, [&](const json& entry) { return entry.at("equation") == equation; });
    if (found == p.entries.end()) throw std::invalid_argument("the ledger has no row (" + equation + ")");
    return *found;
}

/// The part of a statement between the left and the right bracket of d_i.
std::string bracket_of(const std::string& statement) {
    const std::string before = "e^{-\\frac{\\zeta_i\\tau}{R_i}}", after = "\\right]";
    const std::size_t from = statement.find(before + "\\left["), to = statement.find(after, from);
    if (to == std::string::npos) throw std::invalid_argument("a statement without the bracket of d_i: " + statement);
    return statement.substr(from + before.size(), to + after.size() - from - before.size());
}

/// The largest losses over the paper's own scenes, the largest first; equations that lose the same stand together.
std::string largest_losses(const ReportParts& p, std::size_t count) {
    std::vector<std::pair<double, std::string>> losses;
    for (const json& entry : p.entries)
        if (entry.at("printed") == "refuted" && !entry.at("loss").is_null())
            losses.emplace_back(entry.at("loss").get<double>(), entry.at("equation").get<std::string>());
    std::ranges::stable_sort(losses, std::greater(), &std::pair<double, std::string>::first);
    losses.resize(std::min(count, losses.size()));
    std::string text;
    for (std::size_t n = 0; n < losses.size(); ++n) {
        const auto& [loss, equation] = losses[n];
        const bool same = n + 1 < losses.size() && losses[n + 1].first == loss;
        text += "(" + equation + ")" + (same ? " = " : " " + std::to_string(std::lround(100 * loss)) + " %");
        if (!same && n + 1 < losses.size()) text += ", ";
    }
    return text;
}

} // namespace

std::string found_markdown(const ReportParts& p) {
    const std::string bracket = bracket_of(entry_of(p, "46").at("statement"));
    for (const char* other : {"40", "41", "A.15"})
        if (bracket_of(entry_of(p, other).at("statement")) != bracket)
            throw std::invalid_argument(std::string("(46) and (") + other + ") have different brackets");
    const json& scene = entry_of(p, "46").at("scene");
    std::ostringstream out;
    out << "Of " << p.summary.at("equations") << " numbered equations " << p.summary.at("refuted").size()
        << " do not hold as printed, and " << p.summary.at("illegible").size()
        << " more are illegible in the text at hand, a scan. Of the former, the scan alone may be wrong in "
        << listed(p.summary.at("perhaps_scan")) << ". One of the mistakes is printed four times:\n\n"
        << "| in (40), (41), (46), (A.15) as printed | corrected, and proved | " << scene.at("where").get<std::string>()
        << " |\n|---|---|---|\n| $" << bracket << "$ | $" << bracket_of(entry_of(p, "A.8").at("statement")) << "$ | amplitude "
        << three_digits(scene.at("printed")) << " as printed, " << three_digits(scene.at("holds")) << " in truth |\n\n"
        << "On the paper's own scenes these equations have the largest errors, as a share of the largest displacement or "
           "velocity: "
        << largest_losses(p, 5) << ".\n";
    return out.str();
}

std::string with_block(const std::string& text, const std::string& name, const std::string& content) {
    const std::string begin = "<!-- " + name + " -->\n", end = "<!-- /" + name + " -->";
    const std::size_t from = text.find(begin), to = text.find(end);
    if (from == std::string::npos || to == std::string::npos || to < from)
        throw std::invalid_argument("the marks of the block " + name + " are missing");
    return text.substr(0, from + begin.size()) + content + text.substr(to);
}

bool same_but_for_rounding(const std::string& a, const std::string& b) {
    std::istringstream left(a), right(b);
    std::string x, y;
    while (left >> x) {
        if (!(right >> y)) return false;
        if (x == y) continue;
        char *x_end = nullptr, *y_end = nullptr;
        const double p = std::strtod(x.c_str(), &x_end), q = std::strtod(y.c_str(), &y_end);
        if (*x_end != '\0' || *y_end != '\0') return false;
        const bool tiny = std::abs(p) < 1e-12 && std::abs(q) < 1e-12;
        if (!tiny && std::abs(p - q) > 1e-9 * std::max(std::abs(p), std::abs(q))) return false;
    }
    return !(right >> y);
}

} // namespace denhartog::derivation

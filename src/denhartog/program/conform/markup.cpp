// The report in markup: Markdown, and XML for programs that show test results.
#include <algorithm>
#include <map>

#include "conformance/verdict.hpp"
#include "denhartog/program/conform/report.hpp"

namespace denhartog::program {
namespace {

using conformance::Judged;
using conformance::Verdict;

// A cell whose text cannot end it.
std::string markdown_cell(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '|' || c == '<' || c == '`' || c == '*' || c == '\\' || c == '[') safe += '\\';
        safe += c;
    }
    return safe;
}

std::string row(const std::vector<std::string>& cells) {
    std::string text = "|";
    for (const std::string& one : cells) text += " " + markdown_cell(one) + " |";
    return text + "\n";
}

std::string rule(std::size_t columns) {
    std::string text = "|";
    for (std::size_t n = 0; n < columns; ++n) text += "---|";
    return text + "\n";
}

std::string score_rows(const ConformReport& report) {
    const std::vector<std::vector<std::string>> cells = score_cells(report, "worst digits", "0");
    std::string text = row(cells.front()) + rule(cells.front().size());
    for (std::size_t n = 1; n < cells.size(); ++n) text += row(cells[n]);
    return text;
}

std::string worst_rows(const ConformReport& report) {
    constexpr std::size_t most = 20;
    const std::vector<const Judged*> worst = conformance::worst_first(report.judged);
    if (worst.empty()) return "";
    std::string text =
        "\n### Wrong answers\n\n" + row({"id", "verdict", "answer", "true", "error over tolerance", "why"}) + rule(6);
    for (std::size_t n = 0; n < worst.size() && (report.verbose || n < most); ++n) {
        const Judged& one = *worst[n];
        const auto ratio = conformance::error_over_tolerance(one);
        text += row({one.vector->question.id, std::string(name(one.verdict)), value_text(one.given),
                     one.vector->reject.empty() ? value_text(truth_of(*one.vector)) : "to be rejected",
                     ratio ? rough(*ratio) : "", one.reason});
    }
    return text;
}

std::string diagnosis_rows(const conformance::Diagnosis& d) {
    if (d.wrong == 0) return "";
    std::string text = "\n### Diagnosis\n\n";
    for (const conformance::Finding& f : d.findings)
        text +=
            said("- **", markdown_cell(f.mistake.name), "**",
                 f.mistake.equation.empty() ? "" : ", Eq. (" + f.mistake.equation + ")", ": ", markdown_cell(f.mistake.told),
                 " It explains ", f.explained, " of ", d.wrong, " wrong answers, for example ", f.example->vector->question.id,
                 "; ", contradicted_by(f.contradicted), ". Look at ", markdown_cell(f.mistake.look_at), ".\n");
    if (!d.unexplained.empty()) text += said("- Wrong answers that match no known mistake: ", d.unexplained.size(), ".\n");
    const auto first = std::ranges::find_if(d.chain, [](const conformance::Link& link) { return link.wrong > 0; });
    if (first != d.chain.end())
        text += said("  - The first wrong quantity along the chain is: ", markdown_cell(first->name), ", in ", first->wrong,
                     " of ", first->answered, " answers.\n");
    for (const conformance::Finding& f : d.simple)
        text += said("  - A guess is: ", markdown_cell(f.mistake.told), ". It explains ", f.explained, " of them.\n");
    for (const conformance::InCommon& one : d.in_common)
        text += said("  - Of the first wrong quantity they have in common: ", markdown_cell(one.property), ", in ", one.wrong,
                     " of ", one.all_wrong, ".\n");
    return text;
}

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        switch (c) {
        case '&': safe += "&amp;"; break;
        case '<': safe += "&lt;"; break;
        case '>': safe += "&gt;"; break;
        case '"': safe += "&quot;"; break;
        case '\n': safe += "&#10;"; break;
        default: safe += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
        }
    }
    return safe;
}

std::string attribute(const std::string& name, const std::string& text) { return " " + name + "=\"" + escaped(text) + "\""; }

bool is_error(Verdict verdict) { return verdict == Verdict::crash || verdict == Verdict::timeout || verdict == Verdict::stall; }

std::string case_of(const Judged& one) {
    const std::string start = "  <testcase" + attribute("name", one.vector->question.id) +
                              attribute("classname", one.vector->group + "." + one.vector->question.quantity);
    if (conformance::is_right(one.verdict)) return start + "/>\n";
    const std::string verdict(name(one.verdict));
    const std::string element = one.verdict == Verdict::skipped ? "skipped" : is_error(one.verdict) ? "error" : "failure";
    const std::string message = one.reason.empty() ? verdict : one.reason;
    if (element == "skipped") return start + ">\n   <skipped" + attribute("message", message) + "/>\n  </testcase>\n";
    return start + ">\n   <" + element + attribute("type", verdict) + attribute("message", message) + ">" +
           escaped(answer_text(one, "")) + "</" + element + ">\n  </testcase>\n";
}

} // namespace

std::string report_markdown(const ConformReport& report) {
    std::string text = "## " + markdown_cell(report.subject) + "\n\nMethod: " + report.method + "\n\n" + score_rows(report) +
                       worst_rows(report) + diagnosis_rows(report.diagnosis);
    if (!report.notes.empty()) text += "\n### Notes\n\n";
    for (const std::string& note : report.notes) text += "- " + markdown_cell(note) + "\n";
    if (report.changes) {
        text += "\n### Since the last run\n\n";
        for (const auto& [way, changes] : {std::pair("worse", &report.changes->worse), {"better", &report.changes->better}})
            for (const Change& c : *changes) text += said("- ", way, ": ", c.id, ", ", name(c.before), " to ", name(c.now), "\n");
        if (report.changes->worse.empty() && report.changes->better.empty()) text += "Nothing changed.\n";
    }
    return text + "\n" + markdown_cell(conclusion(report)) + "\n";
}

std::string report_junit(const ConformReport& report) {
    struct Suite {
        std::size_t tests = 0, failures = 0, errors = 0, skipped = 0;
        std::string cases;
    };
    std::map<std::string, Suite> suites;
    Suite all;
    for (const Judged& one : report.judged) {
        for (Suite* suite : {&suites[one.vector->group], &all}) {
            ++suite->tests;
            suite->skipped += one.verdict == Verdict::skipped;
            suite->errors += is_error(one.verdict);
            suite->failures += conformance::is_wrong_value(one.verdict) || one.verdict == Verdict::not_rejected;
        }
        suites[one.vector->group].cases += case_of(one);
    }
    const auto counts = [](const Suite& s) {
        return attribute("tests", std::to_string(s.tests)) + attribute("failures", std::to_string(s.failures)) +
               attribute("errors", std::to_string(s.errors)) + attribute("skipped", std::to_string(s.skipped));
    };
    std::string text =
        said("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites", attribute("name", report.subject), counts(all), ">\n");
    const std::string found = diagnosis_text(report.diagnosis) + "\n" + conclusion(report) + "\n";
    for (const auto& [group, suite] : suites)
        text += said(" <testsuite", attribute("name", group), counts(suite), ">\n", suite.cases,
                     suite.failures > 0 ? "  <system-out>" + escaped(found) + "</system-out>\n" : "", " </testsuite>\n");
    return text + "</testsuites>\n";
}

} // namespace denhartog::program

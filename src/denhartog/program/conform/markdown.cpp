#include <algorithm>

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
        "\n### Worst answers\n\n" + row({"id", "verdict", "answer", "true", "error over tolerance", "why"}) + rule(6);
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
        text += "- **" + markdown_cell(f.mistake->name) + "**" +
                (f.mistake->equation.empty() ? "" : ", Eq. (" + f.mistake->equation + ")") + ": " +
                markdown_cell(f.mistake->told) + " It explains " + std::to_string(f.explained) + " of " +
                std::to_string(d.wrong) + " wrong answers, for example " + f.example->vector->question.id + "; " +
                contradicted_by(f.contradicted) + ". Look at " + markdown_cell(f.mistake->look_at) + ".\n";
    if (!d.unexplained.empty())
        text += "- Wrong answers that match no known mistake: " + std::to_string(d.unexplained.size()) + ".\n";
    const auto first = std::find_if(d.chain.begin(), d.chain.end(), [](const conformance::Link& link) { return link.wrong > 0; });
    if (first != d.chain.end())
        text += "  - The first wrong quantity along the chain is: " + markdown_cell(first->name) + ", in " +
                std::to_string(first->wrong) + " of " + std::to_string(first->answered) + " answers.\n";
    for (const conformance::Simple& simple : d.simple)
        text +=
            "  - A guess is: " + markdown_cell(simple.told) + ". It explains " + std::to_string(simple.explained) + " of them.\n";
    for (const conformance::InCommon& one : d.in_common)
        text += "  - They have in common: " + markdown_cell(one.property) + ", in " + std::to_string(one.wrong) + " of " +
                std::to_string(one.all_wrong) + ".\n";
    return text;
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
            for (const Change& c : *changes)
                text += std::string("- ") + way + ": " + c.id + ", " + std::string(name(c.before)) + " to " +
                        std::string(name(c.now)) + "\n";
        if (report.changes->worse.empty() && report.changes->better.empty()) text += "Nothing changed.\n";
    }
    if (!report.cut_short.empty()) text += "\nCut short: " + markdown_cell(report.cut_short) + ".\n";
    const bool good = report.status() == 0;
    return text + (report.broken ? "\nThe program broke.\n" : good ? "\nConforms.\n" : "\nDoes not conform.\n");
}

} // namespace denhartog::program

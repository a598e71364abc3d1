// The report of a conformance run for people, as text and as Markdown, and in XML for programs that show test results. Read
// `report_text` first; `report_markdown` and `report_junit` say the same in their forms.
#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <span>

#include "conformance/verdict.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/program/conform/conform.hpp"
#include "denhartog/program/json/number_json.hpp"

namespace denhartog::program {
namespace {

using namespace conformance;

constexpr std::size_t worst_told = 10, most_of_a_quantity = 2;

std::string rough(double x) { return number_in_digits(x, 2); }

// Digits of an answer to one decimal, or a dash.
std::string digits_cell(const std::optional<double>& digits) {
    if (!digits) return "-";
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.1f", *digits);
    return text.data();
}

// Numbers or a regime in a line: decimal with hexadecimal where there is one number, long lists cut short.
std::string value_text(const Value& value) {
    constexpr std::size_t most = 4;
    const std::size_t count = value.numbers.size();
    if (!value.word.empty()) return value.word;
    if (count == 0) return "nothing";
    if (count == 1) return number_to_text(value.numbers.front()) + " (" + hexadecimal_float(value.numbers.front()) + ")";
    return joined(std::span(value.numbers).first(std::min(count, most)), ", ") +
           (count > most ? said(" and ", count - most, " more") : "");
}

// Verdicts and digits by tier and group, as cells; `none` stands for a count of zero.
Rows score_cells(const ConformReport& report, const std::string& worst, const std::string& none) {
    const Counts total = counts_of(report.judged);
    Rows rows{{"tier", "group", "asked"}};
    for (std::size_t n = 0; n < total.size(); ++n)
        if (total[n] > 0) rows.front().emplace_back(name(static_cast<Verdict>(n)));
    rows.front().insert(rows.front().end(), {"median digits", worst});
    for (const Score& score : scores(report.judged)) {
        rows.push_back({score.tier, score.group, std::to_string(score.asked)});
        for (std::size_t n = 0; n < total.size(); ++n)
            if (total[n] > 0) rows.back().push_back(score.counts[n] > 0 ? std::to_string(score.counts[n]) : none);
        rows.back().insert(rows.back().end(), {digits_cell(score.median_digits), digits_cell(score.worst_digits)});
    }
    return rows;
}

std::string answers_are(std::size_t count) { return count == 1 ? "1 answer is" : said(count, " answers are"); }

std::string of_equation(const Mistake& m) { return m.equation.empty() ? "" : ", Eq. (" + m.equation + ")"; }

std::string contradicted_by(std::size_t answers) {
    if (answers == 0) return "no answer contradicts it";
    return answers == 1 ? "1 answer contradicts it" : said(answers, " answers contradict it");
}

std::string condition_text(const Vector& v) {
    std::vector<std::string> inputs;
    for (const auto& [input, number] : v.condition) inputs.push_back(input + " " + rough(number));
    return inputs.empty() ? "" : "; condition " + joined(inputs, ", ");
}

// The number that has the error, where an answer has several.
std::string numbers_text(const Judged& one, const std::string& indent) {
    const Vector& v = *one.vector;
    const auto single = [](double x) { return value_text({{x}, ""}); };
    if (one.error && v.nearest.size() > 1)
        return said(indent, "answer ", single(one.given.numbers[one.worst]), ", number ", one.worst + 1, " of ", v.nearest.size(),
                    "\n", indent, "true   ", single(v.nearest[one.worst]), "\n");
    return said(one.answered ? indent + "answer " + value_text(one.given) + "\n" : "", indent, "true   ",
                v.reject.empty() ? value_text(truth_of(v)) : "to be rejected: " + v.reject, "\n");
}

// Common parts of several answers: the reason, if there is one, and their scenes.
std::string group_of(const Judged& one) {
    const std::string reason = one.reason.find("finite") != std::string::npos ? "not finite" : std::string(name(one.verdict));
    return reason + (is_overdamped(one.vector->question) ? ", overdamped" : "") +
           (one.vector->regime.empty() ? "" : ", " + one.vector->regime);
}

// Right in kind everywhere: no mistake is to be looked for.
std::string digits_text(const ConformReport& report) {
    const std::size_t inaccurate = counts_of(report.judged)[static_cast<std::size_t>(Verdict::inaccurate)];
    if (inaccurate == 0 || inaccurate != report.diagnosis.wrong) return "";
    const Judged& worst = *std::ranges::max_element(
        report.judged, {}, [](const Judged& one) { return one.verdict == Verdict::inaccurate ? one.error.value_or(0) : -1; });
    return said("\nDigits are missing in ", inaccurate, " answers, and nothing else is wrong. The worst has ",
                digits_cell(digits(*worst.error)), " digits: ", worst.vector->question.id, ", ", worst.vector->question.quantity,
                ".\n");
}

std::string worst_text(const ConformReport& report) {
    const std::vector<const Judged*> worst = worst_first(report.judged);
    if (worst.empty()) return "";
    std::map<std::string, std::size_t> groups, told_by_quantity;
    std::vector<const Judged*> told;
    for (const Judged* one : worst) {
        ++groups[group_of(*one)];
        const bool more = told.size() < worst_told && told_by_quantity[one->vector->question.quantity]++ < most_of_a_quantity;
        if (report.options.verbose || worst.size() <= worst_told || more) told.push_back(one);
    }
    std::string text =
        "\nWrong answers" + (told.size() < worst.size() ? said(", ", told.size(), " of ", worst.size()) : "") + ":\n";
    if (told.size() < worst.size())
        for (const auto& [group, count] : groups) text += said("  ", count, " ", group, "\n");
    for (const Judged* one : told) text += answer_text(*one, "  ");
    return text;
}

std::string finding_text(const Finding& f, std::size_t number, std::size_t wrong) {
    const Mistake& m = f.mistake;
    return said("  ", number, ". ", m.name, of_equation(m), ": ", m.told, "\n     It explains ", f.explained, " of ", wrong,
                " wrong answers (", joined(f.quantities, ", "), "); ", contradicted_by(f.contradicted), ".",
                f.weak ? "\n     This is weak evidence, because few answers are wrong." : "",
                m.number.empty() ? "" : "\n     Your answers show its number: " + m.number + ".", "\n     Look at ", m.look_at,
                ".", m.equation.empty() ? "" : "\n     See its statement and correction: denhartog equations " + m.equation,
                "\n     An example is ", f.example->vector->question.id, ":\n       answer        ", value_text(f.example->given),
                "\n       this mistake  ", value_text(f.mistaken), "\n       true          ",
                value_text(truth_of(*f.example->vector)), "\n");
}

auto first_wrong(const std::vector<InCommon>& chain) {
    return std::ranges::find_if(chain, [](const InCommon& link) { return link.wrong > 0; });
}

// Right links of the chain of quantities, and the first that is wrong.
std::string chain_text(const std::vector<InCommon>& chain) {
    const auto first = first_wrong(chain);
    if (first == chain.end()) return "";
    std::vector<std::string> right;
    for (auto link = chain.begin(); link != first; ++link) right.push_back(link->property);
    return said("    Along the chain of quantities the first wrong one is: ", first->property, ", in ", first->wrong, " of ",
                first->asked, " answers.", right.empty() ? "" : " Before it all is right: " + joined(right, ", ") + ".", "\n");
}

// Explanation of wrong answers.
std::string diagnosis_text(const Diagnosis& d) {
    std::string text;
    if (d.wrong > 0) text += said("\nDiagnosis (", answers_are(d.wrong), " wrong or inaccurate):\n");
    for (std::size_t n = 0; n < d.findings.size(); ++n) text += finding_text(d.findings[n], n + 1, d.wrong);
    if (!d.unexplained.empty()) {
        text += said("  Wrong answers that match no known mistake: ", d.unexplained.size(), ".\n", chain_text(d.chain));
        for (const InCommon& one : d.in_common)
            text += said("    These have in common: ", one.property, ", in ", one.wrong, " of the ", one.all_wrong,
                         ". Of all answers to these quantities ", one.asked, " of ", one.all_asked, " have it.\n");
        for (const Finding& f : d.simple)
            text += said("    A guess is: ", f.mistake.told, ". It explains ", f.explained, " of them (",
                         joined(f.quantities, ", "), "); ", contradicted_by(f.contradicted), ".\n");
        for (const InCommon& one : d.by_quantity)
            text += said("    For ", one.property, " they are ", one.wrong, " of the ", one.asked, " answers.\n");
    }
    for (const auto& [rule, count] : d.accepted)
        text += said(text.empty() ? "\n" : "", "  Questions that the program answered although they break a rule: ", count, " (",
                     rule, ").\n");
    return text;
}

std::string changes_text(const Comparison& changes, bool verbose) {
    std::string text = said("\nSince the last run: ", changes.better.size(), " better, ", changes.worse.size(), " worse\n");
    for (const auto& [way, list] : {std::pair("worse ", &changes.worse), {"better", &changes.better}}) {
        const std::size_t told = verbose ? list->size() : std::min(list->size(), worst_told);
        for (const Change& c : std::span(*list).first(told))
            text += said("  ", way, " ", c.id, ": ", name(c.before), " -> ", name(c.now), "\n");
        if (told < list->size()) text += said("  ", way, " and ", list->size() - told, " more, which --verbose lists\n");
    }
    return text;
}

// A sentence: whether it conforms, and how many answers of other tiers are wrong.
std::string conclusion(const ConformReport& report) {
    if (report.broken) return "The program broke.";
    if (!report.cut_short.empty()) return "Cut short: " + report.cut_short + ". No verdict on the whole.";
    if (!report.conforms) {
        const bool any = std::ranges::any_of(report.judged, [](const Judged& one) { return one.verdict != Verdict::skipped; });
        return said("Does not conform", any ? "" : ", because no question was answered", ".");
    }
    std::string beyond;
    for (const char* tier : {"should", "stress"})
        if (const std::size_t wrong = report.wrong_in(tier); wrong > 0)
            beyond += said(beyond.empty() ? " in must; " : ", ", answers_are(wrong), " wrong in ", tier);
    return "Conforms" + beyond + (report.status() == 1 ? ", but something got worse." : ".");
}

// A cell whose text cannot end it.
std::string markdown_cell(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (std::string_view("|<`*\\[").find(c) != std::string_view::npos) safe += '\\';
        safe += c;
    }
    return safe;
}

// A table under its heading.
std::string table(const Rows& rows) {
    std::string text;
    for (const std::vector<std::string>& cells : rows) {
        text += "|";
        for (const std::string& one : cells) text += " " + markdown_cell(one) + " |";
        text += "\n";
        if (&cells != &rows.front()) continue;
        text += "|";
        for (std::size_t n = 0; n < cells.size(); ++n) text += "---|";
        text += "\n";
    }
    return text;
}

std::string worst_rows(const ConformReport& report) {
    constexpr std::size_t most = 20;
    const std::vector<const Judged*> worst = worst_first(report.judged);
    if (worst.empty()) return "";
    Rows rows{{"id", "verdict", "answer", "true", "error over tolerance", "why"}};
    for (std::size_t n = 0; n < worst.size() && (report.options.verbose || n < most); ++n) {
        const Judged& one = *worst[n];
        const auto ratio = error_over_tolerance(one);
        rows.push_back({one.vector->question.id, std::string(name(one.verdict)), value_text(one.given),
                        one.vector->reject.empty() ? value_text(truth_of(*one.vector)) : "to be rejected",
                        ratio ? rough(*ratio) : "", one.reason});
    }
    return "\n### Wrong answers\n\n" + table(rows);
}

// Text under a heading, as it is.
std::string quoted(const std::string& heading, const std::string& text) {
    return text.empty() ? "" : "\n### " + heading + "\n\n```" + text + "```\n";
}

std::string escaped(const std::string& text) {
    const std::map<char, std::string> entities{{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\n', "&#10;"}};
    std::string safe;
    for (const char c : text) {
        const auto entity = entities.find(c);
        safe += entity != entities.end() ? entity->second : std::string(1, static_cast<unsigned char>(c) < 0x20 ? '?' : c);
    }
    return safe;
}

std::string attribute(const std::string& name, const std::string& text) { return " " + name + "=\"" + escaped(text) + "\""; }

std::string case_of(const Judged& one) {
    const std::string start = "  <testcase" + attribute("name", one.vector->question.id) +
                              attribute("classname", one.vector->group + "." + one.vector->question.quantity);
    if (is_right(one.verdict)) return start + "/>\n";
    const std::string verdict(name(one.verdict)), message = attribute("message", one.reason.empty() ? verdict : one.reason);
    if (one.verdict == Verdict::skipped) return start + ">\n   <skipped" + message + "/>\n  </testcase>\n";
    const std::string element = is_broken(one.verdict) ? "error" : "failure";
    return start + ">\n   <" + element + attribute("type", verdict) + message + ">" + escaped(answer_text(one, "")) + "</" +
           element + ">\n  </testcase>\n";
}

} // namespace

std::size_t ConformReport::wrong_in(std::string_view tier) const {
    return static_cast<std::size_t>(std::ranges::count_if(judged, [&](const Judged& one) {
        return one.vector->tier == tier && !is_right(one.verdict) && one.verdict != Verdict::skipped;
    }));
}

int ConformReport::status() const {
    if (broken) return 3;
    if (!conforms || (changes && !changes->worse.empty())) return 1;
    return options.strict && wrong_in("should") + wrong_in("stress") > 0 ? 4 : 0;
}

std::string answer_text(const Judged& one, const std::string& indent) {
    const Vector& v = *one.vector;
    std::string text = said(indent, v.question.id, "  ", name(one.verdict), one.equation.empty() ? "" : " (" + one.equation + ")",
                            "  ", v.question.quantity, ", ", v.tier, "\n");
    const std::string inner = indent + "  ";
    if (!one.reason.empty()) text += inner + one.reason + "\n";
    if (one.verdict == Verdict::skipped) return text;
    text += numbers_text(one, inner);
    if (one.error)
        text += said(inner, "error ", rough(*one.error), ", over tolerance ", rough(error_over_tolerance(one).value_or(0)),
                     condition_text(v), "\n");
    return text;
}

std::string report_text(const ConformReport& report) {
    const bool own = report.options.method == methods().front().name;
    std::string text = said(report.name, report.dialect.empty() ? "" : " (" + report.dialect + ")", ": ", report.judged.size(),
                            " questions", own ? "" : ", judged by what " + report.options.method + " can do", "\n\n",
                            aligned(score_cells(report, "worst", ".")), worst_text(report), digits_text(report),
                            diagnosis_text(report.diagnosis));
    if (report.options.verbose) {
        text += "\nAll other answers:\n";
        for (const Judged& one : report.judged)
            if (is_right(one.verdict) || one.verdict == Verdict::skipped) text += answer_text(one, "  ");
    }
    if (!report.notes.empty()) text += "\nNotes:\n";
    for (const std::string& note : report.notes) text += "  " + note + "\n";
    if (report.changes) text += changes_text(*report.changes, report.options.verbose);
    return text + "\n" + conclusion(report) + "\n";
}

std::string report_markdown(const ConformReport& report) {
    std::string text = "## " + markdown_cell(report.name) + "\n\nMethod: " + report.options.method + "\n\n" +
                       table(score_cells(report, "worst digits", "0")) + worst_rows(report) +
                       quoted("Diagnosis", diagnosis_text(report.diagnosis));
    if (!report.notes.empty()) text += "\n### Notes\n\n";
    for (const std::string& note : report.notes) text += "- " + markdown_cell(note) + "\n";
    if (report.changes) text += quoted("Since the last run", changes_text(*report.changes, true));
    return text + "\n" + markdown_cell(conclusion(report)) + "\n";
}

std::string report_junit(const ConformReport& report) {
    std::map<std::string, std::vector<Judged>> suites;
    for (const Judged& one : report.judged) suites[one.vector->group].push_back(one);
    const auto is_failure = [](const Judged& one) { return is_wrong_value(one.verdict) || one.verdict == Verdict::not_rejected; };
    const auto counts = [&](std::span<const Judged> all) {
        const auto count = [&](const auto& of_kind) { return std::to_string(std::ranges::count_if(all, of_kind)); };
        return attribute("tests", std::to_string(all.size())) + attribute("failures", count(is_failure)) +
               attribute("errors", count([](const Judged& one) { return is_broken(one.verdict); })) +
               attribute("skipped", count([](const Judged& one) { return one.verdict == Verdict::skipped; }));
    };
    std::string text = said("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites", attribute("name", report.name),
                            counts(report.judged), ">\n");
    const std::string found = diagnosis_text(report.diagnosis) + "\n" + conclusion(report) + "\n";
    for (const auto& [group, all] : suites) {
        text += said(" <testsuite", attribute("name", group), counts(all), ">\n");
        for (const Judged& one : all) text += case_of(one);
        const bool failed = std::ranges::any_of(all, is_failure);
        text += said(failed ? "  <system-out>" + escaped(found) + "</system-out>\n" : "", " </testsuite>\n");
    }
    return text + "</testsuites>\n";
}

} // namespace denhartog::program

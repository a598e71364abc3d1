#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <span>

#include "conformance/method.hpp"
#include "conformance/verdict.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/program/conform/report.hpp"
#include "denhartog/program/json/number_json.hpp"

namespace denhartog::program {
namespace {

using conformance::Judged;
using conformance::Verdict;

constexpr std::size_t worst_told = 10, most_of_a_quantity = 2;

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

std::string condition_text(const conformance::Vector& v) {
    std::string text;
    for (const auto& [input, number] : v.condition) text += (text.empty() ? "condition " : ", ") + input + " " + rough(number);
    return text;
}

// The number that has the error, where an answer has several.
std::string numbers_text(const Judged& one, const std::string& indent) {
    const conformance::Vector& v = *one.vector;
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
    std::size_t inaccurate = 0;
    const Judged* worst = nullptr;
    for (const Judged& one : report.judged) {
        if (one.verdict != Verdict::inaccurate) continue;
        ++inaccurate;
        if (worst == nullptr || one.error.value_or(0) > worst->error.value_or(0)) worst = &one;
    }
    if (worst == nullptr || inaccurate != report.diagnosis.wrong) return "";
    return said("\nDigits are missing in ", inaccurate, " answers, and nothing else is wrong. The worst has ",
                digits_cell(conformance::digits(*worst->error)), " digits: ", worst->vector->question.id, ", ",
                worst->vector->question.quantity, ".\n");
}

std::string worst_text(const ConformReport& report) {
    const std::vector<const Judged*> worst = conformance::worst_first(report.judged);
    if (worst.empty()) return "";
    std::map<std::string, std::size_t> groups, told_by_quantity;
    std::vector<const Judged*> told;
    for (const Judged* one : worst) {
        ++groups[group_of(*one)];
        const bool more = told.size() < worst_told && told_by_quantity[one->vector->question.quantity]++ < most_of_a_quantity;
        if (report.verbose || worst.size() <= worst_told || more) told.push_back(one);
    }
    std::string text =
        "\nWrong answers" + (told.size() < worst.size() ? said(", ", told.size(), " of ", worst.size()) : "") + ":\n";
    if (told.size() < worst.size())
        for (const auto& [group, count] : groups) text += said("  ", count, " ", group, "\n");
    for (const Judged* one : told) text += answer_text(*one, "  ");
    return text;
}

std::string finding_text(const conformance::Finding& f, std::size_t number, std::size_t wrong) {
    const conformance::Mistake& m = f.mistake;
    return said("  ", number, ". ", m.name, m.equation.empty() ? "" : ", Eq. (" + m.equation + ")", ": ", m.told,
                "\n     It explains ", f.explained, " of ", wrong, " wrong answers (", joined(f.quantities), "); ",
                contradicted_by(f.contradicted), ".",
                f.weak ? "\n     This is weak evidence, because few answers are wrong." : "",
                m.number.empty() ? "" : "\n     Your answers show its number: " + m.number + ".", "\n     Look at ", m.look_at,
                ".", m.equation.empty() ? "" : "\n     See its statement and correction: denhartog equations " + m.equation,
                "\n     An example is ", f.example->vector->question.id, ":\n       answer        ", value_text(f.example->given),
                "\n       this mistake  ", value_text(f.mistaken), "\n       true          ",
                value_text(truth_of(*f.example->vector)), "\n");
}

// Right links of the chain of quantities, and the first that is wrong.
std::string chain_text(const std::vector<conformance::Link>& chain) {
    std::string right;
    for (const conformance::Link& link : chain) {
        if (link.wrong > 0)
            return said("    Along the chain of quantities the first wrong one is: ", link.name, ", in ", link.wrong, " of ",
                        link.answered, " answers.", right.empty() ? "" : " Before it all is right: " + right + ".", "\n");
        right += (right.empty() ? "" : ", ") + link.name;
    }
    return "";
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

std::string method_text(const ConformReport& report) {
    const bool own = report.method == conformance::methods().front().name;
    return own ? "" : ", judged by what " + report.method + " can do";
}

std::string all_skipped(const ConformReport& report) {
    const bool any = std::ranges::any_of(report.judged, [](const Judged& one) { return one.verdict != Verdict::skipped; });
    return any ? "" : ", because no question was answered";
}

} // namespace

std::string rough(double x) { return number_in_digits(x, 2); }

std::string digits_cell(const std::optional<double>& digits) {
    if (!digits) return "-";
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.1f", *digits);
    return text.data();
}

std::string value_text(const conformance::Value& value) {
    constexpr std::size_t most = 4;
    if (!value.word.empty()) return value.word;
    if (value.numbers.empty()) return "nothing";
    if (value.numbers.size() == 1)
        return number_to_text(value.numbers.front()) + " (" + conformance::hexadecimal_float(value.numbers.front()) + ")";
    std::string text;
    for (std::size_t n = 0; n < value.numbers.size() && n < most; ++n)
        text += (n > 0 ? ", " : "") + number_to_text(value.numbers[n]);
    const std::size_t rest = value.numbers.size() - std::min(value.numbers.size(), most);
    return text + (rest > 0 ? " and " + std::to_string(rest) + " more" : "");
}

conformance::Value truth_of(const conformance::Vector& v) { return {v.nearest, v.word}; }

Rows score_cells(const ConformReport& report, const std::string& worst, const std::string& none) {
    const conformance::Counts total = conformance::counts_of(report.judged);
    Rows rows{{"tier", "group", "asked"}};
    for (std::size_t n = 0; n < total.size(); ++n)
        if (total[n] > 0) rows.front().emplace_back(conformance::name(static_cast<Verdict>(n)));
    rows.front().insert(rows.front().end(), {"median digits", worst});
    for (const conformance::Score& score : conformance::scores(report.judged)) {
        rows.push_back({score.tier, score.group, std::to_string(score.asked)});
        for (std::size_t n = 0; n < total.size(); ++n)
            if (total[n] > 0) rows.back().push_back(score.counts[n] > 0 ? std::to_string(score.counts[n]) : none);
        rows.back().insert(rows.back().end(), {digits_cell(score.median_digits), digits_cell(score.worst_digits)});
    }
    return rows;
}

std::string diagnosis_text(const conformance::Diagnosis& d) {
    std::string text;
    if (d.wrong > 0) text += said("\nDiagnosis (", answers_are(d.wrong), " wrong or inaccurate):\n");
    for (std::size_t n = 0; n < d.findings.size(); ++n) text += finding_text(d.findings[n], n + 1, d.wrong);
    if (!d.unexplained.empty()) {
        text += said("  Wrong answers that match no known mistake: ", d.unexplained.size(), ".\n", chain_text(d.chain));
        for (const conformance::InCommon& one : d.in_common)
            text += said("    These have in common: ", one.property, ", in ", one.wrong, " of the ", one.all_wrong,
                         ". Of all answers to these quantities ", one.asked, " of ", one.all_asked, " have it.\n");
        for (const conformance::Finding& f : d.simple)
            text += said("    A guess is: ", f.mistake.told, ". It explains ", f.explained, " of them (", joined(f.quantities),
                         "); ", contradicted_by(f.contradicted), ".\n");
        for (const conformance::InCommon& one : d.by_quantity)
            text += said("    For ", one.property, " they are ", one.wrong, " of the ", one.asked, " answers.\n");
    }
    for (const auto& [rule, count] : d.accepted)
        text += said(text.empty() ? "\n" : "", "  Questions that the program answered although they break a rule: ", count, " (",
                     rule, ").\n");
    return text;
}

std::string answers_are(std::size_t count) { return count == 1 ? "1 answer is" : said(count, " answers are"); }

std::size_t ConformReport::wrong_in(std::string_view tier) const {
    return static_cast<std::size_t>(std::ranges::count_if(judged, [&](const Judged& one) {
        return one.vector->tier == tier && !conformance::is_right(one.verdict) && one.verdict != Verdict::skipped;
    }));
}

int ConformReport::status() const {
    if (broken) return 3;
    if (!conforms || (changes && !changes->worse.empty())) return 1;
    return strict && wrong_in("should") + wrong_in("stress") > 0 ? 4 : 0;
}

std::string conclusion(const ConformReport& report) {
    if (report.broken) return "The program broke.";
    if (!report.cut_short.empty()) return "Cut short: " + report.cut_short + ". No verdict on the whole.";
    if (!report.conforms) return "Does not conform" + all_skipped(report) + ".";
    std::string beyond;
    for (const char* tier : {"should", "stress"})
        if (const std::size_t wrong = report.wrong_in(tier); wrong > 0)
            beyond += said(beyond.empty() ? " in must; " : ", ", answers_are(wrong), " wrong in ", tier);
    return "Conforms" + beyond + (report.status() == 1 ? ", but something got worse." : ".");
}

std::string contradicted_by(std::size_t answers) {
    if (answers == 0) return "no answer contradicts it";
    return answers == 1 ? "1 answer contradicts it" : said(answers, " answers contradict it");
}

std::string answer_text(const Judged& one, const std::string& indent) {
    const conformance::Vector& v = *one.vector;
    std::string text = said(indent, v.question.id, "  ", name(one.verdict), one.equation.empty() ? "" : " (" + one.equation + ")",
                            "  ", v.question.quantity, ", ", v.tier, "\n");
    const std::string inner = indent + "  ";
    if (!one.reason.empty()) text += inner + one.reason + "\n";
    if (one.verdict == Verdict::skipped) return text;
    text += numbers_text(one, inner);
    if (one.error)
        text += said(inner, "error ", rough(*one.error), ", over tolerance ",
                     rough(conformance::error_over_tolerance(one).value_or(0)),
                     v.condition.empty() ? "" : "; " + condition_text(v), "\n");
    return text;
}

std::string report_text(const ConformReport& report) {
    std::string text = said(report.subject, report.dialect.empty() ? "" : " (" + report.dialect + ")", ": ", report.judged.size(),
                            " questions", method_text(report), "\n\n", aligned(score_cells(report, "worst", ".")),
                            worst_text(report), digits_text(report), diagnosis_text(report.diagnosis));
    if (report.verbose) {
        text += "\nAll other answers:\n";
        for (const Judged& one : report.judged)
            if (conformance::is_right(one.verdict) || one.verdict == Verdict::skipped) text += answer_text(one, "  ");
    }
    if (!report.notes.empty()) text += "\nNotes:\n";
    for (const std::string& note : report.notes) text += "  " + note + "\n";
    if (report.changes) text += changes_text(*report.changes, report.verbose);
    return text + "\n" + conclusion(report) + "\n";
}

} // namespace denhartog::program

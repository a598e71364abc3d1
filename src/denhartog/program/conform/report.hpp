// The report on an implementation, in four formats; the verdicts that are kept from run to run.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/diagnose.hpp"

namespace denhartog::program {

// Texts and numbers of things, one after the other.
template <class... Parts>
[[nodiscard]] std::string said(const Parts&... parts) {
    std::ostringstream text;
    (text << ... << parts);
    return text.str();
}

// Verdicts by id.
using Verdicts = std::map<std::string, conformance::Verdict>;

// A verdict that changed for better or worse.
struct Change {
    std::string id; // the vector
    conformance::Verdict before, now;
};

// This run beside the file of earlier ones, by id.
struct Comparison {
    std::vector<Change> better, worse;
};

// The verdicts of a file; none where there is no file yet. Throws InputError where it cannot be read or is no such file.
[[nodiscard]] std::optional<Verdicts> tracked_verdicts(const std::string& path);

// Compares a run with a file.
[[nodiscard]] Comparison compare(const Verdicts& before, std::span<const conformance::Judged> judged);

// The text of a file of verdicts: those of a run, and the earlier ones of vectors that were not asked.
[[nodiscard]] std::string tracked_text(Verdicts before, std::span<const conformance::Judged> judged);

// Findings about an implementation.
struct ConformReport {
    std::string subject;                     // the name that the program gives itself, or the file of answers
    std::string command;                     // as a shell takes it; empty for a file
    std::string method;                      // by which the answers were judged
    std::string dialect;                     // `json` or `plain`; empty for a file
    std::vector<conformance::Judged> judged; // the verdicts
    conformance::Diagnosis diagnosis;        // what is the matter
    std::vector<std::string> notes;          // breaches of the protocol that decide no verdict
    std::vector<std::string> needed;         // quantities that must not be skipped
    std::optional<Comparison> changes;       // against earlier runs
    bool conforms = false;                   // nothing is to be said against it
    bool broken = false;                     // the program broke over and over
    bool verbose = false;                    // every answer is told
    bool strict = false;                     // answers of other tiers than must have to be right as well
    std::string cut_short;                   // why not every question was asked; empty where all were

    // Answers of a tier that are not right, skipped ones left out.
    [[nodiscard]] std::size_t wrong_in(std::string_view tier) const;

    // The exit status.
    [[nodiscard]] int status() const;
};

// The report as text for people, as Markdown, as JSON (docs/conformance-output.md), and as XML for programs that show test results:
// a test case a vector, a suite a group.
[[nodiscard]] std::string report_text(const ConformReport& report);
[[nodiscard]] std::string report_markdown(const ConformReport& report);
[[nodiscard]] std::string report_json(const ConformReport& report);
[[nodiscard]] std::string report_junit(const ConformReport& report);

// One answer for people: verdict and reason, answer and truth, in decimal and hexadecimal, error and condition, each line indented.
[[nodiscard]] std::string answer_text(const conformance::Judged& one, const std::string& indent);

// Explanation of wrong answers.
[[nodiscard]] std::string diagnosis_text(const conformance::Diagnosis& d);

// Conclusion as a sentence: whether it conforms, and how many answers of other tiers are wrong.
[[nodiscard]] std::string conclusion(const ConformReport& report);

// Answers with the verb that follows: `1 answer is`, `7 answers are`.
[[nodiscard]] std::string answers_are(std::size_t count);

// Number of answers that contradict an explanation, as a clause.
[[nodiscard]] std::string contradicted_by(std::size_t answers);

// Verdicts and digits by tier and group, as cells; `none` stands for a count of zero.
[[nodiscard]] std::vector<std::vector<std::string>> score_cells(const ConformReport& report, const std::string& worst,
                                                                const std::string& none);

// A number in two significant digits; digits of an answer in a table, to one decimal or a dash.
[[nodiscard]] std::string rough(double x);
[[nodiscard]] std::string digits_cell(const std::optional<double>& digits);

// Numbers or a regime in a line: decimal with hexadecimal where there is one number, long lists cut short; `nothing` where it is
// empty.
[[nodiscard]] std::string value_text(const conformance::Value& value);

// The true answer of a vector.
[[nodiscard]] conformance::Value truth_of(const conformance::Vector& v);

} // namespace denhartog::program

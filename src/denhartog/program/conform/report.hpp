/// @file
/// @brief The report on an implementation, in four formats.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "conformance/diagnose.hpp"
#include "denhartog/program/conform/track.hpp"

namespace denhartog::program {

/// @brief What was found about an implementation.
struct ConformReport {
    std::string subject;                     ///< the name that the program gives itself, or the file of answers
    std::string command;                     ///< as a shell takes it; empty for a file
    std::string method;                      ///< by which the answers were judged
    std::string dialect;                     ///< `json` or `plain`; empty for a file
    std::vector<conformance::Judged> judged; ///< the verdicts
    conformance::Diagnosis diagnosis;        ///< what is the matter
    std::vector<std::string> notes;          ///< breaches of the protocol that decide no verdict
    std::vector<std::string> needed;         ///< quantities that must not be skipped
    std::optional<Comparison> changes;       ///< against earlier runs
    bool conforms = false;                   ///< nothing is to be said against it
    bool broken = false;                     ///< the program broke over and over
    bool verbose = false;                    ///< every answer is told
    std::string cut_short;                   ///< why not every question was asked; empty where all were

    /// @return the exit status
    [[nodiscard]] int status() const { return broken ? 3 : conforms && (!changes || changes->worse.empty()) ? 0 : 1; }
};

/// @brief The report as text for people. @param report the report @return the text
[[nodiscard]] std::string report_text(const ConformReport& report);

/// @brief The report as a page. @param report the report @return Markdown
[[nodiscard]] std::string report_markdown(const ConformReport& report);

/// @brief The report as docs/conformance-output.md has it. @param report the report @return JSON
[[nodiscard]] std::string report_json(const ConformReport& report);

/// @brief The report for programs that show test results: a test case a vector, a suite a group. @param report the report
/// @return XML
[[nodiscard]] std::string report_junit(const ConformReport& report);

/// @brief One answer for people: verdict and reason, answer and truth, in decimal and hexadecimal, error and condition.
/// @param one     the answer
/// @param indent  what every line starts with
/// @return        lines
[[nodiscard]] std::string answer_text(const conformance::Judged& one, const std::string& indent);

/// @brief How many answers contradict an explanation. @param answers their number @return a clause
[[nodiscard]] std::string contradicted_by(std::size_t answers);

/// @brief Words as a shell takes them. @param words a command @return its text
[[nodiscard]] std::string shell_text(const std::vector<std::string>& words);

} // namespace denhartog::program

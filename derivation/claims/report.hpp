/// @file
/// @brief The texts of a run for a reader: the summary on the terminal, the report, and the status that README carries.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace denhartog::derivation {

/// @brief Everything a report is written from.
struct ReportParts {
    nlohmann::json entries;   ///< the ledger, an object an equation
    nlohmann::json summary;   ///< its counts
    nlohmann::json mutants;   ///< counts of the mutated twins
    nlohmann::json agreement; ///< closed form against second witness
    nlohmann::json faults;    ///< sentences; empty where all is green
    nlohmann::json stand_ins; ///< shipped functions that the proofs take by their theorem: name, header, theorem
    nlohmann::json statements = nlohmann::json::array();        ///< what the text says, statement by statement, with verdicts
    nlohmann::json statement_counts = nlohmann::json::object(); ///< how many have which verdict
};

/// @brief The summary for a terminal. @param parts the parts @return lines of text
[[nodiscard]] std::string summary_text(const ReportParts& parts);

/// @brief The report, Markdown with formulas between dollar signs. @param parts the parts @return the text
[[nodiscard]] std::string report_markdown(const ReportParts& parts);

/// @brief The status for README: counts and digits, nothing that changes from run to run. @param parts the parts @return lines
[[nodiscard]] std::string status_markdown(const ReportParts& parts);

/// @brief The first lines of the report: how many equations do not hold, one of them side by side, the costliest.
/// @param p  the parts of the report
/// @return   Markdown, written by every run
[[nodiscard]] std::string found_markdown(const ReportParts& p);

/// @brief Puts content between the two marks `<!-- NAME -->` and `<!-- /NAME -->` of a text.
/// @param text     the text
/// @param name     the name of the marks
/// @param content  what goes between them
/// @return         the text with the content
/// @throws         std::invalid_argument where the marks are missing
[[nodiscard]] std::string with_block(const std::string& text, const std::string& name, const std::string& content);

/// @brief Whether two texts are the same but for the rounding of their numbers: words alike, numbers alike to 9 digits or both
/// below 1e-12 in size, as error bounds are.
/// @param a  a text
/// @param b  another
/// @return   true where they are
[[nodiscard]] bool same_but_for_rounding(const std::string& a, const std::string& b);

} // namespace denhartog::derivation

/// @file
/// @brief Options of `denhartog conform`: which vectors, and how a program is run.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "conformance/session/session.hpp"

namespace CLI {
class App;
} // namespace CLI

namespace denhartog::program {

/// @brief Which vectors.
struct SelectionOptions {
    std::string vectors;             ///< folder
    std::string filter;              ///< regular expression on ids; empty for all
    std::vector<std::string> groups; ///< groups, `systems` for all of systems beyond the paper; empty for those of the paper
    bool systems = false;            ///< those of systems beyond the paper besides
    std::vector<std::string> tiers;  ///< tiers; empty for all
    bool skip_must_fail = false;     ///< without the questions that have to be rejected
};

/// @brief How a program is run and what is left of it.
struct ConformOptions {
    SelectionOptions selection;       ///< which vectors
    std::vector<std::string> command; ///< program and arguments
    std::string answers;              ///< file of answers, in place of a program
    double seconds = 10;              ///< time for an answer
    double total_seconds = 0;         ///< time for all answers; 0: no end
    int jobs = 1;                     ///< processes side by side
    std::vector<std::string> needed;  ///< quantities that must not be skipped
    std::string method;               ///< by which the program answers
    std::string track;                ///< file of verdicts
    std::string repro;                ///< the one question to repeat
    std::string format = "text";      ///< of the report
    std::string output;               ///< file of the report; empty for standard output
    bool verbose = false;             ///< every answer
};

/// @brief Adds the options that choose vectors.
/// @param command  the subcommand
/// @param options  where they go; must outlive the parse
void add_selection_options(CLI::App& command, SelectionOptions& options);

/// @brief Adds PROGRAM and its arguments. @param command the subcommand @param options where they go; must outlive the parse
void add_program_options(CLI::App& command, ConformOptions& options);

/// @brief Adds the options of a report. @param command the subcommand @param options where they go; must outlive the parse
void add_report_options(CLI::App& command, ConformOptions& options);

/// @brief How the program is run.
/// @param options  the options
/// @return         the settings
/// @throws         InputError where a number breaks its rule
[[nodiscard]] conformance::RunSettings run_settings(const ConformOptions& options);

/// @brief The quantities that must not be skipped. @param options the options @return their names
/// @throws InputError for a name that is none
[[nodiscard]] std::set<std::string> needed_quantities(const ConformOptions& options);

/// @brief The vectors that are chosen.
/// @param options  the options
/// @param all      all vectors
/// @return         pointers into them
/// @throws         InputError where an option breaks its rule or no vector is left
[[nodiscard]] std::vector<const conformance::Vector*> selected(const SelectionOptions& options,
                                                               const std::vector<conformance::Vector>& all);

} // namespace denhartog::program

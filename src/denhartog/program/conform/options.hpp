// Options of `denhartog conform`: which vectors, and how a program is run; and what its subcommands do.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "conformance/session/session.hpp"
#include "denhartog/program/exit_status.hpp"

namespace CLI {
class App;
} // namespace CLI

namespace denhartog::program {

// Which vectors.
struct SelectionOptions {
    std::string vectors;             // folder
    std::string filter;              // regular expression on ids; empty for all
    std::vector<std::string> groups; // groups, `systems` for all of systems beyond the paper; empty for those of the paper
    bool systems = false;            // those of systems beyond the paper besides
    std::vector<std::string> tiers;  // tiers; empty for all
    std::vector<std::string> asked;  // quantities; empty for all
    bool skip_must_fail = false;     // without the questions that have to be rejected
};

// Options of a run and of its records.
struct ConformOptions : SelectionOptions {
    std::vector<std::string> command; // program and arguments
    std::string answers;              // file of answers, in place of a program
    double seconds = 10;              // time for an answer
    double total_seconds = 0;         // time for all answers; 0: no end
    int jobs = 1;                     // processes side by side
    std::vector<std::string> needed;  // quantities that must not be skipped
    std::string method;               // by which the program answers
    std::string track;                // file of verdicts
    std::string repro;                // the one question to repeat
    std::string format = "text";      // of the report
    std::string output;               // file of the report; empty for standard output
    bool verbose = false;             // every answer
    bool strict = false;              // a status of its own where answers of other tiers than must are wrong
};

// Adds the options that choose vectors; PROGRAM and its arguments; the options of a report. They must outlive the parse.
void add_selection_options(CLI::App& command, SelectionOptions& options);
void add_program_options(CLI::App& command, ConformOptions& options);
void add_report_options(CLI::App& command, ConformOptions& options);

// Settings of the run. Throws InputError where a number breaks its rule.
[[nodiscard]] conformance::RunSettings run_settings(const ConformOptions& options);

// The quantities that must not be skipped. Throws InputError for a name that is none.
[[nodiscard]] std::set<std::string> needed_quantities(const ConformOptions& options);

// The vectors that are chosen, of all. Throws InputError where an option breaks its rule or no vector is left.
[[nodiscard]] std::vector<const conformance::Vector*> selected(const SelectionOptions& options,
                                                               const std::vector<conformance::Vector>& all);

// The vector of an id. Throws InputError where there is none.
[[nodiscard]] const conformance::Vector& vector_named(const std::string& id, const std::vector<conformance::Vector>& all);

// Words as a shell takes them.
[[nodiscard]] std::string shell_text(const std::vector<std::string>& words);

// `conform run`, its `--repro`, `conform smoke` and `conform grade`. They throw InputError, and BrokenProgram where the program
// cannot be started or does not shake hands.
void conform_run(const ConformOptions& options, ExitStatus& status);
void conform_repro(const ConformOptions& options, ExitStatus& status);
void conform_smoke(const ConformOptions& options, ExitStatus& status);
void conform_grade(const ConformOptions& options, ExitStatus& status);

} // namespace denhartog::program

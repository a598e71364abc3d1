// `denhartog conform`: its options, what its subcommands do, the report on an implementation, and the verdicts that are kept from
// run to run.
#pragma once

#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/diagnose.hpp"
#include "conformance/session/session.hpp"
#include "denhartog/program/exit_status.hpp"

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
struct ConformOptions : SelectionOptions, conformance::RunSettings {
    std::string answers;             // file of answers, in place of a program
    std::vector<std::string> needed; // quantities that must not be skipped
    std::string method;              // by which the program answers
    std::string track;               // file of verdicts
    std::string repro;               // the one question to repeat
    std::string format = "text";     // of the report
    std::string output;              // file of the report; empty for standard output
    bool verbose = false;            // every answer
    bool strict = false;             // a status of its own where answers of other tiers than must are wrong
};

// Throws InputError for a name that is none of a quantity.
void require_quantities(const std::string& option, const std::vector<std::string>& names);

// The vectors that are chosen, of all. Throws InputError where an option breaks its rule or no vector is left.
[[nodiscard]] std::vector<const conformance::Vector*> selected(const SelectionOptions& options,
                                                               const std::vector<conformance::Vector>& all);

// The vector of an id. Throws InputError where there is none.
[[nodiscard]] const conformance::Vector& vector_named(const std::string& id, const std::vector<conformance::Vector>& all);

// `conform run`, its `--repro`, `conform smoke` and `conform grade`. They throw InputError, and BrokenProgram where the program
// cannot be started or does not shake hands.
void conform_run(const ConformOptions& options, ExitStatus& status);
void conform_repro(const ConformOptions& options, ExitStatus& status);
void conform_smoke(const ConformOptions& options, ExitStatus& status);
void conform_grade(const ConformOptions& options, ExitStatus& status);

// Texts and numbers of things, one after the other.
template <class... Parts>
[[nodiscard]] std::string said(const Parts&... parts) {
    std::ostringstream text;
    (text << ... << parts);
    return text.str();
}

// A verdict that changed for better or worse.
struct Change {
    std::string id; // the vector
    conformance::Verdict before, now;
};

// This run beside the file of earlier ones, by id.
struct Comparison {
    std::vector<Change> better, worse;
};

// Findings about an implementation: a conversation with a program, or the answers in a file, which is then the name.
struct ConformReport : conformance::Conversation {
    const ConformOptions& options;
    conformance::Diagnosis diagnosis = {};  // what is the matter
    std::optional<Comparison> changes = {}; // against earlier runs
    bool conforms = false;                  // nothing is to be said against it

    // Answers of a tier that are not right, skipped ones left out.
    [[nodiscard]] std::size_t wrong_in(std::string_view tier) const;

    // The exit status.
    [[nodiscard]] int status() const;
};

// The report as text for people, as Markdown, and as XML for programs that show test results: a test case a vector, a suite a
// group.
[[nodiscard]] std::string report_text(const ConformReport& report);
[[nodiscard]] std::string report_markdown(const ConformReport& report);
[[nodiscard]] std::string report_junit(const ConformReport& report);

// One answer for people: verdict and reason, answer and truth, in decimal and hexadecimal, error and condition, each line
// indented.
[[nodiscard]] std::string answer_text(const conformance::Judged& one, const std::string& indent);

} // namespace denhartog::program

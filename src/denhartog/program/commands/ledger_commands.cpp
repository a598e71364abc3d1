// `denhartog equations` and `denhartog derive`: the verdicts of the derivation on the paper's equations, and its steps. Read
// `show_equations` and `show_derivation`.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <memory>

#include "denhartog/ledger/ledger.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/program/commands/commands.hpp"
#include "denhartog/program/output/files.hpp"

namespace denhartog::program {

namespace {

struct LedgerOptions {
    std::string equation;
    std::string file;
    bool latex = false;
    bool json = false;
};

std::string equation_of(const LedgerOptions& options) {
    return options.equation.empty() ? "" : ledger::asked_equation(options.equation);
}

std::string from_environment(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

void show_equations(const LedgerOptions& options) {
    const std::string equation = equation_of(options);
    const ledger::Ledger found = ledger::read_ledger(
        {options.file, from_environment("DENHARTOG_LEDGER"), derivation_file("ledger.json"), equations_file()});
    const ledger::Json entries = ledger::entries_of(found.entries, equation);
    if (!equation.empty() && entries.empty()) throw InputError("the ledger", "must have the equation", equation, found.file);
    if (!found.from_a_run) report("no derivation has been run here, so every verdict is unknown; run ./verify paper");
    write_standard_output(options.json       ? entries.dump(2) + "\n"
                          : equation.empty() ? ledger::table(entries)
                                             : ledger::card(entries.front()));
}

// Rank of a claim by its distance from the equation asked for: its own first, then those that decide it with others, steps and
// forms last.
int distance_of(const ledger::Json& claim, const std::string& equation) {
    const std::string id = claim.at("claim"), kind = claim.value("kind", "");
    const bool own = id.starts_with(equation + "/"),
               form = kind == "refinement" || kind == "consequence" || kind == "observation";
    return (own ? 0 : 2) + (form ? 1 : 0);
}

void show_derivation(const LedgerOptions& options) {
    const std::string equation = equation_of(options);
    const ledger::Json record =
        ledger::read_derivation(options.file, from_environment("DENHARTOG_DERIVATION"), derivation_file("derivation.json"));
    ledger::Json claims = ledger::entries_of(record, equation);
    if (options.json) return write_standard_output(claims.dump(2) + "\n");
    if (!equation.empty()) {
        std::stable_sort(claims.begin(), claims.end(), [&](const ledger::Json& a, const ledger::Json& b) {
            return distance_of(a, equation) < distance_of(b, equation);
        });
        for (ledger::Json& claim : claims) claim["equation"] = equation; // where a claim speaks of several
    }
    write_standard_output(options.latex ? ledger::derivation_as_latex(claims) : ledger::derivation_as_text(claims, equation));
}

} // namespace

void add_equations_command(CLI::App& app) {
    CLI::App* command = app.add_subcommand("equations", "Show the ledger: what holds of each numbered equation of the paper");
    const auto options = std::make_shared<LedgerOptions>();
    command->add_option("EQUATION", options->equation, "one equation, e.g. 46 or A.7; by default all");
    command->add_flag("--json", options->json, "an array of JSON objects instead of a table");
    command->add_option("--ledger", options->file, "a ledger.json to read instead of the last run's (also: DENHARTOG_LEDGER)");
    command->callback([options] { show_equations(*options); });
}

void add_derive_command(CLI::App& app) {
    CLI::App* command = app.add_subcommand("derive", "Show the steps of the derivation, as text with LaTeX formulas");
    const auto options = std::make_shared<LedgerOptions>();
    command->add_option("EQUATION", options->equation, "one equation, e.g. 46, A.7 or a7; all of them without it");
    CLI::Option* latex = command->add_flag("--latex", options->latex, "a fragment of LaTeX (needs amsmath)");
    command->add_flag("--json", options->json, "an array of JSON objects")->excludes(latex);
    command->add_option("--derivation", options->file,
                        "a derivation.json to read instead of the last run's (also: DENHARTOG_DERIVATION)");
    command->callback([options] { show_derivation(*options); });
}

} // namespace denhartog::program

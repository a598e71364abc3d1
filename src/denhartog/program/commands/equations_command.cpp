#include "denhartog/program/commands/commands.hpp"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <memory>

#include "denhartog/ledger/ledger.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/program/exit_status.hpp"
#include "denhartog/program/output/files.hpp"

namespace denhartog::program {

namespace {

struct EquationsOptions {
    std::string equation;
    std::string file;
    bool json = false;
};

void answer(const EquationsOptions& options) {
    const std::string equation = options.equation.empty() ? "" : ledger::asked_equation(options.equation);
    const char* environment = std::getenv("DENHARTOG_LEDGER");
    const ledger::Ledger found = ledger::read_ledger(
        {options.file, environment == nullptr ? "" : environment, derivation_file("ledger.json"), equations_file()});
    const ledger::Json entries = ledger::entries_of(found.entries, equation);
    if (!equation.empty() && entries.empty()) throw InputError("the ledger", "must have the equation", equation, found.file);
    if (!found.of_a_run) report("no derivation has been run here, so every verdict is unknown; run ./verify paper");
    if (options.json)
        write_standard_output(entries.dump(2) + "\n");
    else
        write_standard_output(equation.empty() ? ledger::table(entries) : ledger::card(entries.front()));
}

} // namespace

void add_equations_command(CLI::App& app) {
    CLI::App* command = app.add_subcommand("equations", "Show the ledger: what holds of each numbered equation of the paper");
    const auto options = std::make_shared<EquationsOptions>();
    command->add_option("EQUATION", options->equation, "one equation, e.g. 46 or A.7; by default all");
    command->add_flag("--json", options->json, "an array of JSON objects instead of a table");
    command->add_option("--ledger", options->file, "a ledger.json to read instead of the last run's (also: DENHARTOG_LEDGER)");
    command->callback([options] { answer(*options); });
}

} // namespace denhartog::program

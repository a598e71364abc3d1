#include "denhartog/program/commands/commands.hpp"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <memory>

#include "denhartog/ledger/derivation_record.hpp"
#include "denhartog/ledger/ledger.hpp"
#include "denhartog/program/files.hpp"
#include "denhartog/program/installed.hpp"

namespace denhartog::program {

namespace {

struct DeriveOptions {
    std::string equation;
    std::string file;
    bool latex = false;
    bool json = false;
};

void answer(const DeriveOptions& options) {
    const std::string equation = options.equation.empty() ? "" : ledger::asked_equation(options.equation);
    const char* environment = std::getenv("DENHARTOG_DERIVATION");
    const ledger::Json record =
        ledger::read_derivation(options.file, environment == nullptr ? "" : environment, derivation_file("derivation.json"));
    const ledger::Json claims = ledger::entries_of(record, equation);
    if (options.json)
        write_standard_output(claims.dump(2) + "\n");
    else
        write_standard_output(options.latex ? ledger::derivation_as_latex(claims) : ledger::derivation_as_text(claims, equation));
}

} // namespace

void add_derive_command(CLI::App& app) {
    CLI::App* command = app.add_subcommand("derive", "Show the steps of the derivation, as text with LaTeX formulas");
    const auto options = std::make_shared<DeriveOptions>();
    command->add_option("EQUATION", options->equation, "one equation, e.g. 46 or A.7; by default all");
    CLI::Option* latex = command->add_flag("--latex", options->latex, "a fragment of LaTeX (needs amsmath)");
    command->add_flag("--json", options->json, "an array of JSON objects")->excludes(latex);
    command->add_option("--derivation", options->file,
                        "a derivation.json to read instead of the last run's (also: DENHARTOG_DERIVATION)");
    command->callback([options] { answer(*options); });
}

} // namespace denhartog::program

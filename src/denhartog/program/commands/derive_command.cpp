#include "denhartog/program/commands/commands.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <memory>

#include "denhartog/ledger/ledger.hpp"
#include "denhartog/program/output/files.hpp"

namespace denhartog::program {

namespace {

struct DeriveOptions {
    std::string equation;
    std::string file;
    bool latex = false;
    bool json = false;
};

/// How near a claim is to the equation asked for: its own first, then those that decide it with others, steps and forms last.
int distance_of(const ledger::Json& claim, const std::string& equation) {
    const std::string id = claim.at("claim"), kind = claim.value("kind", "");
    const bool own = id.starts_with(equation + "/"),
               form = kind == "refinement" || kind == "consequence" || kind == "observation";
    return (own ? 0 : 2) + (form ? 1 : 0);
}

ledger::Json nearest_first(const ledger::Json& claims, const std::string& equation) {
    ledger::Json sorted = claims;
    std::stable_sort(sorted.begin(), sorted.end(), [&](const ledger::Json& a, const ledger::Json& b) {
        return distance_of(a, equation) < distance_of(b, equation);
    });
    return sorted;
}

/// The claims under the number that was asked for, where they speak of several equations.
ledger::Json under_number(ledger::Json claims, const std::string& equation) {
    for (ledger::Json& claim : claims) claim["equation"] = equation;
    return claims;
}

void answer(const DeriveOptions& options) {
    const std::string equation = options.equation.empty() ? "" : ledger::asked_equation(options.equation);
    const char* environment = std::getenv("DENHARTOG_DERIVATION");
    const ledger::Json record =
        ledger::read_derivation(options.file, environment == nullptr ? "" : environment, derivation_file("derivation.json"));
    const ledger::Json found = ledger::entries_of(record, equation);
    if (options.json) return write_standard_output(found.dump(2) + "\n");
    const ledger::Json claims = equation.empty() ? found : under_number(nearest_first(found, equation), equation);
    write_standard_output(options.latex ? ledger::derivation_as_latex(claims) : ledger::derivation_as_text(claims, equation));
}

} // namespace

void add_derive_command(CLI::App& app) {
    CLI::App* command = app.add_subcommand("derive", "Show the steps of the derivation, as text with LaTeX formulas");
    const auto options = std::make_shared<DeriveOptions>();
    command->add_option("EQUATION", options->equation, "one equation, e.g. 46, A.7 or a7; all of them without it");
    CLI::Option* latex = command->add_flag("--latex", options->latex, "a fragment of LaTeX (needs amsmath)");
    command->add_flag("--json", options->json, "an array of JSON objects")->excludes(latex);
    command->add_option("--derivation", options->file,
                        "a derivation.json to read instead of the last run's (also: DENHARTOG_DERIVATION)");
    command->callback([options] { answer(*options); });
}

} // namespace denhartog::program

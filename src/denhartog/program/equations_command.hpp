/// @file
/// @brief `denhartog equations`: the ledger of all numbered equations.
#pragma once

namespace CLI {
class App;
} // namespace CLI

namespace denhartog::program {

/// @brief Adds the subcommand. What is asked for wrongly, or cannot be read, leaves its callback as an InputError.
/// @param app  the program
void add_equations_command(CLI::App& app);

} // namespace denhartog::program

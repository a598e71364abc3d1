/// @file
/// @brief `denhartog boundary`: the friction ratios that bound the regimes.
#pragma once

#include "denhartog/program/exit_status.hpp"

namespace CLI {
class App;
} // namespace CLI

namespace denhartog::program {

/// @brief Adds the subcommand.
/// @param app     the program
/// @param status  where faults are noted
void add_boundary_command(CLI::App& app, ExitStatus& status);

} // namespace denhartog::program

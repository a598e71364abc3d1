/// @file
/// @brief `denhartog solve`: the steady motion in every regime, by the cheapest model that has the digits asked for.
#pragma once

#include "denhartog/program/exit_status.hpp"

namespace CLI {
class App;
} // namespace CLI

namespace denhartog::program {

/// @brief Adds the subcommand.
/// @param app     the program
/// @param status  where faults are noted
void add_solve_command(CLI::App& app, ExitStatus& status);

} // namespace denhartog::program

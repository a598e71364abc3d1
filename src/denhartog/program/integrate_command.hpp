/// @file
/// @brief `denhartog integrate`: the motion from a start over a number of periods, by the paper's algorithm or exactly.
#pragma once

#include "denhartog/program/exit_status.hpp"

namespace CLI {
class App;
} // namespace CLI

namespace denhartog::program {

/// @brief Adds the subcommand.
/// @param app     the program
/// @param status  where faults are noted
void add_integrate_command(CLI::App& app, ExitStatus& status);

} // namespace denhartog::program

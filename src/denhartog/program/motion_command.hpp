/// @file
/// @brief `denhartog motion`: displacements and velocities over one period, as CSV.
#pragma once

#include "denhartog/program/exit_status.hpp"

namespace CLI {
class App;
} // namespace CLI

namespace denhartog::program {

/// @brief Adds the subcommand.
/// @param app     the program
/// @param status  where faults are noted
void add_motion_command(CLI::App& app, ExitStatus& status);

} // namespace denhartog::program

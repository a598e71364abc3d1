/// @file
/// @brief `denhartog response`: regime, amplitude and phase of every mass.
#pragma once

#include "denhartog/program/exit_status.hpp"

namespace CLI {
class App;
} // namespace CLI

namespace denhartog::program {

/// @brief Adds the subcommand.
/// @param app     the program
/// @param status  where faults are noted
void add_response_command(CLI::App& app, ExitStatus& status);

} // namespace denhartog::program

/// @file
/// @brief `denhartog map`: regime, amplitudes and stops over a grid of (r, beta), and boundary curves over r.
#pragma once

#include "denhartog/program/exit_status.hpp"

namespace CLI {
class App;
} // namespace CLI

namespace denhartog::program {

/// @brief Adds the subcommand. What is asked for wrongly, or cannot be read or written, leaves its callback as an InputError.
/// @param app     the program
/// @param status  where faults and an interruption are noted
void add_map_command(CLI::App& app, ExitStatus& status);

} // namespace denhartog::program

/// @file
/// @brief `denhartog functions`: what the response is made of, (22), (23), (28), (29), (33)-(35), (56), (64).
#pragma once

#include "denhartog/program/exit_status.hpp"

namespace CLI {
class App;
} // namespace CLI

namespace denhartog::program {

/// @brief Adds the subcommand.
/// @param app     the program
/// @param status  where faults are noted
void add_functions_command(CLI::App& app, ExitStatus& status);

} // namespace denhartog::program

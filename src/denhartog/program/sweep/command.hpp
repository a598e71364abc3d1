/// @file
/// @brief `denhartog sweep`: a study beyond one machine, chunk by chunk.
#pragma once

#include <string>

#include "denhartog/program/exit_status.hpp"

namespace CLI {
class App;
} // namespace CLI

namespace denhartog::program {

/// @brief `denhartog sweep plan | run | status | merge`.
/// @param app     the program
/// @param status  where faults are noted
/// @param commit  the commit that the program was built from; empty where it is not known
void add_sweep_command(CLI::App& app, ExitStatus& status, const std::string& commit);

} // namespace denhartog::program

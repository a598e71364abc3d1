/// @file
/// @brief `denhartog conform`: another implementation, tested against the certified vectors.
#pragma once

#include <string>
#include <vector>

#include "denhartog/program/exit_status.hpp"

namespace CLI {
class App;
} // namespace CLI

namespace denhartog::program {

/// @brief Adds the subcommand.
/// @param app        the program
/// @param status     where faults are noted
/// @param arguments  the arguments of the program as they came: what follows `--` is taken from here, untouched
void add_conform_command(CLI::App& app, ExitStatus& status, const std::vector<std::string>& arguments);

} // namespace denhartog::program

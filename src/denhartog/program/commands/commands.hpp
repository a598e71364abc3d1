/// @file
/// @brief The subcommands, one source each; how they are added to the program.
#pragma once

#include <string>
#include <vector>

#include "denhartog/program/exit_status.hpp"

namespace CLI {
class App;
} // namespace CLI

namespace denhartog::program {

/// @brief `denhartog solve`: the steady motion in every regime, by the cheapest model that has the digits asked for.
/// @param app     the program
/// @param status  where faults are noted, of this and of every other subcommand
void add_solve_command(CLI::App& app, ExitStatus& status);

/// @brief `denhartog response`: regime, amplitude and phase of every mass.
/// @param app     the program
/// @param status  where faults are noted
void add_response_command(CLI::App& app, ExitStatus& status);

/// @brief `denhartog motion`: displacements and velocities over one period, as CSV.
/// @param app     the program
/// @param status  where faults are noted
void add_motion_command(CLI::App& app, ExitStatus& status);

/// @brief `denhartog boundary`: the friction ratios that bound the regimes.
/// @param app     the program
/// @param status  where faults are noted
void add_boundary_command(CLI::App& app, ExitStatus& status);

/// @brief `denhartog map`: regime, amplitudes and stops over a grid of (r, beta), and boundary curves over r.
/// @param app     the program
/// @param status  where faults are noted
void add_map_command(CLI::App& app, ExitStatus& status);

/// @brief `denhartog integrate`: the motion from a start over a number of periods, by the paper's algorithm or exactly.
/// @param app     the program
/// @param status  where faults are noted
void add_integrate_command(CLI::App& app, ExitStatus& status);

/// @brief `denhartog functions`: what the response is made of, (22), (23), (28), (29), (33)-(35), (56), (64).
/// @param app     the program
/// @param status  where faults are noted
void add_functions_command(CLI::App& app, ExitStatus& status);

/// @brief `denhartog equations`: the ledger of all numbered equations.
/// @param app  the program
/// @throws     InputError from its callback, for what is asked for wrongly or cannot be read
void add_equations_command(CLI::App& app);

/// @brief `denhartog derive`: each step of the derivation.
/// @param app  the program
/// @throws     InputError from its callback, for what is asked for wrongly or cannot be read
void add_derive_command(CLI::App& app);

/// @brief `denhartog describe`: the manual page and the completion of bash, for the build. @param app the program
void add_describe_command(CLI::App& app);

/// @brief `denhartog conform`: another implementation, tested against the certified vectors.
/// @param app        the program
/// @param status     where faults are noted
/// @param arguments  the arguments of the program as they came: what follows `--` is taken from here, untouched
void add_conform_command(CLI::App& app, ExitStatus& status, const std::vector<std::string>& arguments);

} // namespace denhartog::program

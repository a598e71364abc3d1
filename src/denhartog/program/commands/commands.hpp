// The subcommands, and how they are added to the program.
// Faults are noted in the status; InputError comes out of the callbacks.
#pragma once

#include <string>
#include <vector>

#include "denhartog/program/exit_status.hpp"

namespace CLI {
class App;
} // namespace CLI

namespace denhartog::program {

// The steady motion in every regime, by the cheapest model that has the digits asked for.
void add_solve_command(CLI::App& app, ExitStatus& status);
// Regime, amplitude and phase of every mass.
void add_response_command(CLI::App& app, ExitStatus& status);
// Displacements and velocities over one period, as CSV.
void add_motion_command(CLI::App& app, ExitStatus& status);
// The friction ratios that bound the regimes.
void add_boundary_command(CLI::App& app, ExitStatus& status);
// Regime, amplitudes and stops over a grid of (r, beta), and boundary curves over r.
void add_map_command(CLI::App& app, ExitStatus& status);
// The motion from a start over a number of periods, by the paper's algorithm or exactly.
void add_integrate_command(CLI::App& app, ExitStatus& status);
// Values of a number of a scene for which an amplitude is as wanted.
void add_find_command(CLI::App& app, ExitStatus& status);
// Parts of the response, (22), (23), (28), (29), (33)-(35), (56), (64).
void add_functions_command(CLI::App& app, ExitStatus& status);
// The ledger of all numbered equations.
void add_equations_command(CLI::App& app);
// Each step of the derivation.
void add_derive_command(CLI::App& app);
// The manual page and the completion of bash, for the build.
void add_describe_command(CLI::App& app);
// Another implementation, tested against the certified vectors. What follows `--` is taken from the arguments, untouched.
void add_conform_command(CLI::App& app, ExitStatus& status, const std::vector<std::string>& arguments);

} // namespace denhartog::program

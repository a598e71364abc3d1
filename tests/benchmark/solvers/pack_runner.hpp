/// @file
/// @brief Runs a solver over the benchmark's pack and writes its results file, as docs/benchmark.md describes it.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tests/conformance/adapters/solvers/period.hpp"

namespace denhartog::tests {

/// @brief What a solver says of a scene.
struct Ran {
    std::vector<std::vector<double>> x; ///< of each mass at the instants; empty for a mass that the solver does not compute
    std::optional<std::vector<std::array<double, 2>>> stops; ///< starts and ends in tau; none where it does not compute them
};

/// @brief A solver at one setting.
struct PackSolver {
    std::string method;                               ///< e.g. `SUNDIALS CVODE`
    std::string setting;                              ///< e.g. `tolerance 1e-06`
    std::function<Ran(const Scene<double>&)> solve{}; ///< solves a scene; whatever it throws is its failure
};

/// @brief Instants of a period that the pack has.
inline constexpr int pack_instants = 64;

/// @brief A time integrator as a solver of the pack, from rest until the motion has settled. After `budget` processor seconds a
/// scene is given up.
[[nodiscard]] PackSolver settled(const std::string& method, const std::string& setting, TimeIntegrator integrator, double budget);

/// @brief Reads the arguments `SETTING PACK [--budget SECONDS] [--every N] [--from N]`, runs the solver, and writes results to
/// standard output. `make` makes the solver of a setting and a budget, and throws InputError for a setting that is none. Gives
/// the exit status.
int run_pack(int argc, char** argv, const std::function<PackSolver(const std::string& setting, double budget)>& make);

} // namespace denhartog::tests

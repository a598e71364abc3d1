// A motion as a file, in ratios or in the units of the scene.
#pragma once

#include <optional>
#include <string>

#include "denhartog/solve/sampled_solution.hpp"

namespace CLI {
class App;
} // namespace CLI

namespace denhartog::program {

inline constexpr const char* in_ratios = "ratios"; // displacements in units of P / k_1, times in radians of the force
inline constexpr const char* in_scene = "scene";   // the units that the scene was given in

// What the numbers of a motion are multiplied by.
struct MotionUnits {
    double omega;  // angular frequency of the force
    double length; // P / k_1
};

// Adds `--units`, which must outlive the parse.
void add_units_option(CLI::App& command, std::string& units);

// The units that `--units` asks for; none for ratios. Throws InputError where the scene has no such units.
[[nodiscard]] std::optional<MotionUnits> motion_units(const Scene<double>& scene, const std::string& units);

// A motion as CSV: columns tau, x_1 to x_N, v_1 to v_N; in units t in place of tau, and velocities by time.
[[nodiscard]] std::string motion_csv(const SampledSolution& motion, const std::optional<MotionUnits>& units);

} // namespace denhartog::program

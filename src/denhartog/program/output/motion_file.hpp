/// @file
/// @brief A motion as a file, in ratios or in the units of the scene.
#pragma once

#include <optional>
#include <string>

#include "denhartog/solve/sampled_solution.hpp"

namespace CLI {
class App;
} // namespace CLI

namespace denhartog::program {

inline constexpr const char* in_ratios = "ratios"; ///< displacements in units of P / k_1, times in radians of the force
inline constexpr const char* in_scene = "scene";   ///< the units that the scene was given in

/// @brief What the numbers of a motion are multiplied by.
struct MotionUnits {
    double omega;  ///< angular frequency of the force
    double length; ///< P / k_1
};

/// @brief Adds `--units`. @param command the subcommand @param units where it goes; must outlive the parse
void add_units_option(CLI::App& command, std::string& units);

/// @brief The units that `--units` asks for. @param scene the scene, its frequency given @param units the option's value
/// @return none for ratios @throws InputError where the scene has no such units
[[nodiscard]] std::optional<MotionUnits> motion_units(const Scene<double>& scene, const std::string& units);

/// @brief A motion as CSV: columns tau, x_1 to x_N, v_1 to v_N; in units t in place of tau, and velocities by time.
/// @param motion  the motion
/// @param units   what its numbers are multiplied by; none for ratios
/// @return        the text
[[nodiscard]] std::string motion_csv(const SampledSolution& motion, const std::optional<MotionUnits>& units);

} // namespace denhartog::program

// Results as files: a motion, in ratios or in the units of the scene, a regime map, and boundary curves.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "denhartog/map/regime_map.hpp"
#include "denhartog/solve/sampled_solution.hpp"

namespace CLI {
class App;
} // namespace CLI

namespace denhartog::program {

// An axis of a map: frequencies (r, frequency or frequency_hz), or its rows (beta, friction, force or unbalance).
struct MapAxis {
    std::string name; // as the file has it
    std::vector<double> values;
};

// What a file of a map says of its grid.
struct MapGrid {
    MapAxis frequency, rows;
    std::vector<Mass> masses; // whose amplitudes the map has
};

// A map as CSV: a line a point, columns r, beta (or what the axes are called), regime, stops_per_period, periods, amplitude_K for
// each mass K, phase_K likewise where the map has phases, status. A point without numbers has nan in their place and no regime.
[[nodiscard]] std::string map_csv(const MapGrid& grid, const RegimeMap& map);

// A map as NPY: an array of records, frequency ratio by friction ratio, with the columns of the CSV as fields. regime is 0
// continuous, 1 stick_slip, 2 permanent_sticking, -1 none; status 0 answered, 1 on_boundary, 2 not_converged, 3 at_a_pole,
// 4 failed; stops_per_period and periods are -1 where there are no numbers.
[[nodiscard]] std::string map_npy(const MapGrid& grid, const RegimeMap& map);

// Boundary curves: a line or a record for each frequency, r (or the axis's name), exact, paper, approximate, sticking, status.
// sticking is nan where no friction holds the contact.
[[nodiscard]] std::string curves_csv(const MapAxis& axis, const std::vector<BoundaryPoint>& curves);
[[nodiscard]] std::string curves_npy(const MapAxis& axis, const std::vector<BoundaryPoint>& curves);

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

// A motion as CSV: columns tau, x_1 to x_N, v_1 to v_N; in units t in place of tau, and velocities by time. With directions, one an
// instant, a last column `direction`: 1 or -1 as the contact slides, 0 while it sticks.
[[nodiscard]] std::string motion_csv(const SampledSolution& motion, const std::optional<MotionUnits>& units,
                                     const std::vector<int>& directions = {});

// The same as NPY: an array of records with the columns of the CSV as fields.
[[nodiscard]] std::string motion_npy(const SampledSolution& motion, const std::optional<MotionUnits>& units,
                                     const std::vector<int>& directions);

// Whether a file is NPY by its name, and not CSV. Throws InputError where it is neither.
[[nodiscard]] bool as_npy(const std::string& output);

} // namespace denhartog::program

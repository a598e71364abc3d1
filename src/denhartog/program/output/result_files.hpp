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

// Grid of a map, as its file names it.
struct MapGrid {
    MapAxis frequency, rows;
    std::vector<Mass> masses; // whose amplitudes the map has
};

// A column of a table: of numbers, f8, or of integers, i4 or i1. A value of an axis stands for `each` rows, and behind the last the
// axis begins again. In CSV integers may stand for words, from 0 on, and -1 for what is not known.
struct Column {
    std::string name, type;
    std::vector<double> values;
    std::size_t each = 1;
    std::vector<std::string> words{};
    const char* unknown = "-1";
};

// A table of results; NPY has the axes of `shape`, of which the last runs fastest.
struct ResultTable {
    std::vector<Column> columns;
    std::vector<std::size_t> shape;
};

// As CSV, a line a row under the names of the columns; and as NPY, an array of records with the columns as fields.
[[nodiscard]] std::string csv(const ResultTable& table);
[[nodiscard]] std::string npy(const ResultTable& table);

// A map, a row a point, frequency by rows: r, beta (or what the axes are called), regime, stops_per_period, periods, amplitude_K for
// each mass K, phase_K likewise where the map has phases, status. A point without numbers has nan in their place and no regime, which
// is -1 in NPY; regime is 0 continuous, 1 stick_slip, 2 permanent_sticking; status 0 answered, 1 on_boundary, 2 not_converged,
// 3 at_a_pole, 4 failed.
[[nodiscard]] ResultTable map_table(const MapGrid& grid, const RegimeMap& map);

// Boundary curves, a row a frequency: r (or the axis's name), exact, paper, approximate, sticking, status. sticking is nan where no
// friction holds the contact.
[[nodiscard]] ResultTable curves_table(const MapAxis& axis, const std::vector<BoundaryPoint>& curves);

inline constexpr const char* in_ratios = "ratios"; // displacements in units of P / k_1, times in radians of the force
inline constexpr const char* in_scene = "scene";   // the units that the scene was given in

// Factors of the numbers of a motion.
struct MotionUnits {
    double omega;  // angular frequency of the force
    double length; // P / k_1
};

// Adds `--units`, which must outlive the parse.
void add_units_option(CLI::App& command, std::string& units);

// The units that `--units` asks for; none for ratios. Throws InputError where the scene has no such units.
[[nodiscard]] std::optional<MotionUnits> motion_units(const Scene<double>& scene, const std::string& units);

// A motion, a row an instant: tau, x_1 to x_N, v_1 to v_N; in units t in place of tau, and velocities by time. With directions, one an
// instant, a last column `direction`: 1 or -1 as the contact slides, 0 while it sticks.
[[nodiscard]] ResultTable motion_table(const SampledSolution& motion, const std::optional<MotionUnits>& units,
                                       const std::vector<int>& directions = {});

// Whether a file is NPY by its name, and not CSV. Throws InputError where it is neither.
[[nodiscard]] bool as_npy(const std::string& output);

} // namespace denhartog::program

/// @file
/// @brief A regime map and boundary curves as files.
#pragma once

#include <string>
#include <vector>

#include "denhartog/map/regime_map.hpp"

namespace denhartog::program {

/// @brief An axis of a map: frequencies, or friction.
struct MapAxis {
    std::string name;           ///< as the file has it
    std::vector<double> values; ///< along it
};

/// @brief What a file of a map says of its grid.
struct MapGrid {
    MapAxis frequency;        ///< r, or frequency_hz
    MapAxis friction;         ///< beta, or friction
    std::vector<Mass> masses; ///< masses whose amplitudes the map has
};

/// @brief A map as CSV: a line a point, columns r, beta (or what the axes are called), regime, stops_per_period, periods,
/// amplitude_K for each mass K, status.
/// @param grid  the grid
/// @param map   the map
/// @return      the text; a point without numbers has nan in their place and no regime
[[nodiscard]] std::string map_csv(const MapGrid& grid, const RegimeMap& map);

/// @brief A map as NPY: an array of records, frequency ratio by friction ratio, with the columns of the CSV as fields.
///
/// regime is 0 continuous, 1 stick_slip, 2 permanent_sticking, -1 none; status 0 answered, 1 on_boundary, 2 not_converged,
/// 3 at_a_pole, 4 failed; stops_per_period and periods are -1 where there are no numbers.
/// @param grid  the grid
/// @param map   the map
/// @return      the bytes
[[nodiscard]] std::string map_npy(const MapGrid& grid, const RegimeMap& map);

/// @brief Boundary curves as CSV: a line for each frequency, r (or the axis's name), exact, paper, approximate, sticking, status.
/// @param axis    frequencies
/// @param curves  the boundaries there
/// @return        the text; sticking is nan where no friction holds the contact
[[nodiscard]] std::string curves_csv(const MapAxis& axis, const std::vector<BoundaryPoint>& curves);

/// @brief Boundary curves as NPY, an array of records with the columns of the CSV as fields.
/// @param axis    frequencies
/// @param curves  the boundaries there
/// @return        the bytes
[[nodiscard]] std::string curves_npy(const MapAxis& axis, const std::vector<BoundaryPoint>& curves);

} // namespace denhartog::program

// A regime map and boundary curves as files.
#pragma once

#include <string>
#include <vector>

#include "denhartog/map/regime_map.hpp"

namespace denhartog::program {

// An axis of a map: frequencies (r, or frequency_hz), or friction (beta, or friction).
struct MapAxis {
    std::string name; // as the file has it
    std::vector<double> values;
};

// What a file of a map says of its grid.
struct MapGrid {
    MapAxis frequency, friction;
    std::vector<Mass> masses; // whose amplitudes the map has
};

// A map as CSV: a line a point, columns r, beta (or what the axes are called), regime, stops_per_period, periods, amplitude_K for
// each mass K, status. A point without numbers has nan in their place and no regime.
[[nodiscard]] std::string map_csv(const MapGrid& grid, const RegimeMap& map);

// A map as NPY: an array of records, frequency ratio by friction ratio, with the columns of the CSV as fields. regime is 0
// continuous, 1 stick_slip, 2 permanent_sticking, -1 none; status 0 answered, 1 on_boundary, 2 not_converged, 3 at_a_pole,
// 4 failed; stops_per_period and periods are -1 where there are no numbers.
[[nodiscard]] std::string map_npy(const MapGrid& grid, const RegimeMap& map);

// Boundary curves: a line or a record for each frequency, r (or the axis's name), exact, paper, approximate, sticking, status.
// sticking is nan where no friction holds the contact.
[[nodiscard]] std::string curves_csv(const MapAxis& axis, const std::vector<BoundaryPoint>& curves);
[[nodiscard]] std::string curves_npy(const MapAxis& axis, const std::vector<BoundaryPoint>& curves);

} // namespace denhartog::program

/// @file
/// @brief One column of a regime map: all friction ratios at one frequency ratio.
#pragma once

#include <atomic>
#include <span>

#include "denhartog/sliding/steady_state.hpp"
#include "denhartog/map/regime_map.hpp"
#include "denhartog/stick_slip/periodic_orbit.hpp"

namespace denhartog {

/// @brief What the columns of a map share.
struct MapSystem {
    const ContactSystem<double>& system; ///< modes, sliding and stuck
    double mu;                           ///< static over kinetic friction
    MapStart start;                      ///< which motion, where there are several
    const std::vector<double>& beta;     ///< friction ratios
    const std::vector<Mass>& masses;     ///< masses whose amplitudes are wanted
};

/// @brief Computes a column.
/// @param map         what the columns share
/// @param r           frequency ratio
/// @param stop        leaves the rest of the column undone once it is set
/// @param points      where the points go
/// @param amplitudes  where the amplitudes go, filled with NaN before
void compute_column(const MapSystem& map, double r, const std::atomic<bool>& stop, std::span<MapPoint> points,
                    std::span<double> amplitudes);

/// @brief The state of a sliding motion at a maximum of the force, where the exact solver starts.
/// @param sums   modes at the frequency ratio
/// @param state  the sliding motion
/// @return       displacements and velocities at tau = 0 of the force
template <class T>
[[nodiscard]] State<T> at_maximum_of_force(const ModeSums<T>& sums, const SteadyState<T>& state);

} // namespace denhartog

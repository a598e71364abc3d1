/// @file
/// @brief The scenes of the chart: systems with the points that every method is asked.
#pragma once

#include <cstdint>

#include "tests/speed_accuracy/peers/peer.hpp"

namespace denhartog::tests {

/// @brief The chart's scenes.
///
/// SDOF, sliding: zeta = 0.1, r from 0.3 to 2.5, beta below the boundary (69). SDOF, stick-slip: zeta = 0.01, r = 0.1, beta
/// between the boundary and 0.95. 2DOF: the paper's with zeta_i = 0.01/r_n,i, beta = 0.3, r from 0.1 to 3 in equal steps, through
/// all regimes, twice as many points. 5DOF: the paper's with j = 3, l = 1, zeta = 0.1; N = 50: equal masses and springs, j = 10,
/// l = 1, zeta = 0.05, a quarter as many points; in both r from 0.3 to 1.9, beta below the boundary. What is not said is drawn at
/// random. There is at least one point a scene; the same seed gives the same points everywhere.
[[nodiscard]] std::vector<ChartScene> chart_scenes(std::uint64_t seed, int points);

} // namespace denhartog::tests

/// @file
/// @brief Siconos' time stepping on the chart.
#pragma once

#include "tests/speed_accuracy/peers/peer.hpp"

namespace denhartog::tests {

/// @brief Siconos' Moreau-Jean scheme, theta = 1/2, with friction as a relay, 100 to 100000 steps a period.
///
/// The scheme's relay bounds are impulses, beta times the step; and it looks at a contact only where a gap is below zero, so that
/// the relation between relay and displacement has an offset that no motion reaches. A peer a number of steps; one without a
/// method where Siconos was not there to build with.
[[nodiscard]] std::vector<Peer> siconos_peers();

} // namespace denhartog::tests

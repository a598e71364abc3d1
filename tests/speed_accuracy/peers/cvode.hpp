/// @file
/// @brief SUNDIALS CVODE on the chart.
#pragma once

#include "tests/speed_accuracy/peers/peer.hpp"

namespace denhartog::tests {

/// @brief CVODE, Adams' methods, with its root finding at the ends of sliding and sticking, at tolerances from 1e-3 to 1e-12.
///
/// A step is at most a sixteenth of a period long: while the contact of a single mass sticks no error bounds it, and whole
/// periods would be skipped. Ends of phases restart the integrator. A peer a tolerance; one without a method where SUNDIALS was
/// not there to build with.
[[nodiscard]] std::vector<Peer> cvode_peers();

} // namespace denhartog::tests

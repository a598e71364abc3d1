/// @file
/// @brief The monoharmonic approximation: the contact moves harmonically, friction is its own first harmonic.
#pragma once

#include "tests/speed_accuracy/peers/peer.hpp"

namespace denhartog::tests {

/// @brief Equivalent linearisation with the first harmonic \f$ 4\beta/\pi \f$ of a square wave, in closed form. One method,
/// without settings.
[[nodiscard]] std::vector<Peer> monoharmonic_peers();

} // namespace denhartog::tests

/// @file
/// @brief The regime that an integration over time has come to.
#pragma once

#include "denhartog/paper_algorithm/paper_algorithm.hpp"
#include "denhartog/sliding/regime.hpp"

namespace denhartog {

/// @brief The regime of the last period. A stop that has not ended by then counts, though it is not yet among the stops.
/// @param motion  a complete motion
/// @return        the regime; of the steady motion only where that has been reached
[[nodiscard]] inline Regime regime_seen(const PaperMotion& motion) {
    if (motion.rests) return Regime::permanent_sticking;
    return motion.slides ? Regime::continuous : Regime::stick_slip;
}

} // namespace denhartog

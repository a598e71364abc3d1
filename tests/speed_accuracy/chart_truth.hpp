/// @file
/// @brief The truth at a point of the chart and how far a method is from it.
#pragma once

#include "denhartog/sliding/boundary.hpp"
#include "tests/speed_accuracy/peers/peer.hpp"

namespace denhartog::tests {

/// @brief The truth at a point.
struct ChartTruth {
    Regime regime = Regime::continuous; ///< the regime
    PeerAnswer answer;                  ///< X_j to 40 digits, certain to `solve`
    double condition = 0;               ///< relative change of X_j over that of r and of beta, both added
};

/// @brief The truth at a point: `solve` asked for 40 digits, which it takes from two precisions or from a residual; its change
/// with r and beta by central differences.
[[nodiscard]] ChartTruth truth_at(const System<double>& system, const ChartPoint& point);

/// @brief Distance of an answer from the truth, relative, in 100 digits. Where the contact rests for ever its place is not asked
/// for: zero. It is at least 1e-36, which is as far as the truth is trusted.
[[nodiscard]] double error_of(const PeerAnswer& answer, const ChartTruth& truth);

} // namespace denhartog::tests

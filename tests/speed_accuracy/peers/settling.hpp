/// @file
/// @brief When an integration of the chart may end: the period repeats itself to a tolerance, or damping says that it must.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "tests/speed_accuracy/peers/peers.hpp"

namespace denhartog::tests {

/// @brief Follows the states at the ends of periods.
class Settling {
public:
    /// @brief With the `slowest_decay` of the system; the tolerance is the wanted size of what is left of transients.
    Settling(double decay, double r, double tolerance)
        : most_(cycles_needed(decay, r, tolerance)), allowed_(-std::expm1(-2 * std::numbers::pi * decay / r) * tolerance) {}

    /// @brief Takes note of the end of a period. A transient that shrinks by rho a period is \f$ 1/(1-\rho) \f$ times as large as
    /// what it changes in one. Whether the motion has settled.
    bool settled(std::span<const double> state) {
        double change = 0, size = 0;
        for (std::size_t n = 0; n < state.size(); ++n) {
            change = std::max(change, last_.empty() ? 1 : std::abs(state[n] - last_[n]));
            size = std::max(size, std::abs(state[n]));
        }
        last_.assign(state.begin(), state.end());
        return ++cycles_ >= most_ || (cycles_ > 2 && change <= allowed_ * size);
    }

private:
    int most_, cycles_ = 0;
    double allowed_;
    std::vector<double> last_;
};

} // namespace denhartog::tests

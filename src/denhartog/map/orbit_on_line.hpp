/// @file
/// @brief Where the next orbit of a column of a map is looked for: on the line through the two before.
#pragma once

#include <cmath>
#include <optional>

#include "denhartog/stick_slip/motion_record.hpp"

namespace denhartog {

/// @brief A periodic orbit by its state at tau = 0, with its friction ratio.
struct OrbitAt {
    State<double> start; ///< the state
    double beta;         ///< the friction ratio
};

/// @brief The state on the line through two orbits at a friction ratio; none far from both, or where one is missing.
[[nodiscard]] inline std::optional<State<double>> on_line_through(const std::optional<OrbitAt>& a,
                                                                  const std::optional<OrbitAt>& b, double beta) {
    if (!a || !b) return std::nullopt;
    const double part = (beta - b->beta) / (b->beta - a->beta);
    if (!(std::abs(part) <= 2)) return std::nullopt;
    State<double> z = b->start;
    for (std::size_t k = 0; k < z.x.size(); ++k) {
        z.x[k] += part * (b->start.x[k] - a->start.x[k]);
        z.x_prime[k] += part * (b->start.x_prime[k] - a->start.x_prime[k]);
    }
    return z;
}

} // namespace denhartog

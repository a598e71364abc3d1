/// @file
/// @brief Integrators as people write them: friction as a function of velocity in the right-hand side, no events.
///
/// From rest until two successive periods agree to the setting's tolerance or 400 have passed; the answer is the maximum of the
/// period after that. The equations are integrated in modal coordinates, where a right-hand side costs least.
#pragma once

#include "tests/speed_accuracy/peers/peer.hpp"

namespace denhartog::tests {

/// @brief A setting of a plain integrator.
struct PlainSetting {
    double eps = 0;       ///< friction is beta tanh(v / eps), v in units of y_0 a radian; 0: beta sgn(v)
    int steps = 0;        ///< fixed steps a period, Runge-Kutta of fourth order; 0: fifth order, step size controlled
    double tolerance = 0; ///< absolute and relative error of a controlled step; to which two periods agree
    /// As many fixed steps as stability asks for where friction is steepest, and at least `steps`.
    bool stable = false;
};

/// @brief Right-hand sides after which an integrator counts as stalled.
inline constexpr long most_plain_evaluations = 4'000'000;

/// @brief The integrator at one setting. @param setting the setting @return the method; its unit of work is a right-hand side
[[nodiscard]] Peer plain_integrator(const PlainSetting& setting);

/// @brief sgn(v), and tanh(v/eps) for eps from 1e-2 to 1e-6, by both integrators. @return the methods
[[nodiscard]] std::vector<Peer> plain_integrator_peers();

} // namespace denhartog::tests

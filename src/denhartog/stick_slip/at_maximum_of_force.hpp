/// @file
/// @brief The state of a steady motion in closed form at a maximum of the force, where the exact solver starts.
#pragma once

#include <utility>

#include "denhartog/sliding/coupled_sums.hpp"
#include "denhartog/sliding/steady_state.hpp"
#include "denhartog/stick_slip/motion_record.hpp"

namespace denhartog {

/// @brief The state of a sliding motion where the force is largest. @eq{46}
[[nodiscard]] inline State at_maximum_of_force(const ModeSums<double>& sums, const SteadyState<double>& state) {
    Motion<double> at = motion(sums, state, -state.phi_j);
    const std::size_t N = sums.coupled ? sums.coupled->size() : sums.R.size();
    at.x.resize(N); // the coordinates of the system, and no displacements besides
    at.x_prime.resize(N);
    return {std::move(at.x), std::move(at.x_prime)};
}

/// @brief State of the sliding motion at a maximum of the force, at a friction ratio. @eq{46}
[[nodiscard]] inline State sliding_at_maximum_of_force(const ModeSums<double>& sums, double beta) {
    return at_maximum_of_force(sums, steady_state_without_maxima(sums, beta));
}

} // namespace denhartog

/// @file
/// @brief The state of a steady motion in closed form at a maximum of the force, where the exact solver starts.
#pragma once

#include <utility>

#include "denhartog/sliding/steady_state.hpp"
#include "denhartog/stick_slip/motion_record.hpp"
#include "denhartog/stick_slip/stuck_response.hpp"
#include "denhartog/sums/coupled_friction.hpp"

namespace denhartog {

/// @brief The state of a sliding motion. @eq{46}
/// @param sums   modes at the frequency ratio
/// @param state  the sliding motion
/// @return       displacements and velocities where the force is largest
template <class T>
[[nodiscard]] State<T> at_maximum_of_force(const ModeSums<T>& sums, const SteadyState<T>& state) {
    Motion<T> at = motion(sums, state, T(-state.phi_j));
    const std::size_t N = sums.coupled ? sums.coupled->size() : sums.R.size();
    at.x.resize(N); // the coordinates of the system, and no displacements besides
    at.x_prime.resize(N);
    return {std::move(at.x), std::move(at.x_prime)};
}

/// @brief The state of the sliding motion at a friction ratio. @eq{46}
/// @param sums  modes at the frequency ratio
/// @param beta  friction ratio
/// @return      displacements and velocities where the force is largest
template <class T>
[[nodiscard]] State<T> sliding_at_maximum_of_force(const ModeSums<T>& sums, const T& beta) {
    return at_maximum_of_force(sums, steady_state_without_maxima(sums, beta));
}

/// @brief The state while the contact rests at zero.
/// @param stuck  the motion
/// @return       displacements and velocities where the force is largest
template <class T>
[[nodiscard]] State<T> at_maximum_of_force(const StuckResponse<T>& stuck) {
    State<T> state;
    for (const StuckMass<T>& mass : stuck.masses) {
        state.x.push_back(mass.X.re);
        state.x_prime.push_back(-mass.X.im);
    }
    return state;
}

} // namespace denhartog

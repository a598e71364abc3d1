/// @file
/// @brief What the errors of a motion make of the instants at which its phases end.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {

/// @brief The highest natural frequency over that of the force. @param solver the solver of the motion @return it, or 1 if that is more
template <class T>
[[nodiscard]] T highest_over_force(const ExactSolver<T>& solver) {
    return std::max(T(1), T(solver.system().basis.r_n.back() / solver.excitation().r));
}

/// @brief Errors at the ends of phases. A phase of sliding ends where the velocity of the contact is zero, one of sticking where the
/// load on it is what static friction holds; both are known within what the errors of the motion make of them.
template <class T>
struct ErrorsAtEnds {
    T fastest;     ///< highest natural frequency over that of the force, at least 1: of accelerations over velocities
    T of_velocity; ///< error of the velocity of the contact
    T of_load;     ///< error of the load on it while it sticks, in units of P

    /// @param solver        the solver of the motion
    /// @param displacement  bound of the errors of its displacements
    /// @param velocity      bounds of the errors of its velocities, one a coordinate
    ErrorsAtEnds(const ExactSolver<T>& solver, const T& displacement, const std::vector<T>& velocity)
        : fastest(highest_over_force(solver)), of_velocity(velocity[solver.system().contact.index]) {
        using std::abs;
        const StuckConfiguration<T>& stuck = solver.system().stuck;
        const T& r = solver.excitation().r;
        of_load = abs(stuck.k_jj) * displacement;
        for (std::size_t n = 0; n < stuck.masses.size(); ++n)
            of_load += abs(stuck.k_j[n]) * displacement +
                       (r * abs(stuck.c_j[n]) + r * r * abs(stuck.m_j[n]) * fastest) * velocity[stuck.masses[n].index];
    }

    /// @brief How far the end of a phase may be from where it was found: over twice as far that which ends it bends too little to
    /// hide that it changes by more than its error on either side.
    /// @param end     how the phase ends
    /// @param slides  whether the contact slides in it
    /// @return        the error; infinite where that which ends it may not reach zero at all
    [[nodiscard]] T of_instant(const EndOfPhase<T>& end, bool slides) const {
        const T apart = 4 * ((slides ? of_velocity : of_load) + end.noise) / (3 * end.rate);
        return end.rate > 0 && 4 * end.second * apart <= end.rate ? apart : std::numeric_limits<T>::infinity();
    }
};

} // namespace denhartog

/// @file
/// @brief What the errors of a motion make of the instants at which its phases end.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {

/// @brief The highest natural frequency over that of the force. @param solver the solver of the motion @return it, or 1 if that is more
[[nodiscard]] inline double highest_over_force(const ExactSolver& solver) {
    return std::max(1.0, solver.system().basis.r_n.back() / solver.excitation().r);
}

/// @brief Errors at the ends of phases. A phase of sliding ends where the velocity of the contact is zero, one of sticking where the
/// load on it is what static friction holds; both are known within what the errors of the motion make of them.
struct ErrorsAtEnds {
    double fastest;     ///< highest natural frequency over that of the force, at least 1: of accelerations over velocities
    double of_velocity; ///< error of the velocity of the contact
    double of_load;     ///< error of the load on it while it sticks, in units of P

    /// @param solver        the solver of the motion
    /// @param displacement  bound of the errors of its displacements
    /// @param velocity      bounds of the errors of its velocities, one a coordinate
    ErrorsAtEnds(const ExactSolver& solver, double displacement, const std::vector<double>& velocity)
        : fastest(highest_over_force(solver)), of_velocity(velocity[solver.system().contact.index]) {
        const StuckConfiguration<double>& stuck = solver.system().stuck;
        const double r = solver.excitation().r;
        of_load = std::abs(stuck.k_jj) * displacement;
        for (std::size_t n = 0; n < stuck.masses.size(); ++n)
            of_load += std::abs(stuck.k_j[n]) * displacement +
                       (r * std::abs(stuck.c_j[n]) + r * r * std::abs(stuck.m_j[n]) * fastest) * velocity[stuck.masses[n].index];
    }

    /// @brief How far the end of a phase may be from where it was found: over twice as far that which ends it bends too little to
    /// hide that it changes by more than its error on either side.
    /// @param end     how the phase ends
    /// @param slides  whether the contact slides in it
    /// @return        the error; infinite where that which ends it may not reach zero at all
    [[nodiscard]] double of_instant(const EndOfPhase& end, bool slides) const {
        const double apart = 4 * ((slides ? of_velocity : of_load) + end.noise) / (3 * end.rate);
        return end.rate > 0 && 4 * end.second * apart <= end.rate ? apart : std::numeric_limits<double>::infinity();
    }
};

} // namespace denhartog

/// @file
/// @brief What the exact solver computes with: a phase at a time, the motion so far, and its derivative with respect to the start.
#pragma once

#include "denhartog/stick_slip/contact_phases.hpp"

namespace denhartog {

/// @brief Deviations of the state over the 2N deviations of the start, carried through phases and events.
///
/// Within a phase deviations obey the motion without its forces. At an event the instant shifts with them, and the acceleration
/// jumps there: what the shift adds is the jump times the shift, along the accelerations that a force on the contact makes.
struct Deviations {
    Matrix<double> dx; ///< deviations of displacements, N x 2N
    Matrix<double> dv; ///< deviations of velocities, N x 2N

    /// @brief Starts from those of the state itself. If the contact sticks its velocity cannot deviate: an impulse of friction
    /// takes that away, and has the others move with it that inertia ties to the contact.
    /// @param phases the phases @param direction of the first one
    void start(const ContactPhases& phases, int direction);
    /// @brief Carries them over a phase. @param phases evaluated at its end @param direction of it @param event how it ends
    void carry(ContactPhases& phases, int direction, const Event& event);

private:
    Matrix<double> dq, dp; // of modal coordinates and velocities

    void carry_stuck(ContactPhases& phases, const Event& event);
    void shift(const Column<double>& w, double jump, const Matrix<double>& d_tau);
};

/// @brief What the solver computes with.
struct ExactSolver::Work : ContactPhases {
    Effort own;            ///< the work allowed where nobody else allows any
    ExactMotion motion;    ///< the last motion, as far as it came
    Deviations deviations; ///< of its end, where they were asked for

    /// @param s the system @param excitation frequency and friction
    Work(const ContactSystem& s, const Excitation& excitation) : ContactPhases(s, excitation, own) {}

    /// @brief The motion from the state x, v. @param tau_0 its instant @param tau_1 the end @param with_jacobian as asked
    void run(double tau_0, double tau_1, bool with_jacobian);
    /// @brief Takes the start of a phase of the motion into coordinates. @param phase its index
    void stand_at(std::size_t phase);
};

} // namespace denhartog

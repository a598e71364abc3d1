/// @file
/// @brief Working data of the exact solver: the two kinds of phases of one system at one excitation, the events that end them,
/// the motion so far, and its derivative with respect to the start.
///
/// A phase is a stretch of linear motion in modal coordinates: those of the system while the contact slides, those of the stuck
/// configuration while it sticks. Sliding ends where the velocity of the contact is zero, sticking where the load on the
/// contact leaves what static friction can hold, (74), (75).
#pragma once

#include <utility>
#include <vector>

#include "denhartog/evaluation/even_samples.hpp"
#include "denhartog/search/zeros.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"
#include "denhartog/stick_slip/linear_motion.hpp"

namespace denhartog {

/// @brief The phases of one system at one excitation, one at a time. A direction is 1 or -1 as the contact slides, 0 if it sticks.
struct ContactPhases {
    const ContactSystem* system; ///< the system
    Excitation e{};              ///< frequency and friction
    std::size_t N;               ///< number of masses
    LinearMotion sliding;        ///< the motion while the contact slides
    LinearMotion sticking;       ///< the motion while it sticks
    Column w;                    ///< M^-1 w / r^2: accelerations that a unit force on the contact makes
    double inertia;              ///< of the contact, r^2 / (w^T M^-1 w)
    double rest = 0;             ///< where the contact rests in a phase of sticking
    Column k_j;                  ///< stiffness that the stuck modes bring to the contact
    Column c_j;                  ///< damping that they bring
    Column m_j;                  ///< inertia that they bring
    double load_per_energy;      ///< bound of a derivative of the load on the contact over the energy norm of that order
    double load_rest;            ///< what the inertia of the others adds to that bound
    double load_growth;          ///< how fast the bound grows
    Complex<double> direct;      ///< part of the force that acts on the contact itself
    double size_of_direct;       ///< its amplitude
    double step;                 ///< a step that the search for events took
    std::vector<double> x;       ///< displacements at the start of the phase
    std::vector<double> v;       ///< velocities at the start of the phase
    int touching = 0;            ///< events so tangential that rounding decided them
    Effort* effort;              ///< what the evaluations spend

    /// @brief Of a system, whose evaluations spend the work allowed.
    ContactPhases(const ContactSystem& s, const Excitation& excitation, Effort& allowed);

    /// @brief Sets frequency and friction anew. InputError if one breaks its rule.
    void set(const Excitation& excitation);

    /// @brief Takes the state at the start of a phase, at tau, into the coordinates of its motion.
    void start_phase(int direction, double tau);

    /// @brief Displacement, velocity or acceleration, by order 0 to 2, of every mass at the instant last evaluated.
    void masses_of(int direction, int order, std::vector<double>& out) const;

    /// @brief The motion of the masses from the start of the phase, at tau, that was taken into coordinates last.
    [[nodiscard]] evaluation::LinearSum motion_of_masses(int direction, double tau) const;

    /// @brief Velocity of the contact in the direction of the phase, at a time from its start.
    Jet velocity(int direction, double t);
    /// @brief Load on the contact while it sticks, friction apart, (75), at a time from the start of the phase.
    Jet load(double t);

    /// @brief The end of a sliding phase: its velocity is zero. `length` of the stretch is left; the zero at its start is of
    /// `order`.
    Event end_of_sliding(int direction, double length, int order);
    /// @brief The end of a sticking phase of a single mass: the load on it is p cos tau - k_jj x_j, whose passage out of the cone
    /// has a closed form.
    Event end_of_sticking_alone(double tau, double length);
    /// @brief The end of a sticking phase: the load on the contact exceeds static friction, (74).
    Event end_of_sticking(double length);

    /// @brief Direction of the first phase of a stretch, from the velocity or else from the load on the contact, and the order of
    /// the zero of the velocity there.
    std::pair<int, int> first_direction(double tau);

private:
    void set_mode(LinearMotion& m, std::size_t i, double r_n, double half_damping) const; // decay rate over omega_1, zeta r_n
    void set_sticking(double r2);
};

/// @brief Deviations of the state over the 2N deviations of the start, carried through phases and events.
///
/// Within a phase deviations obey the motion without its forces. At an event the instant shifts with them, and the acceleration
/// jumps there: what the shift adds is the jump times the shift, along the accelerations that a force on the contact makes.
struct Deviations {
    Matrix<double> dx; ///< deviations of displacements, N x 2N
    Matrix<double> dv; ///< deviations of velocities, N x 2N

    /// @brief Starts from those of the state itself, with a phase of that direction. If the contact sticks its velocity cannot
    /// deviate: an impulse of friction takes that away, and has the others move with it that inertia ties to the contact.
    void start(const ContactPhases& phases, int direction);
    /// @brief Carries them over a phase that ends with the event, `phases` being evaluated there.
    void carry(ContactPhases& phases, int direction, const Event& event);

private:
    Matrix<double> dq, dp; // of modal coordinates and velocities

    void carry_stuck(ContactPhases& phases, const Event& event);
    void shift(const Column& w, double jump, const Matrix<double>& d_tau);
};

/// @brief Working space of the solver.
struct ExactSolver::Work : ContactPhases {
    Effort own;            ///< the work allowed if no other budget is set
    ExactMotion motion;    ///< the last motion, as far as it came
    Deviations deviations; ///< of its end, if they were asked for

    /// @brief Of a system.
    Work(const ContactSystem& s, const Excitation& excitation) : ContactPhases(s, excitation, own) {}

    /// @brief The motion from the state x, v.
    void run(double tau_0, double tau_1, bool with_jacobian);
    /// @brief Takes the start of a phase of the motion into coordinates.
    void stand_at(std::size_t phase);
};

} // namespace denhartog

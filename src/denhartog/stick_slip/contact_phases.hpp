/// @file
/// @brief The two kinds of phases of one system at one excitation, and the events that end them.
///
/// A phase is a stretch of linear motion in modal coordinates: those of the system while the contact slides, those of the stuck
/// configuration while it sticks. Sliding ends where the velocity of the contact is zero, sticking where the load on the
/// contact leaves what static friction can hold, (74), (75).
#pragma once

#include <utility>
#include <vector>

#include "denhartog/search/first_zero.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"
#include "denhartog/stick_slip/linear_motion.hpp"

namespace denhartog {

/// @brief The phases of one system at one excitation, one at a time. A direction is 1 or -1 as the contact slides, 0 if it sticks.
struct ContactPhases {
    const ContactSystem* system;   ///< the system
    Excitation e{};                ///< frequency and friction
    std::size_t N;                 ///< number of masses
    LinearMotion sliding;          ///< the motion while the contact slides
    LinearMotion sticking;         ///< the motion while it sticks
    Column<double> w;              ///< M^-1 w / r^2: accelerations that a unit force on the contact makes
    double inertia;                ///< of the contact, r^2 / (w^T M^-1 w)
    double rest = 0;               ///< where the contact rests in a phase of sticking
    Column<double> k_j;            ///< stiffness that the stuck modes bring to the contact
    Column<double> c_j;            ///< damping that they bring
    Column<double> m_j;            ///< inertia that they bring
    double load_per_energy;        ///< bound of a derivative of the load on the contact over the energy norm of that order
    double load_rest;              ///< what the inertia of the others adds to that bound
    double load_growth;            ///< how fast the bound grows
    double direct;                 ///< part of the force that acts on the contact itself
    double step;                   ///< a step that the search for events took
    std::vector<double> x;         ///< displacements at the start of the phase
    std::vector<double> v;         ///< velocities at the start of the phase
    int touching = 0;              ///< events so tangential that rounding decided them
    Effort* effort;                ///< what the evaluations spend

    /// @param s the system @param excitation frequency and friction @param allowed the work allowed
    ContactPhases(const ContactSystem& s, const Excitation& excitation, Effort& allowed);

    /// @brief Sets frequency and friction anew. @param excitation frequency and friction @throws InputError
    void set(const Excitation& excitation);

    /// @brief The state at the start of a phase, taken into the coordinates of its motion.
    /// @param direction of the phase @param tau instant of the start
    void start_phase(int direction, double tau);

    /// @brief Displacement, velocity or acceleration of every mass at the instant last evaluated.
    /// @param direction of the phase @param order 0 to 2 @param out gets a value a mass
    void masses_of(int direction, int order, std::vector<double>& out) const;

    /// @brief Velocity of the contact in the direction of the phase.
    /// @param direction 1 or -1 @param t time from the start of the phase @return value, three derivatives and their bounds
    Jet<double> velocity(int direction, double t);
    /// @brief What the contact carries while it sticks: everything but friction.
    /// @param t time from the start of the phase @return value, three derivatives and their bounds
    Jet<double> load(double t);

    /// @brief Where a sliding phase ends: its velocity is zero.
    /// @param direction 1 or -1 @param length of the stretch that is left @param order of the zero at its start @return the event
    Event end_of_sliding(int direction, double length, int order);
    /// @brief Where a sticking phase of a single mass ends: the load on it is p cos tau - k_jj x_j, whose passage out of the cone
    /// has a closed form. @param tau instant of the start @param length of the stretch that is left @return the event
    Event end_of_sticking_alone(double tau, double length);
    /// @brief Where a sticking phase ends: the load on the contact is more than friction holds.
    /// @param length of the stretch that is left @return the event
    Event end_of_sticking(double length);

    /// @brief Direction of the first phase of a stretch, from the velocity or else from the load on the contact.
    /// @param tau instant of the start @return the direction, and the order of the zero of the velocity there
    std::pair<int, int> first_direction(double tau);

private:
    void set_mode(LinearMotion& m, std::size_t i, double r_n, double half_damping) const; // decay rate over omega_1, zeta r_n
    void set_sticking(double r2);
};

} // namespace denhartog

/// @file
/// @brief One phase of a motion with stops: how the masses move in it, and what ends it.
///
/// While the contact slides, (6) is linear in the modes of the system; while it sticks, in those of the stuck configuration:
/// \f$ q_i'' + \sum_m D_{im} q_m' + \omega_i^2 q_i = F_i\cos(\tau+\theta_i) + G_i \f$.
/// Sliding ends where the velocity of the contact is zero, sticking where the load on it leaves what static friction can hold,
/// (74), (75). Read `LinearMotion` first, then `ContactPhases`.
#pragma once

#include <array>
#include <boost/container/small_vector.hpp>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include "denhartog/evaluation/driven_motion.hpp"
#include "denhartog/evaluation/even_samples.hpp"
#include "denhartog/model/coupled_motion.hpp"
#include "denhartog/search/zeros.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {

inline constexpr double eps = std::numeric_limits<double>::epsilon(); ///< distance of 1 from the next double

/// @brief A view of numbers as a column, to be read or written.
template <class Values>
[[nodiscard]] auto column(Values& values) {
    return Eigen::Map<std::conditional_t<std::is_const_v<Values>, const Column, Column>>(
        values.data(), static_cast<Eigen::Index>(values.size()));
}

/// @brief Values of the coordinates, a few of them without memory of their own.
template <class T>
using CoordinateValues = boost::container::small_vector<T, 4>;

/// @brief A linear stretch of motion; the time t counts from its start. If D is diagonal each coordinate has its closed form,
/// else they are carried together by the exponential of a matrix. A force that leads by theta has the form of one in phase at
/// tau + theta.
struct LinearMotion {
    static constexpr int orders = 6; ///< derivatives kept: 0 to 5

    CoordinateValues<double> omega_0;               ///< natural frequencies over the frequency of the force
    CoordinateValues<double> gap;                   ///< 1 - omega_0^2
    CoordinateValues<double> decay;                 ///< half the diagonal of D
    Matrix<double> D;                               ///< damping matrix if it is not diagonal, else empty
    CoordinateValues<double> F;                     ///< amplitudes of the harmonic force
    CoordinateValues<Complex<double>> lead;         ///< exp(i theta) of each; empty if all are in phase
    CoordinateValues<double> G;                     ///< constant force
    std::array<CoordinateValues<double>, orders> q; ///< coordinates and derivatives at the instant last evaluated
    Effort* const* effort = nullptr; ///< where the budget stands that exponentials of a coupled system spend; null: none

    /// @brief Sets the number of coordinates.
    void resize(std::size_t n);
    /// @brief Number of coordinates.
    [[nodiscard]] std::size_t size() const { return omega_0.size(); }
    /// @brief Whether D couples the coordinates.
    [[nodiscard]] bool coupled() const { return D.size() > 0; }
    /// @brief Operations that an evaluation costs.
    [[nodiscard]] long cost() const {
        const auto n = static_cast<long>(size());
        return coupled() ? 10 + n * n : n;
    }

    /// @brief Sets F and lead: amplitudes of the force on the coordinates in units of r^2.
    void set_force(const std::vector<Complex<double>>& load, double r2);
    /// @brief To be called when omega_0, gap, decay, D or F have changed.
    void prepare();
    /// @brief Starts the stretch at tau from the coordinates and velocities in q[0], q[1].
    void start(double tau);
    /// @brief Coordinates and velocities at a time from the start, into q[0], q[1].
    void move_to(double t);
    /// @brief All derivatives at a time from the start.
    void differentiate_at(double t);
    /// @brief Carries deviations over a time, free of force: columns of dq and dp, of the coordinates and of their velocities.
    void carry(double t, Matrix<double>& dq, Matrix<double>& dp);

    /// @brief Sine and cosine of tau at the instant last evaluated.
    [[nodiscard]] const SineCosine<double>& now() const { return now_; }

private:
    // Sine and cosine of tau + theta_i from those of tau.
    [[nodiscard]] SineCosine<double> at_force(const SineCosine<double>& tau, std::size_t i) const {
        if (lead.empty()) return tau;
        return {tau.s * lead[i].re + tau.c * lead[i].im, tau.c * lead[i].re - tau.s * lead[i].im};
    }
    // A derivative of the force on a coordinate.
    [[nodiscard]] double force(int order, std::size_t i) const {
        const SineCosine<double> at = at_force(now_, i);
        const std::array<double, 4> wave{at.c, -at.s, -at.c, at.s};
        return order == 0 ? F[i] * wave[0] + G[i] : F[i] * wave[static_cast<std::size_t>(order)];
    }
    // Of the coupled system: z = (q less that at rest, q', cos tau, sin tau) obeys z' = A z.
    [[nodiscard]] Eigen::Index rows() const { return 2 * static_cast<Eigen::Index>(size()) + 2; }

    double tau_0_;
    SineCosine<double> now_;      // of tau at the instant last evaluated
    bool differentiated_ = false; // whether q holds all derivatives, at the instant at_
    double at_;
    CoordinateValues<double> at_rest_;                                   // where the constant force would hold the coordinates
    CoordinateValues<evaluation::DrivenCoordinate<double>> coordinates_; // prepared for any start
    CoordinateValues<evaluation::DrivenStart<double>> starts_;           // the last start
    CoordinateValues<evaluation::FreeMotion<double>> free_;              // the free motions at free_at_, whatever the start
    double free_at_ = -1;
    CoupledMotion together_; // all coordinates if D couples them
};

/// @brief End of a phase.
struct Event {
    double t;          ///< time from the start of the phase
    int next;          ///< direction of the next phase
    int order;         ///< order of the zero of its guard function
    double load;       ///< load on the contact
    bool found;        ///< false if the end of the stretch came first
    bool open = false; ///< no end was found up to t, and what comes after is not known
};

/// @brief Deviations of the state over the 2N deviations of the start, carried through phases and events.
///
/// Within a phase deviations obey the motion without its forces. At an event the instant shifts with them, and the acceleration
/// jumps there: what the shift adds is the jump times the shift, along the accelerations that a force on the contact makes.
struct Deviations {
    Matrix<double> dx; ///< deviations of displacements, N x 2N
    Matrix<double> dv; ///< deviations of velocities, N x 2N

    /// @brief Starts from those of the state itself, with a phase of that direction.
    void start(const ContactPhases& phases, int direction);
    /// @brief Carries them over a phase that ends with the event, `phases` being evaluated there.
    void carry(ContactPhases& phases, int direction, const Event& event);

private:
    Matrix<double> dq, dp; // of modal coordinates and velocities

    void carry_stuck(ContactPhases& phases, const Event& event);
};

/// @brief The phases of one system at one excitation, one at a time, and the motion so far: the working space of `ExactSolver`.
/// A direction is 1 or -1 as the contact slides, 0 if it sticks.
struct ContactPhases {
    Effort own;                  ///< the work allowed if no other budget is set
    Effort* effort = &own;       ///< what the evaluations spend
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
    Complex<double> direct;      ///< part of the force that acts on the contact itself
    double size_of_direct;       ///< its amplitude
    double load_per_energy;      ///< bound of a derivative of the load on the contact over the energy norm of that order
    double load_rest;            ///< what the inertia of the others adds to that bound
    double load_growth;          ///< how fast the bound grows
    double step;                 ///< a step that the search for events took
    std::vector<double> x;       ///< displacements at the start of the phase
    std::vector<double> v;       ///< velocities at the start of the phase
    int touching = 0;            ///< events so tangential that rounding decided them
    ExactMotion motion;          ///< the last motion, as far as it came
    Deviations deviations;       ///< of its end, if they were asked for

    /// @brief Of a system.
    ContactPhases(const ContactSystem& s, const Excitation& excitation);

    /// @brief Sets frequency and friction anew. InputError if one breaks its rule.
    void set(const Excitation& excitation);
    /// @brief The motion of a kind of phase.
    [[nodiscard]] LinearMotion& motion_of(int direction) { return direction == 0 ? sticking : sliding; }
    /// @brief Takes the state at the start of a phase, at tau, into the coordinates of its motion.
    void start_phase(int direction, double tau);
    /// @brief Displacement, velocity or acceleration, by order 0 to 2, of every mass at the instant last evaluated.
    void masses_of(int direction, int order, std::vector<double>& out) const;
    /// @brief The motion of the masses from the start of the phase, at tau, that was taken into coordinates last.
    [[nodiscard]] evaluation::LinearSum motion_of_masses(int direction, double tau) const;

    /// @brief Velocity of the contact in the direction of the phase, at a time from its start, and three derivatives.
    std::array<double, 4> velocity(int direction, double t);
    /// @brief Load on the contact while it sticks, friction apart, (75), at a time from the start of the phase; derivatives too.
    std::array<double, 4> load(double t);
    /// @brief The velocity with what bounds it ahead.
    Jet velocity_ahead(int direction, double t);
    /// @brief The load with what bounds it ahead.
    Jet load_ahead(double t);

    /// @brief Direction of the first phase of a stretch, from the velocity or else from the load on the contact, and the order of
    /// the zero of the velocity there.
    std::pair<int, int> first_direction(double tau);
    /// @brief The end of a sliding phase: its velocity is zero. `length` is left; the zero at its start is of `order`.
    Event end_of_sliding(int direction, double length, int order);
    /// @brief The end of a sticking phase: the load on the contact exceeds static friction, (74).
    Event end_of_sticking(double length);
    /// @brief The same of a single mass: the load p cos tau - k_jj x_j leaves the cone where a closed form has it.
    Event end_of_sticking_alone(double tau, double length);

    /// @brief The motion from the state x, v.
    void run(double tau_0, double tau_1, bool with_jacobian);
    /// @brief Takes the start of a phase of the motion into coordinates.
    void stand_at(std::size_t phase);

private:
    void set_bounds_of_load();
};

} // namespace denhartog

/// @file
/// @brief The motion from phase to phase, each in closed form: (6) with (2), (3), (74), (75), without a time step.
///
/// While the contact slides, (6) is linear in the modes of the system; while it sticks, in those of the system with row and column
/// j taken out. Sliding ends where the velocity of the contact is zero, sticking where the load on it leaves what static friction
/// can hold. Read `LinearMotion`, one phase, then `ContactSystem`, what is prepared, then `ExactSolver`, which follows a motion.
#pragma once

#include <algorithm>
#include <array>
#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include "denhartog/evaluation/driven_motion.hpp"
#include "denhartog/model/coupled_motion.hpp"
#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/model/stuck_configuration.hpp"
#include "denhartog/number/bounded.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/work_counted.hpp"
#include "denhartog/sliding/steady_state.hpp"
#include "denhartog/stick_slip/motion_record.hpp"

namespace denhartog {

namespace evaluation {
struct EvenInstants;
struct LinearSum;
} // namespace evaluation
struct Jet;

inline constexpr double double_epsilon = std::numeric_limits<double>::epsilon(); ///< distance of 1 from the next double

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
    static constexpr int orders = 8; ///< derivatives kept: 0 to 7

    CoordinateValues<double> omega_0;               ///< natural frequencies over the frequency of the force
    CoordinateValues<double> gap;                   ///< 1 - omega_0^2
    CoordinateValues<double> decay;                 ///< half the diagonal of D
    Matrix<double> D;                               ///< damping matrix if it is not diagonal, else empty
    CoordinateValues<double> F;                     ///< amplitudes of the harmonic force
    CoordinateValues<Complex<double>> lead;         ///< exp(i theta) of each; empty if all are in phase
    CoordinateValues<double> G;                     ///< constant force
    std::array<CoordinateValues<double>, orders> q; ///< coordinates and derivatives at the instant last evaluated
    Effort* const* effort = nullptr; ///< where the budget stands that exponentials of a coupled system spend; null: none

    void resize(std::size_t n);                                       ///< sets the number of coordinates
    [[nodiscard]] std::size_t size() const { return omega_0.size(); } ///< number of coordinates
    [[nodiscard]] bool coupled() const { return D.size() > 0; }       ///< whether D couples the coordinates
    /// @brief Operations that an evaluation costs.
    [[nodiscard]] long cost() const {
        const auto n = static_cast<long>(size());
        return coupled() ? 10 + n * n : n;
    }

    /// @brief Sets F and lead: amplitudes of the force on the coordinates in units of r^2.
    void set_force(const std::vector<Complex<double>>& load, double r2);
    void prepare();                  ///< to be called when omega_0, gap, decay, D or F have changed
    void start(double tau);          ///< starts the stretch at tau from the coordinates and velocities in q[0], q[1]
    void move_to(double t);          ///< coordinates and velocities at a time from the start, into q[0], q[1]
    void differentiate_at(double t); ///< all derivatives at a time from the start
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
    // The harmonic force on a coordinate with its first three derivatives, after which they come again.
    [[nodiscard]] std::array<double, 4> harmonic_force(std::size_t i) const {
        const auto [s, c] = at_force(now_, i);
        return {F[i] * c, F[i] * -s, F[i] * -c, F[i] * s};
    }
    [[nodiscard]] evaluation::FreeMotion<double> free_at(double t, std::size_t i) const {
        return evaluation::free_motion(t, coordinates_[i].R, coordinates_[i].zeta, coordinates_[i].w);
    }
    // Of the coupled system: z = (q less that at rest, q', cos tau, sin tau) obeys z' = A z.
    [[nodiscard]] Eigen::Index rows() const { return 2 * static_cast<Eigen::Index>(size()) + 2; }

    double tau_0_;
    SineCosine<double> at_start_, now_; // of tau at the start, and at the instant last evaluated
    bool differentiated_ = false;       // whether q holds all derivatives, at the instant at_
    double at_;
    CoordinateValues<double> at_rest_;                                   // where the constant force would hold the coordinates
    CoordinateValues<evaluation::DrivenCoordinate<double>> coordinates_; // prepared for any start
    CoordinateValues<evaluation::DrivenStart<double>> starts_;           // the last start
    // The free motions at t = 0 and at free_t_, whatever the start.
    CoordinateValues<evaluation::FreeMotion<double>> free_at_start_, free_;
    double free_t_ = -1;
    CoupledMotion together_;   // all coordinates if D couples them
    Column together_at_start_; // their state
};

/// @brief End of a phase.
struct Event {
    double t;          ///< time from the start of the phase
    int next;          ///< direction of the next phase
    int order;         ///< order of the zero that the velocity of the contact has at the start of the next phase, if that slides
    double load;       ///< load on the contact
    bool found;        ///< false if the end of the stretch came first
    bool open = false; ///< no end was found up to t, and what comes after is not known
};

/// @brief A constant load: what it brings to the modes, sliding and stuck, none without one, and to the contact itself.
struct ConstantLoad {
    std::vector<double> modal{}; ///< phi^T s of the modes while the contact slides
    std::vector<double> stuck{}; ///< the same of the stuck modes
    double direct = 0;           ///< the part that acts on the contact itself
};

/// @brief A system with all that does not depend on frequency or friction: prepared once for a whole map.
struct ContactSystem {
    Mass contact;                              ///< the row of the contact, see `contact_row`
    Mass load;                                 ///< the row of the load
    ModalBasis<double> basis;                  ///< modes while the contact slides
    Matrix<double> momentum;                   ///< phi^T M in units of m_1: modal coordinates of a state, mode by mass
    StuckConfiguration stuck;                  ///< modes while the contact sticks
    std::vector<Complex<double>> modal_load{}; ///< phi^T p, what the load brings to each mode
    std::vector<Complex<double>> stuck_load{}; ///< the same of the stuck modes
    std::vector<double> detuned{};             ///< by what part of itself each natural frequency may be off
    Matrix<double> damping_error{}; ///< bounds of what rounding makes of phi^T C phi and what is left out of it, N x N, or none
    ConstantLoad constant{};        ///< the constant load, see `add_static_load`
    Column contact_shape{};         ///< w^T phi: what each mode of sliding moves the contact by
    bool damping_fixes_modes{};     ///< a damping matrix was given: modes of one frequency are those that it does not couple
    Reasons rounded_because{};      ///< why double has no modes of its own, if these are those of the reference; else empty
};

/// @brief Prepares a system for the exact solver. InputError and PrecisionError as `modal_basis` and `stuck_configuration`.
[[nodiscard]] ContactSystem contact_system(const System<double>& s);

/// @brief The system with its modal basis known; `held` is the held system in more digits, if the basis comes from them too. The
/// modes of sticking are paid from a budget.
[[nodiscard]] ContactSystem contact_system(const System<double>& s, const ModalBasis<Bounded<double>>& modes,
                                           const RoundedModes* held = nullptr, Effort* effort = nullptr);

/// @brief A system whose modes are taken for exact: `detuned` and `damping_error` are left empty.
[[nodiscard]] ContactSystem contact_system(const System<double>& s, ModalBasis<double> basis, const RoundedModes* held,
                                           Effort* effort);

/// @brief Adds a constant force on each mass, N values in units of P.
void add_static_load(ContactSystem& system, const std::vector<double>& s);

/// @brief Takes the harmonic load away: the motion is free.
void take_load_away(ContactSystem& system);

/// @brief The state of a sliding motion where the force is largest. @eq{46}
[[nodiscard]] State at_maximum_of_force(const ModeSums<double>& sums, const SteadyState<double>& state);

/// @brief The state of the sliding motion of a system, at a friction ratio, where the force is largest. @eq{46}
[[nodiscard]] inline State sliding_at_maximum_of_force(const ModeSums<double>& sums, double beta) {
    return at_maximum_of_force(sums, steady_state_without_maxima(sums, beta));
}

/// @brief The frequency and the friction.
struct Excitation {
    double r;    ///< frequency ratio, Eq. (10); positive
    double beta; ///< friction ratio, Eq. (11); not negative
    double mu;   ///< static over kinetic friction, Eq. (3); at least 1
};

/// @brief Outcome of following a stretch of motion.
enum class MotionStatus : std::uint8_t {
    complete,   ///< the end asked for was reached
    chattering, ///< more phases than a motion can have: phases of no length follow each other
    open        ///< the effort is spent, or the motion is too fast for double; the phases are those before
};

/// @brief A stretch of motion, phase by phase.
struct ExactMotion {
    MotionStatus status = MotionStatus::complete; ///< whether the end was reached
    std::vector<Phase> phases;                    ///< in order; the first starts, the last ends where asked
    std::vector<double> states;                   ///< the states at the starts of the phases, x then x', 2N values a phase
    State end;                                    ///< the state at the end
    Matrix<double> jacobian;                      ///< d end / d start over (x, x'), 2N x 2N; only if it was asked for
    int touching = 0;                             ///< events met so tangentially that rounding decided them

    /// @brief The state at the start of a phase.
    [[nodiscard]] State start_of(std::size_t phase) const {
        const auto N = static_cast<std::ptrdiff_t>(end.x.size());
        const auto x = states.begin() + 2 * N * static_cast<std::ptrdiff_t>(phase);
        return {{x, x + N}, {x + N, x + 2 * N}};
    }

    /// @brief The phase that holds an instant, of two that meet there the first; beyond the end the last.
    [[nodiscard]] std::size_t phase_at(double tau) const {
        const auto found = std::ranges::lower_bound(phases, tau, {}, &Phase::end);
        return static_cast<std::size_t>(std::min(found - phases.begin(), std::ssize(phases) - 1));
    }
};

/// @brief The function that is zero at the end of a phase, next to that end: the velocity of a contact that slides; or, while it
/// sticks, the static friction that the load leaves.
struct EndOfPhase {
    double rate;   ///< its rate of change, in size
    double second; ///< bound of the size of its second derivative next to the end
    double noise;  ///< its rounding error

    /// @brief Error of the instant of the end if the function has the given error besides its rounding: over twice that distance
    /// it certainly changes by more than its error on either side. Infinite if it may not reach zero at all.
    [[nodiscard]] double error_of_instant(double error) const;
};

class ExactSolver;

/// @brief Deviations of the state over the 2N deviations of the start, carried through phases and events.
///
/// Within a phase deviations obey the motion without its forces. At an event the instant shifts with them, and the acceleration
/// jumps there: what the shift adds is the jump times the shift, along the accelerations that a force on the contact makes.
struct Deviations {
    Matrix<double> dx; ///< deviations of displacements, N x 2N
    Matrix<double> dv; ///< deviations of velocities, N x 2N

    /// @brief Starts from those of the state itself, with a phase of that direction.
    void start(const ExactSolver& at, int direction);
    /// @brief Carries them over a phase that ends with the event, at which the solver stands.
    void carry(ExactSolver& at, int direction, const Event& event);

private:
    Matrix<double> dq, dp; // of modal coordinates and velocities

    void carry_stuck(ExactSolver& at, const Event& event);
};

/// @brief Solver of one system at one excitation; keeps its working space from call to call. Not for two threads at once. A
/// direction is 1 or -1 as the contact slides, 0 if it sticks.
class ExactSolver {
public:
    /// @brief The system must outlive the solver. InputError if r, beta or mu breaks its rule.
    ExactSolver(const ContactSystem& system, const Excitation& excitation);
    ExactSolver(const ExactSolver&) = delete;
    ExactSolver& operator=(const ExactSolver&) = delete;

    void set(const Excitation& excitation); ///< sets frequency and friction anew
    /// @brief Allows an amount of work from now on, in place of that of `default_effort` for each period of a call; null for
    /// that. Returns what was given before.
    Effort* allow(Effort* effort) { return std::exchange(effort_, effort != nullptr ? effort : &own_); }
    [[nodiscard]] Effort& effort() const { return *effort_; }              ///< the work allowed, which all calls spend
    [[nodiscard]] const ContactSystem& system() const { return *system_; } ///< the system as given
    [[nodiscard]] const Excitation& excitation() const { return e_; }      ///< frequency and friction as set last

    /// @brief The motion from one instant to a later one; the forces are Re{p exp(i tau)}, and a contact at rest sticks if (74)
    /// lets it. With the derivative of the end with respect to the start, if it is wanted. Valid until the next call.
    const ExactMotion& run(const State& start, double tau_0, double tau_1, bool with_jacobian = false);
    /// @brief The state at an instant within a phase of the last motion.
    [[nodiscard]] State state_at(std::size_t phase, double tau);
    /// @brief The same within the phase that holds the instant.
    [[nodiscard]] State state_at(double tau) { return state_at(motion_.phase_at(tau), tau); }
    /// @brief States at evenly spaced instants: displacements, then velocities, of all masses at each. No mass loses more than
    /// `most_lost` to rounding beside what `state_at` does, which answers if a recurrence would lose more or damping couples.
    void sample(std::size_t phase, const evaluation::EvenInstants& at, const std::vector<double>& most_lost, double* x,
                double* x_prime);

    [[nodiscard]] EndOfPhase end_of(std::size_t phase); ///< the end of a phase of the last motion
    /// @brief Error of the function that ends a phase, if the displacements of a motion are off by no more than `displacement` and
    /// the velocities by one bound a coordinate: of the velocity of a contact that slides, or else of the load on it, in units of P.
    [[nodiscard]] double error_at_ends(bool slides, double displacement, const std::vector<double>& velocity) const;
    /// @brief The highest natural frequency over that of the force, or 1 if that is more: of accelerations over velocities.
    [[nodiscard]] double highest_over_force() const;
    /// @brief Distance from the motion of a phase within which every motion slides for ever, in the norm of the energy, to half of
    /// what bounds prove; 0 if that is too little to be of use. The phase starts at the turning point of a steady motion that slides
    /// without a stop, and every motion is damped.
    [[nodiscard]] double sliding_reach(std::size_t phase);
    /// @brief Largest size of every displacement over the last motion, then that of a contact between two, guaranteed between
    /// samples; other maxima within twice `error`, a bound of the errors of the displacements, may be the largest: `spread`
    /// counts them, except for the contact. If the frame of the displacements moves by `frame` cos tau, displacements are those
    /// seen from the ground, and there is no entry for a contact between two.
    [[nodiscard]] std::vector<Extremum> largest_displacements(double error = 0, double frame = 0);

private:
    friend struct Deviations;

    // The phases, one at a time.
    [[nodiscard]] LinearMotion& motion_of(int direction) { return direction == 0 ? sticking_ : sliding_; }
    void start_phase(int direction, double tau); // takes the state at its start into the coordinates of its motion
    void stand_at(std::size_t phase);            // the same of a phase of the last motion
    void masses_of(int direction, int order, std::vector<double>& out) const; // derivative 0 to 2 where last evaluated
    [[nodiscard]] evaluation::LinearSum motion_of_masses(int direction, double tau) const; // in the phase started at tau
    void follow(double tau_0, double tau_1, bool with_jacobian);                           // from z_

    // Velocity of the contact in the direction of the phase, or the load on it while it sticks, friction apart, (75): at a time from
    // the start of the phase, with five derivatives; and with what bounds it ahead.
    std::array<double, 6> velocity(int direction, double t);
    std::array<double, 6> load(double t);
    Jet velocity_ahead(int direction, double t);
    Jet load_ahead(double t);
    void set_bounds_of_load();

    // Direction of the first phase, and the order of the zero of the velocity there; ends of phases, with `length` of the stretch
    // left. That of a single mass that sticks has a closed form: p cos tau - k_jj x_j leaves the cone.
    std::pair<int, int> first_direction(double tau);
    Event end_of_sliding(int direction, double length, int order);
    Event end_of_sticking(double tau, double length);
    Event end_of_sticking_alone(double tau, double length);

    [[nodiscard]] double load_of_distance() const;
    bool slides_within(int direction, const Jet& start, double needed, double distance);

    Effort own_;             // the work allowed if no other budget is set
    Effort* effort_ = &own_; // what the evaluations spend
    const ContactSystem* system_;
    Excitation e_{};
    std::size_t N_;          // number of masses
    LinearMotion sliding_;   // the motion while the contact slides
    LinearMotion sticking_;  // the motion while it sticks
    Column w_;               // M^-1 w / r^2: accelerations that a unit force on the contact makes
    double inertia_;         // of the contact, r^2 / (w^T M^-1 w)
    double rest_ = 0;        // where the contact rests in a phase of sticking
    Column k_j_, c_j_, m_j_; // stiffness, damping and inertia that the stuck modes bring to the contact
    Complex<double> direct_; // part of the force that acts on the contact itself
    double size_of_direct_;  // its amplitude
    double load_per_energy_; // bound of a derivative of the load on the contact over the energy norm of that order
    double load_rest_;       // what the inertia of the others adds to that bound
    double load_growth_;     // how fast the bound grows
    double step_;            // the step that the next search for an event tries first
    State z_;                // at the start of the phase
    ExactMotion motion_;     // the last motion, as far as it came
    Deviations deviations_;  // of its end, if they were asked for
};

/// @brief Number of phases propagated since the program started, over all threads; tests gate on it.
[[nodiscard]] inline long phases_propagated() { return work_counted.phases_propagated; }

} // namespace denhartog

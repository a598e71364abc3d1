/// @file
/// @brief The motion from phase to phase, each in closed form: (6) with (2), (3), (74), (75), without a time step.
///
/// While the contact slides, (6) is linear in its modes. While it sticks, the others obey the linear system with row and column j
/// taken out. Read `ContactSystem`, what is prepared, then `ExactSolver`, which follows a motion.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

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
}
struct ContactPhases;

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

/// @brief Adds a constant force on each mass, N values in units of P.
void add_static_load(ContactSystem& system, const std::vector<double>& s);

/// @brief Takes the harmonic load away: the motion is free.
void take_load_away(ContactSystem& system);

/// @brief The state of a sliding motion where the force is largest. @eq{46}
[[nodiscard]] State at_maximum_of_force(const ModeSums<double>& sums, const SteadyState<double>& state);

/// @brief The same at a friction ratio. @eq{46}
[[nodiscard]] inline State sliding_at_maximum_of_force(const ModeSums<double>& sums, double beta) {
    return at_maximum_of_force(sums, steady_state_without_maxima(sums, beta));
}

/// @brief The load on the contact and the friction there, at one frequency.
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

/// @brief Solver of one system at one excitation; keeps its working space from call to call. Not for two threads at once.
class ExactSolver {
public:
    /// @brief The system must outlive the solver. InputError if r, beta or mu breaks its rule.
    ExactSolver(const ContactSystem& system, const Excitation& excitation);
    ~ExactSolver();

    /// @brief Sets frequency and friction anew.
    void set(const Excitation& excitation);
    /// @brief Allows an amount of work from now on, in place of that of `default_effort` for each period of a call; null for
    /// that. Returns what was given before.
    Effort* allow(Effort* effort);
    /// @brief The work allowed, which all calls spend.
    [[nodiscard]] Effort& effort() const;
    /// @brief The system as given.
    [[nodiscard]] const ContactSystem& system() const;
    /// @brief Frequency and friction as set last.
    [[nodiscard]] const Excitation& excitation() const;

    /// @brief The motion from one instant to a later one; the forces are Re{p exp(i tau)}, and a contact at rest sticks if (74)
    /// lets it. With the derivative of the end with respect to the start, if it is wanted. Valid until the next call.
    const ExactMotion& run(const State& start, double tau_0, double tau_1, bool with_jacobian = false);

    /// @brief The state at an instant within a phase of the last motion.
    [[nodiscard]] State state_at(std::size_t phase, double tau);

    /// @brief States at evenly spaced instants: displacements, then velocities, of all masses at each. No mass loses more than
    /// `most_lost` to rounding beside what `state_at` does, which answers if a recurrence would lose more or damping couples.
    void sample(std::size_t phase, const evaluation::EvenInstants& at, const std::vector<double>& most_lost, double* x,
                double* x_prime);

    /// @brief The end of a phase of the last motion.
    [[nodiscard]] EndOfPhase end_of(std::size_t phase);

    /// @brief Distance from the motion of a phase within which every motion slides for ever. The phase starts at the turning
    /// point of a steady motion that slides without a stop, and every motion is damped. The distance is in the norm of the
    /// energy, to half of what bounds prove; 0 if that is too little to be of use.
    [[nodiscard]] double sliding_reach(std::size_t phase);

    /// @brief Largest size of every displacement over the last motion, then that of a contact between two, guaranteed between
    /// samples; of the contact without what else may be. One that is smaller by less than twice `error`, a bound of the errors of
    /// the displacements, may be the largest. If the frame of the displacements moves by `frame` cos tau, of the masses as they are
    /// seen from the ground, the one in contact as every other, and of no contact.
    [[nodiscard]] std::vector<Extremum> largest_displacements(double error = 0, double frame = 0);

private:
    std::unique_ptr<ContactPhases> work_;
};

/// @brief The highest natural frequency over that of the force, or 1 if that is more: of accelerations over velocities.
[[nodiscard]] double highest_over_force(const ExactSolver& solver);

/// @brief Error of the function that ends a phase, if the displacements of a motion are off by no more than `displacement` and the
/// velocities by one bound a coordinate: of the velocity of a contact that slides, or else of the load on it, in units of P.
[[nodiscard]] double error_at_ends(const ExactSolver& solver, bool slides, double displacement,
                                   const std::vector<double>& velocity);

/// @brief Number of phases propagated since the program started, over all threads; tests gate on it.
[[nodiscard]] inline long phases_propagated() { return work_counted.phases_propagated; }

} // namespace denhartog

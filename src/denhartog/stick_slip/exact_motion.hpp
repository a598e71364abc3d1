/// @file
/// @brief The motion from phase to phase, each in closed form: (6) with (2), (3), (74), (75), without a time step.
///
/// While the contact slides, (6) is linear and its modes are uncoupled. While it sticks, the others obey the linear system with
/// row and column j taken out; its modes are uncoupled where they diagonalise their block of the damping matrix, else its
/// Taylor series is summed to rounding. Ends of phases are isolated by bounds of the fourth derivative, so that none is missed.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "denhartog/model/stuck_configuration.hpp"
#include "denhartog/number/bounded.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/work_counted.hpp"
#include "denhartog/stick_slip/motion_record.hpp"

namespace denhartog {

/// @brief How a phase ends.
template <class T>
struct Event {
    T t;               ///< time from the start of the phase
    int next;          ///< direction of the next phase
    int order;         ///< order of the zero of its guard function
    T load;            ///< load on the contact
    bool found;        ///< false where the end of the stretch came first
    bool open = false; ///< no end was found up to t, and what comes after is not known
};

/// @brief A system with all that does not depend on frequency or friction: prepared once for a whole map.
template <class T>
struct ContactSystem {
    Mass contact;                  ///< the mass in contact, j
    Mass load;                     ///< the loaded mass, l, or the place of the load's displacement where it acts on several
    ModalBasis<T> basis;           ///< modes while the contact slides
    Matrix<T> momentum;            ///< phi^T M in units of m_1: modal coordinates of a state, mode by mass
    StuckConfiguration<T> stuck;   ///< modes while the contact sticks
    std::vector<T> modal_load{};   ///< phi^T p, what the load brings to each mode
    std::vector<T> stuck_load{};   ///< the same of the stuck modes
    std::vector<T> detuned{};      ///< by what part of itself each natural frequency may be off
    Matrix<T> damping_error{};     ///< bounds of what rounding makes of phi^T C phi and what is left out of it, N x N, or none
    Coordinates<T> coordinates{};  ///< the masses that are none; none for a scene of the paper
    Matrix<T> further{};           ///< mode shapes of these masses while the contact slides, a row each
    bool damping_fixes_modes{};    ///< a damping matrix was given: modes of one frequency are those that it does not couple
    std::string rounded_because{}; ///< why T has no modes of its own, where these are those of the reference; else empty
};

/// @brief Prepares a system for the exact solver.
/// @param s  the system
/// @return   its modes, sliding and stuck
/// @throws   InputError, PrecisionError as `modal_basis` and `stuck_configuration`
template <class T>
[[nodiscard]] ContactSystem<T> contact_system(const System<T>& s);

/// @brief The same, the modal basis known.
/// @param s      the system
/// @param modes  its modal basis with bounds
/// @param held   what more digits have found beside the basis, where that comes from them too; else null
/// @return       its modes
template <class T>
[[nodiscard]] ContactSystem<T> contact_system(const System<T>& s, const ModalBasis<Bounded<T>>& modes,
                                              const RoundedModes<T>* held = nullptr);

/// @brief The load on the contact and the friction there, at one frequency.
template <class T>
struct Excitation {
    T r;    ///< frequency ratio, Eq. (10); positive
    T beta; ///< friction ratio, Eq. (11); not negative
    T mu;   ///< static over kinetic friction, Eq. (3); at least 1
};

/// @brief How a stretch of motion ended.
enum class MotionStatus : std::uint8_t {
    complete,   ///< the end asked for was reached
    chattering, ///< more phases than a motion can have: phases of no length follow each other
    open        ///< the effort is spent, or the motion is too fast for the number type; the phases are those before
};

/// @brief A stretch of motion, phase by phase.
template <class T>
struct ExactMotion {
    MotionStatus status = MotionStatus::complete; ///< whether the end was reached
    std::vector<Phase<T>> phases;                 ///< in order; the first starts, the last ends where asked
    std::vector<T> states;                        ///< the states at the starts of the phases, x then x', 2N values a phase
    State<T> end;                                 ///< the state at the end
    Matrix<T> jacobian;                           ///< d end / d start over (x, x'), 2N x 2N; only where it was asked for
    int touching = 0;                             ///< events met so tangentially that rounding decided them
    long effort_for_jacobian = 0;                 ///< operations that the Jacobian took
};

/// @brief How that which ends a phase vanishes there: the velocity of a contact that slides; while it sticks, what the load on it
/// leaves of static friction.
template <class T>
struct EndOfPhase {
    T rate;   ///< its rate of change, in size
    T second; ///< bound of the size of its second derivative next to the end
    T noise;  ///< its rounding error
};

/// @brief Solver of one system at one excitation; keeps its working space from call to call. Not for two threads at once.
template <class T>
class ExactSolver {
public:
    /// @param system      the system; must outlive the solver
    /// @param excitation  frequency and friction
    /// @throws InputError where r, beta or mu breaks its rule
    ExactSolver(const ContactSystem<T>& system, const Excitation<T>& excitation);
    ~ExactSolver();
    /// @param other  a solver, which is left without its working space
    ExactSolver(ExactSolver&& other) noexcept;

    /// @brief Sets frequency and friction anew. @param excitation frequency and friction
    void set(const Excitation<T>& excitation);
    /// @brief Allows an amount of work from now on, in place of that of `default_effort` for each period of a call.
    /// @param effort  the work; null for the default
    /// @return        what was given before
    Effort* allow(Effort* effort);
    /// @brief The work allowed. @return what all calls spend
    [[nodiscard]] Effort& effort() const;
    /// @brief The system. @return the one given
    [[nodiscard]] const ContactSystem<T>& system() const;
    /// @brief Frequency and friction. @return as set last
    [[nodiscard]] const Excitation<T>& excitation() const;

    /// @brief The motion from one instant to a later one.
    /// @param start          the state there; a contact at rest sticks where (74) lets it
    /// @param tau_0          the instant of the start; the force is cos tau
    /// @param tau_1          the end
    /// @param with_jacobian  whether the derivative of the end with respect to the start is wanted
    /// @return               the motion; valid until the next call
    const ExactMotion<T>& run(const State<T>& start, const T& tau_0, const T& tau_1, bool with_jacobian = false);

    /// @brief The state within a phase of the last motion.
    /// @param phase  index of the phase
    /// @param tau    an instant in it
    /// @return       the state
    [[nodiscard]] State<T> state_at(std::size_t phase, const T& tau);

    /// @brief How a phase of the last motion ends. @param phase index of the phase @return the rate of what vanishes there
    [[nodiscard]] EndOfPhase<T> end_of(std::size_t phase);

    /// @brief How near a motion has to be to that of a phase to slide for ever: the phase starts at the turning point of a steady
    /// motion that slides without a stop, and every motion is damped.
    /// @param phase  index of the phase
    /// @return       the distance in the norm of the energy, to half of what bounds prove; 0 where that is too little to be of use
    [[nodiscard]] T sliding_reach(std::size_t phase);

    /// @brief Largest size of every displacement over the last motion, guaranteed between samples.
    /// @param error  bound of the errors of the displacements: one that is smaller by less than twice this may be the largest
    /// @return       the extremum of every coordinate, then of the masses that are none; of the contact without what else may be
    [[nodiscard]] std::vector<Extremum<T>> largest_displacements(const T& error = T(0));

private:
    struct Work;
    std::unique_ptr<Work> work_;
};

/// @brief Number of phases propagated since the program started; tests gate on it.
/// @return the count, over all number types and threads
[[nodiscard]] inline long phases_propagated() { return work_counted.phases_propagated; }

} // namespace denhartog

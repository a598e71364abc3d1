/// @file
/// @brief What is asked of a scene, and the answer with its method, its error and the work it took.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "denhartog/solve/answer.hpp"
#include "denhartog/stick_slip/motion_record.hpp"
#include "denhartog/stick_slip/stuck_response.hpp"

namespace denhartog {

/// @brief What is asked of a scene.
enum class Asked : std::uint8_t {
    amplitude, ///< amplitudes of all masses
    phase,     ///< their phases, and the amplitudes besides
    motion,    ///< the whole motion
    regime     ///< the regime and its boundaries alone
};

/// @brief A question to a scene.
struct Question {
    Asked asked = Asked::motion; ///< what is asked
    std::optional<int> digits;   ///< significant digits; without, 6 are aimed at
    bool all = false;            ///< whether other motions are looked for, from seeded starts and sweeps
    std::optional<Mass> mass{};  ///< the one mass that is asked about: others have no digits and are not listed; none for all
};

/// @brief What a mass does in the steady motion.
template <class T>
struct SolvedMass {
    T amplitude;                              ///< largest displacement, units of P / k_1
    std::optional<T> phase;                   ///< lag behind the force, radians in (-pi, pi]; none where the mass does not move
    T error_bound;                            ///< bound of the error of the displacements
    T phase_error;                            ///< bound of the error of the phase
    std::optional<MassResponse<T>> sliding{}; ///< all of the closed form, where it is the answer and was asked for
};

/// @brief Where the contact may rest for ever.
template <class T>
struct RestInterval {
    T from;                      ///< lower end, units of P / k_1
    T to;                        ///< upper end
    T error_bound;               ///< bound of the error of the ends
    std::optional<T> rests_at{}; ///< where the motion from rest comes to rest, where it was followed
};

/// @brief Stability of a motion as its Floquet multipliers have it.
struct Stability {
    bool stable = false;             ///< whether all are inside the unit circle, by more than their error
    std::vector<double> multipliers; ///< their sizes over the period of the motion, descending
};

/// @brief The numbers of an answer.
template <class T>
struct Solved {
    T r;                                            ///< frequency ratio, Eq. (10)
    T beta;                                         ///< friction ratio, Eq. (11)
    Mass contact;                                   ///< the mass in contact, j
    std::optional<Boundary<T>> boundary{};          ///< the boundary at r, where it was computed
    std::optional<T> slides_below{};                ///< what it is not below, where that was enough
    std::optional<T> sticking_by_88{};              ///< the boundary of permanent sticking by (88) as printed, for chains
    std::vector<SolvedMass<T>> masses{};            ///< N, or one; empty where the regime alone was asked for
    std::optional<Mass> only{};                     ///< the one mass listed, where one was asked about
    std::vector<Stop<T>> stops{};                   ///< stops of the contact within the period of the motion
    std::optional<State<T>> start{};                ///< the state at the maximum of the force, where the exact solver answered
    std::optional<RestInterval<T>> rest_interval{}; ///< in permanent sticking
};

/// @brief What an answer cost.
struct Work {
    long eigen_solves = 0;      ///< eigenproblems (15)
    long mode_evaluations = 0;  ///< modes evaluated at a frequency ratio
    long phases_propagated = 0; ///< phases of sliding and sticking in the exact solver
};

/// @brief A steady motion of the same scene from another start.
struct OtherMotion {
    Regime regime;                                     ///< how the contact moves
    State<double> from;                                ///< a state at the maximum of the force that leads to it
    std::string found;                                 ///< how it was found
    int periods = 1;                                   ///< its period in periods of the force
    bool symmetric = false;                            ///< whether it mirrors itself after half its period
    Stability stability;                               ///< its stability
    std::vector<SolvedMass<double>> masses;            ///< amplitudes and phases; in permanent sticking for rest at zero
    std::vector<Stop<double>> stops;                   ///< stops within its period
    State<double> start;                               ///< its own state at the maximum of the force
    std::optional<RestInterval<double>> rest_interval; ///< in permanent sticking
};

/// @brief The answer to a question.
struct Solution {
    Asked asked = Asked::motion;                                           ///< what was asked
    RegimeAtPoint regime;                                                  ///< the regime, with the reason
    std::optional<Regime> regime_by_56;                                    ///< the regime by (69) with (56), where it differs
    Method method;                                                         ///< model, precision, and why
    std::variant<Solved<double>, Solved<Real50>, Solved<Real100>> numbers; ///< the numbers
    double relative_error = 0;          ///< what is sure of them: the largest error, as digits count
    bool unique = false;                ///< whether the steady velocities are known not to depend on the start
    std::string unique_because;         ///< why, or why it is not known
    int periods = 1;                    ///< period of the motion in periods of the force
    bool symmetric = true;              ///< whether the motion mirrors itself after half its period, Eq. (25)
    std::optional<Stability> stability; ///< where the exact solver answered
    std::vector<OtherMotion> motions;   ///< all motions found, where they were looked for
    Work work;                          ///< what the answer cost
};

} // namespace denhartog

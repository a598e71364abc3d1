/// @file
/// @brief What is asked of a scene, and the answer: certified numbers, the method, the error and the work it took.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "denhartog/number/certified.hpp"
#include "denhartog/scene/scene.hpp"
#include "denhartog/sliding/regime_at_point.hpp"
#include "denhartog/stick_slip/motion_record.hpp"

namespace denhartog {

/// @brief The most digits that can be asked for.
constexpr int most_digits = 95;
/// @brief The digits aimed at where none are asked for.
constexpr int digits_by_default = 6;

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

/// @brief How an answer was computed.
struct Method {
    std::string model;     ///< the model that answers, e.g. `closed form`
    std::string precision; ///< `double`, `50 digits` or `100 digits`
    std::string why;       ///< why this model in this precision
};

/// @brief The friction ratios that part the regimes at one frequency ratio.
struct Limits {
    Certified exact;                   ///< (69) with the maximum over tau of the sum over modes
    Certified paper;                   ///< (69) with (56): the sum of the maxima of the modes
    Certified approximate;             ///< (67)
    std::optional<Certified> sticking; ///< the smallest beta at which the contact never moves; none where nothing holds it
    BindingCondition binding{};        ///< the condition that ends the sliding regime first
};

/// @brief What the closed form says of a mass besides its amplitude and phase.
struct SlidingOfMass {
    Certified x0;                     ///< displacement at the maximum of x_j, Eq. (44)
    Certified v0;                     ///< velocity d/dtau there, Eq. (45)
    Certified instant;                ///< tau in [0, pi] where the displacement is largest in size
    Certified amplitude_monoharmonic; ///< Eq. (52)
    Certified phase_monoharmonic;     ///< phi_j + phi_kj, Eq. (53); radians in (-pi, pi]
};

/// @brief What a mass does in the steady motion.
struct SolvedMass {
    Certified amplitude;                    ///< largest displacement, units of P / k_1
    std::optional<Certified> phase;         ///< lag behind the force, radians in (-pi, pi]; none where the mass does not move
    std::optional<SlidingOfMass> sliding{}; ///< the rest of the closed form, where it is the answer and was asked for
};

/// @brief Bound of the errors of all displacements of a mass. @param m the mass @return the largest, in units of P / k_1
[[nodiscard]] double error_of_displacements(const SolvedMass& m);

/// @brief A stop of the contact within the period of the motion.
struct SolvedStop {
    Certified start; ///< tau where the contact comes to rest, from the maximum of the force
    Certified end;   ///< tau where it breaks away
    Certified x;     ///< where it rests
};

/// @brief The state of all masses at an instant.
struct SolvedState {
    std::vector<Certified> x;       ///< displacements, N values
    std::vector<Certified> x_prime; ///< velocities with respect to tau, N values
};

/// @brief Where the contact may rest for ever.
struct RestInterval {
    Certified from;                      ///< lower end, units of P / k_1
    Certified to;                        ///< upper end
    std::optional<Certified> rests_at{}; ///< where the motion from rest comes to rest, where it was followed
};

/// @brief Stability of a motion as its Floquet multipliers have it.
struct Stability {
    bool stable = false;             ///< whether all are inside the unit circle, by more than their error
    std::vector<double> multipliers; ///< their sizes over the period of the motion, descending
};

/// @brief What an answer cost.
struct Work {
    long eigen_solves = 0;      ///< eigenproblems (15)
    long mode_evaluations = 0;  ///< modes evaluated at a frequency ratio
    long phases_propagated = 0; ///< phases of sliding and sticking in the exact solver
};

/// @brief A steady motion of the same scene from another start.
struct OtherMotion {
    Regime regime;                             ///< how the contact moves
    State<double> from;                        ///< a state at the maximum of the force that leads to it
    std::string found;                         ///< how it was found
    int periods = 1;                           ///< its period in periods of the force
    bool symmetric = false;                    ///< whether it mirrors itself after half its period
    Stability stability;                       ///< its stability
    std::vector<SolvedMass> masses;            ///< amplitudes and phases; in permanent sticking for rest at zero
    std::vector<SolvedStop> stops;             ///< stops within its period
    State<double> start;                       ///< its own state at the maximum of the force
    std::optional<RestInterval> rest_interval; ///< in permanent sticking
};

/// @brief The answer to a question.
struct Solution {
    Asked asked = Asked::motion;               ///< what was asked
    Certified r;                               ///< frequency ratio, Eq. (10)
    Certified mu;                              ///< static over kinetic friction, Eq. (3)
    std::optional<Certified> beta;             ///< friction ratio, Eq. (11); none where the boundary alone was asked for
    Mass contact;                              ///< the mass in contact, j
    std::optional<Mass> contact_with{};        ///< the mass that it rubs against, where that is no wall
    std::optional<SolvedMass> between{};       ///< then the motion of the one relative to the other
    RegimeAtPoint regime;                      ///< the regime, with the reason
    std::optional<Regime> regime_by_56;        ///< the regime by (69) with (56), where it differs
    Method method;                             ///< model, precision, and why
    std::optional<Limits> limits;              ///< the boundary at r, where it was computed
    std::optional<Certified> slides_below;     ///< what it is not below, where that was enough
    std::optional<Certified> sticking_by_88;   ///< the boundary of permanent sticking by (88) as printed, for chains
    std::vector<SolvedMass> masses;            ///< N, or one; empty where the regime alone was asked for
    std::optional<Mass> only;                  ///< the one mass listed, where one was asked about
    std::vector<SolvedStop> stops;             ///< stops of the contact within the period of the motion
    std::optional<SolvedState> start;          ///< the state at the maximum of the force, where the exact solver answered
    std::optional<RestInterval> rest_interval; ///< in permanent sticking
    double relative_error = 0;                 ///< what is sure of them: the largest error, as digits count
    bool digits_reached = true;                ///< whether the digits asked for, or aimed at, are there
    bool unique = false;                       ///< whether the steady velocities are known not to depend on the start
    std::string_view unique_because;           ///< why, or why it is not known
    int periods = 1;                           ///< period of the motion in periods of the force
    bool symmetric = true;                     ///< whether the motion mirrors itself after half its period, Eq. (25)
    std::optional<Stability> stability;        ///< where the exact solver answered
    std::vector<OtherMotion> motions;          ///< all motions found, where they were looked for
    Work work;                                 ///< what the answer cost

    /// @brief Amplitude of a mass, units of P / k_1. @param k a mass that is listed @return its largest displacement
    /// @throws DomainError where the answer has no amplitudes
    [[nodiscard]] const Certified& amplitude(Mass k) const;
    /// @brief Phase of a mass. @param k a mass that is listed @return its lag behind the force; none where it does not move
    /// @throws DomainError where the answer has no amplitudes
    [[nodiscard]] const std::optional<Certified>& phase(Mass k) const;
};

/// @brief Puts an answer that was found in coordinates of its own in the order of the masses.
/// @param c  the coordinates; nothing is done where there are none
/// @param s  the answer
void put_in_order_of_masses(const Coordinates<double>& c, Solution& s);

/// @brief What is known of a mass. @param s an answer @param k a mass, listed in it @return the mass
[[nodiscard]] const SolvedMass& mass_of(const Solution& s, Mass k);

/// @brief How often a rung of precision did not have the digits and the next was taken, since the program started.
/// @return the count; tests gate on it
[[nodiscard]] long precision_steps();

} // namespace denhartog

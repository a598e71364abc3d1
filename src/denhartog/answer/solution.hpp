/// @file
/// @brief Questions about a scene, and the answer: certified numbers, the method, the error and the work it took; the energies
/// that a steady motion dissipates in a period of the force, and the forces that it hands to wall and base.
///
/// Displacements are in units of P / k_1. Time is tau = omega t, zero where the force is largest. Phases are lags behind the
/// force in radians. Equation numbers are the paper's.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "denhartog/number/certified.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/scene/scene.hpp"
#include "denhartog/sliding/regime_at_point.hpp"
#include "denhartog/stick_slip/motion_record.hpp"

namespace denhartog {

/// @brief The largest number of significant digits that you can ask for; from 15 on the reference answers.
constexpr int most_digits = 100'000;
/// @brief The number of significant digits that the library aims at if you ask for none.
constexpr int digits_by_default = 6;

/// @brief The numbers that a question asks for; asking for less is cheaper.
enum class Asked : std::uint8_t {
    amplitude, ///< amplitudes of all masses
    phase,     ///< amplitudes and phases of all masses
    motion,    ///< the whole motion: amplitudes, phases, stops, states and stability
    regime     ///< only the regime and its boundaries
};

/// @brief A question about a scene.
struct Question {
    Asked asked = Asked::motion; ///< the numbers asked for
    std::optional<int> digits;   ///< significant digits, 1 to `most_digits`; by default the aim is 6, and it may be missed
    bool all = false;            ///< whether to look for other motions too, from seeded starts and sweeps
    std::optional<Mass> mass{};  ///< ask about this mass alone: only it is listed, only it must have the digits; empty: all
    bool proved = false;         ///< whether every number must be proved: the reference then answers
};

/// @brief The method of an answer.
struct Method {
    std::string model;     ///< the model that answers, e.g. `closed form`
    std::string precision; ///< `double` or `reference`
    Reasons why;           ///< why this model answers, and in this precision
    bool proved = false;   ///< whether every number of the answer is proved; else bounds are estimates, docs/promises.md
};

/// @brief The friction ratios that separate the regimes at one frequency ratio.
///
/// Below `exact` the contact slides throughout. Always `paper` <= `exact` <= `approximate`; where rounding of the damping matrix
/// alone couples the modes, `paper` is that of the modes, and the order holds to 1e-9 of them.
struct Limits {
    Certified exact;                   ///< (69) with the maximum over tau of the sum over modes; the true boundary
    Certified paper;                   ///< (69) with (56), the sum of the maxima of the modes
    Certified approximate;             ///< (67)
    std::optional<Certified> sticking; ///< the smallest beta at which the contact never moves; empty if no friction holds it
    BindingCondition binding{};        ///< which condition of (54) ends the sliding regime
};

/// @brief The numbers that the closed form has of a mass besides its amplitude and phase.
struct SlidingOfMass {
    Certified x0;                     ///< displacement where the contact is at its maximum, Eq. (44); units of P / k_1
    Certified v0;                     ///< velocity dx/dtau there, Eq. (45); units of P / k_1
    Certified instant;                ///< time in [0, pi] from the maximum of the contact to the largest |x_k|, tau of (46)
    Certified amplitude_monoharmonic; ///< amplitude of the monoharmonic approximation, Eq. (52); units of P / k_1
    Certified phase_monoharmonic;     ///< its phase phi_j + phi_kj, Eq. (53); radians in (-pi, pi]
};

/// @brief The steady motion of a mass.
struct SolvedMass {
    Certified amplitude;                    ///< largest |x_k| over the motion; units of P / k_1
    std::optional<Certified> phase;         ///< lag behind the force, radians in (-pi, pi]; empty if the mass does not move
    std::optional<SlidingOfMass> sliding{}; ///< the rest of the closed form, if it is the answer and was asked for
};

/// @brief Bound of the errors of all displacements that are given of a mass. @param m the mass @return it, in units of P / k_1
[[nodiscard]] double error_of_displacements(const SolvedMass& m);

/// @brief The motion of a mass as it is seen from the ground, where base, wall or both move harmonically.
struct MassFromGround {
    Certified amplitude;            ///< its largest absolute displacement; units of P / k_1
    Certified transmissibility;     ///< its amplitude over that of base or wall
    std::optional<Certified> phase; ///< lag of its largest absolute displacement behind base or wall, radians in (-pi, pi]
};

/// @brief A stop of the contact within the period of the motion.
///
/// The bound of an instant is the error of the velocity of the contact, at the start, or of the load on it, at the end, over its
/// rate of change. If the rate is too small to tell, as when the contact only just stops, the bound is half the period.
using SolvedStop = StopOf<Certified>;

/// @brief The state of all masses at an instant.
struct SolvedState {
    std::vector<Certified> x;       ///< displacements, N values in units of P / k_1
    std::vector<Certified> x_prime; ///< velocities dx/dtau, N values in units of P / k_1
};

/// @brief Where the contact may rest for ever.
struct RestInterval {
    Certified from;                      ///< lower end, units of P / k_1
    Certified to;                        ///< upper end
    std::optional<Certified> rests_at{}; ///< where the motion from rest comes to rest, if it was followed
};

/// @brief Stability of a motion, from its Floquet multipliers.
struct Stability {
    bool stable = false;                ///< whether all multipliers are inside the unit circle, by more than their error
    std::vector<Certified> multipliers; ///< their sizes over the period of the motion, descending, in double; a bound may be
                                        ///< infinite, where an event only just happens
};

/// @brief A mode without damping of which the sliding motion may keep any share: it has an even number of periods in one of the
/// force, so that friction does no work on it.
struct KeptMode {
    std::size_t mode; ///< the mode, counted from 0
    Certified
        contact_at_most; ///< amplitude of the contact with the largest share; units of P / k_1. Without any it is the answer's
};

/// @brief The cost of an answer.
struct Work {
    long eigen_solves = 0;      ///< number of eigenproblems (15) solved
    long mode_evaluations = 0;  ///< number of modes evaluated at a frequency ratio
    long phases_propagated = 0; ///< number of phases of sliding and sticking that the exact solver followed
};

/// @brief A steady motion of the same scene from another start.
struct OtherMotion {
    Regime regime;                             ///< the regime of the contact
    State from;                                ///< a state at the maximum of the force that leads to it
    Reasons found;                             ///< the start that led to it
    int periods = 1;                           ///< its period in periods of the force
    bool symmetric = false;                    ///< whether it mirrors itself after half its period
    Stability stability;                       ///< its stability
    std::vector<SolvedMass> masses;            ///< amplitudes and phases; in permanent sticking for a contact at zero
    std::vector<SolvedStop> stops;             ///< stops of the contact within its period
    State start;                               ///< its own state at the maximum of the force
    std::optional<RestInterval> rest_interval; ///< where the contact may rest; in permanent sticking only
};

/// @brief The answer to a question.
struct Solution {
    Asked asked = Asked::motion;               ///< the numbers asked for
    Certified r;                               ///< frequency ratio, Eq. (10)
    Certified mu;                              ///< static over kinetic friction, Eq. (3)
    std::optional<Certified> beta;             ///< friction ratio, Eq. (11); empty if only the boundary was asked for
    Mass contact;                              ///< the mass in contact, j
    std::optional<Mass> contact_with{};        ///< the mass that it rubs against; empty for a wall
    std::vector<double> contact_direction{};   ///< w, if the contact slides along another direction; N values or none
    std::optional<SolvedMass> between{};       ///< in both cases the motion of the contact itself: of `contact` relative to
                                               ///< `contact_with`, or w^T x
    RegimeAtPoint regime;                      ///< the regime, with the reason
    std::optional<Regime> regime_by_56;        ///< the regime by (69) with (56), if it differs from `regime`
    Method method;                             ///< model, precision, and why
    std::optional<Limits> limits;              ///< the boundary at r, if it was computed
    std::optional<Certified> slides_below;     ///< a lower bound of `Limits::exact`, if that bound was enough
    std::optional<Certified> sticking_by_88;   ///< boundary of permanent sticking by (88) as printed; for chains only
    std::vector<SolvedMass> masses;            ///< N values, or one if one mass was asked about; empty for `Asked::regime`
    std::optional<Mass> only;                  ///< the mass that `masses` lists, if one mass was asked about
    std::optional<Certified> base_amplitude;   ///< amplitude of base or wall, if one moves; units of P / k_1
    std::vector<MassFromGround> from_ground;   ///< N values, if base or wall move and the motion of all masses was asked for
    std::vector<SolvedStop> stops;             ///< stops of the contact within the period of the motion
    std::optional<SolvedState> start;          ///< the state at the maximum of the force, if the exact solver answered
    std::optional<RestInterval> rest_interval; ///< where the contact may rest; in permanent sticking only
    double relative_error = 0;                 ///< largest bound of a relative error among the numbers asked for
    bool digits_reached = true;                ///< whether they have the digits asked for, or aimed at
    bool unique = false;                       ///< whether the steady velocities are known not to depend on the start
    Reasons unique_because;                    ///< the reason, or why it is not known
    std::optional<KeptMode> kept_mode;  ///< if the closed form is one of a continuum of steady motions: what they differ by
    Reasons not_from_rest;              ///< why the start from rest is not known to lead to this motion; empty if it does, and
                                        ///< of a closed form that was asked for by itself
    int periods = 1;                    ///< period of the motion, in periods of the force
    bool symmetric = true;              ///< whether the motion mirrors itself after half its period, Eq. (25)
    std::optional<Stability> stability; ///< stability of the motion, if the exact solver followed it
    std::vector<OtherMotion> motions;   ///< all motions that were found, if `Question::all` was set
    Work work;                          ///< the cost of the answer

    /// @brief Amplitude of a mass. @param k a mass that the answer lists @return its largest |x_k|; units of P / k_1
    /// @throws DomainError if the answer has no amplitude of the mass
    [[nodiscard]] const Certified& amplitude(Mass k) const;
    /// @brief Phase of a mass. @param k a mass that the answer lists @return its lag behind the force in radians, in (-pi, pi];
    /// empty if it does not move @throws DomainError if the answer has no amplitude of the mass
    [[nodiscard]] const std::optional<Certified>& phase(Mass k) const;
};

/// @brief Friction as the dashpot that dissipates as much, and as textbooks have it.
struct EquivalentDamping {
    Certified
        coefficient; ///< \f$ c = W/(\pi\omega X^2) \f$ with the energy W and the amplitude X of the contact; units of sqrt(k_1 m_1)
    Certified ratio;                                   ///< \f$ c/(2\sqrt{k_1m_1}) \f$
    Certified textbook_energy;                         ///< \f$ 4FX \f$, units of P^2 / k_1
    Certified textbook_energy_error;                   ///< by what part of the energy it is off
    std::optional<Certified> textbook_amplitude;       ///< X by a dashpot \f$ 4F/(\pi\omega X) \f$ in place of friction, units of
                                                       ///< P / k_1; empty where friction is too large for that
    std::optional<Certified> textbook_amplitude_error; ///< by what part of the amplitude it is off
};

/// @brief Energies in a period of the force, and forces. Every number is proved. In a period the load does as much work as
/// contact and dampers take; of a motion that is longer than a period they are the mean over its periods.
///
/// Energies have their digits beside the largest work that the load could do on that motion, everything else beside itself.
struct Energies {
    Certified contact;  ///< that friction dissipates, units of P^2 / k_1
    Certified dampers;  ///< that the dampers dissipate, units of P^2 / k_1
    Certified friction; ///< largest friction force, which the contact hands to the wall, or to the other mass; units of P
    Certified on_base;  ///< largest force of springs and dampers on the base, without a constant load; units of P
    std::optional<EquivalentDamping> equivalent; ///< empty where the contact does not move
};

/// @brief The entry of an answer about a mass. @param s an answer @param k a mass that it lists @return the mass
/// @throws DomainError if the answer has no amplitude of the mass
[[nodiscard]] const SolvedMass& mass_of(const Solution& s, Mass k);

/// @brief The number of questions that double did not settle, since the program started.
/// @return the count, over all threads
[[nodiscard]] long precision_steps();

} // namespace denhartog

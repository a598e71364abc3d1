/// @file
/// @brief The steady motion in any regime: a periodic orbit by Newton shooting on the exact solver, with its stability.
///
/// The force satisfies \f$ \cos(\tau + \pi) = -\cos\tau \f$, so that half a period of the force carries the state z to
/// \f$ P(z) = -\Phi_{0\to\pi}(z) \f$ in a frame that is mirrored every half-period, and P is always the same map. A fixed point
/// of P mirrors itself after half a period, Eq. (25). A fixed point of an even number h of these maps and of no fewer is a motion
/// of h/2 periods without that symmetry; one of an odd number h is a motion of h periods that mirrors itself after half of them.
/// Which of them the motion is comes from what is seen of it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "denhartog/orbit/floquet.hpp"
#include "denhartog/orbit/orbit_map.hpp"
#include "denhartog/stick_slip/stuck_response.hpp"

namespace denhartog {

/// @brief The end of a search for a periodic orbit.
enum class OrbitStatus : std::uint8_t {
    periodic,          ///< a periodic orbit to which the start leads, with its error bounded
    permanently_stuck, ///< the contact came to rest for ever
    not_from_start,    ///< a periodic orbit, with its error bounded, to which the start is not known to lead: see `reason`
    not_converged      ///< none of these: `reason` says what was seen; no number is an answer
};

/// @brief Limits of the search, and the results that are wanted.
struct OrbitSearch {
    const State* guess = nullptr; ///< a state near which an orbit of half a period is looked for first; null: none
    int most_periods = 20000;     ///< periods after which the search gives up; sooner if damping ends it, see `periods_to_follow`
    bool follow_start = true;     ///< make sure that the motion from the start tends to the orbit, not another
    bool converging_only = false; ///< give up once the motion from the start is seen to come to no orbit; no other is wanted
    bool contact_only = false;    ///< leave `masses` empty: the maxima of the masses that are not in contact cost most
    bool with_stability = true;   ///< compute Floquet multipliers and the verdict on stability
    Effort* effort = nullptr;     ///< the budget of the question, of which the search has its share; null: `default_effort`
};

/// @brief The result of a search for a steady motion.
struct PeriodicOrbit {
    OrbitStatus status = OrbitStatus::not_converged; ///< what was found
    Reasons reason;                                  ///< why, if the status is no periodic orbit; else what to know of it
    int periods = 1;                                 ///< its period in periods of the force
    bool symmetric = false;                          ///< whether it mirrors itself after half its period, Eq. (25)
    State start;                         ///< the state at tau = 0, a maximum of the force; the last one if none was found
    std::vector<Stop> stops;             ///< within its period, starts ascending in [0, 2 pi periods)
    MassMotion contact{};                ///< amplitude and phase of the mass in contact
    std::vector<MassMotion> masses;      ///< amplitude and phase of every mass; empty if the contact's alone are asked
    std::vector<Multiplier> multipliers; ///< Floquet multipliers over its period, by descending size
    bool stable = false;                 ///< whether all multipliers are certainly inside the unit circle
    double error_bound = 0;              ///< bound of the error of the displacements, units of P / k_1
    std::vector<double> velocity_errors; ///< those of the velocities: of each mass, then of a contact between two
    bool more_digits_may_tell = false;   ///< none was found, and rounding may be why
    int touching = 0;           ///< events so tangential that rounding decided them: errors of the multipliers are then infinite
    int newton_steps = 0;       ///< steps of Newton's method taken
    int periods_propagated = 0; ///< periods propagated in all
    long effort_spent = 0;      ///< operations that the search took
};

/// @brief Whether an orbit is the steady motion that the start leads to.
[[nodiscard]] inline bool is_from_start(const PeriodicOrbit& orbit) {
    return orbit.status == OrbitStatus::periodic || orbit.status == OrbitStatus::permanently_stuck;
}

/// @brief The steady motion that a start, the state at tau = 0, leads to; or why there is none. InputError if the start breaks
/// a rule.
///
/// The search ends when its effort is spent: `reason` then says how far it came. If mu = 1 and every damping ratio is positive,
/// the steady velocities are unique, and the first orbit found is the answer. Otherwise an orbit is accepted only if it is stable
/// and the motion from the start approaches it as its linearisation predicts; or, for an orbit without stops, comes so near that
/// `sliding_reach` proves the approach; unless `follow_start` is off. A contact at rest stays for ever if the load on it
/// in the steady stuck motion, plus a bound of what the transient adds, is below mu beta. That motion is one of a continuum, and
/// `multipliers` are those of the other masses.
[[nodiscard]] PeriodicOrbit periodic_orbit(ExactSolver& solver, const State& start, const OrbitSearch& search = {});

/// @brief Periods for which a motion is followed that does not become periodic: 500 and thirty decay times of the slowest mode, at
/// most `most`; `most` if damping couples the modes.
[[nodiscard]] int periods_to_follow(const ExactSolver& solver, int most);

/// @brief Bounds of the errors over an orbit.
struct ErrorsOfOrbit {
    double settled;               ///< of every displacement, as far as Newton's method can settle it; in units of P / k_1
    double displacement;          ///< of every displacement, errors of the mode shapes included; the bound that is handed out
    std::vector<double> velocity; ///< of the velocity of each mass, then of a contact between two, mode shapes included
};

/// @brief Bounds of the errors over the orbit to which the map was applied last, with its Jacobian; none if 1 - DP is
/// singular to rounding. The start is as far from the fixed point as \f$ |(1 - DP)^{-1}| \f$ times the difference of the two ends
/// and the rounding of the map; with mu > 1 the largest growth that the Jacobian shows is allowed for along the orbit.
[[nodiscard]] std::optional<ErrorsOfOrbit> errors_of(const OrbitMap& map);

/// @brief Reads the orbit with the state z at tau = 0 off the map that was applied to it last, with its Jacobian. None if its
/// error is too large for a number, or the contact does not surely slip.
[[nodiscard]] std::optional<PeriodicOrbit> orbit_of(const OrbitMap& map, const State& z, const OrbitSearch& search);

/// @brief The steady motion with the contact at rest in x_j, to which the map is applied; none if the contact does not stay.
[[nodiscard]] std::optional<PeriodicOrbit> rest_of(OrbitMap& map, const LastingRest& rest, double x_j, const OrbitSearch& search);

/// @brief Multipliers of the map that was applied last, with the error of its rounding alone, as if the instants of events were
/// known. With mu = 1 no deviation grows, wherever they are.
[[nodiscard]] std::vector<Multiplier> multipliers_next_to(const OrbitMap& map);

/// @brief Multipliers of the other masses, over the stretch of the map that was applied to a motion whose contact rested throughout.
[[nodiscard]] std::vector<Multiplier> multipliers_of_rest(const OrbitMap& map);

/// @brief Floquet multipliers of the orbit to which the map was applied last, over its stretch, with the errors of its events too.
[[nodiscard]] std::vector<Multiplier> multipliers_of_orbit(const OrbitMap& map, const ErrorsOfOrbit& errors);

} // namespace denhartog

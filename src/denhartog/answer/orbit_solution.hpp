/// @file
/// @brief The answer that a periodic orbit gives: amplitudes and phases of all masses with their errors; and the motions
/// that other starts lead to.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>

#include "denhartog/answer/solution.hpp"
#include "denhartog/orbit/periodic_orbit.hpp"
#include "denhartog/sliding/bounded_modes.hpp"

namespace denhartog {

/// @brief A periodic orbit as an answer.
struct OrbitSolution {
    std::vector<SolvedMass> masses;        ///< N, and that of a contact between two; zero where not asked about
    std::vector<SolvedMass> from_ground{}; ///< N in their absolute motion, where a frame that moves was asked about
    std::vector<SolvedStop> stops;         ///< stops of the contact
    double relative_amplitude = 0;         ///< largest error of an amplitude, relative
    double phase_error = 0;                ///< largest error of a phase
};

/// @brief Amplitudes, phases and stops of an orbit with their errors.
///
/// The error of a phase is that of the velocity at the extremum over the acceleration there. That of an instant at which a stop
/// begins is found likewise, and that of its end from the load on the contact and its rate. Where the rate may vanish within the
/// error, an instant may be anywhere. The solver is moved along the orbit once more. With `only` one mass is asked about; for the
/// contact the orbit needs no other. `frame` is by how much the frame of the displacements moves.
[[nodiscard]] OrbitSolution orbit_solution(ExactSolver& solver, const PeriodicOrbit& orbit,
                                           std::optional<Mass> only = std::nullopt, double frame = 0);

/// @brief Where the contact of an orbit of permanent sticking rests; none without a finite bound of its error.
[[nodiscard]] std::optional<Certified> place_of_rest(const PeriodicOrbit& orbit);

/// @brief Whether an orbit is the sliding motion of the closed form, whose contact has the amplitude X_j, as far as double can
/// tell. Its stops are left aside: next to the boundary they may be rounding. So is whether it mirrors itself, which is rounding
/// where deviations die out slowly.
[[nodiscard]] inline bool is_sliding_motion(const PeriodicOrbit& orbit, double X_j) {
    return orbit.periods == 1 && std::abs(orbit.contact.amplitude - X_j) <= 16 * orbit.error_bound + 1e-9 * X_j;
}

/// @brief Whether an orbit below the boundary of sliding can be no other than the closed form's. Static friction acts in stops
/// alone: a motion without any is one with mu = 1, and that is unique where every free motion is damped.
[[nodiscard]] inline bool must_be_sliding_motion(const PeriodicOrbit& orbit, bool damped) {
    return damped && orbit.stops.empty();
}

/// @brief Whether double does not tell if the contact stops: beyond the boundary the stops of a motion may be too short to be
/// seen, and of the sliding motion they may be rounding. The boundary is that of sliding. `stops` tells whether the motion has
/// stops for certain, as it has beyond the boundary where mu = 1 or every free motion is damped: static friction acts in stops
/// alone, so that a motion without any is one with mu = 1, and that the closed form's. `slides` tells whether it is the sliding
/// motion of the closed form.
[[nodiscard]] inline bool stops_are_open(const PeriodicOrbit& orbit, bool beyond, bool stops, bool slides) {
    return orbit.stops.empty() ? stops || (beyond && orbit.symmetric && orbit.periods == 1) : slides;
}

/// @brief Sizes of the multipliers of an orbit whose stability was computed, and the verdict.
[[nodiscard]] Stability stability_of(const PeriodicOrbit& orbit);

/// @brief Distinct steady motions, the one from rest first; none where no start leads to one.
///
/// Starts: rest; the sliding motion of the closed form, and larger and smaller ones; the contact displaced to either side; random
/// states in the size of the motion without friction; the orbits of neighbouring r and beta, from both sides. Unstable orbits are
/// those that Newton's method finds from the same starts. Where the motion is known to be unique the start from rest alone is
/// followed. With mu > 1 the motion depends on the start: what is listed was found, and what was not found may still exist. The
/// starts are the same in every run.
[[nodiscard]] std::vector<OtherMotion> other_motions(const Scene<double>& scene, const ContactSystem& system,
                                                     const std::shared_ptr<const ModalBasis<Bounded<double>>>& basis,
                                                     Effort* effort);

} // namespace denhartog

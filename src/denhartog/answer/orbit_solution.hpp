/// @file
/// @brief The answer that a periodic orbit gives: amplitudes and phases of all masses with their errors; and the motions
/// that other starts lead to.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>

#include "denhartog/answer/solution.hpp"
#include "denhartog/orbit/periodic_orbit.hpp"
#include "denhartog/sums/bounded_modes.hpp"

namespace denhartog {

/// @brief A periodic orbit as an answer.
struct OrbitSolution {
    std::vector<SolvedMass> masses;        ///< N, and that of a contact between two; zero where not asked about
    std::vector<SolvedMass> from_ground{}; ///< N in their absolute motion, where a frame that moves was asked about
    std::vector<SolvedStop> stops;         ///< stops of the contact
    double relative_amplitude = 0;         ///< largest error of an amplitude, relative
    double phase_error = 0;                ///< largest error of a phase
};

/// @brief Amplitudes, phases and stops of an orbit, along which the solver is moved once more. The error of a phase is that of the
/// velocity at the extremum over the acceleration there; so is that of an instant, of the end of a stop with the load on the contact
/// and its rate. With `only` one mass is asked about. `frame` is by how much the frame of the displacements moves.
[[nodiscard]] OrbitSolution orbit_solution(ExactSolver& solver, const PeriodicOrbit& orbit,
                                           std::optional<Mass> only = std::nullopt, double frame = 0);

/// @brief Where the contact of an orbit of permanent sticking rests; none without a finite bound of its error.
[[nodiscard]] std::optional<Certified> place_of_rest(const PeriodicOrbit& orbit);

/// @brief Whether an orbit is the sliding motion of the closed form, whose contact has the amplitude X_j, as far as double can tell:
/// its stops, and whether it mirrors itself, may be rounding next to the boundary.
[[nodiscard]] inline bool is_sliding_motion(const PeriodicOrbit& orbit, double X_j) {
    return orbit.periods == 1 && std::abs(orbit.contact.amplitude - X_j) <= 16 * orbit.error_bound + 1e-9 * X_j;
}

/// @brief Whether an orbit below the boundary can be no other than the closed form's: static friction acts in stops alone, so that one
/// without any is a motion with mu = 1, and that is unique where every free motion is damped.
[[nodiscard]] inline bool must_be_sliding_motion(const PeriodicOrbit& orbit, bool damped) {
    return damped && orbit.stops.empty();
}

/// @brief Whether double does not tell if the contact stops: beyond the boundary of sliding stops may be too short to be seen, and
/// those of the closed form's motion (`slides`) may be rounding. `stops`: the motion has some for certain.
[[nodiscard]] inline bool stops_are_open(const PeriodicOrbit& orbit, bool beyond, bool stops, bool slides) {
    return orbit.stops.empty() ? stops || (beyond && orbit.symmetric && orbit.periods == 1) : slides;
}

/// @brief Sizes of the multipliers of an orbit whose stability was computed, and the verdict.
[[nodiscard]] Stability stability_of(const PeriodicOrbit& orbit);

/// @brief Distinct steady motions that were found, the one from rest first; more may exist. The starts are the same in every run:
/// rest; the sliding motion, larger and smaller ones; the contact displaced; random states; the orbits of neighbouring r and beta.
/// Newton's method from these finds the unstable ones. Where the motion is known to be unique rest alone is followed.
[[nodiscard]] std::vector<OtherMotion> other_motions(const Scene<double>& scene, const ContactSystem& system,
                                                     const std::shared_ptr<const ModalBasis<Bounded<double>>>& basis,
                                                     Effort* effort);

} // namespace denhartog

/// @file
/// @brief The models that answer in double, every number with its bound: the closed form where the contact slides throughout, the
/// stuck response where it rests for ever, and the periodic orbit of the exact solver; whether the motion is the only one,
/// and the motions that other starts lead to.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "denhartog/answer/certify.hpp"
#include "denhartog/answer/scene_source.hpp"
#include "denhartog/answer/solution.hpp"
#include "denhartog/model/modal_basis.hpp"
#include "denhartog/model/stuck_configuration.hpp"
#include "denhartog/number/bounded.hpp"
#include "denhartog/orbit/periodic_orbit.hpp"
#include "denhartog/sliding/boundary.hpp"
#include "denhartog/sliding/bounded_modes.hpp"
#include "denhartog/sliding/friction_motion.hpp"
#include "denhartog/sliding/steady_state.hpp"

namespace denhartog {

/// @brief A damping matrix hardly couples the modes where no entry of phi^T C phi between two modes is a larger part of the
/// geometric mean of theirs. (56) is then that of the modes by themselves, if the coupling does not change (69) by more than
/// `hardly_changed`.
inline constexpr double hardly_coupled = 1e-6;
/// @brief See `hardly_coupled`: a part of (69).
inline constexpr double hardly_changed = 1e-9;

/// @brief The sums at a frequency ratio, and what searches for instants need of them: values without bounds, found when first
/// asked for.
class SearchedSums {
public:
    /// @brief Of sums. Searches take their share of `effort`.
    explicit SearchedSums(ModeSums<Bounded<double>> sums, Effort* effort) : sums_(std::move(sums)), effort_(effort) {}
    SearchedSums(const SearchedSums&) = delete;
    SearchedSums& operator=(const SearchedSums&) = delete;
    /// @brief The sums.
    [[nodiscard]] const ModeSums<Bounded<double>>& sums() const { return sums_; }
    /// @brief The sums without bounds.
    [[nodiscard]] const ModeSums<double>& values() { return values_ ? *values_ : values_.emplace(values_of(sums_)); }
    /// @brief Friction's share of the motion.
    [[nodiscard]] FrictionMotions& motions();
    /// @brief The instants of the largest demands: that of the sum over modes, then those of the modes.
    [[nodiscard]] std::vector<double> demands();
    /// @brief The steady state below the boundary; `with_rivals` the errors of phases hold other instants that may be the
    /// largest's.
    /// @eq{38,39,44,45,47,52,53}
    [[nodiscard]] SteadyState<Bounded<double>> steady_state(const Bounded<double>& beta, std::optional<Mass> only,
                                                            bool with_rivals);

private:
    ModeSums<Bounded<double>> sums_;
    Effort* effort_;
    std::optional<ModeSums<double>> values_{};
    std::optional<FrictionMotions> motions_{};
};

/// @brief True of a mode that the load excites, beyond the bounds of its shape.
[[nodiscard]] bool is_excited(const ModalBasis<Bounded<double>>& basis, const System<double>& system, std::size_t mode);

/// @brief The knowledge of a point.
struct SlidingPoint {
    Boundary<Bounded<double>> boundary;                ///< the boundary there
    std::optional<RegimeAtPoint> regime;               ///< the regime; none without a friction ratio
    std::optional<SteadyState<Bounded<double>>> state; ///< the steady state, in the sliding regime and where it was asked for
    std::vector<MassFromGround> from_ground{};         ///< the masses as seen from the ground, where base or wall move
    Attempted attempted{0};                            ///< the largest error, and whether the regime is certain
};

/// @brief The point of a scene, without beta its boundary alone; if one mass is asked about no other has a maximum. Errors count
/// relative to amplitudes and friction ratios, absolute for phases. DomainError at a pole of a mode without damping,
/// PrecisionError where a maximum is not settled. @eq{38,39,44,45,47,52,53,69}
[[nodiscard]] SlidingPoint sliding_point(const Scene<double>& scene, const ModalBasis<Bounded<double>>& basis,
                                         const Question& question, Effort* effort = nullptr);

/// @brief The point of a scene as an answer; `modes` are those in double, if they are prepared. A bad scene and bad digits are an
/// InputError, a pole is a DomainError, which says `Why::pole_by_rounding` if it is within a few units in the last place.
[[nodiscard]] Solution sliding_solution(const SceneSource& source, const Question& question,
                                        std::shared_ptr<const ModalBasis<Bounded<double>>> modes = nullptr);

/// @brief The stuck response with its error.
struct HeldSolution {
    std::vector<SolvedMass> masses;          ///< N; the contact's amplitude is zero
    std::vector<MassFromGround> from_ground; ///< N, where base or wall move: the same as it is seen from the ground
    RestInterval rest_interval;              ///< where the contact may rest
    std::optional<Certified> sticking_by_88; ///< the boundary of permanent sticking by (88) as printed, for chains
    double relative = 0;                     ///< largest error, relative to amplitudes, absolute for phases
};

/// @brief The stuck response for rest at zero; what it leaves over in the equations of motion bounds its error. With `only` the
/// errors of one mass count. DomainError where the load excites the resonance of an undamped stuck mode. @eq{88}
[[nodiscard]] HeldSolution held_solution(const Scene<double>& scene, const StuckConfiguration& stuck,
                                         const ModalBasis<Bounded<double>>& basis, std::optional<Mass> only = std::nullopt);

/// @brief The boundary of permanent sticking by (88) as printed; none for a system that is no chain, or at a resonance. @eq{88}
[[nodiscard]] std::optional<Certified> sticking_by_88(const Scene<double>& scene);

/// @brief A periodic orbit as an answer.
struct OrbitSolution {
    std::vector<SolvedMass> masses;        ///< N, and that of a contact between two; zero where not asked about
    std::vector<SolvedMass> from_ground{}; ///< N in their absolute motion, where a frame that moves was asked about
    std::vector<SolvedStop> stops;         ///< stops of the contact
    double relative_amplitude = 0;         ///< largest error of an amplitude, relative
    double phase_error = 0;                ///< largest error of a phase
};

/// @brief Amplitudes, phases and stops of an orbit, along which the solver is moved once more. The error of a phase is that of
/// the velocity at the extremum over the acceleration there; so is that of an instant, of the end of a stop with the load on the
/// contact and its rate. With `only` one mass is asked about. `frame` is by how much the frame of the displacements moves.
[[nodiscard]] OrbitSolution orbit_solution(ExactSolver& solver, const PeriodicOrbit& orbit,
                                           std::optional<Mass> only = std::nullopt, double frame = 0);

/// @brief Where the contact of an orbit of permanent sticking rests; none without a finite bound of its error.
[[nodiscard]] std::optional<Certified> place_of_rest(const PeriodicOrbit& orbit);

/// @brief True of an orbit that is the closed form's sliding motion, whose contact has the amplitude X_j, as far as double can
/// tell: its stops, and whether it mirrors itself, may be rounding next to the boundary.
[[nodiscard]] inline bool is_sliding_motion(const PeriodicOrbit& orbit, double X_j) {
    return orbit.periods == 1 && std::abs(orbit.contact.amplitude - X_j) <= 16 * orbit.error_bound + 1e-9 * X_j;
}

/// @brief True of an orbit below the boundary that can be no other than the closed form's: static friction acts in stops alone,
/// so that one without any is a motion with mu = 1, and that is unique where every free motion is damped.
[[nodiscard]] inline bool must_be_sliding_motion(const PeriodicOrbit& orbit, bool damped) {
    return damped && orbit.stops.empty();
}

/// @brief True where double does not tell if the contact stops: beyond the boundary of sliding stops may be too short to be seen,
/// and those of the closed form's motion (`slides`) may be rounding. `stops`: the motion has some for certain.
[[nodiscard]] inline bool stops_are_open(const PeriodicOrbit& orbit, bool beyond, bool stops, bool slides) {
    return orbit.stops.empty() ? stops || (beyond && orbit.symmetric && orbit.periods == 1) : slides;
}

/// @brief Sizes of the multipliers of an orbit whose stability was computed, and the verdict.
[[nodiscard]] Stability stability_of(const PeriodicOrbit& orbit);

/// @brief Distinct steady motions that were found, the one from rest first; more may exist. The starts are the same in every run:
/// rest; the sliding motion, larger and smaller ones; the contact displaced; random states; the orbits of neighbouring r and
/// beta. Newton's method from these finds the unstable ones. Where the motion is known to be unique rest alone is followed.
[[nodiscard]] std::vector<OtherMotion> other_motions(const Scene<double>& scene, const ContactSystem& system,
                                                     const std::shared_ptr<const ModalBasis<Bounded<double>>>& basis,
                                                     Effort* effort);

/// @brief Says whether the velocities are known not to depend on the start, and why; and what is steady besides where a mode
/// without damping keeps any share of the sliding motion. The answer has its point already; `contact` is the row of the contact
/// in the shapes of the basis.
///
/// With mu = 1 no two motions move apart, and their distance stays the same only if friction and dampers do no work on their
/// difference. That is then a free motion of modes without damping, which lets the contact turn at the same instants: at
/// multiples of pi. Of modes whose phases over pi are told from 0, from pi and from each other's it is zero. A mode with an even
/// number of periods in one of the force may keep any share. Of one mass that stops, two motions at the same distance rest and
/// break away together, and so from the same place.
void say_whether_unique(const ModalBasis<Bounded<double>>& basis, Mass contact, const System<double>& system, double mu,
                        Solution& s);

} // namespace denhartog

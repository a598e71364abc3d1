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

/// @brief The sums at a frequency ratio, and what searches for instants need of them, found when first asked for.
class SearchedSums {
public:
    /// @brief Of sums. Searches take their share of `effort`.
    explicit SearchedSums(ModeSums<Bounded<double>> sums, Effort* effort) : sums_(std::move(sums)), effort_(effort) {}
    SearchedSums(const SearchedSums&) = delete;
    SearchedSums& operator=(const SearchedSums&) = delete;
    [[nodiscard]] const ModeSums<Bounded<double>>& sums() const { return sums_; } ///< the sums
    /// @brief The sums without bounds.
    [[nodiscard]] const ModeSums<double>& values() { return values_ ? *values_ : values_.emplace(values_of(sums_)); }
    [[nodiscard]] std::vector<double> demands(); ///< instants of the largest demands: of the sum over modes, then of each mode
    /// @brief The steady state below the boundary; with `with_rivals` the error of a phase reaches
    /// to every other instant at which the displacement may be largest.
    /// @eq{38,39,44,45,47,52,53}
    [[nodiscard]] SteadyState<Bounded<double>> steady_state(const Bounded<double>& beta, std::optional<Mass> only,
                                                            bool with_rivals);

private:
    FrictionMotions& motions(); // friction's share of the motion

    ModeSums<Bounded<double>> sums_;
    Effort* effort_;
    std::optional<ModeSums<double>> values_{};
    std::optional<FrictionMotions> motions_{};
};

/// @brief True of a mode that the load excites, beyond the bounds of its shape.
[[nodiscard]] bool is_excited(const ModalBasis<Bounded<double>>& basis, const System<double>& system, std::size_t mode);

/// @brief Writes the point and the question into an answer.
void set_point(const System<double>& system, double r, std::optional<double> beta, double mu, Asked asked, Solution& s);

/// @brief Boundary, regime and sliding motion of a scene; `modes` are those in double, if they are prepared. Without beta there
/// is the boundary alone; if one mass is asked about no other has a maximum. Errors count relative to amplitudes and friction
/// ratios, absolute for phases. A bad scene and bad digits are an InputError, PrecisionError says that a maximum is not settled,
/// or that a boundary has no digits or is beyond the range of a double, DomainError that a mode without damping is at a pole,
/// with `Why::pole_by_rounding` within a few units in the last place. @eq{38,39,44,45,47,52,53,69}
[[nodiscard]] Solution sliding_solution(const SceneSource& source, const Question& question,
                                        std::shared_ptr<const ModalBasis<Bounded<double>>> modes = nullptr);

/// @brief Writes the stuck response for rest at zero into an answer: masses, where the contact may rest, (88) as printed, and the
/// largest error, relative to amplitudes, absolute for phases. The error is bounded by what the response leaves over in the
/// equations of motion. With `only` the errors of one mass count. DomainError where the load excites the resonance of an undamped
/// stuck mode, PrecisionError where the digits do not suffice. @eq{88}
void set_stuck_response(const Scene<double>& scene, const StuckConfiguration& stuck, const ModalBasis<Bounded<double>>& basis,
                        std::optional<Mass> only, Solution& s);

/// @brief The boundary of permanent sticking by (88) as printed; none for a system that is no chain, or at a resonance. @eq{88}
[[nodiscard]] std::optional<Certified> sticking_by_88(const Scene<double>& scene);

/// @brief Writes the motion of an orbit into an answer: masses, stops, start, period, stability and the largest error, from one
/// more run of the solver. The entry of a mass that is not asked about is zero. The error of a phase is that of the velocity at
/// the extremum over the acceleration there; so is that of the start of a stop; that of its end is the error of the load on the
/// contact over its rate.
void set_motion_of_orbit(const Scene<double>& scene, const Question& question, ExactSolver& solver, const PeriodicOrbit& orbit,
                         Solution& s);

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
/// beta. Newton's method from these may find unstable ones. Where the motion is known to be unique rest alone is followed.
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

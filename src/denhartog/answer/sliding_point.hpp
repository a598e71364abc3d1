/// @file
/// @brief Boundary, regime and, where the contact slides throughout, the steady state of one point, every number with its bound;
/// and the answer that they make.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "denhartog/answer/certify.hpp"
#include "denhartog/answer/scene_source.hpp"
#include "denhartog/answer/solution.hpp"
#include "denhartog/sliding/regime.hpp"
#include "denhartog/sliding/steady_state.hpp"
#include "denhartog/sums/bounded_modes.hpp"
#include "denhartog/sums/friction_motion.hpp"

namespace denhartog {

/// @brief A damping matrix hardly couples the modes where no entry of phi^T C phi between two modes is a larger part of the
/// geometric mean of theirs. (56) is then that of the modes by themselves, if the coupling does not change (69) by more than
/// `hardly_changed`.
inline constexpr double hardly_coupled = 1e-6;
/// @brief See `hardly_coupled`: a part of (69).
inline constexpr double hardly_changed = 1e-9;

/// @brief The sums at a frequency ratio, and what searches for instants need of them: values without bounds, found when first asked for.
class SearchedSums {
public:
    /// @brief Of sums. Searches take their share of `effort`.
    explicit SearchedSums(ModeSums<Bounded<double>> sums, Effort* effort) : sums_(std::move(sums)), effort_(effort) {}
    SearchedSums(const SearchedSums&) = delete;
    SearchedSums& operator=(const SearchedSums&) = delete;
    /// @brief The sums.
    [[nodiscard]] const ModeSums<Bounded<double>>& sums() const { return sums_; }
    /// @brief The same without bounds.
    [[nodiscard]] const ModeSums<double>& values() { return values_ ? *values_ : values_.emplace(values_of(sums_)); }
    /// @brief Friction's share of the motion.
    [[nodiscard]] FrictionMotions& motions();
    /// @brief The instants of the largest demands: that of the sum over modes, then those of the modes.
    [[nodiscard]] std::vector<double> demands();
    /// @brief The steady state below the boundary; `with_rivals` the errors of phases hold other instants that may be the largest's.
    /// @eq{38,39,44,45,47,52,53}
    [[nodiscard]] SteadyState<Bounded<double>> steady_state(const Bounded<double>& beta, std::optional<Mass> only,
                                                            bool with_rivals);

private:
    ModeSums<Bounded<double>> sums_;
    Effort* effort_;
    std::optional<ModeSums<double>> values_{};
    std::optional<FrictionMotions> motions_{};
};

/// @brief What is known of a point.
struct SlidingPoint {
    Boundary<Bounded<double>> boundary;                ///< the boundary there
    std::optional<RegimeAtPoint> regime;               ///< the regime; none without a friction ratio
    std::optional<SteadyState<Bounded<double>>> state; ///< the steady state, in the sliding regime and where it was asked for
    std::vector<MassFromGround> from_ground{};         ///< the same as it is seen from the ground, where base or wall move
    Attempted attempted{0};                            ///< the largest error, and whether the regime is certain
};

/// @brief The point of a scene, without beta its boundary alone; if one mass is asked about no other has a maximum. Errors count
/// relative to amplitudes and friction ratios, absolute for phases. DomainError at a pole of a mode without damping, PrecisionError
/// where a maximum is not settled. @eq{38,39,44,45,47,52,53,69}
[[nodiscard]] SlidingPoint sliding_point(const Scene<double>& scene, const ModalBasis<Bounded<double>>& basis,
                                         const Question& question, Effort* effort = nullptr);

/// @brief The same as an answer; `modes` are those in double, where they are prepared. A bad scene and bad digits are an InputError,
/// a pole is a DomainError, which says `Why::pole_by_rounding` if it is within a few units in the last place.
[[nodiscard]] Solution sliding_solution(const SceneSource& source, const Question& question,
                                        std::shared_ptr<const ModalBasis<Bounded<double>>> modes = nullptr);

} // namespace denhartog

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

/// @brief The sums at a frequency ratio, and what searches for instants need of them, which is set up when it is first asked for:
/// they look at values without bounds, and share many instants.
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
    /// @brief The steady state below the boundary. `with_rivals` looks for other instants at which a displacement may be largest,
    /// which the error of its phase then holds. @eq{38,39,44,45,47,52,53}
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

/// @brief What is asked of a point.
struct PointWish {
    bool motion = true;         ///< whether the steady state is wanted too, or boundary and regime alone
    bool limits = true;         ///< whether the friction ratios of the boundary must have the digits, or the regime be certain
    std::optional<Mass> only{}; ///< the one mass that must have the digits: no other has a maximum; none for all
    bool from_ground = false;   ///< whether absolute displacements are wanted too, where base or wall move
};

/// @brief The point of a scene; searches take their share of `effort`.
///
/// The instants of the maxima are searched for on values alone, and the formulas are then evaluated there with bounds. Errors
/// count relative to amplitudes and friction ratios, absolute for phases. A mass that does not move, and a contact that the load
/// does not reach, have none. Without beta the boundary alone is computed. At a pole of a mode without damping it throws
/// DomainError, and where a maximum is not settled PrecisionError.
/// @eq{38,39,44,45,47,52,53,69}
[[nodiscard]] SlidingPoint sliding_point(const Scene<double>& scene, const ModalBasis<Bounded<double>>& basis,
                                         const PointWish& wish, Effort* effort = nullptr);

/// @brief What is asked of the closed form.
struct SlidingQuestion {
    Asked asked = Asked::motion; ///< what is asked; `regime` needs no motion
    std::optional<int> digits{}; ///< significant digits; without, 6 are aimed at
    std::optional<Mass> only{};  ///< the one mass that must have them: no other has a maximum; none for all
    std::shared_ptr<const ModalBasis<Bounded<double>>> modes{}; ///< modes in double, where they are prepared
};

/// @brief Boundary, regime and sliding motion at the point of a scene, in double.
///
/// Digits are relative to the amplitude of the mass for displacements, to the value for friction ratios, absolute for phases; a
/// mass that does not move has none. Without beta there is the boundary alone, and outside the sliding regime there are no
/// masses. A bad scene and bad digits are an InputError, a pole of a mode without damping is a DomainError, which says
/// `Why::pole_by_rounding` if it is within a few units in the last place.
/// @eq{38,39,44,45,47,52,53,69}
[[nodiscard]] Solution sliding_solution(const SceneSource& source, const SlidingQuestion& question);

} // namespace denhartog

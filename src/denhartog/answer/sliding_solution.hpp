/// @file
/// @brief The response at one point by the closed form: boundary, regime and, where the contact slides throughout, its motion.
#pragma once

#include <memory>
#include <optional>

#include "denhartog/answer/scene_source.hpp"
#include "denhartog/answer/sliding_point.hpp"
#include "denhartog/answer/solution.hpp"

namespace denhartog {

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
/// masses. A bad scene and bad digits are an InputError, a pole of a mode without damping is a DomainError.
/// @eq{38,39,44,45,47,52,53,69}
[[nodiscard]] Solution sliding_solution(const SceneSource& source, const SlidingQuestion& question);

} // namespace denhartog

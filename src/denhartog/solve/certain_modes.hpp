/// @file
/// @brief Natural frequencies, damping ratios, mode shapes, and what each mode contributes, to `digits_by_default` digits.
///
/// Of other systems than chains double has the squares of natural frequencies to some units of the highest one. Beside a light
/// mass or a stiff spring that leaves the lowest ones few digits; the reference then has the modes.
#pragma once

#include <memory>
#include <vector>

#include "denhartog/answer/scene_source.hpp"
#include "denhartog/sums/bounded_modes.hpp"

namespace denhartog {

/// @brief The modal basis, in double if that has the digits, else by the reference.
///
/// Of modes with one frequency, and of more than 200 masses, it is what double has.
/// @eq{14,15,18}
[[nodiscard]] std::shared_ptr<const ModalBasis<Bounded<double>>>
certain_modes(const SceneSource& source, const std::shared_ptr<const ModalBasis<Bounded<double>>>& basis);

/// @brief (23), (28), (29) of each mode at the frequency ratio of a scene, in double if that has the digits, else by the
/// reference. The modes are not coupled; DomainError where an undamped one is at a pole. @eq{22,23,28,29}
[[nodiscard]] std::vector<evaluation::ModeFunctions<Bounded<double>>>
certain_mode_functions(const SceneSource& source, const std::shared_ptr<const ModalBasis<Bounded<double>>>& basis);

} // namespace denhartog

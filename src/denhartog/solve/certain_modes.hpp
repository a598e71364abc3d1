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
/// @param source  the system
/// @param basis   its basis in double, see `modes_in_double`
/// @return        the basis with bounds of its errors
/// @throws        as `modal_basis`
[[nodiscard]] std::shared_ptr<const ModalBasis<Bounded<double>>>
certain_modes(const SceneSource& source, const std::shared_ptr<const ModalBasis<Bounded<double>>>& basis);

/// @brief What each mode contributes at the frequency ratio of a scene, in double if that has the digits, else by the reference.
/// @eq{22,23,28,29}
/// @param source  the scene, with r
/// @param basis   its modes, none coupled
/// @return        (23), (28), (29) of each mode
/// @throws        DomainError where an undamped mode is at a pole of (23), (28)
[[nodiscard]] std::vector<evaluation::ModeFunctions<Bounded<double>>>
certain_mode_functions(const SceneSource& source, const std::shared_ptr<const ModalBasis<Bounded<double>>>& basis);

} // namespace denhartog

/// @file
/// @brief The modes of a system in double; where double has none, those of the reference, rounded. What an answer says of a
/// damping matrix that couples them.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "denhartog/answer/scene_source.hpp"
#include "denhartog/evaluation/mode_values.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {

/// @brief The modal basis in double.
struct ModesInDouble {
    std::shared_ptr<const ModalBasis<Bounded<double>>> basis; ///< with bounds of its errors
    Reasons rounded_because{};                                ///< why double has none, where the reference found it; else empty
};

/// @brief Finds the modes of a system.
[[nodiscard]] ModesInDouble modes_in_double(const SceneSource& source);

/// @brief Prepares a system for the exact solver in double, sliding and stuck.
[[nodiscard]] std::shared_ptr<const ContactSystem> moving_in_double(const SceneSource& source, const ModesInDouble& modes);

/// @brief The same with the modes of the reference; `because` says why double has none, or not their digits.
[[nodiscard]] ContactSystem moving_by_reference(const SceneSource& source, const Reasons& because);

/// @brief A damping matrix that couples the modes.
struct CoupledDamping {
    bool taken_in;                      ///< whether the coupling counts, or is left out as `damping_tolerance` allows
    double distance_from_classical;     ///< as that measures it
    double largest_coupling;            ///< of an entry between two modes, over the geometric mean of theirs
    std::vector<double> damping_ratios; ///< those nearest to the matrix, mode by mode
};

/// @brief Whether the damping matrix of a scene couples the modes, and how much: double tells, or else the reference. None where
/// damping was given by ratios, or by a matrix that does not couple the modes by more than the bounds of its entries. @eq{18}
[[nodiscard]] std::optional<CoupledDamping> coupled_damping(const SceneSource& source);

/// @brief The modal basis to `digits_by_default` digits, in double if that has them, else by the reference.
///
/// Of other systems than chains double has the squares of natural frequencies to some units of the highest one. Beside a light
/// mass or a stiff spring that leaves the lowest ones few digits. Of modes with one frequency, and of more than 200 masses, it is
/// what double has.
/// @eq{14,15,18}
[[nodiscard]] std::shared_ptr<const ModalBasis<Bounded<double>>>
certain_modes(const SceneSource& source, const std::shared_ptr<const ModalBasis<Bounded<double>>>& basis);

/// @brief (23), (28), (29) of each mode at the frequency ratio of a scene, in double if that has the digits, else by the
/// reference. The modes are not coupled; DomainError where an undamped one is at a pole. @eq{22,23,28,29}
[[nodiscard]] std::vector<evaluation::ModeFunctions<Bounded<double>>>
certain_mode_functions(const SceneSource& source, const std::shared_ptr<const ModalBasis<Bounded<double>>>& basis);

} // namespace denhartog

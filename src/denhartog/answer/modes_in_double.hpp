/// @file
/// @brief The modes of a system in double; where double has none, those of the reference, rounded.
#pragma once

#include <memory>
#include <string>

#include "denhartog/answer/scene_source.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {

/// @brief The modal basis in double.
struct ModesInDouble {
    std::shared_ptr<const ModalBasis<Bounded<double>>> basis; ///< with bounds of its errors
    std::string rounded_because{};                            ///< why double has none, where the reference found it; else empty
};

/// @brief Whether a damping matrix, given as `D` of the modes, certainly couples two of them.
[[nodiscard]] bool certainly_couples(const ModalBasis<Bounded<double>>& basis);

/// @brief Takes modes that a damping matrix does not couple, or hardly, to move by themselves. Their `D` is taken from them, and
/// they get bounds of what is left out.
void leave_out_coupling(ModalBasis<Bounded<double>>& basis);

/// @brief Finds the modes of a system.
[[nodiscard]] ModesInDouble modes_in_double(const SceneSource& source);

/// @brief Prepares a system for the exact solver in double, sliding and stuck.
[[nodiscard]] std::shared_ptr<const ContactSystem<double>> moving_in_double(const SceneSource& source,
                                                                            const ModesInDouble& modes);

/// @brief The same with the modes of the reference; `because` says why double has none, or not their digits.
[[nodiscard]] ContactSystem<double> moving_by_reference(const SceneSource& source, const std::string& because);

} // namespace denhartog

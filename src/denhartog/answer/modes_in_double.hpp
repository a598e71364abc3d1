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

/// @brief Whether a damping matrix certainly couples two modes. @param basis modes with their `D` @return true if so
[[nodiscard]] bool certainly_couples(const ModalBasis<Bounded<double>>& basis);

/// @brief Takes modes that a damping matrix does not couple, or hardly, to move by themselves.
/// @param basis  modes with their `D`, which is taken from them; gets bounds of what is left out
void leave_out_coupling(ModalBasis<Bounded<double>>& basis);

/// @brief Finds the modes. @param source the system @return the modes @throws as `modal_basis`
[[nodiscard]] ModesInDouble modes_in_double(const SceneSource& source);

/// @brief Prepares a system for the exact solver in double.
/// @param source  the system
/// @param modes   its modes
/// @return        the system, sliding and stuck
/// @throws        as `contact_system`
[[nodiscard]] std::shared_ptr<const ContactSystem> moving_in_double(const SceneSource& source, const ModesInDouble& modes);

/// @brief The same with the modes of the reference.
/// @param source   the system
/// @param because  why double has none, or not their digits
/// @return         the system, sliding and stuck
/// @throws         as `contact_system`
[[nodiscard]] ContactSystem moving_by_reference(const SceneSource& source, const std::string& because);

} // namespace denhartog

/// @file
/// @brief The modes of a system in double; where double has none, those of 50 digits, rounded.
#pragma once

#include <memory>
#include <string>

#include "denhartog/answer/sliding_point.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {

/// @brief The modal basis in double.
struct ModesInDouble {
    std::shared_ptr<const ModalBasis<Bounded<double>>> basis; ///< with bounds of its errors
    std::shared_ptr<const SceneIn<Real50>> rounded_from{};    ///< what 50 digits have, if double has no modes; else null
    std::string rounded_because{};                            ///< why double has none; else empty
};

/// @brief Finds them. @param source the system @return the modes @throws as `modal_basis`
[[nodiscard]] ModesInDouble modes_in_double(const SceneSource& source);

/// @brief Prepares a system for the exact solver in double.
/// @param source  the system
/// @param modes   its modes
/// @return        the system, sliding and stuck
/// @throws        as `contact_system`
[[nodiscard]] std::shared_ptr<const ContactSystem<double>> moving_in_double(const SceneSource& source,
                                                                            const ModesInDouble& modes);

} // namespace denhartog

/// @file
/// @brief The system as the exact solver needs it in double, also where double has no modes.
#pragma once

#include <memory>

#include "denhartog/answer/scene_source.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {

/// @brief Prepares a system for the exact solver in double; where double does not have its modes, 50 digits have them, rounded.
/// @param source  the system
/// @return        its modes, sliding and stuck
/// @throws        as `contact_system`
[[nodiscard]] std::shared_ptr<const ContactSystem<double>> moving_in_double(const SceneSource& source);

} // namespace denhartog

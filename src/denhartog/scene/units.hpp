/// @file
/// @brief From ratios to the units of a dimensional scene.
#pragma once

#include <cmath>

#include "denhartog/scene/scene.hpp"

namespace denhartog {

/// @brief Angular frequency \f$ \omega = r \sqrt{k_1 / m_1} \f$, Eq. (10) solved for it; radians per unit of time.
[[nodiscard]] inline double angular_frequency(const Units& units, double r) {
    return r * std::sqrt(units.stiffness / units.mass);
}

/// @brief The unit of displacements, \f$ P / k_1 \f$, where the force has the amplitude P.
[[nodiscard]] inline double displacement_unit(const Units& units, double P) { return P / units.stiffness; }

} // namespace denhartog

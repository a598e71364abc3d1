/// @file
/// @brief The energies that a steady motion dissipates in a period of the force, and the forces that it hands to wall and base.
#pragma once

#include <optional>

#include "denhartog/number/certified.hpp"

namespace denhartog {

/// @brief Friction as the dashpot that dissipates as much, and as textbooks have it.
struct EquivalentDamping {
    Certified
        coefficient; ///< \f$ c = W/(\pi\omega X^2) \f$ with the energy W and the amplitude X of the contact; units of sqrt(k_1 m_1)
    Certified ratio;                                   ///< \f$ c/(2\sqrt{k_1m_1}) \f$
    Certified textbook_energy;                         ///< \f$ 4FX \f$, units of P^2 / k_1
    Certified textbook_energy_error;                   ///< by what part of the energy it is off
    std::optional<Certified> textbook_amplitude;       ///< X by a dashpot \f$ 4F/(\pi\omega X) \f$ in place of friction, units of
                                                       ///< P / k_1; empty where friction is too large for that
    std::optional<Certified> textbook_amplitude_error; ///< by what part of the amplitude it is off
};

/// @brief Energies in a period of the force, and forces. Every number is proved. In a period the load does as much work as contact
/// and dampers take; of a motion that is longer than a period they are the mean over its periods.
///
/// Energies have their digits beside the largest work that the load could do on that motion, everything else beside itself.
struct Energies {
    Certified contact;  ///< that friction dissipates, units of P^2 / k_1
    Certified dampers;  ///< that the dampers dissipate, units of P^2 / k_1
    Certified friction; ///< largest friction force, which the contact hands to the wall, or to the other mass; units of P
    Certified on_base;  ///< largest force of springs and dampers on the base, without a constant load; units of P
    std::optional<EquivalentDamping> equivalent; ///< empty where the contact does not move
};

} // namespace denhartog

/// @file
/// @brief Energy that a steady motion dissipates in a period of the force, and forces on base and wall; proved in every regime.
///
/// Only the first harmonic of the motion takes energy from the load. With
/// \f$ \mathbf A = \mathbf K - r^2\mathbf M + \mathrm ir\mathbf C \f$ it is
/// \f$ \mathbf X = \mathbf A^{-1}(\mathbf p - \mathbf w\Lambda) \f$, where \f$ \Lambda \f$ is that of friction, whatever friction
/// does within the period.
#pragma once

#include <optional>
#include <vector>

#include "denhartog/formulas/complex.hpp"
#include "denhartog/reference/orbit.hpp"
#include "denhartog/reference/sliding.hpp"

namespace denhartog::reference {

/// @brief Energies in a period of the force, in units of \f$ P^2/k_1 \f$; of a longer motion their mean over its periods.
struct EnergiesInBalls {
    Ball contact{};   ///< that friction dissipates, \f$ \beta\oint|\mathbf w^T\mathrm d\bar{\mathbf x}| \f$
    Ball dampers{};   ///< that the dampers dissipate, \f$ r\oint\bar{\mathbf x}'^T\mathbf C\bar{\mathbf x}'\,\mathrm d\tau \f$
    Ball at_most{};   ///< \f$ \pi\sum_k|p_kX_k| \f$, which the load cannot exceed
    Ball amplitude{}; ///< largest displacement of the contact, in units of P / k_1
    Ball friction{};  ///< largest size of the force at the contact, in units of P
    Ball on_base{};   ///< largest size of the force that springs and dampers hand to the base, in units of P
    std::optional<Ball> by_textbooks{}; ///< amplitude of the contact by equivalent viscous damping; none if that has none
};

/// @brief The motion of the base in the frame of the displacements over cos tau, in units of P / k_1: 1 of a base that moves alone,
/// -1 in the frame of a wall that does, else 0.
[[nodiscard]] Ball motion_of_base_in_frame(BaseMotion motion);

/// @brief Energies that the sliding motion dissipates. The scene has its damping matrix; d is `motion_of_base_in_frame`.
/// @throws Unproved if more bits may help, as the next two do
[[nodiscard]] EnergiesInBalls energies_of_sliding(const SceneInBalls& s, const ResponsesInBalls& r, const Ball& d);

/// @brief Energies that a motion from phase to phase dissipates.
///
/// Over a phase of sliding \f$ \mathbf A\int\bar{\mathbf x}e^{-\mathrm i\tau}\mathrm d\tau \f$ is that of the forces, less the
/// change of \f$ (r^2\mathbf M(\bar{\mathbf x}' + \mathrm i\bar{\mathbf x}) + r\mathbf C\bar{\mathbf x})e^{-\mathrm i\tau} \f$:
/// states at events alone determine the first harmonic of the contact.
[[nodiscard]] EnergiesInBalls energies_of_orbit(const SceneInBalls& s, const OrbitInPhases& motion, const Ball& d);

/// @brief Energies that the motion with the contact at rest dissipates.
[[nodiscard]] EnergiesInBalls energies_of_rest(const SceneInBalls& s, const StuckInBalls& stuck, const Ball& d);

} // namespace denhartog::reference

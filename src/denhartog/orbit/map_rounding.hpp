/// @file
/// @brief What rounding and the errors of the modes make of the motion over a stretch.
#pragma once

#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {

/// @brief Bounds of what rounding makes of the end of a stretch.
struct MapRounding {
    Column<double> modal;  ///< of the modal displacements
    Column<double> turned; ///< what turned modes make of them
    /// @brief Of a modal displacement. @param i the mode @param of_modes whether with what turned modes make of it @return the bound
    [[nodiscard]] double of(Eigen::Index i, bool of_modes) const { return of_modes ? modal(i) + turned(i) : modal(i); }
};

/// @brief Of the end of a motion.
/// @param solver  the system, frequency and friction
/// @param motion  the motion
/// @param length  the time that it takes
/// @return        bounds
[[nodiscard]] MapRounding rounding_of_map(const ExactSolver& solver, const ExactMotion& motion, double length);

/// @brief Of the Jacobian of the end with respect to the start, the events apart.
/// @param solver  the system, frequency and friction
/// @param motion  the motion
/// @param length  the time that it takes
/// @return        a bound of the error, in the norm of the energy
[[nodiscard]] double rounding_of_jacobian(const ExactSolver& solver, const ExactMotion& motion, double length);

} // namespace denhartog

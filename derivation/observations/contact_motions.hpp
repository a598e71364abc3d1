/// @file
/// @brief The steady motion of the contact over grids of frequency and friction, by the exact solver: what Section 4.2 speaks of.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "denhartog/stick_slip/exact_motion.hpp"
#include "derivation/observations/observation.hpp"

namespace denhartog::derivation {

/// @brief The steady motion of the contact from rest, mu = 1.
struct ContactMotion {
    double X;          ///< amplitude
    std::size_t stops; ///< stops a period
    bool rests;        ///< it rests for ever
};

/// @brief The steady motion from rest. @param solver a system, set anew @param r frequency ratio @param beta friction ratio
/// @return  the motion
/// @throws  std::logic_error where none is found
[[nodiscard]] ContactMotion motion_of_contact(ExactSolver& solver, double r, double beta);

/// @brief The motions of the contact at a point, one for each damping ratio of the figures, ascending.
struct GridPoint {
    std::string system;                 ///< its name
    double r;                           ///< frequency ratio
    double beta;                        ///< friction ratio
    std::vector<ContactMotion> motions; ///< one a damping ratio
};

/// @brief SDOF and 2DOF j = 2, l = 1 over a grid, beta = 0.02 to 0.8.
/// @param frequencies  frequency ratios
/// @return             the points of both
[[nodiscard]] std::vector<GridPoint> contact_over_grid(const std::vector<double>& frequencies);

/// @brief A point as witness. @param p a point @return system, r, beta
[[nodiscard]] Witness place(const GridPoint& p);

/// @brief The largest change of the amplitude of the contact from zeta = 0.001 to 0.01 and to 0.1, where it moves with both.
/// @param grid       the points
/// @param counts     which motions count
/// @param threshold  the change that is said not to be exceeded
/// @return           refuted with the point, or unknown with the largest change
[[nodiscard]] Outcome change_with_damping(const std::vector<GridPoint>& grid,
                                          const std::function<bool(const ContactMotion&)>& counts, double threshold);

} // namespace denhartog::derivation

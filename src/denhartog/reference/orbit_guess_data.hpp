/// @file
/// @brief A motion with stops as double precision sees it: what a proof starts from.
#pragma once

#include <vector>

namespace denhartog {

/// @brief A periodic motion with stops as double precision sees it. Nothing in it is certain; a proof needs it to be near.
///
/// It covers one stretch: the period of the motion, or half of it if the other half is its mirror image, Eq. (25). Event 0 is
/// the first of the stretch; event m, a stretch later, is event 0 again.
struct OrbitGuess {
    /// m + 1 values: direction of the contact in the phase before event 0, then in the phases that end at events 1 to m. It is
    /// 1 or -1 while the contact slides, 0 while it sticks.
    std::vector<int> directions{};
    bool mirrored = false;         ///< whether the stretch is half of the period, and the other half its mirror image
    int periods = 1;               ///< period of the motion, in periods of the force
    std::vector<double> x{};       ///< displacements of the masses at event 0, units of P / k_1
    std::vector<double> x_prime{}; ///< their velocities there, with respect to tau
    std::vector<double> events{};  ///< tau of events 0 to m - 1, from a maximum of the force, ascending
    /// Instants at which the contact slides so slowly that it may in truth come to rest there, without turning; ascending
    std::vector<double> slow{};
};

} // namespace denhartog

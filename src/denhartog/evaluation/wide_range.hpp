/// @file
/// @brief (28) and (29) of doubles so large or so small that sums of two doubles leave their range on the way.
#pragma once

#include "denhartog/evaluation/mode_values.hpp"

namespace denhartog::evaluation {

/// @brief Whether (28) and (29) can be computed in sums of two doubles: neither overflow nor underflow takes a digit.
/// @param R     modal frequency ratio, Eq. (22)
/// @param zeta  modal damping ratio
/// @return      whether they can
[[nodiscard]] inline bool within_range_of_two_doubles(double R, double zeta) {
    return R > 0x1p-100 && R < 0x1p100 && zeta < 0x1p100 && (zeta > 0x1p-400 || zeta == 0);
}

/// @brief (28) and (29) in 50 digits, rounded once.
/// @param R     modal frequency ratio, Eq. (22)
/// @param zeta  modal damping ratio
/// @return      u, g
[[nodiscard]] DampingFunctions<double> damping_functions_in_50_digits(double R, double zeta);

} // namespace denhartog::evaluation

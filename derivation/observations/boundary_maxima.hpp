/// @file
/// @brief Largest departures of the boundaries of the sliding regime from each other, searched over the frequency ratio.
#pragma once

#include <functional>

#include "derivation/observations/observed_systems.hpp"
#include "tests/support/largest_over_range.hpp"

namespace denhartog::derivation {

/// @brief (67) over (69) with the maximum of the sum, less 1. @param b a boundary @return the departure
[[nodiscard]] double departure_of_67(const Boundary<double>& b);

/// @brief The relative loss of (69) by (56), the sum of the maxima in place of the maximum of the sum. @param b a boundary
/// @return  the loss
[[nodiscard]] double loss_by_56(const Boundary<double>& b);

/// @brief The largest value of a function of the boundary over the frequency ratio, mu = 1: a grid of 1000 parts, then closer
///        round its highest peaks. Poles of a mode without damping are passed over.
/// @param s     a system
/// @param low   least frequency ratio
/// @param high  largest
/// @param of    the function
/// @return      the largest value found, and where
[[nodiscard]] LargestOverRange largest_over_frequency(const ObservedSystem& s, double low, double high,
                                                      const std::function<double(const Boundary<double>&)>& of);

} // namespace denhartog::derivation

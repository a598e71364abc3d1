/// @file
/// @brief Searches for largest values where damping couples the modes: their bounds come from the free motion, which never grows.
#pragma once

#include <utility>

#include "denhartog/sums/mode_sums.hpp"

namespace denhartog {

/// @brief Where in [0, pi] (57)'s expression summed over the contact is largest, guaranteed by `global_maximum`; 0 stands for the
/// limit. PrecisionError where the maximum is not settled. @eq{56,57}
template <class T>
[[nodiscard]] T instant_of_largest_demand_where_coupled(const ModeSums<T>& s);

/// @brief Where in [0, pi] a displacement of the sliding regime is largest, and by how many radians the phase of another such
/// instant may differ; `error` bounds the error that the sums make of the displacement. @eq{46}
template <class T>
[[nodiscard]] std::pair<T, T> instant_and_spread_where_coupled(const ModeSums<T>& s, const T& beta, std::size_t k,
                                                               const T& error);

} // namespace denhartog

/// @file
/// @brief Searches for largest values where damping couples the modes: their bounds come from the free motion, which never grows.
#pragma once

#include <utility>

#include "denhartog/sums/mode_sums.hpp"

namespace denhartog {

/// @brief Where (57)'s expression summed over the contact is largest, guaranteed by `global_maximum`.
/// @eq{56,57}
/// @param s  sums of a system whose damping couples the modes
/// @return   non-dimensional time in [0, pi]; 0 stands for the limit
/// @throws   PrecisionError where the maximum is not settled
template <class T>
[[nodiscard]] T instant_of_largest_demand_where_coupled(const ModeSums<T>& s);

/// @brief Where a displacement is largest, and how far the phase of another such instant may be from that of this one.
/// @eq{46}
/// @param s      sums of a system whose damping couples the modes
/// @param beta   friction ratio, Eq. (11), in the sliding regime
/// @param k      the displacement
/// @param error  bound of the error that the sums make of it
/// @return       instant in [0, pi], and radians
template <class T>
[[nodiscard]] std::pair<T, T> instant_and_spread_where_coupled(const ModeSums<T>& s, const T& beta, std::size_t k,
                                                               const T& error);

} // namespace denhartog

/// @file
/// @brief The bound by which what friction demands may rise between two samples. Included by sources only.
#pragma once

#include <algorithm>

#include "denhartog/number/number.hpp"
#include "denhartog/sliding/maximum.hpp"

namespace denhartog {

/// @brief How far the demand may rise between two samples above the larger of them.
///
/// F sin solves y'' + y = Z, so that between two samples it exceeds the sine through them by at most
/// z_bound (cos(tau - m) / cos(h / 2) - 1); over the sine this is at most z_bound tan(h / 2) next to an end of the half-period.
/// In place of the sines and cosines stand the first terms of their series that bound them.
/// @param a        left end
/// @param b        right end, not more than 2 from it
/// @param z_bound  bound of |Z| between them
/// @return         the rise
template <class T>
T rise_of_demand(const T& a, const T& b, const T& z_bound) {
    const T half = (b - a) / 2, square = half * half;
    if (!(a > 0) || !(b < pi<T>())) return z_bound * half / (1 - square / 2);
    const T from_end = std::min(a, T(pi<T>() - b));
    return z_bound * square / (2 - square) / (from_end * (1 - from_end * from_end / 6));
}

} // namespace denhartog

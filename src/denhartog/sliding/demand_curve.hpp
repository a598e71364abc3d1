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
/// @param a        left end
/// @param b        right end
/// @param z_bound  bound of |Z| between them
/// @return         the rise
template <class T>
T rise_of_demand(const T& a, const T& b, const T& z_bound) {
    const T half = (b - a) / 2;
    if (!(a > 0) || !(b < pi<T>())) return z_bound * sin(half) / cos(half);
    const T quarter = sin(T(half / 2));
    return z_bound * 2 * quarter * quarter / cos(half) / std::min(T(sin(a)), T(sin(b)));
}

} // namespace denhartog

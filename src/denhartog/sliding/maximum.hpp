/// @file
/// @brief The global maximum of a function on an interval, guaranteed by bounds on its derivatives.
///
/// Branch and bound. An interval is done with when no point in it can exceed the best value known by more than rounding; or
/// when the derivative is seen to be monotone over it, so that it holds one interior extremum at most, found as a bracketed root.
/// Else it is halved. No maximum can hide between samples: what the function does there is bounded, not sampled.
#pragma once

#include <functional>

namespace denhartog {

/// @brief A function at one instant.
template <class T>
struct Sample {
    T f; ///< the function
    T w; ///< zero at every interior maximum: the derivative, or a function with its sign
    T z; ///< w is monotone wherever z keeps its sign
};

/// @brief A function with what bounds it between samples.
template <class T>
struct Curve {
    std::function<Sample<T>(const T& tau)> sample; ///< f, w and z at an instant
    std::function<T(const T& a, const T& b)> rate; ///< a bound of |z'| on [a, b]
    /// how far f may rise on [a, b] above the larger of its values at a and b, given a bound of |z| there
    std::function<T(const T& a, const T& b, const T& z_bound)> rise;
};

/// @brief A maximum and where it lies.
template <class T>
struct Maximum {
    T value;   ///< the largest value
    T instant; ///< where it is taken, or approached at an end of the interval
};

/// @brief Largest value of f on [a, b], to the rounding of its samples.
/// @param curve  the function with its bounds
/// @param a      left end
/// @param b      right end, larger than a
/// @return       the maximum
/// @throws       PrecisionError where 2^21 intervals do not settle it
template <class T>
[[nodiscard]] Maximum<T> global_maximum(const Curve<T>& curve, const T& a, const T& b);

/// @brief Root of a continuous function between two points where it has opposite signs.
/// @param f    the function
/// @param a    left end
/// @param b    right end
/// @param f_a  value at a
/// @param f_b  value at b, of the other sign
/// @return     the root, to the last digits of the number type
template <class T>
[[nodiscard]] T bracketed_root(const std::function<T(const T&)>& f, const T& a, const T& b, const T& f_a, const T& f_b);

} // namespace denhartog

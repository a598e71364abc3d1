/// @file
/// @brief The global maximum of a function on an interval, guaranteed by bounds on its derivatives.
///
/// An interval is done with when no point in it can exceed the best value known by more than the error of the samples; or when
/// the derivative is seen to be monotone over it, so that it holds one interior extremum at most, found as a bracketed zero. Else
/// it is halved. No maximum can hide between samples: what the function does there is bounded, not sampled.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "denhartog/number/effort.hpp"

namespace denhartog {

/// @brief A function at one instant.
struct Sample {
    double f;         ///< the function
    double w;         ///< zero at every interior maximum: the derivative, or a function with its sign
    double z;         ///< w is monotone wherever z keeps its sign
    double slope = z; ///< the derivative of w: z times what is not negative
};

/// @brief A function with what bounds it between samples.
struct Curve {
    std::function<Sample(double tau)> sample;       ///< f, w and z at an instant
    std::function<double(double a, double b)> rate; ///< a bound of |z'| on [a, b]
    /// how far f may rise on [a, b] above the larger of its values at a and b, given a bound of |z| there; here where z is f''
    std::function<double(double a, double b, double z_bound)> rise = [](double a, double b, double z_bound) {
        return z_bound * (b - a) * (b - a) / 8;
    };
    long cost = 1;                      ///< operations that a sample takes
    long share = default_effort(1) / 4; ///< of the question's that a search may spend, being one of several
    Effort* question = nullptr;         ///< the budget of the question; null: there is none
};

/// @brief A stretch in which the function may be as large as its largest value.
struct Place {
    double from;    ///< its left end
    double to;      ///< its right end
    double instant; ///< where the largest value in it was seen
    double value;   ///< that value
    double upper;   ///< no value in it is larger, but for the error of a sample
    double reach;   ///< how far from there the largest value in it may be; zero if it was found as a root of w
};

/// @brief A maximum and where it lies.
struct Maximum {
    double value;        ///< the largest value seen; the largest value is not below it by more than the error of the samples
    double instant;      ///< where it is taken, or approached at an end of the interval
    double upper;        ///< no value is larger
    bool settled = true; ///< false if the effort was spent before no interval could exceed the best value
    std::vector<Place> places; ///< ascending: outside of them every value is below the largest one
};

/// @brief Largest value of f on [a, b], to the error of its samples.
///
/// If samples in double leave open which maximum is the largest, `places` has a place for each; more digits there settle it.
/// `noise` bounds the absolute error of f at an instant; smaller differences are not searched. Values up to `least` do not count:
/// if all values are below it, the result is `least` at a, without a place. `error` bounds an error of f that the search cannot
/// reduce: a maximum may be the largest, and has a place, if it is below the largest value by twice that at most. Without an
/// effort the search has its share of the question's; PrecisionError if that does not settle the maximum.
[[nodiscard]] Maximum global_maximum(const Curve& curve, double a, double b, double noise = 0, Effort* effort = nullptr,
                                     double least = std::numeric_limits<double>::lowest(), double error = 0);

/// @brief The places of one function, ascending, with those that touch made one, which reaches as far as its maxima lie apart.
[[nodiscard]] std::vector<Place> joined(std::vector<Place> places);

/// @brief Places where a function that goes on at a as it ends at b may be largest, besides the instant of its largest value; the
/// place of that instant is among them if it has a reach. Places are ascending, and no two touch.
[[nodiscard]] std::vector<Place> rivals(const std::vector<Place>& places, double a, double b, double instant);

} // namespace denhartog

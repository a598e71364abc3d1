/// @file
/// @brief The largest value of a function on an interval, proved. Nothing here knows of modes, masses or friction.
///
/// Branch and bound: an interval is done with when no point in it can exceed the best value known, or when the function is seen
/// to rise or fall over it, or to have one maximum there; else it is halved. No maximum can hide between samples: what the function
/// does there is bounded, not sampled. `stretches_of_largest` searches with ranges of any number type, which offers `low()` and
/// `high()`; `global_maximum` searches in double, with bounds on derivatives.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "denhartog/number/effort.hpp"

namespace denhartog {

/// @brief Takes from `open` the greatest stretch, `look(stretch)` at it, which appends its parts that may still hold the largest
/// value, and so on until `ends(next)`; the stretches that were not examined are then in `open`, as a heap.
template <class Stretches, class Ends, class Look>
void branch_and_bound(Stretches& open, const Ends& ends, const Look& look) {
    std::make_heap(open.begin(), open.end());
    while (!open.empty() && !ends(open.front())) {
        std::pop_heap(open.begin(), open.end());
        const auto now = std::move(open.back());
        open.pop_back();
        auto count = static_cast<std::ptrdiff_t>(open.size());
        look(now);
        while (count < static_cast<std::ptrdiff_t>(open.size())) std::push_heap(open.begin(), open.begin() + ++count);
    }
}

/// @brief Trend of a function over a stretch, if it is certain.
enum class TrendOnStretch : unsigned char {
    unknown,    ///< nothing is certain
    rises,      ///< it does not fall
    falls,      ///< it does not rise
    one_maximum ///< it has one stationary point, a maximum
};

/// @brief Bounds that a function gives of itself over a stretch.
template <class T>
struct SeenOverStretch {
    T range;              ///< holds its values
    TrendOnStretch trend; ///< whether it rises or falls
};

/// @brief A function on an interval, as a search sees it.
template <class T>
struct SearchedFunction {
    std::function<T(const T&)> value;                          ///< at an instant
    std::function<SeenOverStretch<T>(double, double)> stretch; ///< over a stretch
};

/// @brief A stretch that may hold the largest value.
struct StretchOfLargest {
    double from;                                    ///< its lower end
    double to;                                      ///< its upper end; one instant if the ends are equal
    double upper;                                   ///< no value in it is larger
    TrendOnStretch trend = TrendOnStretch::unknown; ///< whether the function rises or falls in it

    /// @brief The higher one is looked into first.
    friend bool operator<(const StretchOfLargest& x, const StretchOfLargest& y) { return x.upper < y.upper; }
};

/// @brief Result of a search.
struct LargestOnStretches {
    std::vector<StretchOfLargest> stretches; ///< one of them holds the largest value, if that may be `lower` or more
    double lower;                            ///< a value that the function has, or the one that it has to reach
    bool settled;                            ///< whether the search came to its end
};

/// @brief Stretches that hold the largest value of a function: the interval is halved if its range may hold it. A stretch with
/// one maximum is kept once it is as narrow as `narrow`, and any once it is as narrow as `flat`. Stretches are halved `looks`
/// times at most. Values below `at_least` are of no interest.
template <class T>
[[nodiscard]] LargestOnStretches stretches_of_largest(const SearchedFunction<T>& f, double a, double b, double narrow,
                                                      double flat, int looks,
                                                      double at_least = -std::numeric_limits<double>::infinity()) {
    constexpr int parts = 4;
    std::vector<StretchOfLargest> open;
    LargestOnStretches found{{}, at_least, false};
    const auto see = [&](double at) {
        const T value = f.value(T(at));
        found.lower = std::max(found.lower, value.low());
        return value.high();
    };
    const auto add = [&](double from, double to, double upper) {
        const SeenOverStretch<T> seen = f.stretch(from, to);
        open.push_back({from, to, std::min(upper, seen.range.high()), seen.trend});
    };
    for (int n = 0; n <= parts; ++n) (void)see(n == parts ? b : a + (b - a) * n / parts);
    for (int n = 0; n < parts; ++n)
        add(a + (b - a) * n / parts, n == parts - 1 ? b : a + (b - a) * (n + 1) / parts, std::numeric_limits<double>::infinity());
    const auto is_below = [&](const StretchOfLargest& s) { return s.upper < found.lower; };
    const auto ends = [&](const StretchOfLargest& s) { return is_below(s) || looks-- <= 0; };
    branch_and_bound(open, ends, [&](const StretchOfLargest& s) {
        if (s.trend == TrendOnStretch::rises || s.trend == TrendOnStretch::falls) {
            const double at = s.trend == TrendOnStretch::rises ? s.to : s.from;
            found.stretches.push_back({at, at, see(at)});
            return;
        }
        const double middle = s.from + (s.to - s.from) / 2;
        (void)see(middle);
        if ((s.trend == TrendOnStretch::one_maximum && s.to - s.from < narrow) || s.to - s.from < flat) {
            found.stretches.push_back(s);
        } else {
            add(s.from, middle, s.upper);
            add(middle, s.to, s.upper);
        }
    });
    found.settled = open.empty() || is_below(open.front());
    std::erase_if(found.stretches, is_below);
    return found;
}

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
    /// the rise of f at most, on [a, b] above the larger of its values at a and b, given a bound of |z| there; here where z is f''
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
    double reach;   ///< the distance from there within which the largest value in it lies; zero if it was found as a root of w
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

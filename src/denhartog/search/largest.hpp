/// @file
/// @brief The largest value of a function on an interval, proved. Nothing here knows of modes, masses or friction.
///
/// A function gives to the search its value at an instant, its range and trend over a stretch, and a step of Newton's method
/// towards a maximum. The number type offers `within(a, b)`, a number that holds an interval, and
/// `low()` and `high()`, bounds in double.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace denhartog {

/// @brief Branch and bound: takes from `open` the stretch that may hold the largest value and examines it, again and again.
/// The stretches are ordered: the greatest one is examined first. `ends(next)` decides before each step whether the search ends;
/// the stretches that were not examined are then in `open`, as a heap. `look(stretch)` examines a stretch that was taken out and
/// appends to `open` the parts of it that may still hold the largest value, if any.
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

} // namespace denhartog

/// @file
/// @brief The largest value of a function on an interval, proved. Nothing here knows of modes, masses or friction.
///
/// A function says of itself what a search needs: its value at an instant, a range over a stretch, where it is going there, and a
/// step of Newton's method towards a maximum. The number type offers `within(a, b)`, a number that holds an interval, and
/// `low()` and `high()`, bounds in double.
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace denhartog {

/// @brief Where a function is going over a stretch, where that is certain.
enum class TrendOnStretch : unsigned char {
    unknown,    ///< nothing is certain
    rises,      ///< it does not fall
    falls,      ///< it does not rise
    one_maximum ///< it has one stationary point, a maximum
};

/// @brief A function on an interval, as a search sees it.
template <class T>
struct SearchedFunction {
    std::function<T(const T&)> value;                    ///< at an instant
    std::function<T(double, double)> over;               ///< a range over a stretch
    std::function<TrendOnStretch(double, double)> trend; ///< where it is going over a stretch
};

/// @brief A stretch that may hold the largest value.
struct StretchOfLargest {
    double from;              ///< its lower end
    double to;                ///< its upper end; one instant where the ends are equal
    double upper;             ///< no value in it is larger
    bool one_maximum = false; ///< whether it holds one stationary point, a maximum
};

/// @brief What a search found.
struct LargestOnStretches {
    std::vector<StretchOfLargest> stretches; ///< one of them holds the largest value
    double lower;                            ///< the largest value is not below
    bool settled;                            ///< whether the search came to its end
};

/// @brief Stretches that hold the largest value of a function: the interval is halved where its range may hold it.
/// @param f        the function
/// @param a        lower end
/// @param b        upper end
/// @param narrow   a stretch with one maximum is kept once it is as narrow
/// @param flat     any stretch is kept once it is as narrow
/// @param looks    how often a stretch may be looked at
/// @return         the stretches
template <class T>
[[nodiscard]] LargestOnStretches stretches_of_largest(const SearchedFunction<T>& f, double a, double b, double narrow,
                                                      double flat, int looks) {
    constexpr int parts = 8;
    const auto is_lower = [](const StretchOfLargest& x, const StretchOfLargest& y) { return x.upper < y.upper; };
    std::priority_queue<StretchOfLargest, std::vector<StretchOfLargest>, decltype(is_lower)> open(is_lower);
    LargestOnStretches found{{}, -std::numeric_limits<double>::infinity(), false};
    const auto see = [&](double at) {
        const T value = f.value(T(at));
        found.lower = std::max(found.lower, value.low());
        return value.high();
    };
    (void)see(a);
    (void)see(b);
    for (int n = 0; n < parts; ++n) {
        const double from = a + (b - a) * n / parts, to = n == parts - 1 ? b : a + (b - a) * (n + 1) / parts;
        open.push({from, to, std::numeric_limits<double>::infinity()});
    }
    for (; !open.empty() && looks > 0; --looks) {
        const StretchOfLargest s = open.top();
        if (s.upper < found.lower) break;
        open.pop();
        const TrendOnStretch trend = f.trend(s.from, s.to);
        const double middle = s.from + (s.to - s.from) / 2;
        if (trend == TrendOnStretch::rises || trend == TrendOnStretch::falls) {
            const double at = trend == TrendOnStretch::rises ? s.to : s.from;
            found.stretches.push_back({at, at, see(at)});
        } else if ((trend == TrendOnStretch::one_maximum && s.to - s.from < narrow) || s.to - s.from < flat) {
            (void)see(middle);
            found.stretches.push_back({s.from, s.to, f.over(s.from, s.to).high(), trend == TrendOnStretch::one_maximum});
        } else {
            (void)see(middle);
            for (const auto& [from, to] : {std::pair(s.from, middle), std::pair(middle, s.to)})
                open.push({from, to, std::min(s.upper, f.over(from, to).high())});
        }
    }
    found.settled = open.empty() || open.top().upper < found.lower;
    std::erase_if(found.stretches, [&](const StretchOfLargest& s) { return s.upper < found.lower; });
    return found;
}

} // namespace denhartog

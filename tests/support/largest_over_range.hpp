/// @file
/// @brief The largest value of a function over a range, where a grid alone would stop beside the peaks. Header only.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace denhartog {

/// @brief A largest value, and where it is.
struct LargestOverRange {
    double x;     ///< where
    double value; ///< how large
};

/// @brief Searches a grid, then closer round each of its highest local maxima by golden sections.
///
/// A peak that is narrower than a step of the grid and between two of its points can be missed: what is found is a lower bound,
/// minus infinity where the function has no value on the grid. Of the highest local maxima so many are looked at as `peaks` says.
[[nodiscard]] inline LargestOverRange largest_over_range(const std::function<double(double)>& f, double low, double high,
                                                         int parts, std::size_t peaks = 16) {
    const auto at = [&](double x) {
        const double value = f(x);
        return std::isnan(value) ? -INFINITY : value;
    };
    std::vector<double> x, y;
    for (int n = 0; n <= parts; ++n) {
        x.push_back(low + (high - low) * n / parts);
        y.push_back(at(x.back()));
    }
    std::vector<std::size_t> maxima;
    for (std::size_t n = 0; n < x.size(); ++n)
        if ((n == 0 || y[n] >= y[n - 1]) && (n + 1 == x.size() || y[n] >= y[n + 1]) && y[n] > -INFINITY) maxima.push_back(n);
    std::ranges::sort(maxima, [&](std::size_t a, std::size_t b) { return y[a] > y[b]; });
    if (maxima.size() > peaks) maxima.resize(peaks);
    LargestOverRange best{low, -INFINITY};
    const auto take = [&](double where, double value) {
        if (value > best.value) best = {where, value};
    };
    const double golden = (std::sqrt(5.0) - 1) / 2;
    for (const std::size_t n : maxima) {
        take(x[n], y[n]);
        double a = x[n == 0 ? 0 : n - 1], b = x[std::min(n + 1, x.size() - 1)];
        for (int step = 0; step < 40; ++step) {
            const double left = b - golden * (b - a), right = a + golden * (b - a);
            const double y_left = at(left), y_right = at(right);
            take(left, y_left);
            take(right, y_right);
            (y_left > y_right ? b : a) = y_left > y_right ? right : left;
        }
    }
    return best;
}

} // namespace denhartog

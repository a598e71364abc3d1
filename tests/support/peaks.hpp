/// @file
/// @brief Where a smooth function is largest, in many digits, by a fine sample. Header only.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "denhartog/number/number.hpp"

namespace denhartog {

/// @brief Where a smooth function is largest between two instants, to half its digits: by golden sections, then by parabolas
/// through three instants, whose distance is squared from step to step.
template <class T, class Function>
[[nodiscard]] T instant_of_peak(const Function& f, T a, T b) {
    const T golden = (sqrt(T(5)) - 1) / 2, from = a, to = b;
    T x = b - golden * (b - a), y = a + golden * (b - a), f_x = f(x), f_y = f(y);
    while (b - a > ldexp(T(1), -20)) {
        if (f_x > f_y) {
            b = y;
            y = x;
            x = b - golden * (b - a);
            f_y = std::exchange(f_x, f(x));
        } else {
            a = x;
            x = y;
            y = a + golden * (b - a);
            f_x = std::exchange(f_y, f(y));
        }
    }
    T tau = (a + b) / 2;
    for (int bits = 20; 2 * bits <= std::numeric_limits<T>::digits; bits *= 2) {
        const T h = ldexp(T(1), -bits), low = f(std::max(T(tau - h), from)), high = f(std::min(T(tau + h), to));
        const T bend = low - 2 * f(tau) + high;
        if (bend < 0) tau = std::clamp(T(tau + h * (low - high) / (2 * bend)), from, to);
    }
    return tau;
}

/// @brief Where a smooth function on [0, pi] is largest, to half its digits. It is looked at closely next to each sample in double
/// that may be next to the largest value.
template <class T, class Function, class InDouble>
[[nodiscard]] T instant_of_largest(const Function& f, const InDouble& in_double, int steps) {
    std::vector<double> samples;
    for (int n = 0; n <= steps; ++n) samples.push_back(in_double(n == steps ? pi<double>() : pi<double>() * n / steps));
    const auto at = [&](int n) { return samples[static_cast<std::size_t>(std::clamp(n, 0, steps))]; };
    const auto instant = [&](int n) { return n >= steps ? pi<T>() : n <= 0 ? T(0) : T(pi<T>() * n / steps); };
    const double best_sample = *std::max_element(samples.begin(), samples.end()), noise = 1e-9 * std::abs(best_sample);
    T best(0), largest = f(best);
    const auto take = [&](const T& tau) {
        if (const T value = f(tau); value > largest) {
            best = tau;
            largest = value;
        }
    };
    for (int n = 0; n <= steps; ++n) {
        if (at(n - 1) > at(n) || at(n + 1) > at(n)) continue;
        if (2 * at(n) - std::min(at(n - 1), at(n + 1)) + noise < best_sample) continue;
        take(instant(n));
        take(instant_of_peak(f, instant(n - 1), instant(n + 1)));
    }
    return best;
}

} // namespace denhartog

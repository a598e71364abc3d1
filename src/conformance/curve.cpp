#include "conformance/curve.hpp"

#include <algorithm>
#include <cmath>

namespace denhartog::conformance {
namespace {

constexpr double share_of_an_event = 0.25;

// Distance of a value to the piecewise linear curve over half a step to either side of a sample.
double distance_in_tube(double value, double before, double at, double after) {
    const double to_the_left = (before + at) / 2, to_the_right = (at + after) / 2;
    const double lowest = std::min({to_the_left, at, to_the_right}), highest = std::max({to_the_left, at, to_the_right});
    return std::max({0.0, lowest - value, value - highest});
}

} // namespace

CurveDeviation curve_deviation(const std::vector<double>& given, const std::vector<double>& reference) {
    const std::size_t n = reference.size();
    const auto x = [&](std::size_t i) { return reference[i % n]; };
    std::vector<double> second(n);
    double largest = 0;
    for (std::size_t i = 0; i < n; ++i) {
        second[i] = x(i + 1) - 2 * x(i) + x(i + n - 1);
        largest = std::max(largest, std::abs(second[i]));
    }
    const auto jumps = [&](std::size_t i) { return std::abs(second[(i + 1) % n] - second[i % n]) > share_of_an_event * largest; };
    CurveDeviation worst;
    for (std::size_t i = 0; i < n; ++i) {
        const bool event = jumps(i) || jumps(i + n - 1);
        const double deviation =
            event ? distance_in_tube(given[i], x(i + n - 1), x(i), x(i + 1)) : std::abs(given[i] - reference[i]);
        if (deviation > worst.deviation) worst = {deviation, i};
    }
    return worst;
}

} // namespace denhartog::conformance

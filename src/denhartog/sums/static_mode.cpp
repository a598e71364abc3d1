#include "denhartog/sums/static_mode.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "denhartog/elementary/elementary.hpp"
#include "denhartog/evaluation/overdamped.hpp"

namespace denhartog {
namespace {

constexpr double above_rounding = 1 + 1e-9;                     // of the bounds' own evaluation
constexpr double smallest = std::numeric_limits<double>::min(); // below it their digits are lost

struct Errors {
    double of_u, of_g;
};

Errors of_oscillating(double R, double zeta) {
    const double delta = std::numbers::pi * zeta / R, half = elementary::sinh(std::min(300.0, delta / 2));
    const double cosh_minus_one = 2 * half * half / above_rounding, w = std::sqrt((1 - zeta) * (1 + zeta));
    return {1 / (R * w * cosh_minus_one) + smallest / R, (elementary::exp(-delta) + 1 + zeta / w) / cosh_minus_one};
}

Errors of_overdamped(double R, double zeta) {
    const double x = std::numbers::pi / R, a = evaluation::slow_rate(zeta), w = evaluation::overdamped_w(zeta);
    const double slow = elementary::exp(-a * x), S = slow * (2 * w * x > 1 ? 1 / (2 * w) : x);
    return {2 * S / R * above_rounding + smallest / R, 2 * (slow + a * S + elementary::exp(-2 * zeta * x)) * above_rounding};
}

} // namespace

evaluation::ModeFunctions<Bounded<double>> static_mode_functions(double R, double zeta) {
    const double a = (1 - R) * (1 + R), b = 2 * zeta * R;
    const double of_v = above_rounding * R * elementary::hypot(R, 2 * zeta) / elementary::hypot(a, b);
    const Errors errors = zeta >= 1 ? of_overdamped(R, zeta) : of_oscillating(R, zeta);
    return {{{1, of_v}, {0, of_v}}, {0, errors.of_u}, {1, errors.of_g}};
}

} // namespace denhartog

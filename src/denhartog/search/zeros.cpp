// A step of the search for the first zero: what the bounds of a jet prove over it, by Bernstein coefficients of the Taylor
// polynomial; and the zero of that polynomial.
#include "denhartog/search/zeros.hpp"

#include "denhartog/number/number.hpp"

namespace denhartog {
namespace {

// Of a polynomial on [0, 1] that is zero to an order at 0, over t^order: what its derivative k + order there brings to Bernstein
// coefficient i, which is (i choose k) / (degree choose k) / (k + order)!.
template <int degree, int order>
constexpr auto bernstein_weights = [] {
    std::array<std::array<double, degree + 1>, degree + 1> weights{};
    for (int i = 0; i <= degree; ++i) {
        double weight = 1;
        for (int k = 1; k <= order; ++k) weight /= k;
        for (int k = 0; k <= i; ++k) {
            weights[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] = weight;
            weight *= static_cast<double>(i - k) / ((degree - k) * (k + 1 + order) + (k == degree));
        }
    }
    return weights;
}();

// True if the Bernstein coefficients on [0, h] of `sign` times such a polynomial exceed a limit: the polynomial lies above the
// least of them. The last one is its value at h. The derivatives are those from `order` on.
template <int degree, int order>
bool exceeds(const double* derivatives, double sign, double h, double limit) {
    std::array<double, degree + 1> terms;
    for (std::size_t k = 0; k <= degree; ++k) {
        terms[k] = derivatives[k] * sign;
        sign *= h;
    }
    for (std::size_t i = degree + 1; i-- > 0;) {
        double coefficient = 0;
        for (std::size_t k = 0; k <= i; ++k) coefficient += bernstein_weights<degree, order>[i][k] * terms[k];
        if (!(coefficient > limit)) return false;
    }
    return true;
}

// A polynomial over [0, h] with bounds of its difference from f, and of that of the slopes: Taylor's of fifth degree or, where
// the bound of the fourth derivative does more than that of the sixth, of third degree.
struct Nearby {
    std::array<double, 6> f; // derivatives at 0
    double remainder, remainder_of_slope;
};

Nearby nearby(const Jet& jet, double h) {
    const double grown = jet.growth * h, h_3 = h * h * h, by_sixth = (jet.bound + grown) * h_3 * h_3 * (1.0 / 720),
                 by_fourth = (jet.fourth + grown) * h_3 * h * (1.0 / 24);
    if (by_fourth < by_sixth) return {{jet.f[0], jet.f[1], jet.f[2], jet.f[3]}, by_fourth, 4 * by_fourth / h};
    return {jet.f, by_sixth, 6 * by_sixth / h};
}

// The Taylor polynomial and its slope.
ValueAt taylor(const std::array<double, 6>& f, double t) {
    constexpr double third = 1.0 / 3, fifth = 0.2;
    const double f_4 = f[4] + t * fifth * f[5], slope_4 = f[4] + t / 4 * f[5];
    return {t, f[0] + t * (f[1] + t / 2 * (f[2] + t * third * (f[3] + t / 4 * f_4))),
            f[1] + t * (f[2] + t / 2 * (f[3] + t * third * slope_4))};
}

} // namespace

bool stays_positive(const Jet& jet, int order, double h) {
    if (h < tangent_up_to) {
        const double bend = (jet.second + jet.growth * h) * h / 2;
        if (order == 0 && std::min(jet.f[0], jet.f[0] + jet.f[1] * h) > bend * h) return true;
        if (order == 1 && jet.f[1] > bend) return true;
    }
    const Nearby p = nearby(jet, h);
    if (order == 2) return exceeds<3, 2>(&p.f[2], 1, h, p.remainder / (h * h));
    if (order == 1) return exceeds<4, 1>(&p.f[1], 1, h, p.remainder / h);
    return exceeds<5, 0>(&p.f[0], 1, h, p.remainder);
}

bool falls(const Jet& jet, double h) {
    if (h < tangent_up_to && jet.f[1] < -(jet.second + jet.growth * h) * h) return true;
    const Nearby p = nearby(jet, h);
    return exceeds<4, 0>(&p.f[1], -1, h, p.remainder_of_slope);
}

bool is_below(const Jet& jet, double h) {
    const Nearby p = nearby(jet, h);
    return taylor(p.f, h).f < -p.remainder;
}

ValueAt zero_of_taylor(const Jet& jet, double low, double high) {
    constexpr int most_steps = 60;
    constexpr double settled = 1e-8;                                   // the next step of Newton's method is the square of this
    const double bend = jet.f[1] * jet.f[1] - 2 * jet.f[0] * jet.f[2]; // the first guess is by a parabola
    ValueAt at{0, jet.f[0], jet.f[1]};
    (at.f > 0 ? low : high) = 0;
    if (bend > 0) at = taylor(jet.f, std::clamp(2 * at.f / (sqrt(bend) - at.slope), low, high));
    for (int n = 0; n < most_steps; ++n) {
        (at.f > 0 ? low : high) = at.t;
        const double newton = at.t - at.f / at.slope, next = low <= newton && newton <= high ? newton : low + (high - low) / 2;
        if (std::abs(next - at.t) <= settled * std::abs(next)) return {next, 0, at.slope};
        at = taylor(jet.f, next);
    }
    return at;
}

} // namespace denhartog

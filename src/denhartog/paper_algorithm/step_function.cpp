// A displacement or velocity within one step, a polynomial and a harmonic, and its zeros: the first fall below zero, which ends a
// phase, and all changes of sign. Read `first_fall`; the search itself is `first_crossing`.
#include "denhartog/paper_algorithm/detail/step_function.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "elementary/elementary.hpp"

namespace denhartog {
namespace {

// Sign with which a function leaves the zero that it has at an instant, to rounding.
struct Leaving {
    int order;   // of the zero; 0 where there is none
    double rate; // the first coefficient of its series that is not zero; 0 where there is none
};

Leaving leaving(const Jet& jet, double noise) {
    double factorial = 1;
    for (int order = 0; order < 4; factorial *= ++order)
        if (std::abs(jet.f[static_cast<std::size_t>(order)]) > noise * factorial)
            return {order, jet.f[static_cast<std::size_t>(order)] / factorial};
    return {0, 0};
}

// The first zero after an instant; none where no step is short enough to see it.
std::optional<Crossing> zero_after(double from, const StepFunction& f, int order) {
    double step = 1;
    std::optional<Crossing> zero = first_crossing(f, from, 1.0, order, step, Effort{});
    return zero && zero->open ? std::nullopt : zero;
}

} // namespace

Jet StepFunction::operator()(double theta) const {
    std::array<double, 6> d{}; // derivatives of the polynomial over the factorials
    const double h_2 = h * h, swing = std::abs(cosine) + std::abs(sine);
    double size = swing;
    for (const double each : c) size += std::abs(each);
    if (theta == 0) std::copy_n(c.begin(), d.size(), d.begin());
    for (std::size_t k = theta == 0 ? 0 : c.size(); k-- > 0;) {
        for (std::size_t n = c.size() - 1 - k; n > 0; --n) d[n] = d[n] * theta + d[n - 1];
        d[0] = d[0] * theta + c[k];
    }
    const auto [S, C] = h == 0 ? SineCosine<double>{0, 1} : elementary::sine_cosine(h * theta);
    const double x = cosine * C + sine * S, x_prime = h * (sine * C - cosine * S);
    return {{d[0] + x, d[1] + x_prime, 2 * d[2] - h_2 * x, 6 * d[3] - h_2 * x_prime, 24 * d[4] + h_2 * h_2 * x,
             120 * d[5] + h_2 * h_2 * x_prime},
            h_2 * h_2 * h_2 * swing,
            0,
            std::numeric_limits<double>::epsilon() * size};
}

StepFunction quintic(const StepValues& v) {
    // f = c_0 + c_1 theta + theta^2 g, and g = g_1 + s g_1' + s^2 (E + F s), s = theta - 1.
    const double c_0 = v.f_0, c_1 = v.h_f_prime_0, g_1 = v.f_1 - c_0 - c_1, rate = v.h_f_prime_1 - c_1 - 2 * g_1,
                 g_third = 9 * (v.f_third - c_0 - c_1 / 3), g_two_thirds = (v.f_two_thirds - c_0 - 2 * c_1 / 3) * 9 / 4,
                 p = (g_third - g_1 + 2 * rate / 3) * 9 / 4, q = 9 * (g_two_thirds - g_1 + rate / 3), E = 2 * q - p,
                 F = 3 * (q - p);
    return {{c_0, c_1, g_1 - rate + E - F, rate - 2 * E + 3 * F, E - 3 * F, F}};
}

StepFunction operator-(double limit, const StepFunction& f) {
    StepFunction rest{{}, -f.cosine, -f.sine, f.h};
    for (std::size_t k = 0; k < f.c.size(); ++k) rest.c[k] = -f.c[k];
    rest.c[0] += limit;
    return rest;
}

void sign_changes(const StepFunction& f, std::vector<double>& zeros) {
    zeros.clear();
    auto [order, rate] = leaving(f(0), 0);
    if (rate == 0 || order > 2) return;
    StepFunction side = rate > 0 ? f : 0 - f;
    for (double from = 0; zeros.size() < f.c.size();) {
        const std::optional<Crossing> zero = zero_after(from, side, order);
        if (!zero) return;
        from = zero->t;
        zeros.push_back(from);
        side = 0 - side;
        order = 1;
    }
}

std::optional<double> first_fall(const StepFunction& f, double noise) {
    const bool starts_positive = f.c[0] + f.cosine > noise;
    const auto [order, rate] = starts_positive ? Leaving{0, 1} : leaving(f(0), noise);
    if (rate < 0) return 0;
    if (rate == 0 || order > 2) return std::nullopt;
    const std::optional<Crossing> zero = zero_after(0, f, order);
    return zero ? std::optional(zero->t) : std::nullopt;
}

} // namespace denhartog

#include "denhartog/sweep/study/marginal.hpp"

#include <mpfr.h>

#include <algorithm>
#include <cmath>

#include "denhartog/elementary/elementary.hpp"

namespace denhartog::sweep {
namespace {

// So many more digits than a double has that a result is rounded to double once.
constexpr mpfr_prec_t bits = 160;

class Wide {
public:
    explicit Wide(double x = 0) {
        mpfr_init2(value, bits);
        mpfr_set_d(value, x, MPFR_RNDN);
    }
    ~Wide() { mpfr_clear(value); }
    Wide(const Wide&) = delete;
    Wide& operator=(const Wide&) = delete;

    [[nodiscard]] double rounded() const { return mpfr_get_d(value, MPFR_RNDN); }

    mpfr_t value;
};

// erfc(-x / sqrt(2)) / 2, in place.
void to_normal_probability(Wide& x) {
    Wide root(2);
    mpfr_sqrt(root.value, root.value, MPFR_RNDN);
    mpfr_div(x.value, x.value, root.value, MPFR_RNDN);
    mpfr_neg(x.value, x.value, MPFR_RNDN);
    mpfr_erfc(x.value, x.value, MPFR_RNDN);
    mpfr_div_2ui(x.value, x.value, 1, MPFR_RNDN);
}

// exp(-x^2 / 2) / sqrt(2 pi)
void to_normal_density(Wide& x) {
    Wide pi;
    mpfr_const_pi(pi.value, MPFR_RNDN);
    mpfr_mul_2ui(pi.value, pi.value, 1, MPFR_RNDN);
    mpfr_sqrt(pi.value, pi.value, MPFR_RNDN);
    mpfr_sqr(x.value, x.value, MPFR_RNDN);
    mpfr_div_2ui(x.value, x.value, 1, MPFR_RNDN);
    mpfr_neg(x.value, x.value, MPFR_RNDN);
    mpfr_exp(x.value, x.value, MPFR_RNDN);
    mpfr_div(x.value, x.value, pi.value, MPFR_RNDN);
}

double exponential(double x) {
    Wide wide(x);
    mpfr_exp(wide.value, wide.value, MPFR_RNDN);
    return wide.rounded();
}

// The x below which a standard normal number lies with a probability p up to one half, to 4.5e-4: Abramowitz and Stegun, 26.2.23;
// next to the middle to 1e-6 of itself.
double quantile_to_three_digits(double p) {
    if (p > 0.499) return (p - 0.5) / 0.3989422804014327; // the density at 0
    const double t = std::sqrt(-2 * elementary::log(p));
    return (2.515517 + t * (0.802853 + t * 0.010328)) / (1 + t * (1.432788 + t * (0.189269 + t * 0.001308))) - t;
}

// from (to / from)^part
double between_logarithmically(double from, double to, double part) {
    Wide start(from), ratio(to);
    mpfr_div(ratio.value, ratio.value, start.value, MPFR_RNDN);
    mpfr_log(ratio.value, ratio.value, MPFR_RNDN);
    mpfr_mul_d(ratio.value, ratio.value, part, MPFR_RNDN);
    mpfr_exp(ratio.value, ratio.value, MPFR_RNDN);
    mpfr_mul(ratio.value, ratio.value, start.value, MPFR_RNDN);
    return std::clamp(ratio.rounded(), from, to);
}

// A normal or lognormal: the bounds that cut it off as numbers of the standard normal distribution.
double standard(const Marginal& m, double bound) {
    if (m.distribution == Distribution::normal) return (bound - m.first) / m.second;
    Wide ratio(bound), median(m.first);
    mpfr_div(ratio.value, ratio.value, median.value, MPFR_RNDN);
    mpfr_log(ratio.value, ratio.value, MPFR_RNDN);
    mpfr_div_d(ratio.value, ratio.value, m.second, MPFR_RNDN);
    return ratio.rounded();
}

// The part of the distribution that is left has the probabilities from P(below) to P(above).
double within_bounds(const Marginal& m, double u) {
    const double below = m.from ? normal_probability(standard(m, *m.from)) : 0;
    const double above = m.to ? normal_probability(standard(m, *m.to)) : 1;
    return below + (above - below) * u;
}

} // namespace

Marginal lognormal_of_mean(double mean, double deviation) {
    const double of_mean = deviation / mean, square = 1 + of_mean * of_mean;
    Wide logarithm(square);
    mpfr_log(logarithm.value, logarithm.value, MPFR_RNDN);
    mpfr_sqrt(logarithm.value, logarithm.value, MPFR_RNDN);
    return {Distribution::lognormal, mean / std::sqrt(square), logarithm.rounded(), {}, {}};
}

double normal_probability(double x) {
    Wide wide(x);
    to_normal_probability(wide);
    return wide.rounded();
}

// Halley's method trebles the digits at each step: from three, two steps lead beyond those of a double.
double normal_quantile(double u) {
    const bool upper = u > 0.5;
    const double p = upper ? 1 - u : u;
    Wide root(quantile_to_three_digits(p));
    for (int step = 0; step < 2; ++step) {
        Wide change, slope, half;
        mpfr_set(change.value, root.value, MPFR_RNDN);
        mpfr_set(slope.value, root.value, MPFR_RNDN);
        to_normal_probability(change);
        mpfr_sub_d(change.value, change.value, p, MPFR_RNDN);
        to_normal_density(slope);
        mpfr_div(change.value, change.value, slope.value, MPFR_RNDN); // Newton's
        mpfr_mul(half.value, change.value, root.value, MPFR_RNDN);
        mpfr_div_2ui(half.value, half.value, 1, MPFR_RNDN);
        mpfr_add_d(half.value, half.value, 1, MPFR_RNDN); // the second derivative is -x times the first
        mpfr_div(change.value, change.value, half.value, MPFR_RNDN);
        mpfr_sub(root.value, root.value, change.value, MPFR_RNDN);
    }
    return upper ? -root.rounded() : root.rounded();
}

double quantile(const Marginal& m, double u) {
    switch (m.distribution) {
    case Distribution::uniform: return m.first + (m.second - m.first) * u;
    case Distribution::loguniform: return between_logarithmically(m.first, m.second, u);
    case Distribution::normal:
    case Distribution::lognormal: break;
    }
    const double x = normal_quantile(m.from || m.to ? within_bounds(m, u) : u);
    const double drawn = m.distribution == Distribution::normal ? m.first + m.second * x : m.first * exponential(m.second * x);
    return std::min(std::max(drawn, m.from.value_or(drawn)), m.to.value_or(drawn));
}

std::vector<double> logarithmic_values(double from, double to, std::size_t count) {
    std::vector<double> values(count, from);
    for (std::size_t n = 1; n < count; ++n)
        values[n] =
            n + 1 == count ? to : between_logarithmically(from, to, static_cast<double>(n) / static_cast<double>(count - 1));
    return values;
}

} // namespace denhartog::sweep

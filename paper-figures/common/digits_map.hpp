/// @file
/// @brief What becomes of (23), (28), (29) at a point of the (R, zeta) plane, and the points of the maps.
#pragma once

#include "figure.hpp"
#include "kept_digits.hpp"

namespace denhartog::figures {

constexpr double many = 8;       ///< digits lost that are many
constexpr double moderate = 100; ///< condition numbers below it are good ones

/// @brief |a - b| / |b|.
template <class T>
[[nodiscard]] inline T difference(const Complex<T>& a, const Complex<T>& b) {
    return modulus(a + T(-1) * b) / modulus(b);
}

/// @brief What becomes of a function at a point of a map.
struct Place {
    double by_R;      ///< relative change for a relative change of R
    double by_zeta;   ///< relative change for a relative change of zeta
    bool below_range; ///< smaller than the least normal double
    double printed;   ///< decimal digits lost in the paper's form, 0 to 16; infinite where it gives no number
    double shipped;   ///< the same in the form that callers get
    [[nodiscard]] double condition() const { return std::max(by_R, by_zeta); }
    [[nodiscard]] bool good() const { return !below_range && condition() < moderate; }
};

/// @brief Decimal digits lost in double.
[[nodiscard]] inline double digits_lost(const Complex<double>& value, const Complex<Real50>& truth) {
    if (!std::isfinite(value.re) || !std::isfinite(value.im)) return INFINITY;
    const Real50 in_units = ldexp(difference(Complex<Real50>{value.re, value.im}, truth), 53);
    return in_units <= 1 ? 0 : std::min(16.0, std::log10(static_cast<double>(in_units)));
}

/// @brief Of all functions at a point.
using Places = Three<Place>;

/// @brief Both forms and the condition numbers at a point.
[[nodiscard]] inline Places places(double R, double zeta) {
    const Real50 h = ldexp(Real50(1), -70), R50 = R, zeta50 = zeta;
    const Three<Complex<Real50>> truth = shipped_functions(R50, zeta50),
                                 beside = shipped_functions(Real50(R50 * (1 + h)), zeta50),
                                 above = shipped_functions(R50, Real50(zeta50 * (1 + h)));
    const Three<Complex<double>> ours = shipped_functions(R, zeta), theirs = printed_functions(R, zeta);
    Places result;
    for (std::size_t n = 0; n < truth.size(); ++n)
        result[n] = {static_cast<double>(Real50(difference(beside[n], truth[n]) / h)),
                     static_cast<double>(Real50(difference(above[n], truth[n]) / h)),
                     modulus(truth[n]) < std::numeric_limits<double>::min(), digits_lost(theirs[n], truth[n]),
                     digits_lost(ours[n], truth[n])};
    return result;
}

/// @brief A map over R and zeta, R by R.
struct Map {
    std::string name;           ///< of its tables
    std::vector<double> R;      ///< frequency ratios, rising
    std::vector<double> zeta;   ///< damping ratios, rising
    std::vector<Places> points; ///< R by R
    [[nodiscard]] double R_of(std::size_t n) const { return R[n / zeta.size()]; }
    [[nodiscard]] double zeta_of(std::size_t n) const { return zeta[n % zeta.size()]; }
};

/// @brief Powers of ten, equally spaced in the exponent.
[[nodiscard]] inline std::vector<double> powers_of_ten(double a, double b, std::size_t n) {
    std::vector<double> x = spaced(a, b, n);
    for (double& each : x) each = std::pow(10, each);
    return x;
}

/// @brief Damping ratios from 1e-16 to 10^-0.5 by quarters of a decade, then by halves of a decade of their distance from 1.
[[nodiscard]] inline std::vector<double> damping_ratios() {
    std::vector<double> zeta = powers_of_ten(-16, -0.5, 63);
    for (const double each : powers_of_ten(-0.5, -16, 32)) zeta.push_back(1 - each);
    return zeta;
}

/// @brief R from 0.001 to 100; the values next to 1/n, n to 12, are 1/n.
[[nodiscard]] inline Map wide() {
    Map map{"wide", powers_of_ten(-3, 2, 186), damping_ratios(), {}};
    for (int n = 1; n <= 12; ++n)
        *std::min_element(map.R.begin(), map.R.end(),
                          [n](double a, double b) { return std::abs(std::log(a * n)) < std::abs(std::log(b * n)); }) = 1.0 / n;
    return map;
}

/// @brief R from 0.7 to 1.3 by the decades of its distance from 1.
[[nodiscard]] inline Map near_one() {
    Map map{"near", {}, damping_ratios(), {}};
    const std::vector<double> x = powers_of_ten(-15.5, -0.5, 61);
    for (std::size_t n = x.size(); n-- > 0;) map.R.push_back(1 - x[n]);
    map.R.push_back(1);
    for (const double each : x) map.R.push_back(1 + each);
    return map;
}

} // namespace denhartog::figures

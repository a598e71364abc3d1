/// @file
/// @brief Places (R, zeta) at which the functions of a mode are surveyed: seeded ones, zone by zone, and the hard ones.
#pragma once

#include <boost/math/special_functions/fpclassify.hpp>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "denhartog/evaluation/demand.hpp"
#include "denhartog/number/reduced_angle.hpp"
#include "tests/support/multiprecision.hpp"

namespace denhartog::tests {

/// @name Numbers in more digits than the printed forms use up
/// @{
using Real300 = Multiprecision<300>;
using Real600 = Multiprecision<600>;
using Real1100 = Multiprecision<1100>;
/// @}

/// A number in hexadecimal, exact.
template <class T>
std::string hexadecimal(const T& x) {
    char text[160];
    if constexpr (std::is_floating_point_v<T>)
        std::snprintf(text, sizeof text, "%La", static_cast<long double>(x));
    else
        mpfr_snprintf(text, sizeof text, "%Ra", x.backend().data());
    return text;
}

/// The expression under the maximum in (57) with (28) and (29), by the forms that ship, in more digits and rounded once.
template <class T>
T s_d_rounded_once(const T& tau, const T& R, const T& zeta) {
    using Wide = std::conditional_t<(std::numeric_limits<T>::digits10 < 50), Real50, Real100>;
    const Wide wide_R(R), wide_zeta(zeta);
    return static_cast<T>(
        evaluation::s_d_integrand_of(Wide(tau), wide_R, wide_zeta, evaluation::selected_damping_functions(wide_R, wide_zeta)));
}

/// Seeded numbers, the same on every machine.
template <class T>
class Source {
public:
    explicit Source(std::uint64_t seed = 20220117) : bits_(seed) {}
    double uniform(double low, double high) { return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53; }
    int whole(int low, int high) { return low + static_cast<int>(bits_() % static_cast<std::uint64_t>(high - low + 1)); }
    /// A number with all its digits in [1, 2).
    T mantissa() {
        T x(0);
        for (int k = 0; k < std::numeric_limits<T>::digits; k += 32) x = (x + T(static_cast<double>(bits_() >> 32))) / T(0x1p32);
        return 1 + x;
    }
    /// Log-uniform between powers of ten.
    T spread(double low, double high) {
        const double exponent = uniform(low, high) / std::log10(2.0);
        return ldexp(mantissa(), static_cast<int>(std::floor(exponent)));
    }
    /// 1 with a deviation of random size down to the last place, or none.
    T near_one() {
        const int digits = std::numeric_limits<T>::digits;
        const int place = whole(1, digits + 2);
        const T deviation = place > digits ? T(0) : ldexp(mantissa(), -place - 1);
        return whole(0, 1) ? T(1 + deviation) : T(1 - deviation);
    }

private:
    std::mt19937_64 bits_;
};

template <class T>
struct Place {
    T R, zeta;
};

/// One seeded point in so many is compared with the paper's formulas whatever the forms in 50 digits say.
constexpr int always_against_the_paper = 16;

template <class T>
T below_one(const T& zeta) {
    const T last = 1 - std::numeric_limits<T>::epsilon() / 2;
    return zeta < last ? zeta : last;
}

/// A number, and what stands for it where the number type is float.
template <class T>
T unless_float(double usual, double in_float) {
    return T(std::is_same_v<T, float> ? in_float : usual);
}

/// Powers of ten between which R lies, and the least damping ratio.
template <class T>
struct Exponents {
    double R = std::is_same_v<T, float> ? 30 : 300;
    double zeta = std::is_same_v<T, float> ? -44 : -320;
};

/// Subnormal in float; in the other types what is subnormal in double.
template <class T>
T subnormal_in(Source<T>& s) {
    if constexpr (std::is_same_v<T, float>) return ldexp(s.mantissa(), s.whole(-149, -127));
    return T(static_cast<double>(ldexp(s.mantissa(), s.whole(-1074, -1023))));
}

/// The zones; the powers of ten are those in double, in float they are 1e-30 to 1e30 and 1e-44.
inline const std::vector<std::string>& mode_zones() {
    static const std::vector<std::string> names{"R 0.05 to 20, zeta 1e-4 to 1",
                                                "R 1e-300 to 1e300, zeta 1e-320 to 1",
                                                "R near 1/n, n odd",
                                                "R near 1, zeta of the distance",
                                                "zeta subnormal",
                                                "zeta near 1",
                                                "zeta = 0",
                                                "R small, zeta of the size of R",
                                                "R 2 to 1e300",
                                                "R near sqrt(1 - zeta^2) / n",
                                                "hard points"};
    return names;
}

template <class T>
Place<T> place_in(std::size_t zone, Source<T>& s) {
    const int digits = std::numeric_limits<T>::digits;
    const auto near_odd = [&s] { return T(s.near_one() / (2 * static_cast<int>(std::exp(s.uniform(0, 5))) - 1)); };
    const auto [far, least] = Exponents<T>();
    const auto any_R = [&s, far = far] { return T(s.spread(s.whole(0, 1) ? -far : -2, s.whole(0, 1) ? far : 2)); };
    switch (zone) {
    case 0: return {s.spread(-1.3, 1.3), below_one(s.spread(-4, 0))};
    case 1: return {s.spread(-far, far), below_one(s.spread(least, 0))};
    case 2: return {near_odd(), s.spread(-30, -0.4)};
    case 3: return {s.near_one(), ldexp(s.mantissa(), -s.whole(2, digits + 20))};
    case 4: return {s.whole(0, 1) ? near_odd() : any_R(), subnormal_in(s)};
    case 5: return {s.spread(-3, 3), below_one(T(1 - ldexp(s.mantissa(), -s.whole(2, digits + 1))))};
    case 6: return {s.whole(0, 1) ? near_odd() : any_R(), T(0)};
    case 7: {
        const T R = s.spread(-far, -1.5);
        return {R, below_one(T(R * s.spread(-3, 2.5)))};
    }
    case 8: return {s.spread(0.3, far), below_one(s.spread(-20, 0))};
    default: {
        const T zeta = below_one(s.spread(-8, 0));
        return {T(sqrt(T((1 - zeta) * (1 + zeta))) * s.near_one() / s.whole(1, 40)), zeta};
    }
    }
}

template <class T>
std::vector<Place<T>> hard_places() {
    const T eps = std::numeric_limits<T>::epsilon();
    std::vector<T> R{T(1),     1 + eps, 1 - eps / 2, 1 + 2 * eps, T(2), 2 - eps, T(5) / 4, T(5) / 4 * (1 - eps),
                     T(3) / 2, T(4),    T(1) / 1024};
    for (const auto& [usual, in_float] : {std::pair{1e-300, 1e-30},
                                          {1e300, 1e30},
                                          {1e77, 1e9},
                                          {2e77, 4e9},
                                          {1e100, 1e12},
                                          {1.3e154, 1.8e19},
                                          {1.4e154, 1.9e19},
                                          {1e160, 1e20},
                                          {1e-16, 1e-7},
                                          {3e-17, 3e-8}})
        R.push_back(unless_float<T>(usual, in_float));
    for (const int n : {2, 3, 4, 5, 6, 7, 9, 99, 1001, 2147483647})
        for (const int k : {-2, -1, 0, 1, 2}) R.push_back(T(1) / n * (1 + k * eps));
    std::vector<T> zeta{T(0),
                        unless_float<T>(0x1p-1074, 0x1p-149),
                        unless_float<T>(3 * 0x1p-1074, 3 * 0x1p-149),
                        unless_float<T>(1e-320, 1e-40),
                        unless_float<T>(0x1p-1022, 0x1p-126),
                        unless_float<T>(0x1p-1022 - 0x1p-1074, 0x1p-126 - 0x1p-149),
                        unless_float<T>(0x1p-970, 0x1p-103),
                        unless_float<T>(1e-200, 1e-30),
                        unless_float<T>(1e-162, 1e-22),
                        unless_float<T>(1e-154, 1e-19),
                        unless_float<T>(1e-100, 1e-14),
                        unless_float<T>(1e-30, 1e-10),
                        eps,
                        unless_float<T>(1e-9, 1e-5),
                        unless_float<T>(1e-6, 1e-4),
                        T(1e-3),
                        T(1) / 8,
                        T(1) / 2,
                        (1 - eps) / 2,
                        T(0.70710678118654752440),
                        T(7) / 8,
                        1 - 4 * eps,
                        1 - eps / 2};
    std::vector<Place<T>> places;
    for (const T& r : R)
        for (const T& z : zeta) places.push_back({r, z});
    return places;
}

/// Whether exp(-pi zeta / R) is below the range of every number type: below 2^(-2^30).
template <class T>
bool decays_out_of_range(const Place<T>& p) {
    return p.zeta > 0 && std::max(-330.0, std::log10(static_cast<double>(p.zeta))) - std::log10(static_cast<double>(p.R)) > 8.375;
}

/// Digits in which the printed damping functions have those of T and more: they lose those of the angle 1/R; near a pole the
/// square of the distance from it, or of zeta where R is 1/n exactly; at large R what the two terms of (29) cancel, but nothing
/// below the range of the type.
template <class T>
double digits_needed(const Place<T>& p) {
    const double R = std::log10(static_cast<double>(p.R)),
                 eps = std::log10(static_cast<double>(std::numeric_limits<T>::epsilon()));
    const double zeta = p.zeta > 0 ? std::max(-330.0, std::log10(static_cast<double>(p.zeta))) : eps;
    using std::remainder;
    const double near_pole = remainder(T(1), p.R) == 0 ? 2 * std::max(-zeta, -eps) : -2 * eps;
    const double far = std::min(2 * R, 20 - std::numeric_limits<T>::min_exponent10 - R);
    return 25 - eps + (R < 0.5 ? near_pole : far) + std::max(0.0, -R);
}

/// Error in units of eps of the true value, or of the least normal number where that is larger; infinite where the value is not
/// finite.
template <class T>
double error_of(const T& value, const Real100& truth) {
    if (!boost::math::isfinite(value)) return std::numeric_limits<double>::infinity();
    const Real100 least((std::numeric_limits<T>::min)()), size(abs(truth));
    const Real100 unit = Real100(std::numeric_limits<T>::epsilon()) * (size > least ? size : least);
    return static_cast<double>(Real100(abs(Real100(Real100(value) - truth)) / unit));
}

/// Error in units of eps of the true value, or of the least value that counts; beyond the largest number infinity is right.
template <class T>
double error_of(const T& value, const Real100& truth, const Real100& least) {
    if (boost::math::isnan(value)) return std::numeric_limits<double>::infinity();
    if (Real100(value) == truth) return 0;
    const Real100 largest((std::numeric_limits<T>::max)()), size(abs(truth));
    if (size > largest) return value == (truth > 0 ? 1 : -1) * std::numeric_limits<T>::infinity() ? 0 : 1e300;
    if (!boost::math::isfinite(value)) return std::numeric_limits<double>::infinity();
    const Real100 unit = Real100(std::numeric_limits<T>::epsilon()) * (size > least ? size : least);
    return static_cast<double>(Real100(abs(Real100(Real100(value) - truth)) / unit));
}

} // namespace denhartog::tests

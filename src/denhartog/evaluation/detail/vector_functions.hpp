/// @file
/// @brief Exponential, sine and cosine on a short range, without branch, table or call: what a compiler turns into vectors.
///
/// They are Taylor polynomials of fixed degree after a reduction of the argument, and use the four operations of IEEE 754 alone:
/// the digits do not depend on how many numbers the processor takes at once. The vector functions of glibc were measured and not
/// taken: `tests/speed_accuracy/batch_speed.cpp` shows their errors beside these.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "denhartog/evaluation/batch_forms.hpp"
#include "elementary/exact_arithmetic.hpp"
#include "elementary/series_tables.hpp"

namespace denhartog::evaluation {

using elementary::nearest_whole;

/// @brief 1 / n!. @param n a number up to 27 @return the inverse, rounded
[[nodiscard]] constexpr double inverse_factorial(int n) { return elementary::inverse_factorials[n]; }

/// @brief \f$ a + bz + cz^2 + dz^3 \f$, the pairs apart so that they do not wait for each other; zz is the square of z.
[[nodiscard, gnu::always_inline]] inline double cubic(double a, double b, double c, double d, double z, double zz) {
    return (a + b * z) + (c + d * z) * zz;
}

/// @brief \f$ e^x \f$ and \f$ e^x-1 \f$: x less a multiple of ln 2, a polynomial of degree 13, then powers of two.
/// @param x  a number, zero or negative
/// @return   both; from -1400 on downwards those of -1400, whose exponential rounds to zero
[[nodiscard, gnu::always_inline]] inline Exponential<double> exponential_of_negative(double x) {
    constexpr double ln2_high = 0x1.62e42feep-1;      // 32 bits: its products with whole numbers up to 2^20 are exact
    constexpr double ln2_low = 0x1.a39ef35793c76p-33; // the rest
    constexpr double shift = 0x1.8p52;                // brings a whole number into the low bits
    const double a = x > -1400.0 ? x : -1400.0;
    const double k = nearest_whole(a * 0x1.71547652b82fep0);
    const double r = (a - k * ln2_high) - k * ln2_low;
    const double z = r * r, z4 = z * z;
    constexpr auto c = inverse_factorial;
    const double low = cubic(c(2), c(3), c(4), c(5), r, z);
    const double middle = cubic(c(6), c(7), c(8), c(9), r, z);
    const double high = cubic(c(10), c(11), c(12), c(13), r, z);
    const double p = r + z * (low + z4 * (middle + z4 * high));
    // 2^k as two factors, each in the range of normal numbers, so that their product alone can underflow.
    const double half = nearest_whole(k * 0.5);
    const double first = std::bit_cast<double>((std::bit_cast<std::uint64_t>(half + shift) + 1023) << 52);
    const double second = std::bit_cast<double>((std::bit_cast<std::uint64_t>(k - half + shift) + 1023) << 52);
    return {(1 + p) * first, second, p * first * second + (first * second - 1)};
}

/// @brief Largest lag of an angle, in parts of 2 R, before it is reduced anew. @return a sixty-fourth
[[nodiscard]] constexpr double most_late() { return 0x1p-6; }

/// @brief \f$ \sin\alpha\cos\alpha \f$ and \f$ \cos^2\alpha \f$ of \f$ \alpha = \pi\,(w-\lambda)/(2R) \f$, reduced exactly.
///
/// R is split into two numbers of half the digits, so that \f$ w-2nR \f$ is found without rounding for the whole n next to
/// \f$ w/(2R) \f$. Beyond an eighth of a turn sine and cosine change places; \f$ R-|w-2nR| \f$ is exact there too,
/// and \f$ \lambda \f$ is taken off last: the cosine keeps its digits next to its zeros however small it is.
/// @param R     a number from 2^-27 to 2^200
/// @param x     1 / (2 R), rounded
/// @param w     a number from 2^-27 to 1
/// @param late  \f$ \lambda \f$, a number from 0 to 1/7
/// @return      both
[[nodiscard, gnu::always_inline]] inline HalfAngleProducts<double> half_angle_products(double R, double x, double w,
                                                                                       double late) {
    constexpr double pi = 0x1.921fb54442d18p1;
    const double twice = 2 * nearest_whole(w * x);
    const double high = std::bit_cast<double>(std::bit_cast<std::uint64_t>(R) & 0xfffffffff8000000U);
    const double rest_on_time = (w - twice * high) - twice * (R - high);
    const bool reduce = late * x > most_late();
    const double behind = rest_on_time - late;
    const double rest = reduce ? behind - nearest_whole(behind * x) * (2 * R) : rest_on_time;
    const double still_late = __builtin_copysign(reduce ? 0.0 : late, rest);
    const double size = __builtin_fabs(rest);
    const double other = R - size;
    const bool beyond_eighth = other < size;
    const double y = pi * ((beyond_eighth ? other + still_late : size - still_late) * x);
    const double s = y * y, ss = s * s, s4 = ss * ss;
    constexpr auto c = inverse_factorial;
    const double sine_tail = cubic(-c(3), c(5), -c(7), c(9), s, ss) + s4 * cubic(-c(11), c(13), -c(15), c(17), s, ss);
    const double cosine_tail = cubic(c(4), -c(6), c(8), -c(10), s, ss) + s4 * (c(12) - c(14) * s + c(16) * ss);
    const double sine = y + y * s * sine_tail;
    const double h = 0.5 * s;
    const double whole = 1 - h;
    const double cosine = whole + (((1 - whole) - h) + ss * cosine_tail);
    const double kept = beyond_eighth ? sine : cosine;
    return {__builtin_copysign(1.0, rest) * sine * cosine, kept * kept};
}

/// @brief Coefficients of \f$ \frac{1}{q^2}\left[\frac{\sinh q\zeta}{q\zeta}-\frac{\sin qw}{qw}\right] \f$ as a polynomial
/// in q^2.
struct BracketSeries {
    std::array<double, 12> c; ///< from the constant on
};

/// @brief The coefficients of a mode, by the recurrence of `sinhc_less_sinc_over_square`. @param zeta damping ratio @return them
[[nodiscard]] inline BracketSeries bracket_series(double zeta) {
    const double square = zeta * zeta, product = square * ((1 - zeta) * (1 + zeta));
    BracketSeries series{};
    double before = 0, now = 1;
    for (int k = 0; k < 12; ++k) {
        series.c[static_cast<std::size_t>(k)] = now * inverse_factorial(2 * k + 3);
        const double next = (2 * square - 1) * now + product * before;
        before = now;
        now = next;
    }
    return series;
}

/// @brief The bracket over q^2.
/// @param series  coefficients of the mode
/// @param s       q^2, up to 32/5
/// @return        the value
[[nodiscard, gnu::always_inline]] inline double bracket_over_square(const BracketSeries& series, double s) {
    const double ss = s * s, s4 = ss * ss;
    const std::array<double, 12>& c = series.c;
    return cubic(c[0], c[1], c[2], c[3], s, ss) +
           s4 * (cubic(c[4], c[5], c[6], c[7], s, ss) + s4 * cubic(c[8], c[9], c[10], c[11], s, ss));
}

} // namespace denhartog::evaluation

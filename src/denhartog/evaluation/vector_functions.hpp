/// @file
/// @brief Exponential, sine and cosine on a short range, without branch, table or call: what a compiler turns into vectors.
///
/// They are Taylor polynomials of fixed degree after a reduction of the argument, and use the four operations of IEEE 754 alone:
/// the digits do not depend on how many numbers the processor takes at once. The vector functions of glibc were measured and not
/// taken: `tests/speed_accuracy/batch_speed.cpp` shows their errors beside these.
#pragma once

#include <bit>
#include <cstdint>

namespace denhartog::evaluation {

/// @brief 1 / n!, rounded from a quotient in long double. @param n a number up to 25 @return the inverse
[[nodiscard]] constexpr double inverse_factorial(int n) {
    long double factorial = 1;
    for (int k = 2; k <= n; ++k) factorial *= k;
    return static_cast<double>(1 / factorial);
}

/// @brief Nearest whole number, ties to even. @param x a number of size up to 2^51 @return the whole number
[[nodiscard, gnu::always_inline]] inline double nearest_whole(double x) {
    const double shift = 0x1.8p52;
    return (x + shift) - shift;
}

/// @brief Sum of four terms of a polynomial, the pairs apart so that they do not wait for each other.
/// @param a   first coefficient
/// @param b   second coefficient
/// @param c   third coefficient
/// @param d   fourth coefficient
/// @param z   the variable
/// @param zz  its square
/// @return    a + b z + c z^2 + d z^3
[[nodiscard, gnu::always_inline]] inline double cubic(double a, double b, double c, double d, double z, double zz) {
    return (a + b * z) + (c + d * z) * zz;
}

/// @brief \f$ e^x \f$ and \f$ e^x-1 \f$ of one argument.
struct Exponential {
    double E;           ///< exp(x), with gradual underflow
    double E_minus_one; ///< exp(x) - 1, without cancellation near 0
};

/// @brief \f$ e^x \f$ and \f$ e^x-1 \f$: x less a multiple of ln 2, a polynomial of degree 13, then powers of two.
/// @param x  a number, zero or negative
/// @return   both
[[nodiscard, gnu::always_inline]] inline Exponential exponential_of_negative(double x) {
    constexpr double ln2_high = 0x1.62e42feep-1;      // 32 bits: its products with whole numbers up to 2^20 are exact
    constexpr double ln2_low = 0x1.a39ef35793c76p-33; // the rest
    constexpr double shift = 0x1.8p52;                // brings a whole number into the low bits
    const double a = x > -746.0 ? x : -746.0;         // exp(-746) rounds to zero
    const double k = nearest_whole(a * 0x1.71547652b82fep0);
    const double r = (a - k * ln2_high) - k * ln2_low;
    const double z = r * r, z4 = z * z;
    constexpr auto c = inverse_factorial;
    const double low = cubic(c(2), c(3), c(4), c(5), r, z);
    const double middle = cubic(c(6), c(7), c(8), c(9), r, z);
    const double high = cubic(c(10), c(11), c(12), c(13), r, z);
    const double p = r + z * (low + z4 * (middle + z4 * high));
    // 2^k as two factors, each in the range of normal numbers, so that the last product alone can underflow.
    const double half = nearest_whole(k * 0.5);
    const double first = std::bit_cast<double>((std::bit_cast<std::uint64_t>(half + shift) + 1023) << 52);
    const double second = std::bit_cast<double>((std::bit_cast<std::uint64_t>(k - half + shift) + 1023) << 52);
    return {(1 + p) * first * second, p * first * second + (first * second - 1)};
}

/// @brief Products of the sine and cosine of a half angle.
struct HalfAngleProducts {
    double sine_cosine;   ///< sin cos
    double cosine_square; ///< cos^2
};

/// @brief The largest second argument of `half_angle_products`. @return a sixty-fourth of half a turn
[[nodiscard]] constexpr double most_late() { return 0x1p-6; }

/// @brief \f$ \sin(\pi z)\cos(\pi z) \f$ and \f$ \cos^2(\pi z) \f$ at \f$ z \f$ = turn - late: whole numbers in z do not matter.
///
/// Beyond a quarter sine and cosine change places before `late` is taken off, so that the cosine keeps its digits near its zero
/// and a `late` below the rounding of 1/2 is not lost there.
/// @param turn  a number from -1/2 to 1/2
/// @param late  a number from 0 to `most_late()`
/// @return      both
[[nodiscard, gnu::always_inline]] inline HalfAngleProducts half_angle_products(double turn, double late) {
    constexpr double pi = 0x1.921fb54442d18p1;
    const double size = __builtin_fabs(turn);
    const double other = 0.5 - size;
    const double signed_late = __builtin_copysign(late, turn);
    const double y = pi * ((other < size ? other : size) + (size > 0.25 ? signed_late : -signed_late));
    const double s = y * y, ss = s * s, s4 = ss * ss;
    constexpr auto c = inverse_factorial;
    const double sine_tail = cubic(-c(3), c(5), -c(7), c(9), s, ss) + s4 * cubic(-c(11), c(13), -c(15), c(17), s, ss);
    const double cosine_tail = cubic(c(4), -c(6), c(8), -c(10), s, ss) + s4 * (c(12) - c(14) * s + c(16) * ss);
    const double sine = y + y * s * sine_tail;
    const double h = 0.5 * s;
    const double whole = 1 - h;
    const double cosine = whole + (((1 - whole) - h) + ss * cosine_tail);
    const double kept = size > 0.25 ? sine : cosine;
    const double sign = __builtin_copysign(1.0, turn);
    return {sign * sine * cosine, kept * kept};
}

/// @brief \f$ \sum_{k\ge1} s^k/(2k+1)! \f$: \f$ \sinh(x)/x-1 \f$ at \f$ s=x^2 \f$, \f$ \sin(x)/x-1 \f$ at \f$ s=-x^2 \f$.
/// @param s  a number of size up to 5/2
/// @return   the sum
[[nodiscard, gnu::always_inline]] inline double odd_series(double s) {
    constexpr auto c = inverse_factorial;
    const double ss = s * s, s4 = ss * ss;
    const double low = cubic(c(3), c(5), c(7), c(9), s, ss);
    const double middle = cubic(c(11), c(13), c(15), c(17), s, ss);
    return s * (low + s4 * (middle + s4 * (c(19) + c(21) * s)));
}

} // namespace denhartog::evaluation

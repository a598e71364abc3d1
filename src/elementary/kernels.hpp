/// @file
/// @brief The kernels of the elementary functions: the argument and the result in two parts, the second good to 2^-58 of the
/// whole.
#pragma once

#include <cmath>
#include <limits>

#include "elementary/angle_tables.hpp"
#include "elementary/circle_tables.hpp"
#include "elementary/exact_arithmetic.hpp"
#include "elementary/power_tables.hpp"

namespace denhartog::elementary {

/// @brief The value of a function outside its domain.
inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
/// @brief From here on \f$ e^x-1 \f$ and \f$ e^x \f$ are one double, and so are \f$ e^x+e^{-x} \f$ and \f$ e^x \f$.
inline constexpr double one_is_nothing = 40;

/// @brief Whether a number is finite. @param x a number @return true if so
[[nodiscard, gnu::always_inline]] inline bool is_finite(double x) { return x - x == 0; }

/// @brief 2^n. @param n a whole number from -1022 to 1023 @return the power
[[nodiscard, gnu::always_inline]] inline double power_of_two(std::int64_t n) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(n + 1023) << 52U);
}

/// @brief A number as a multiple of ln 2 / 256 and the rest, up to half of that.
struct ReducedExponent {
    std::uint64_t n; ///< the multiple, in its last 51 bits
    double first;    ///< the number less the multiple of the first part, exact
    double behind;   ///< the multiple of the second part, to be taken from it
};

/// @brief Reduces an exponent. @param x a number of size up to 800 @return it reduced
[[nodiscard, gnu::always_inline]] inline ReducedExponent reduce_exponent(double x) {
    const double shift = 0x1.8p52, shifted = x * parts_in_one + shift, k = shifted - shift;
    return {std::bit_cast<std::uint64_t>(shifted), x - k * part_high, k * part_low};
}

/// @brief \f$ e^x = 2^m t (1 + r + s) \f$.
struct TakenApart {
    std::int64_t m; ///< exponent of two
    double t;       ///< \f$ 2^{k/256} \f$, from the table
    double r;       ///< what is left of the argument, up to ln 2 / 512
    double s;       ///< the rest of the series, and what r and t lack
};

/// @brief Takes \f$ e^x \f$ apart: x less a multiple of ln 2 / 256, then a polynomial of degree 5.
/// @param x  a number of size up to 800
/// @return   the parts
[[nodiscard, gnu::always_inline]] inline TakenApart exponential(double x) {
    const ReducedExponent reduced = reduce_exponent(x);
    const auto whole = static_cast<std::int64_t>(reduced.n << 13U) >> 13U;
    const Power& power = powers[whole & 255];
    const double first = reduced.first, behind = reduced.behind;
    const double r = first - behind, r_low = (first - r) - behind, z = r * r;
    const double series = (0.5 + r * (1.0 / 6)) + z * (1.0 / 24 + r * (1.0 / 120));
    return {whole >> 8U, power.value, r, z * series + (r_low + (power.relative + power.relative * r))};
}

/// @brief \f$ 2^{n/256} \f$ with its first 53 bits. @param n the multiple of a reduced exponent @return the power, in the normal
/// range, and what its rounding lacks, as a part of it
[[nodiscard, gnu::always_inline]] inline Power power_at(std::uint64_t n) {
    const Power& power = powers[n & 255U];
    return {std::bit_cast<double>(std::bit_cast<std::uint64_t>(power.value) + (n >> 8U << 52U)), power.relative};
}

/// @brief \f$ e^x - 1 \f$. @param x a number of size up to 40 @return both parts
[[nodiscard, gnu::always_inline]] inline Parts exponential_less_one(double x) {
    const TakenApart e = exponential(x);
    const Parts less_one = exact_sum(power_of_two(e.m) * e.t, -1), head = ordered_sum(less_one.high, e.r);
    return {head.high, head.low + (less_one.low + (e.s + less_one.high * (e.r + e.s)))};
}

/// @brief An angle as a multiple of pi / 64 and the rest.
struct ReducedAngle {
    std::uint64_t n; ///< the multiple, but for whole turns in its first 7 bits
    double d;        ///< the rest, up to pi / 128
    double d_low;    ///< what d lacks
};

/// @brief Reduces an angle of any size by as many bits of 2 / pi as it takes. @param x radians, finite, from 2^-60 on
/// @return it reduced
[[nodiscard]] ReducedAngle reduce_by_all_bits(double x);

/// @brief The rest of an angle beyond the multiple of pi / 64 next to it, all four parts of pi / 64 taken.
/// @param k      the multiple, up to 2^29
/// @param first  the angle less k times the first two parts
/// @return       both parts
[[nodiscard]] Parts beyond_multiple(double k, double first);

/// @brief Reduces an angle. pi / 64 is taken in three parts, whose first two have exact products with whole numbers up to 2^29.
/// @param x  radians, finite
/// @return   it reduced; the rest is good to 2^-60 of itself
[[nodiscard, gnu::always_inline]] inline ReducedAngle reduce(double x) {
    const double shift = 0x1.8p52, shifted = x * steps_in_radian + shift, k = shifted - shift;
    const double behind = k * step_third, first = (x - k * step_first) - k * step_second;
    const double d = first - behind;
    if (!(std::fabs(x) < 0x1p24)) [[unlikely]] {
        const ReducedAngle angle = reduce_by_all_bits(x);
        const Parts sum = exact_sum(angle.d, angle.d_low);
        return {angle.n, sum.high, sum.low};
    }
    if (std::fabs(d) < 0x1p-16 && k != 0) [[unlikely]] {
        const Parts rest = beyond_multiple(k, first);
        return {std::bit_cast<std::uint64_t>(shifted), rest.high, rest.low};
    }
    return {std::bit_cast<std::uint64_t>(shifted), d, (first - d) - behind};
}

/// @brief An angle in half turns without whole turns, where there are many. @param x half turns @return the rest, exact
[[nodiscard, gnu::always_inline]] inline double without_many_turns(double x) {
    return std::fabs(x) < 0x1p43 ? x : x - 2 * std::floor(x / 2);
}

/// @brief Reduces an angle in half turns. @param x half turns, of size up to 2^43 @return it reduced
[[nodiscard, gnu::always_inline]] inline ReducedAngle reduce_half_turns(double x) {
    const double shift = 0x1.8p52, shifted = x * 64 + shift, t = x - (shifted - shift) * 0x1p-6;
    const Parts d = exact_product_in_range(t, pi_high);
    const Parts sum = ordered_sum(d.high, d.low + t * pi_low);
    return {std::bit_cast<std::uint64_t>(shifted), sum.high, sum.low};
}

/// @brief The sine of a reduced angle from that of the multiple:
/// \f$ S + \sigma d + [(C-\sigma)d + C(\sin d-d) + S(\cos d-1)] \f$, where \f$ \sigma \f$ is the whole number next to C. The
/// first two terms are added without rounding, and the bracket is small beside their sum.
/// @param a  a reduced angle
/// @return   both parts
[[nodiscard, gnu::always_inline]] inline Parts sine(const ReducedAngle& a) {
    const Direction& at = circle[a.n & 127U];
    const double d = a.d, z = d * d, along = at.whole * d;
    const double sine_part = d * z * (-1.0 / 6 + z * (1.0 / 120 - z * (1.0 / 5040)));
    const double cosine_part = z * (-0.5 + z * ((1.0 / 24 - z * (1.0 / 720)) + z * z * (1.0 / 40320)));
    const Parts head = ordered_sum(at.sine, along);
    const double first = at.cosine_less_whole * d + at.sine * cosine_part + (at.rest + at.whole * a.d_low);
    return {head.high, head.low + (first + (at.whole + at.cosine_less_whole) * sine_part)};
}

/// @brief The cosine: the sine a quarter turn on. @param a a reduced angle @return both parts
[[nodiscard, gnu::always_inline]] inline Parts cosine(const ReducedAngle& a) { return sine({a.n + 32, a.d, a.d_low}); }

/// @brief A function from its expansion: the value at the point and the distance are added without rounding, and the rest is small
/// beside their sum.
/// @param table  expansions at the multiples of 1 / 64
/// @param x      a positive number, at most the last of them
/// @param low    a small one, to be added to it
/// @return       both parts
[[nodiscard, gnu::always_inline]] inline Parts expanded(const Expansion* table, double x, double low) {
    const double c = nearest_whole(x * 64), r = x - c * 0x1p-6, z = r * r;
    const Expansion& at = table[static_cast<int>(c)];
    const double z_2 = z * z;
    const double higher = z_2 * ((at.fourth + r * at.fifth) + z * (at.sixth + r * at.seventh)) + z_2 * z_2 * at.eighth;
    const double rest = (at.slope_less_one * (r + low) + low) + (z * (at.second + r * at.third) + higher);
    const Parts head = ordered_sum(at.high, r);
    return {head.high, head.low + (at.low + rest)};
}

} // namespace denhartog::elementary

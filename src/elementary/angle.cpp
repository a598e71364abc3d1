/// @file
/// @brief Sines, cosines and their inverses.
#include <cmath>
#include <limits>
#include <utility>

#include "elementary/elementary.hpp"
#include "elementary/kernels.hpp"

namespace denhartog::elementary {

using Wide = unsigned __int128;

// With x = m 2^e, m a whole number, bits of 2 / pi that make multiples of 128 steps of it are left out: 256 bits behind them
// hold the steps, their fraction, and 60 bits more than a double can come close to a multiple.
ReducedAngle reduce_by_all_bits(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const auto exponent = static_cast<int>(bits >> 52U & 2047U) - 1075; // m 2^exponent
    const std::uint64_t m = (bits & 0xfffffffffffffU) | 0x10000000000000U;
    const auto from = static_cast<unsigned>(exponent - 2 + 128); // 64 / pi = 32 (2 / pi), and 128 = 2^7
    const std::uint64_t* word = two_over_pi + from / 64;
    const unsigned shift = from % 64;
    std::uint64_t product[4]; // of m and 256 bits, the last first
    std::uint64_t carried = 0;
    for (int n = 3; n >= 0; --n) {
        const std::uint64_t window = shift == 0 ? word[n] : word[n] << shift | word[n + 1] >> (64 - shift);
        const Wide sum = static_cast<Wide>(m) * window + carried;
        product[3 - n] = static_cast<std::uint64_t>(sum);
        carried = static_cast<std::uint64_t>(sum >> 64U);
    }
    std::uint64_t n = product[3] >> 57U;
    std::uint64_t a = product[3] << 7U | product[2] >> 57U, b = product[2] << 7U | product[1] >> 57U,
                  c = product[1] << 7U | product[0] >> 57U; // 192 bits of the fraction
    const bool over = a >> 63U != 0;                        // more than half a step: the next multiple
    if (over) {
        ++n;
        a = ~a;
        b = ~b;
        c = ~c;
    }
    int zeros = 0;
    if (a == 0) {
        a = b;
        b = c;
        c = 0;
        zeros = 64;
    }
    const int leading = std::countl_zero(a | 1U);
    if (leading > 0) {
        a = a << leading | b >> (64 - leading);
        b = b << leading | c >> (64 - leading);
    }
    const double first = static_cast<double>(a >> 11U), second = static_cast<double>((a & 2047U) << 42U | b >> 22U);
    const double unit = power_of_two(-53 - zeros - leading), high = first * unit, low = second * unit * 0x1p-53;
    const Parts whole = exact_product_in_range(high, step_high);
    const double rest = whole.low + (high * step_low + low * step_high);
    const double sign = over != (bits >> 63U != 0) ? -1 : 1;
    return {bits >> 63U != 0 ? -n : n, sign * whole.high, sign * rest};
}

Parts beyond_multiple(double k, double first) {
    const Parts third = exact_product_in_range(k, step_third), beyond = exact_sum(first, -third.high);
    return exact_sum(beyond.high, beyond.low - (third.low + k * step_fourth));
}

namespace {

// The angle of (x, y), both positive, y not above x and not below 2^-60 x, within the range where products are exact.
[[gnu::always_inline]] inline Parts angle_in_first_octant(double y, double x) {
    const double by_x = 1 / x, slope = y * by_x;
    const Parts back = exact_product_in_range(slope, x);
    return expanded(arc_tangents, slope, ((y - back.high) - back.low) * by_x);
}

// A half turn or a quarter, and an angle of at most that size, added to it or taken from it. @param turns half turns
[[gnu::always_inline]] inline Parts from_half_turns(double turns, double sign, const Parts& angle) {
    const Parts head = ordered_sum(turns * pi_high, sign * angle.high);
    return {head.high, head.low + (turns * pi_low + sign * angle.low)};
}

// The angle of the point (x, y), finite and not both zero, from -pi to pi.
Parts angle_of(double y, double x) {
    const bool left = x < 0, below = y < 0;
    x = std::fabs(x);
    y = std::fabs(y);
    const bool steep = y > x;
    if (steep) std::swap(x, y);
    Parts angle{0, 0};
    if (y < x * 0x1p-60) {
        angle.high = y / x;
    } else {
        const double scale = x > 0x1p700 ? 0x1p-600 : x < 0x1p-700 ? 0x1p600 : 1;
        angle = angle_in_first_octant(y * scale, x * scale);
    }
    if (steep || left) angle = from_half_turns(steep ? 0.5 : 1, steep == left ? 1 : -1, angle);
    return below ? Parts{-angle.high, -angle.low} : angle;
}

} // namespace

double sin(double x) noexcept {
    if (!is_finite(x)) return no_number;
    if (std::fabs(x) < 0x1p-30) return x;
    const Parts s = sine(reduce(x));
    return s.high + s.low;
}

double cos(double x) noexcept {
    if (!is_finite(x)) return no_number;
    const Parts c = cosine(reduce(x));
    return c.high + c.low;
}

SineCosine<double> sine_cosine(double x) noexcept {
    if (!is_finite(x)) return {no_number, no_number};
    const ReducedAngle angle = reduce(x);
    const Parts s = sine(angle), c = cosine(angle);
    return {std::fabs(x) < 0x1p-30 ? x : s.high + s.low, c.high + c.low};
}

double sine_of_half_turns(double x) noexcept {
    x = without_many_turns(x);
    if (!is_finite(x)) return no_number;
    if (std::fabs(x) < 0x1p-60) {
        if (x == 0) return x;
        const Parts s = exact_product(x * 0x1p600, pi_high);
        return (s.high + (s.low + x * 0x1p600 * pi_low)) * 0x1p-600;
    }
    const Parts s = sine(reduce_half_turns(x));
    return s.high + s.low;
}

double cosine_of_half_turns(double x) noexcept {
    x = without_many_turns(x);
    if (!is_finite(x)) return no_number;
    const Parts c = cosine(reduce_half_turns(x));
    return c.high + c.low;
}

double atan2(double y, double x) noexcept {
    if (x != x || y != y) return no_number;
    if (!is_finite(x) || !is_finite(y))
        return atan2(std::copysign(is_finite(y) ? 0 : 1, y), std::copysign(is_finite(x) ? 0 : 1, x));
    if (y == 0) return std::signbit(x) ? std::copysign(pi_high, y) : y;
    const Parts angle = angle_of(y, x);
    return angle.high + angle.low;
}

double atan(double x) noexcept {
    const double size = std::fabs(x);
    if (size <= 1) {
        const Parts angle = expanded(arc_tangents, size, 0);
        return std::copysign(angle.high + angle.low, x);
    }
    if (!(size < 0x1p60)) return size == size ? std::copysign(pi_high / 2, x) : no_number;
    const Parts angle = from_half_turns(0.5, -1, angle_in_first_octant(1, size));
    return std::copysign(angle.high + angle.low, x);
}

// The root and, from the exact difference to the larger or the smaller side, what it lacks: Borges, ACM Transactions on
// Mathematical Software 47 (2020), 9.
[[gnu::always_inline]] inline double length(double larger, double smaller) {
    const double root = std::sqrt(larger * larger + smaller * smaller);
    double excess;
    if (root <= 2 * smaller) {
        const double d = root - smaller;
        excess = larger * (2 * d - larger) + (d - 2 * (larger - smaller)) * d;
    } else {
        const double d = root - larger;
        excess = 2 * d * (larger - 2 * smaller) + ((4 * d - smaller) * smaller + d * d);
    }
    return root - excess / (2 * root);
}

double hypot(double x, double y) noexcept {
    x = std::fabs(x);
    y = std::fabs(y);
    const double larger = x > y ? x : y, smaller = x > y ? y : x;
    if (larger < 0x1p500 && smaller > 0x1p-400) [[likely]]
        return length(larger, smaller);
    if (!is_finite(x) || !is_finite(y))
        return std::isinf(x) || std::isinf(y) ? std::numeric_limits<double>::infinity() : no_number;
    if (smaller <= larger * 0x1p-54) return larger + smaller;
    const double scale = larger >= 0x1p500 ? 0x1p-600 : 0x1p600;
    return length(larger * scale, smaller * scale) / scale;
}

} // namespace denhartog::elementary

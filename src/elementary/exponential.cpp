/// @file
/// @brief Exponentials, hyperbolic functions and logarithms.
#include <cmath>
#include <limits>

#include "elementary/elementary.hpp"
#include "elementary/kernels.hpp"
#include "elementary/logarithm_tables.hpp"

namespace denhartog::elementary {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

double rounded(const Parts& parts) { return parts.high + parts.low; }

// e^x 2^by where it may leave the normal range: powers of two in two steps, so that the last operation alone rounds there.
[[gnu::noinline]] Parts exponential_far_out(double x, int by) {
    if (x != x) return {x, 0};
    if (x > 800) return {infinite, 0};
    if (x < -800) return {0, 0};
    const TakenApart e = exponential(x);
    const std::int64_t m = e.m + by, half = m / 2;
    const double first = power_of_two(half), second = power_of_two(m - half);
    const Parts value = ordered_sum(e.t * first, e.t * (e.r + e.s) * first);
    return {value.high * second, m > -900 ? value.low * second : 0};
}

// Half of e^x + sign e^-x, x from 0 on and below 600: with the powers of two for p and q, whose sum or difference is taken first,
// (p + sign q) cosh(r) + (p - sign q) sinh(r).
[[gnu::always_inline]] inline double hyperbolic(double x, double sign) {
    const auto [n, first, behind] = reduce_exponent(x);
    const double r = first - behind;
    const Power p = power_at(n - 256), q = power_at(-n - 256);
    const Parts head = ordered_sum(p.value, sign * q.value);
    const double rest = head.low + (p.value * p.relative + sign * q.value * q.relative);
    const double z = r * r, other = (p.value - sign * q.value) * r;
    const double even = head.high * (z * (0.5 + z * (1.0 / 24))), odd = other * (z * (1.0 / 6 + z * (1.0 / 120)));
    return head.high + (((rest + other) + even) + odd);
}

// log(x) in two parts, x positive and normal by its bits, or such a number times 2^-54.
[[gnu::always_inline]] inline Parts logarithm(std::uint64_t bits, std::int32_t shift) {
    constexpr std::uint64_t least = 0x3fe6a00000000000U; // m is taken from here to its double
    const std::uint64_t exponent = (bits - least) & 0xfff0000000000000U;
    const double m = std::bit_cast<double>(bits - exponent), first = first_half(m);
    const auto k = static_cast<double>((static_cast<std::int32_t>(exponent >> 32U) >> 20U) + shift);
    const Logarithm& at = logarithms[bits >> 44U & 255U];
    // m times the inverse is a multiple of 2^-61 and less than 2^-8 from 1: what is left is exact, in one step or in several.
    const double R = has_fused_product ? fused_product(m, at.inverse, -1) : (first * at.inverse - 1) + (m - first) * at.inverse;
    const double z = R * R;
    const double series = z * (-1.0 / 2 + R * (1.0 / 3)) + z * z * ((-1.0 / 4 + R * (1.0 / 5)) + z * (-1.0 / 6 + R * (1.0 / 7)));
    const Parts head = ordered_sum(k * ln_2_high + at.high, R);
    return {head.high, head.low + ((k * ln_2_low + at.low) + series)};
}

constexpr std::uint64_t least_normal = 0x0010000000000000U, infinity_bits = 0x7ff0000000000000U;

// Whether the bits are those of a positive normal number.
bool is_normal(std::uint64_t bits) { return bits - least_normal < infinity_bits - least_normal; }

// log(x) where x is no positive normal number.
[[gnu::noinline]] Parts logarithm_far_out(double x) {
    if (x == 0) return {-infinite, 0};
    if (!(x > 0)) return {no_number, 0};
    if (x == infinite) return {x, 0};
    return logarithm(std::bit_cast<std::uint64_t>(x * 0x1p54), -54);
}

} // namespace

double exp(double x) noexcept {
    if (!(std::fabs(x) < 600)) [[unlikely]]
        return rounded(exponential_far_out(x, 0));
    const auto [n, first, behind] = reduce_exponent(x);
    const Power power = power_at(n);
    const double r = first - behind, z = r * r;
    const double linear = power.value * (power.relative + r), square = power.value * z;
    return power.value + (linear + square * ((0.5 + r * cubic) + z * (1.0 / 24)));
}

double expm1(double x) noexcept {
    if (std::fabs(x) < 0x1p-9) {
        if (std::fabs(x) < 0x1p-60) return x;
        const double z = x * x;
        return x + z * ((0.5 + x * (1.0 / 6)) + z * ((1.0 / 24 + x * (1.0 / 120)) + z * (1.0 / 720)));
    }
    if (!(std::fabs(x) < one_is_nothing)) return x > 0 ? exp(x) : exp(x) - 1;
    const Parts e = exponential_less_one(x);
    return e.high + e.low;
}

double sinh(double x) noexcept {
    const double size = std::fabs(x);
    if (size < 0.0625) {
        const double z = x * x;
        const double series = (1.0 / 6 + z * (1.0 / 120)) + z * z * (1.0 / 5040 + z * (1.0 / 362880));
        return x + x * z * series;
    }
    return std::copysign(size < 600 ? hyperbolic(size, -1) : rounded(exponential_far_out(size, -1)), x);
}

double cosh(double x) noexcept {
    const double size = std::fabs(x);
    return size < 600 ? hyperbolic(size, 1) : rounded(exponential_far_out(size, -1));
}

double log(double x) noexcept {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const Parts l = is_normal(bits) ? logarithm(bits, 0) : logarithm_far_out(x);
    return l.high + l.low;
}

double log10(double x) noexcept {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const Parts l = is_normal(bits) ? logarithm(bits, 0) : logarithm_far_out(x);
    if (!(l.high - l.high == 0)) [[unlikely]]
        return l.high;
    const Parts product = exact_product_in_range(l.high, log10_e_high);
    return product.high + (product.low + (l.high * log10_e_low + l.low * log10_e_high));
}

} // namespace denhartog::elementary

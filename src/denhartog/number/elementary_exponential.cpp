/// @file
/// @brief Exponentials, hyperbolic functions and logarithms.
#include <cmath>
#include <limits>

#include "denhartog/number/double_double.hpp"
#include "denhartog/number/elementary.hpp"
#include "denhartog/number/elementary_kernels.hpp"

namespace denhartog {
namespace elementary {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double one_is_nothing = 40; // from here on e^x - 1 and e^x are one double, and so are e^x + e^-x and e^x

// e^x 2^by where it may leave the normal range: powers of two in two steps, so that the last operation alone rounds there.
[[gnu::noinline]] DoubleDouble exponential_far_out(double x, double low, int by) {
    if (x != x) return DoubleDouble(x);
    if (x > 800) return DoubleDouble(infinite);
    if (x < -800) return DoubleDouble(0);
    const TakenApart e = exponential(x, low);
    const std::int64_t m = e.m + by, half = m / 2;
    const double first = power_of_two(half), second = power_of_two(m - half);
    const Parts value = ordered_sum(e.t * first, e.t * (e.r + e.s) * first);
    return m > -900 ? DoubleDouble(value.high * second, value.low * second) : DoubleDouble(value.high * second);
}

DoubleDouble scaled_exponential(const DoubleDouble& a, int by) {
    if (!(std::fabs(a.high) < 600)) return exponential_far_out(a.high, a.low, by);
    const TakenApart e = exponential(a.high, a.low);
    const double scaled = e.t * power_of_two(e.m + by);
    return {scaled, scaled * (e.r + e.s)};
}

// e^x, x not negative and below 40.
Parts exponential_below_overflow(double x) {
    const TakenApart e = short_exponential(x);
    const double scaled = e.t * power_of_two(e.m);
    return ordered_sum(scaled, scaled * (e.r + e.s));
}

// log(x) in two parts, x positive and normal by its bits, or such a number times 2^-54.
[[gnu::always_inline]] inline Parts logarithm(std::uint64_t bits, double shift) {
    constexpr std::uint64_t least = 0x3fe6a00000000000U; // m is taken from here to its double
    const std::uint64_t exponent = (bits - least) & 0xfff0000000000000U;
    const double m = std::bit_cast<double>(bits - exponent), first = first_half(m);
    const double k = static_cast<double>(static_cast<std::int32_t>(exponent >> 32U) >> 20U) + shift;
    const Logarithm& at = logarithms[bits >> 45U & 127U];
    // The product of 35 bits less 1 has none below 2^-35, far above the last of the other: the sum is exact as if it were the
    // larger.
    const double larger = first * at.inverse - 1, smaller = (m - first) * at.inverse;
    const double R = has_fused_product ? fused_product(m, at.inverse, -1) : larger + smaller, z = R * R;
    const double series =
        ((-1.0 / 2 + R * (1.0 / 3)) + z * (-1.0 / 4 + R * (1.0 / 5))) + z * z * ((-1.0 / 6 + R * (1.0 / 7)) - z * (1.0 / 8));
    const Parts head = ordered_sum(k * ln_2_high + at.high, R);
    return {head.high, (head.low + ((k * ln_2_low + at.low) + (smaller - (R - larger)))) + z * series};
}

constexpr std::uint64_t least_normal = 0x0010000000000000U, of_infinity = 0x7ff0000000000000U;

// Whether the bits are those of a positive normal number.
bool is_normal(std::uint64_t bits) { return bits - least_normal < of_infinity - least_normal; }

// log(x) where x is no positive normal number.
[[gnu::noinline]] Parts logarithm_far_out(double x) {
    if (x == 0) return {-infinite, 0};
    if (!(x > 0)) return {std::numeric_limits<double>::quiet_NaN(), 0};
    if (x == infinite) return {x, 0};
    return logarithm(std::bit_cast<std::uint64_t>(x * 0x1p54), -54);
}

} // namespace

double exp(double x) noexcept {
    if (!(std::fabs(x) < 600)) [[unlikely]]
        return exponential_far_out(x, 0, 0).high;
    const TakenApart e = short_exponential(x);
    const double scaled = e.t * power_of_two(e.m);
    return scaled + scaled * (e.r + e.s);
}

double expm1(double x) noexcept {
    if (std::fabs(x) < 0x1p-9) {
        if (std::fabs(x) < 0x1p-60) return x;
        const double z = x * x;
        return x + z * ((0.5 + x * (1.0 / 6)) + z * ((1.0 / 24 + x * (1.0 / 120)) + z * (1.0 / 720)));
    }
    if (!(std::fabs(x) < one_is_nothing)) return x > 0 ? exp(x) : exp(x) - 1;
    const Parts e = exponential_less_one(x, 0);
    return e.high + e.low;
}

double sinh(double x) noexcept {
    const double size = std::fabs(x);
    if (size < 1) {
        const double z = x * x, z_2 = z * z, z_4 = z_2 * z_2;
        const double first = (1.0 / 6 + z * (1.0 / 120)) + z_2 * (1.0 / 5040 + z * (1.0 / 362880));
        const double second =
            (1.0 / 39916800 + z * (1.0 / 6227020800)) + z_2 * (1.0 / 1307674368000 + z * (1.0 / 355687428096000));
        return x + x * z * (first + z_4 * second);
    }
    if (!(size < one_is_nothing)) return std::copysign(scaled_exponential(DoubleDouble(size), -1).high, x);
    const Parts power = exponential_below_overflow(size);
    const Parts difference = ordered_sum(power.high, -1 / power.high);
    return std::copysign(0.5 * (difference.high + (difference.low + power.low)), x);
}

double cosh(double x) noexcept {
    const double size = std::fabs(x);
    if (!(size < one_is_nothing)) return scaled_exponential(DoubleDouble(size), -1).high;
    const Parts power = exponential_below_overflow(size);
    const double inverse = 1 / power.high;
    const Parts sum = ordered_sum(power.high, inverse);
    return 0.5 * (sum.high + (sum.low + power.low * (1 - inverse * inverse)));
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

} // namespace elementary

DoubleDouble exp(const DoubleDouble& a) { return elementary::scaled_exponential(a, 0); }

DoubleDouble expm1(const DoubleDouble& a) {
    if (!(std::fabs(a.high) < elementary::one_is_nothing)) return a.high > 0 ? exp(a) : exp(a) - 1;
    if (std::fabs(a.high) < 0x1p-60) return a;
    return DoubleDouble(elementary::exponential_less_one(a.high, a.low));
}

DoubleDouble sinh(const DoubleDouble& a) {
    if (a.high < 0) return -sinh(-a);
    if (!(a.high < elementary::one_is_nothing)) return elementary::scaled_exponential(a, -1);
    if (a.high < 0x1p-60) return a;
    const DoubleDouble less_one(elementary::exponential_less_one(a.high, a.low)), twice = less_one + less_one / (1 + less_one);
    return {twice.high / 2, twice.low / 2};
}

DoubleDouble cosh(const DoubleDouble& a) {
    const DoubleDouble size = abs(a);
    if (!(size.high < elementary::one_is_nothing)) return elementary::scaled_exponential(size, -1);
    const DoubleDouble power = exp(size), twice = power + 1 / power;
    return {twice.high / 2, twice.low / 2};
}

} // namespace denhartog

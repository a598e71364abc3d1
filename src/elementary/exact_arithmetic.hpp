/// @file
/// @brief Sums and products of doubles without rounding, as a result and what it lacks, by the operations of IEEE 754 alone.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace denhartog::elementary {

/// @brief A result and what its rounding lacks.
struct Parts {
    double high; ///< the result
    double low;  ///< the rest
};

/// @brief Nearest whole number, ties to even. @param x a number of size up to 2^51 @return the whole number
[[nodiscard, gnu::always_inline]] inline double nearest_whole(double x) {
    const double shift = 0x1.8p52;
    return (x + shift) - shift;
}
#if defined(__x86_64__) && !defined(__FMA__) && !defined(DENHARTOG_WITHOUT_FUSED_PRODUCT)
/// @brief Whether the processor has the instruction that rounds a product and a sum once. Until it is known it has none.
inline const bool has_fused_product = [] {
    __builtin_cpu_init();
    return __builtin_cpu_supports("fma") != 0;
}();
#elif defined(__FP_FAST_FMA) && !defined(DENHARTOG_WITHOUT_FUSED_PRODUCT)
/// @brief Every processor that this is compiled for has that instruction.
inline constexpr bool has_fused_product = true;
#else
/// @brief Not every one has it, or a test does without.
inline constexpr bool has_fused_product = false;
#endif

/// @brief A product and a sum, rounded once: by the instruction where there is one, since a call takes several times as long.
/// @param a  a number
/// @param b  a number
/// @param c  a number
/// @return   a b + c
[[nodiscard, gnu::always_inline]] inline double fused_product(double a, double b, double c) {
#if defined(__x86_64__) && !defined(__FMA__)
    if (has_fused_product) [[likely]] {
        asm volatile("vfmadd231sd %2, %1, %0" : "+x"(c) : "x"(a), "x"(b)); // volatile: never moved before the question
        return c;
    }
#endif
    return std::fma(a, b, c);
}
/// @brief The first 26 bits of a number. @param x a number @return it without the bits after them
[[nodiscard, gnu::always_inline]] inline double first_half(double x) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & 0xfffffffff8000000U);
}
/// @brief A number rounded to 26 bits. @param x a number below 2^1023 in size @return it; what it lacks has 26 bits and a sign
[[nodiscard, gnu::always_inline]] inline double rounded_half(double x) {
    return std::bit_cast<double>((std::bit_cast<std::uint64_t>(x) + 0x4000000U) & 0xfffffffff8000000U);
}
/// @brief A sum. @param a a number, not smaller in size than b unless it is 0 @param b a number @return both parts, exact
[[nodiscard, gnu::always_inline]] inline Parts ordered_sum(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}
/// @brief A sum. @param a a number @param b a number @return both parts, exact
[[nodiscard, gnu::always_inline]] inline Parts exact_sum(double a, double b) {
    const double sum = a + b, b_part = sum - a;
    return {sum, (a - (sum - b_part)) + (b - b_part)};
}
/// @brief A product, after Dekker. @param a a number @param b a number @param a_1 its first half @param b_1 that of the other
/// @return both parts
[[nodiscard, gnu::always_inline]] inline Parts product_by_halves(double a, double b, double a_1, double b_1) {
    const double product = a * b, a_2 = a - a_1, b_2 = b - b_1;
    return {product, ((a_1 * b_1 - product) + a_1 * b_2 + a_2 * b_1) + a_2 * b_2};
}
/// @brief A product. @param a a number @param b a number
/// @return both parts; the second is exact but for its 53rd bit, and where it is below the range of a double
[[nodiscard, gnu::always_inline]] inline Parts exact_product(double a, double b) {
    return product_by_halves(a, b, first_half(a), first_half(b));
}
/// @brief A product of numbers from 2^-400 to 2^400 in size, or zero. @param a a number @param b a number
/// @return both parts, exact
[[nodiscard, gnu::always_inline]] inline Parts exact_product_in_range(double a, double b) {
    if (!has_fused_product) return product_by_halves(a, b, rounded_half(a), rounded_half(b));
    const double product = a * b;
    return {product, fused_product(a, b, -product)};
}

} // namespace denhartog::elementary

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
inline constexpr bool has_fused_product = true;
#else
inline constexpr bool has_fused_product = false; // tests compile it on every processor
#endif

/// @brief A product and a sum, rounded once: by the instruction where there is one, since a call takes several times as long.
/// @param a  a number
/// @param b  a number
/// @param c  a number
/// @return   a b + c
[[nodiscard, gnu::always_inline]] inline double fused_product(double a, double b, double c) {
#if defined(__x86_64__) && !defined(__FMA__)
    if (has_fused_product) [[likely]] {
        asm("vfmadd231sd %2, %1, %0" : "+x"(c) : "x"(a), "x"(b));
        return c;
    }
#endif
    return std::fma(a, b, c);
}
/// @brief The same where the product of a and b has no more bits than a double. @param a a number @param b a number
/// @param c  a number
/// @return   a b + c
[[nodiscard, gnu::always_inline]] inline double sum_with_exact(double a, double b, double c) {
    return has_fused_product ? fused_product(a, b, c) : a * b + c;
}

/// @brief A number to 26 bits. @param x a number @return it; what it lacks has 26 bits too, and a sign
[[nodiscard, gnu::always_inline]] inline double first_half(double x) {
    return std::bit_cast<double>((std::bit_cast<std::uint64_t>(x) + 0x4000000U) & 0xfffffffff8000000U);
}
/// @brief A sum. @param a a number, not smaller in size than b unless it is 0 @param b a number @return both parts, exact
[[nodiscard, gnu::always_inline]] inline Parts ordered_sum(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}
/// @brief A sum. @param a a number @param b a number @return both parts, exact
[[nodiscard, gnu::always_inline]] inline Parts exact_sum(double a, double b) {
    const double sum = a + b, of_b = sum - a;
    return {sum, (a - (sum - of_b)) + (b - of_b)};
}
/// @brief A product, after Dekker. @param a a number @param b a number
/// @return both parts, exact where the second is not below the range of a double
[[nodiscard, gnu::always_inline]] inline Parts exact_product(double a, double b) {
    const double product = a * b, a_1 = first_half(a), a_2 = a - a_1, b_1 = first_half(b), b_2 = b - b_1;
    return {product, ((a_1 * b_1 - product) + a_1 * b_2 + a_2 * b_1) + a_2 * b_2};
}
/// @brief The same of numbers from 2^-400 to 2^400 in size, or zero: to the bit, and faster where products are fused.
/// @param a  a number
/// @param b  a number
/// @return   both parts, exact
[[nodiscard, gnu::always_inline]] inline Parts exact_product_in_range(double a, double b) {
    if (!has_fused_product) return exact_product(a, b);
    const double product = a * b;
    return {product, fused_product(a, b, -product)};
}

} // namespace denhartog::elementary

/// @file
/// @brief Sums and products of doubles without rounding, as a result and what it lacks, by the operations of IEEE 754 alone.
#pragma once

#include <bit>
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
/// @brief The first 26 bits of a number. @param x a number @return it without the bits after them
[[nodiscard, gnu::always_inline]] inline double first_half(double x) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & 0xfffffffff8000000U);
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
/// @brief A product. @param a a number @param b a number
/// @return both parts; the second is exact but for its 53rd bit, and where it is below the range of a double
[[nodiscard, gnu::always_inline]] inline Parts exact_product(double a, double b) {
    const double product = a * b, a_1 = first_half(a), a_2 = a - a_1, b_1 = first_half(b), b_2 = b - b_1;
    return {product, ((a_1 * b_1 - product) + a_1 * b_2 + a_2 * b_1) + a_2 * b_2};
}

} // namespace denhartog::elementary

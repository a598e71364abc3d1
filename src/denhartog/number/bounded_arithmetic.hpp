/// @file
/// @brief A number with a bound of its error: sums, products and quotients, errors followed through each.
///
/// The rounding error of a sum, product, quotient or root is computed, not estimated. The formulas are templates on their number
/// type: on this type they give their value in the type inside and a bound of its error, without a second computation in more
/// digits. Errors are taken as independent and of the worst sign. The bound is therefore never too small for the operations
/// carried out, and often several times too large. Comparisons compare the values alone.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "denhartog/number/number.hpp"
#include "elementary/exact_arithmetic.hpp"

namespace denhartog {

/// @brief Unit in the last place of 1.
template <class T>
[[nodiscard]] T unit_of() {
    return std::numeric_limits<T>::epsilon();
}
/// @brief The size of a number.
template <class T>
[[nodiscard]] T size_of_number(const T& x) {
    return x < 0 ? T(-x) : x;
}

/// @brief A number x known to be within e of a true one.
template <class T>
struct Bounded {
    T x{}; ///< the value
    T e{}; ///< bound of its absolute error

    Bounded() = default;
    /// @brief A whole number, exact.
    Bounded(int n) : x(n), e(0) {}
    /// @brief An exact number.
    Bounded(const T& value) : x(value), e(0) {}
    /// @brief A number with a bound of its error.
    Bounded(const T& value, const T& error) : x(value), e(error) {}

    /// @brief A result with a bound. If the bound is no number, as of zero times something unbounded, or the result is none,
    /// there is no bound: it is infinite. `error` is what the errors of the operands make of it, `rounding` how far its own
    /// rounding may have moved it.
    [[nodiscard, gnu::always_inline]] static Bounded of(const T& value, const T& error, const T& rounding) {
        const T bound = (error + rounding) * (1 + 8 * unit_of<T>()) + (std::numeric_limits<T>::min)();
        return {value, bound >= 0 && value - value == 0 ? bound : std::numeric_limits<T>::infinity()};
    }
    /// @brief The result of a library function that is trusted with so many units in the last place; `error` as above.
    [[nodiscard]] static Bounded rounded(const T& value, const T& error, double units) {
        return of(value, error, T(units * unit_of<T>() * size_of_number(value)));
    }

    /// @brief The opposite, as certain.
    [[nodiscard]] friend Bounded operator-(const Bounded& a) { return {T(-a.x), a.e}; }
    /// @brief Sum: the errors add up, and its rounding is known.
    [[nodiscard, gnu::always_inline]] friend Bounded operator+(const Bounded& a, const Bounded& b) {
        const T sum = a.x + b.x, b_part = sum - a.x;
        return of(sum, a.e + b.e, std::abs((a.x - (sum - b_part)) + (b.x - b_part)));
    }
    /// @brief Difference, bounded as a sum is.
    [[nodiscard, gnu::always_inline]] friend Bounded operator-(const Bounded& a, const Bounded& b) { return a + -b; }
    /// @brief Product; its rounding is known from a fused product.
    [[nodiscard, gnu::always_inline]] friend Bounded operator*(const Bounded& a, const Bounded& b) {
        const T product = a.x * b.x, error = size_of_number(a.x) * b.e + size_of_number(b.x) * a.e + a.e * b.e;
        return of(product, error, std::abs(elementary::fused_product(a.x, b.x, -product)));
    }
    /// @brief Quotient; unbounded if the divisor may be zero.
    [[nodiscard, gnu::always_inline]] friend Bounded operator/(const Bounded& a, const Bounded& b) {
        const T q = a.x / b.x, least = size_of_number(b.x) - b.e;
        const T error = least > 0 ? T((a.e + size_of_number(q) * b.e) / least) : std::numeric_limits<T>::infinity();
        return of(q, error, std::abs(elementary::fused_product(-q, b.x, a.x) / b.x));
    }
    /// @{
    /// @brief In place, and comparisons of the values, in which bounds play no part.
    Bounded& operator+=(const Bounded& b) { return *this = *this + b; }
    Bounded& operator-=(const Bounded& b) { return *this = *this - b; }
    Bounded& operator*=(const Bounded& b) { return *this = *this * b; }
    Bounded& operator/=(const Bounded& b) { return *this = *this / b; }
    [[nodiscard]] friend bool operator<(const Bounded& a, const Bounded& b) { return a.x < b.x; }
    [[nodiscard]] friend bool operator>(const Bounded& a, const Bounded& b) { return a.x > b.x; }
    [[nodiscard]] friend bool operator<=(const Bounded& a, const Bounded& b) { return a.x <= b.x; }
    [[nodiscard]] friend bool operator>=(const Bounded& a, const Bounded& b) { return a.x >= b.x; }
    [[nodiscard]] friend bool operator==(const Bounded& a, const Bounded& b) { return a.x == b.x; }
    [[nodiscard]] friend bool operator!=(const Bounded& a, const Bounded& b) { return a.x != b.x; }
    /// @}

    /// @brief Largest size that the number can have.
    [[nodiscard]] T most() const { return size_of_number(x) + e; }
    /// @brief Least size that the number can have.
    [[nodiscard]] T least() const { return std::max(T(0), T(size_of_number(x) - e)); }
};

} // namespace denhartog

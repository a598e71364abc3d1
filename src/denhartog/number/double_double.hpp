/// @file
/// @brief A number of twice the digits of a double, as the sum of two: some 30 digits of sums, products, quotients and roots,
/// 17 of elementary functions.
///
/// It is the type of differences whose terms may not be rounded to a double first (`wider.hpp`). It has the range of a double,
/// and the same digits on every machine, which `long double` has not.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>

#include "denhartog/elementary/circle_tables.hpp"
#include "denhartog/elementary/exact_arithmetic.hpp"
#include "denhartog/number/number.hpp"

namespace denhartog {

/// @brief The sum of two doubles, the second at most half a unit in the last place of the first.
struct DoubleDouble {
    double high = 0; ///< the sum, rounded
    double low = 0;  ///< the rest

    DoubleDouble() = default;
    /// @param n  a whole number
    template <std::same_as<int> Whole> // a double is not cut off to a whole number on its way here
    DoubleDouble(Whole n) : high(n) {}
    /// @param x  a number
    explicit DoubleDouble(double x) : high(x) {}
    /// @param x     a number
    /// @param rest  another, at most as large
    DoubleDouble(double x, double rest) : high(x + rest), low(high - high == 0 ? rest - (high - x) : 0) {}
    /// @param parts  a number and its rest
    explicit DoubleDouble(const elementary::Parts& parts) : DoubleDouble(parts.high, parts.low) {}
    /// @return the number rounded
    explicit operator double() const { return high; }

    /// @brief The opposite. @param a a number @return -a
    [[nodiscard]] friend DoubleDouble operator-(const DoubleDouble& a) {
        DoubleDouble opposite(-a.high);
        opposite.low = -a.low;
        return opposite;
    }
    /// @brief Sum. @param a a number @param b a number @return a + b
    [[nodiscard]] friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
        const elementary::Parts high = elementary::exact_sum(a.high, b.high), low = elementary::exact_sum(a.low, b.low);
        const DoubleDouble sum(high.high, high.low + low.high);
        return {sum.high, sum.low + low.low};
    }
    /// @brief Difference. @param a a number @param b a number @return a - b
    [[nodiscard]] friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }
    /// @brief Product. @param a a number @param b a number @return a b
    [[nodiscard]] friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
        const elementary::Parts high = elementary::exact_product(a.high, b.high);
        return {high.high, high.low + (a.high * b.low + a.low * b.high)};
    }
    /// @brief Quotient. @param a a number @param b a number, not zero @return a / b
    [[nodiscard]] friend DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
        const double q = a.high / b.high;
        if (!(q - q == 0) || !(b.high - b.high == 0)) return DoubleDouble(q);
        const elementary::Parts back = elementary::exact_product(q, b.high);
        return {q, (((a.high - back.high) - back.low) + a.low - q * b.low) / b.high};
    }
    /// @brief Adds. @param b a number @return this
    DoubleDouble& operator+=(const DoubleDouble& b) { return *this = *this + b; }
    /// @brief Subtracts. @param b a number @return this
    DoubleDouble& operator-=(const DoubleDouble& b) { return *this = *this - b; }
    /// @brief Multiplies. @param b a number @return this
    DoubleDouble& operator*=(const DoubleDouble& b) { return *this = *this * b; }
    /// @brief Divides. @param b a number @return this
    DoubleDouble& operator/=(const DoubleDouble& b) { return *this = *this / b; }

    /// @brief Compares. @param a a number @param b a number @return whether both are one
    [[nodiscard]] friend bool operator==(const DoubleDouble& a, const DoubleDouble& b) = default;
    /// @brief Compares. @param a a number @param b a number @return whether a is less
    [[nodiscard]] friend bool operator<(const DoubleDouble& a, const DoubleDouble& b) {
        return a.high < b.high || (a.high == b.high && a.low < b.low);
    }
    /// @brief Compares. @param a a number @param b a number @return whether a is greater
    [[nodiscard]] friend bool operator>(const DoubleDouble& a, const DoubleDouble& b) { return b < a; }
    /// @brief Compares. @param a a number @param b a number @return whether a is not greater
    [[nodiscard]] friend bool operator<=(const DoubleDouble& a, const DoubleDouble& b) { return a < b || a == b; }
    /// @brief Compares. @param a a number @param b a number @return whether a is not less
    [[nodiscard]] friend bool operator>=(const DoubleDouble& a, const DoubleDouble& b) { return b <= a; }

    /// @brief Size. A function of the class, since one of the namespace would hide that of a double.
    /// @param a a number @return |a|
    [[nodiscard]] friend DoubleDouble abs(const DoubleDouble& a) { return a.high < 0 ? -a : a; }
};

/// @brief Square root. @param a a number, not negative @return its root
[[nodiscard]] inline DoubleDouble sqrt(const DoubleDouble& a) {
    const double root = std::sqrt(a.high);
    if (!(root > 0) || !(root - root == 0)) return DoubleDouble(root);
    const elementary::Parts back = elementary::exact_product(root, root);
    return {root, (((a.high - back.high) - back.low) + a.low) / (2 * root)};
}
/// @brief Exponential. @param a a number @return exp(a)
[[nodiscard]] DoubleDouble exp(const DoubleDouble& a);
/// @brief Exponential less one. @param a a number @return exp(a) - 1
[[nodiscard]] DoubleDouble expm1(const DoubleDouble& a);
/// @brief Hyperbolic sine. @param a a number @return sinh(a)
[[nodiscard]] DoubleDouble sinh(const DoubleDouble& a);
/// @brief Hyperbolic cosine. @param a a number @return cosh(a)
[[nodiscard]] DoubleDouble cosh(const DoubleDouble& a);
/// @brief Sine. @param a radians @return sin(a)
[[nodiscard]] DoubleDouble sin(const DoubleDouble& a);
/// @brief Cosine. @param a radians @return cos(a)
[[nodiscard]] DoubleDouble cos(const DoubleDouble& a);
/// @brief Sine of half turns. @param a half turns @return sin(pi a)
[[nodiscard]] DoubleDouble sine_of_half_turns(const DoubleDouble& a);
/// @brief Cosine of half turns. @param a half turns @return cos(pi a)
[[nodiscard]] DoubleDouble cosine_of_half_turns(const DoubleDouble& a);
/// @brief Angle of the point (x, y). @param y ordinate @param x abscissa @return radians, from -pi to pi
[[nodiscard]] DoubleDouble atan2(const DoubleDouble& y, const DoubleDouble& x);
/// @brief Remainder of 1 after division by m, of the least size. @param m a positive number
/// @return 1 - n m, exact where m is a double
[[nodiscard]] DoubleDouble remainder_of_one(const DoubleDouble& m);

/// @brief pi in two doubles.
template <>
struct PiOf<DoubleDouble> {
    /// @return pi
    static DoubleDouble value() { return {elementary::pi_high, elementary::pi_low}; }
};

} // namespace denhartog

namespace std {

/// @brief The limits: those of a double but for the unit in the last place.
template <>
class numeric_limits<denhartog::DoubleDouble> : public numeric_limits<double> {
public:
    static constexpr int digits = 104; ///< binary
    /// @return the unit in the last place of 1
    static denhartog::DoubleDouble epsilon() { return denhartog::DoubleDouble(0x1p-103); }
    /// @return the least positive normal number
    static denhartog::DoubleDouble min() { return denhartog::DoubleDouble(numeric_limits<double>::min()); }
    /// @return the largest finite number
    static denhartog::DoubleDouble max() { return denhartog::DoubleDouble(numeric_limits<double>::max()); }
    /// @return infinity
    static denhartog::DoubleDouble infinity() { return denhartog::DoubleDouble(numeric_limits<double>::infinity()); }
};

} // namespace std

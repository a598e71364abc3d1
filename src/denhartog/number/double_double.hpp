// A number of twice the digits of a double, as the sum of two.
//
// Sums, products, quotients and roots have some 30 digits, elementary functions 17. It is the type of differences whose terms may
// not be rounded to a double first (`WiderOf`). It has the range of a double, and the same digits on every machine, which
// `long double` has not.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>

#include "denhartog/elementary/circle_tables.hpp"
#include "denhartog/elementary/exact_arithmetic.hpp"
#include "denhartog/number/number.hpp"

namespace denhartog {

// The sum of two doubles, the second at most half a unit in the last place of the first.
struct DoubleDouble {
    double high = 0; // the sum, rounded
    double low = 0;  // the rest

    DoubleDouble() = default;
    template <std::same_as<int> Whole> // a double is not cut off to a whole number on its way here
    DoubleDouble(Whole n) : high(n) {}
    explicit DoubleDouble(double x) : high(x) {}
    DoubleDouble(double x, double rest) : high(x + rest), low(high - high == 0 ? rest - (high - x) : 0) {}
    explicit DoubleDouble(const elementary::Parts& parts) : DoubleDouble(parts.high, parts.low) {}
    explicit operator double() const { return high; }

    [[nodiscard]] friend DoubleDouble operator-(const DoubleDouble& a) {
        DoubleDouble opposite(-a.high);
        opposite.low = -a.low;
        return opposite;
    }
    [[nodiscard]] friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
        const elementary::Parts high = elementary::exact_sum(a.high, b.high), low = elementary::exact_sum(a.low, b.low);
        const DoubleDouble sum(high.high, high.low + low.high);
        return {sum.high, sum.low + low.low};
    }
    [[nodiscard]] friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }
    [[nodiscard]] friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
        const elementary::Parts high = elementary::exact_product(a.high, b.high);
        return {high.high, high.low + (a.high * b.low + a.low * b.high)};
    }
    [[nodiscard]] friend DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
        const double q = a.high / b.high;
        if (!(q - q == 0) || !(b.high - b.high == 0)) return DoubleDouble(q);
        const elementary::Parts back = elementary::exact_product(q, b.high);
        return {q, (((a.high - back.high) - back.low) + a.low - q * b.low) / b.high};
    }
    DoubleDouble& operator+=(const DoubleDouble& b) { return *this = *this + b; }
    DoubleDouble& operator-=(const DoubleDouble& b) { return *this = *this - b; }
    DoubleDouble& operator*=(const DoubleDouble& b) { return *this = *this * b; }
    DoubleDouble& operator/=(const DoubleDouble& b) { return *this = *this / b; }

    [[nodiscard]] friend bool operator==(const DoubleDouble& a, const DoubleDouble& b) = default;
    [[nodiscard]] friend bool operator<(const DoubleDouble& a, const DoubleDouble& b) {
        return a.high < b.high || (a.high == b.high && a.low < b.low);
    }
    [[nodiscard]] friend bool operator>(const DoubleDouble& a, const DoubleDouble& b) { return b < a; }
    [[nodiscard]] friend bool operator<=(const DoubleDouble& a, const DoubleDouble& b) { return a < b || a == b; }
    [[nodiscard]] friend bool operator>=(const DoubleDouble& a, const DoubleDouble& b) { return b <= a; }
    /// @}

    // Size. A function of the class, since one of the namespace would hide that of a double.
    [[nodiscard]] friend DoubleDouble abs(const DoubleDouble& a) { return a.high < 0 ? -a : a; }
};

[[nodiscard]] inline DoubleDouble sqrt(const DoubleDouble& a) {
    const double root = std::sqrt(a.high);
    if (!(root > 0) || !(root - root == 0)) return DoubleDouble(root);
    const elementary::Parts back = elementary::exact_product(root, root);
    return {root, (((a.high - back.high) - back.low) + a.low) / (2 * root)};
}
[[nodiscard]] DoubleDouble exp(const DoubleDouble& a);
[[nodiscard]] DoubleDouble expm1(const DoubleDouble& a);
[[nodiscard]] DoubleDouble sinh(const DoubleDouble& a);
[[nodiscard]] DoubleDouble cosh(const DoubleDouble& a);
[[nodiscard]] DoubleDouble sin(const DoubleDouble& a);
[[nodiscard]] DoubleDouble cos(const DoubleDouble& a);
[[nodiscard]] DoubleDouble sine_of_half_turns(const DoubleDouble& a);
[[nodiscard]] DoubleDouble cosine_of_half_turns(const DoubleDouble& a);
[[nodiscard]] DoubleDouble atan2(const DoubleDouble& y, const DoubleDouble& x);
// Remainder of 1 after division by m, of the least size: exact where m is a double.
[[nodiscard]] DoubleDouble remainder_of_one(const DoubleDouble& m);

template <>
struct PiOf<DoubleDouble> {
    static DoubleDouble value() { return {elementary::pi_high, elementary::pi_low}; }
};

// The next wider number type, for a difference whose terms may not be rounded first; the type itself where none is wider.
template <class T>
struct WiderOf {
    using type = T;
};
template <>
struct WiderOf<float> {
    using type = double;
};
template <>
struct WiderOf<double> {
    using type = DoubleDouble;
};
template <>
struct WiderOf<long double>; // who uses it defines it

} // namespace denhartog

namespace std {

// The limits: those of a double but for the unit in the last place.
template <>
class numeric_limits<denhartog::DoubleDouble> : public numeric_limits<double> {
public:
    static constexpr int digits = 104; // binary
    static denhartog::DoubleDouble epsilon() { return denhartog::DoubleDouble(0x1p-103); }
    static denhartog::DoubleDouble min() { return denhartog::DoubleDouble(numeric_limits<double>::min()); }
    static denhartog::DoubleDouble max() { return denhartog::DoubleDouble(numeric_limits<double>::max()); }
    static denhartog::DoubleDouble infinity() { return denhartog::DoubleDouble(numeric_limits<double>::infinity()); }
};

} // namespace std

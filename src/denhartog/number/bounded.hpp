/// @file
/// @brief A double with a bound of its error: rounding errors and errors of the input, followed through every operation.
///
/// What the rounding of a sum, product, quotient or root took is computed, not estimated.
/// The formulas are templates on their number type; on this one they give the error of what they give on double, without a
/// second computation in more digits. Errors are taken as if independent and of the worst sign, so that the bound is never too
/// small for the operations carried out and often some times too large. Comparisons compare the values alone.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/special_functions/cos_pi.hpp>
#include <boost/math/special_functions/sin_pi.hpp>
#include <cmath>
#include <limits>

#include "denhartog/number/number.hpp"
#include "denhartog/number/reduced_angle.hpp"

namespace denhartog {

/// @brief A number x known to be within e of a true one.
struct Bounded {
    double x = 0; ///< the value
    double e = 0; ///< bound of its absolute error

    Bounded() = default;
    /// @param n  a whole number, exact
    Bounded(int n) : x(n) {}
    /// @param value  an exact number
    Bounded(double value) : x(value) {}
    /// @param value  a number
    /// @param error  bound of its error
    Bounded(double value, double error) : x(value), e(error) {}

    /// @brief Adds. @param b a number @return this
    Bounded& operator+=(const Bounded& b);
    /// @brief Subtracts. @param b a number @return this
    Bounded& operator-=(const Bounded& b);
    /// @brief Multiplies. @param b a number @return this
    Bounded& operator*=(const Bounded& b);
    /// @brief Divides. @param b a number @return this
    Bounded& operator/=(const Bounded& b);
};

/// @brief A result with a bound. Where the bound is no number, as of zero times something unbounded, or the result is none, there
/// is no bound: it is infinite.
/// @param x         the result
/// @param e         what the errors of the operands make of it
/// @param rounding  how far its own rounding may have moved it
/// @return          the number with both
[[nodiscard]] inline Bounded with_bound(double x, double e, double rounding) {
    constexpr double unit = std::numeric_limits<double>::epsilon();
    const double bound = (e + rounding) * (1 + 8 * unit) + std::numeric_limits<double>::min();
    return {x, bound >= 0 && std::isfinite(x) ? bound : std::numeric_limits<double>::infinity()};
}

/// @brief The result of a library function. @param x the result @param e what the errors of the operands make of it
/// @param units  how many units in the last place the function is trusted with
/// @return       the number with both
[[nodiscard]] inline Bounded rounded(double x, double e, double units) {
    return with_bound(x, e, units * std::numeric_limits<double>::epsilon() * std::abs(x));
}

/// @brief What the rounding of a sum took. @param a a number @param b a number @param sum their sum as rounded @return its size
[[nodiscard]] inline double rounding_of_sum(double a, double b, double sum) {
    const double of_b = sum - a;
    return std::abs((a - (sum - of_b)) + (b - of_b));
}

/// @brief Units in the last place that the library's exponential, sine, cosine and arc tangent are trusted with.
constexpr double library_units = 0.6;
/// @brief The same for hyperbolic functions and those of pi times x, which are made of others.
constexpr double composed_units = 2;

/// @brief The opposite, as certain. @param a a number @return -a
[[nodiscard]] inline Bounded operator-(const Bounded& a) { return {-a.x, a.e}; }
/// @brief Sum: the errors add up, and its rounding is known. @param a a number @param b a number @return a + b
[[nodiscard]] inline Bounded operator+(const Bounded& a, const Bounded& b) {
    const double sum = a.x + b.x;
    return with_bound(sum, a.e + b.e, rounding_of_sum(a.x, b.x, sum));
}
/// @brief Difference, bounded as a sum is. @param a a number @param b a number @return a - b
[[nodiscard]] inline Bounded operator-(const Bounded& a, const Bounded& b) { return a + -b; }
/// @brief Product; its rounding is known from a fused product. @param a a number @param b a number @return a b
[[nodiscard]] inline Bounded operator*(const Bounded& a, const Bounded& b) {
    const double product = a.x * b.x;
    return with_bound(product, std::abs(a.x) * b.e + std::abs(b.x) * a.e + a.e * b.e, std::abs(std::fma(a.x, b.x, -product)));
}
/// @brief Quotient; unbounded where the divisor may be zero. @param a a number @param b a number @return a / b
[[nodiscard]] inline Bounded operator/(const Bounded& a, const Bounded& b) {
    const double q = a.x / b.x, least = std::abs(b.x) - b.e;
    return with_bound(q, least > 0 ? (a.e + std::abs(q) * b.e) / least : std::numeric_limits<double>::infinity(),
                      std::abs(std::fma(-q, b.x, a.x) / b.x));
}
inline Bounded& Bounded::operator+=(const Bounded& b) { return *this = *this + b; }
inline Bounded& Bounded::operator-=(const Bounded& b) { return *this = *this - b; }
inline Bounded& Bounded::operator*=(const Bounded& b) { return *this = *this * b; }
inline Bounded& Bounded::operator/=(const Bounded& b) { return *this = *this / b; }
/// @brief Compares values; bounds play no part. @param a a number @param b a number @return whether a is less
[[nodiscard]] inline bool operator<(const Bounded& a, const Bounded& b) { return a.x < b.x; }
/// @brief Compares values; bounds play no part. @param a a number @param b a number @return whether a is greater
[[nodiscard]] inline bool operator>(const Bounded& a, const Bounded& b) { return a.x > b.x; }
/// @brief Compares values; bounds play no part. @param a a number @param b a number @return whether a is not greater
[[nodiscard]] inline bool operator<=(const Bounded& a, const Bounded& b) { return a.x <= b.x; }
/// @brief Compares values; bounds play no part. @param a a number @param b a number @return whether a is not less
[[nodiscard]] inline bool operator>=(const Bounded& a, const Bounded& b) { return a.x >= b.x; }
/// @brief Compares values; bounds play no part. @param a a number @param b a number @return whether both are one value
[[nodiscard]] inline bool operator==(const Bounded& a, const Bounded& b) { return a.x == b.x; }
/// @brief Compares values; bounds play no part. @param a a number @param b a number @return whether they differ
[[nodiscard]] inline bool operator!=(const Bounded& a, const Bounded& b) { return a.x != b.x; }

/// @brief Square root. @param a a number @return its root; of one that may be zero, or negative by its error, an error as large
[[nodiscard]] inline Bounded sqrt(const Bounded& a) {
    if (a.x < 0 && a.x + a.e >= 0) return with_bound(0, std::sqrt(a.x + a.e), 0);
    const double root = std::sqrt(a.x);
    return with_bound(root, a.x > 4 * a.e ? a.e / (root + std::sqrt(a.x - a.e)) : std::sqrt(a.x + a.e),
                      root > 0 ? std::abs(std::fma(-root, root, a.x)) / root : 0);
}
/// @brief Exponential. @param a a number @return exp(a)
[[nodiscard]] inline Bounded exp(const Bounded& a) {
    return rounded(std::exp(a.x), std::exp(a.x) * std::expm1(a.e), library_units);
}
/// @brief Sine. @param a radians @return sin(a)
[[nodiscard]] inline Bounded sin(const Bounded& a) {
    return rounded(std::sin(a.x), std::min(2.0, a.e > 0 ? a.e * (std::abs(std::cos(a.x)) + a.e) : 0), library_units);
}
/// @brief Cosine. @param a radians @return cos(a)
[[nodiscard]] inline Bounded cos(const Bounded& a) {
    return rounded(std::cos(a.x), std::min(2.0, a.e > 0 ? a.e * (std::abs(std::sin(a.x)) + a.e) : 0), library_units);
}
/// @brief Hyperbolic cosine. @param a a number @return cosh(a)
[[nodiscard]] inline Bounded cosh(const Bounded& a) {
    return rounded(std::cosh(a.x), std::sinh(std::abs(a.x) + a.e) * a.e, composed_units);
}
/// @brief Hyperbolic sine. @param a a number @return sinh(a)
[[nodiscard]] inline Bounded sinh(const Bounded& a) {
    return rounded(std::sinh(a.x), std::cosh(std::abs(a.x) + a.e) * a.e, composed_units);
}
/// @brief Angle of the point (x, y). @param y ordinate @param x abscissa @return radians in (-pi, pi]
[[nodiscard]] inline Bounded atan2(const Bounded& y, const Bounded& x) {
    const double size = std::max(std::abs(x.x), std::abs(y.x)), X = std::abs(x.x) / size, Y = std::abs(y.x) / size;
    const double across = X * (y.e / size) + Y * (x.e / size), along = X * X + Y * Y - X * (x.e / size) - Y * (y.e / size);
    return rounded(std::atan2(y.x, x.x), along > 0 ? std::atan(across / along) * (1 + 1e-15) : 2 * std::numbers::pi,
                   library_units);
}
/// @brief Largest whole number not above the value. @param a a number @return an exact whole number
[[nodiscard]] inline Bounded floor(const Bounded& a) { return {std::floor(a.x)}; }
/// @brief The value without its sign. @param a a number @return |a|
[[nodiscard]] inline Bounded abs(const Bounded& a) { return a.x < 0 ? -a : a; }

/// @brief \f$ \sin(\pi x) \f$. @param a a number @return sin(pi a)
[[nodiscard]] inline Bounded sin_pi(const Bounded& a) {
    return rounded(boost::math::sin_pi(a.x), std::min(2.0, 4 * a.e), composed_units);
}
/// @brief \f$ \cos(\pi x) \f$. @param a a number @return cos(pi a)
[[nodiscard]] inline Bounded cos_pi(const Bounded& a) {
    return rounded(boost::math::cos_pi(a.x), std::min(2.0, 4 * a.e), composed_units);
}
/// @brief \f$ e^x - 1 \f$. @param a a number @return exp(a) - 1
[[nodiscard]] inline Bounded exp_minus_one(const Bounded& a) {
    return rounded(std::expm1(a.x), std::exp(a.x) * std::expm1(a.e), composed_units);
}
/// @brief Sine and cosine of \f$ \pi\,[1/(2R) - y] \f$. @param R a positive number @param y a number
/// @return both, with what the errors of R and y make of them
[[nodiscard]] inline SineCosine<Bounded> sine_cosine_of_half_period(const Bounded& R, const Bounded& y) {
    const SineCosine<double> f = sine_cosine_of_half_period(R.x, y.x);
    const double unit = std::numeric_limits<double>::epsilon();
    const double by_R = R.e > 0 ? (R.e < R.x ? 2 * R.e / (R.x * (R.x - R.e)) : 2) : 0; // 2 is more than pi / 2
    const double error = std::min(2.0, by_R + 4 * y.e + 8 * unit * std::abs(y.x));     // y is rounded once more there
    return {rounded(f.s, error, 2.5), rounded(f.c, error, 2.5)};
}

/// @brief pi as a number with its error.
template <>
struct PiOf<Bounded> {
    /// @return pi, and what its double lacks
    static Bounded value() { return {std::numbers::pi, 1.2247e-16}; }
};

} // namespace denhartog

namespace std {

/// @brief The limits of the value, a double.
template <>
class numeric_limits<denhartog::Bounded> : public numeric_limits<double> {};

} // namespace std

namespace Eigen {

/// @brief What Eigen asks of a number that it stores.
template <>
struct NumTraits<denhartog::Bounded> : GenericNumTraits<denhartog::Bounded> {
    using Real = denhartog::Bounded;       ///< the number type
    using NonInteger = denhartog::Bounded; ///< the type of quotients
    using Literal = double;                ///< the type of literals in Eigen's code
    enum { IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 1, ReadCost = 2, AddCost = 4, MulCost = 8 };
};

} // namespace Eigen

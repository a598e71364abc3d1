/// @file
/// @brief A double with a bound of its error: rounding errors and errors of the input, followed through every operation.
///
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

#include "denhartog/number.hpp"
#include "denhartog/reduced_angle.hpp"

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

    Bounded& operator+=(const Bounded& b); ///< adds
    Bounded& operator-=(const Bounded& b); ///< subtracts
    Bounded& operator*=(const Bounded& b); ///< multiplies
    Bounded& operator/=(const Bounded& b); ///< divides
};

/// @brief A result rounded once, or by a library function to within a unit in the last place.
/// @param x  the result
/// @param e  what the errors of the operands make of it
/// @return   the number with both
[[nodiscard]] inline Bounded rounded(double x, double e) {
    constexpr double unit = std::numeric_limits<double>::epsilon();
    return {x, e * (1 + 8 * unit) + unit * std::abs(x) + std::numeric_limits<double>::min()};
}

[[nodiscard]] inline Bounded operator-(const Bounded& a) { return {-a.x, a.e}; }
[[nodiscard]] inline Bounded operator+(const Bounded& a, const Bounded& b) { return rounded(a.x + b.x, a.e + b.e); }
[[nodiscard]] inline Bounded operator-(const Bounded& a, const Bounded& b) { return rounded(a.x - b.x, a.e + b.e); }
[[nodiscard]] inline Bounded operator*(const Bounded& a, const Bounded& b) {
    return rounded(a.x * b.x, std::abs(a.x) * b.e + std::abs(b.x) * a.e + a.e * b.e);
}
[[nodiscard]] inline Bounded operator/(const Bounded& a, const Bounded& b) {
    const double q = a.x / b.x, least = std::abs(b.x) - b.e;
    return rounded(q, least > 0 ? (a.e + std::abs(q) * b.e) / least : std::numeric_limits<double>::infinity());
}
inline Bounded& Bounded::operator+=(const Bounded& b) { return *this = *this + b; }
inline Bounded& Bounded::operator-=(const Bounded& b) { return *this = *this - b; }
inline Bounded& Bounded::operator*=(const Bounded& b) { return *this = *this * b; }
inline Bounded& Bounded::operator/=(const Bounded& b) { return *this = *this / b; }
[[nodiscard]] inline bool operator<(const Bounded& a, const Bounded& b) { return a.x < b.x; }
[[nodiscard]] inline bool operator>(const Bounded& a, const Bounded& b) { return a.x > b.x; }
[[nodiscard]] inline bool operator<=(const Bounded& a, const Bounded& b) { return a.x <= b.x; }
[[nodiscard]] inline bool operator>=(const Bounded& a, const Bounded& b) { return a.x >= b.x; }
[[nodiscard]] inline bool operator==(const Bounded& a, const Bounded& b) { return a.x == b.x; }
[[nodiscard]] inline bool operator!=(const Bounded& a, const Bounded& b) { return a.x != b.x; }

/// @brief Square root. @param a a number @return its root; of a number that may be zero, with an error as large as the root
[[nodiscard]] inline Bounded sqrt(const Bounded& a) {
    const double root = std::sqrt(a.x);
    return rounded(root, a.x > 4 * a.e ? a.e / (root + std::sqrt(a.x - a.e)) : std::sqrt(std::max(0.0, a.x) + a.e));
}
/// @brief Exponential. @param a a number @return exp(a)
[[nodiscard]] inline Bounded exp(const Bounded& a) { return rounded(std::exp(a.x), std::exp(a.x) * std::expm1(a.e)); }
/// @brief Sine. @param a radians @return sin(a)
[[nodiscard]] inline Bounded sin(const Bounded& a) { return rounded(std::sin(a.x), std::min(2.0, a.e)); }
/// @brief Cosine. @param a radians @return cos(a)
[[nodiscard]] inline Bounded cos(const Bounded& a) { return rounded(std::cos(a.x), std::min(2.0, a.e)); }
/// @brief Hyperbolic cosine. @param a a number @return cosh(a)
[[nodiscard]] inline Bounded cosh(const Bounded& a) { return rounded(std::cosh(a.x), std::sinh(std::abs(a.x) + a.e) * a.e); }
/// @brief Hyperbolic sine. @param a a number @return sinh(a)
[[nodiscard]] inline Bounded sinh(const Bounded& a) { return rounded(std::sinh(a.x), std::cosh(std::abs(a.x) + a.e) * a.e); }
/// @brief Angle of the point (x, y). @param y ordinate @param x abscissa @return radians in (-pi, pi]
[[nodiscard]] inline Bounded atan2(const Bounded& y, const Bounded& x) {
    const double distance = std::hypot(x.x, y.x), error = std::hypot(x.e, y.e);
    const double angle = std::atan2(y.x, x.x);
    return rounded(angle, error < distance ? std::asin(error / distance) : 2 * std::numbers::pi);
}
/// @brief Largest whole number not above the value. @param a a number @return an exact whole number
[[nodiscard]] inline Bounded floor(const Bounded& a) { return {std::floor(a.x)}; }
/// @brief The value without its sign. @param a a number @return |a|
[[nodiscard]] inline Bounded abs(const Bounded& a) { return a.x < 0 ? -a : a; }

/// @brief \f$ \sin(\pi x) \f$. @param a a number @return sin(pi a)
[[nodiscard]] inline Bounded sin_pi(const Bounded& a) { return rounded(boost::math::sin_pi(a.x), std::min(2.0, 4 * a.e)); }
/// @brief \f$ \cos(\pi x) \f$. @param a a number @return cos(pi a)
[[nodiscard]] inline Bounded cos_pi(const Bounded& a) { return rounded(boost::math::cos_pi(a.x), std::min(2.0, 4 * a.e)); }
/// @brief \f$ e^x - 1 \f$. @param a a number @return exp(a) - 1
[[nodiscard]] inline Bounded exp_minus_one(const Bounded& a) { return rounded(std::expm1(a.x), std::exp(a.x) * std::expm1(a.e)); }
/// @brief Sine and cosine of \f$ \pi\,[1/(2R) - y] \f$. @param R a positive number @param y a number
/// @return both, with what the errors of R and y make of them
[[nodiscard]] inline SineCosine<Bounded> sine_cosine_of_half_period(const Bounded& R, const Bounded& y) {
    const SineCosine<double> f = sine_cosine_of_half_period(R.x, y.x);
    const double unit = std::numeric_limits<double>::epsilon();
    const double by_R = R.e > 0 ? (R.e < R.x ? 2 * R.e / (R.x * (R.x - R.e)) : 2) : 0; // 2 is more than pi / 2
    const double error = std::min(2.0, by_R + 4 * y.e + 8 * unit * std::abs(y.x));     // y is rounded once more there
    return {rounded(f.s, error + 2 * unit * std::abs(f.s)), rounded(f.c, error + 2 * unit * std::abs(f.c))};
}

/// @brief pi as a number with its error.
template <>
struct PiOf<Bounded> {
    /// @return pi to half a unit in its last place
    static Bounded value() { return {std::numbers::pi, std::numeric_limits<double>::epsilon()}; }
};

} // namespace denhartog

/// @brief The limits of the value, a double.
template <>
class std::numeric_limits<denhartog::Bounded> : public std::numeric_limits<double> {};

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

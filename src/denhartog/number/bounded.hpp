/// @file
/// @brief A number with a bound of its error: rounding errors and errors of the input, followed through every operation.
///
/// What the rounding of a sum, product, quotient or root took is computed in double, not estimated; of the wider types it is half
/// a unit in the last place. The formulas are templates on their number type; on this one they give the error of what they give
/// on the type inside, without a second computation in more digits. Errors are taken as if independent and of the worst sign, so
/// that the bound is never too small for the operations carried out and often some times too large. Comparisons compare the
/// values alone.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/special_functions/cos_pi.hpp>
#include <boost/math/special_functions/expm1.hpp>
#include <boost/math/special_functions/sin_pi.hpp>
#include <cmath>
#include <concepts>
#include <limits>

#include "denhartog/number/number.hpp"
#include "denhartog/number/reduced_angle.hpp"

namespace denhartog {

/// @brief Unit in the last place of 1. @tparam T the number type @return epsilon
template <class T>
[[nodiscard]] T unit_of() {
    return std::numeric_limits<T>::epsilon();
}
/// @brief The size of a number. @param x a number @return |x|
template <class T>
[[nodiscard]] T size_of_number(const T& x) {
    return x < 0 ? T(-x) : x;
}

/// @brief A number x known to be within e of a true one.
/// @tparam T  the type of both
template <class T>
struct Bounded {
    T x{}; ///< the value
    T e{}; ///< bound of its absolute error

    Bounded() = default;
    /// @param n  a whole number, exact
    Bounded(int n) : x(n), e(0) {}
    /// @param value  an exact number
    Bounded(const T& value) : x(value), e(0) {}
    /// @param value  a number
    /// @param error  bound of its error
    Bounded(const T& value, const T& error) : x(value), e(error) {}
    /// @param value  an exact number of the narrower type
    explicit Bounded(double value) requires(!std::same_as<T, double>) : x(value), e(0) {}

    /// @brief A result with a bound. Where the bound is no number, as of zero times something unbounded, or the result is none,
    /// there is no bound: it is infinite.
    /// @param value     the result
    /// @param error     what the errors of the operands make of it
    /// @param rounding  how far its own rounding may have moved it
    /// @return          the number with both
    [[nodiscard]] static Bounded of(const T& value, const T& error, const T& rounding) {
        const T bound = (error + rounding) * (1 + 8 * unit_of<T>()) + (std::numeric_limits<T>::min)();
        return {value, bound >= 0 && value - value == 0 ? bound : std::numeric_limits<T>::infinity()};
    }
    /// @brief The same where the rounding is at most half a unit in the last place, as of the wide types.
    /// @param value  the result
    /// @param error  what the errors of the operands make of it
    /// @return       the number with both
    [[nodiscard, gnu::noinline]] static Bounded rounded_correctly(const T& value, const T& error) {
        return of(value, error, T(unit_of<T>() * size_of_number(value) / 2));
    }
    [[nodiscard, gnu::noinline]] static Bounded wide_sum(const Bounded& a, const Bounded& b) {
        return rounded_correctly(T(a.x + b.x), T(a.e + b.e));
    }
    [[nodiscard, gnu::noinline]] static Bounded wide_product(const Bounded& a, const Bounded& b) {
        return rounded_correctly(T(a.x * b.x), T(size_of_number(a.x) * b.e + size_of_number(b.x) * a.e + a.e * b.e));
    }
    [[nodiscard, gnu::noinline]] static Bounded wide_quotient(const Bounded& a, const Bounded& b) {
        const T q = a.x / b.x, least = size_of_number(b.x) - b.e;
        return rounded_correctly(q, least > 0 ? T((a.e + size_of_number(q) * b.e) / least) : std::numeric_limits<T>::infinity());
    }
    [[nodiscard, gnu::noinline]] static Bounded wide_opposite(const Bounded& a) { return {T(-a.x), a.e}; }

    /// @brief The result of a library function. @param value the result @param error what the errors of the operands make of it
    /// @param units  how many units in the last place the function is trusted with
    /// @return       the number with both
    [[nodiscard]] static Bounded rounded(const T& value, const T& error, double units) {
        return of(value, error, T(units * unit_of<T>() * size_of_number(value)));
    }

    /// @brief The opposite, as certain. @param a a number @return -a
    [[nodiscard]] friend Bounded operator-(const Bounded& a) {
        if constexpr (std::floating_point<T>)
            return {-a.x, a.e};
        else
            return wide_opposite(a);
    }
    /// @brief Sum: the errors add up, and its rounding is known. @param a a number @param b a number @return a + b
    [[nodiscard]] friend Bounded operator+(const Bounded& a, const Bounded& b) {
        if constexpr (std::floating_point<T>) {
            const T sum = a.x + b.x, of_b = sum - a.x;
            return of(sum, a.e + b.e, std::abs((a.x - (sum - of_b)) + (b.x - of_b)));
        } else {
            return wide_sum(a, b);
        }
    }
    /// @brief Difference, bounded as a sum is. @param a a number @param b a number @return a - b
    [[nodiscard]] friend Bounded operator-(const Bounded& a, const Bounded& b) { return a + -b; }
    /// @brief Product; its rounding is known from a fused product. @param a a number @param b a number @return a b
    [[nodiscard]] friend Bounded operator*(const Bounded& a, const Bounded& b) {
        if constexpr (std::floating_point<T>) {
            const T product = a.x * b.x;
            return of(product, std::abs(a.x) * b.e + std::abs(b.x) * a.e + a.e * b.e, std::abs(std::fma(a.x, b.x, -product)));
        } else {
            return wide_product(a, b);
        }
    }
    /// @brief Quotient; unbounded where the divisor may be zero. @param a a number @param b a number @return a / b
    [[nodiscard]] friend Bounded operator/(const Bounded& a, const Bounded& b) {
        if constexpr (std::floating_point<T>) {
            const T q = a.x / b.x, least = std::abs(b.x) - b.e;
            return of(q, least > 0 ? (a.e + std::abs(q) * b.e) / least : std::numeric_limits<T>::infinity(),
                      std::abs(std::fma(-q, b.x, a.x) / b.x));
        } else {
            return wide_quotient(a, b);
        }
    }
    /// @brief Adds. @param b a number @return this
    Bounded& operator+=(const Bounded& b) { return *this = *this + b; }
    /// @brief Subtracts. @param b a number @return this
    Bounded& operator-=(const Bounded& b) { return *this = *this - b; }
    /// @brief Multiplies. @param b a number @return this
    Bounded& operator*=(const Bounded& b) { return *this = *this * b; }
    /// @brief Divides. @param b a number @return this
    Bounded& operator/=(const Bounded& b) { return *this = *this / b; }
    /// @brief Compares values; bounds play no part. @param a a number @param b a number @return whether a is less
    [[nodiscard]] friend bool operator<(const Bounded& a, const Bounded& b) { return a.x < b.x; }
    /// @brief Compares values; bounds play no part. @param a a number @param b a number @return whether a is greater
    [[nodiscard]] friend bool operator>(const Bounded& a, const Bounded& b) { return a.x > b.x; }
    /// @brief Compares values; bounds play no part. @param a a number @param b a number @return whether a is not greater
    [[nodiscard]] friend bool operator<=(const Bounded& a, const Bounded& b) { return a.x <= b.x; }
    /// @brief Compares values; bounds play no part. @param a a number @param b a number @return whether a is not less
    [[nodiscard]] friend bool operator>=(const Bounded& a, const Bounded& b) { return a.x >= b.x; }
    /// @brief Compares values; bounds play no part. @param a a number @param b a number @return whether both are one value
    [[nodiscard]] friend bool operator==(const Bounded& a, const Bounded& b) { return a.x == b.x; }
    /// @brief Compares values; bounds play no part. @param a a number @param b a number @return whether they differ
    [[nodiscard]] friend bool operator!=(const Bounded& a, const Bounded& b) { return a.x != b.x; }

    /// @brief Largest size that the number can have. @return |x| + e
    [[nodiscard]] T most() const { return size_of_number(x) + e; }
    /// @brief Least size that the number can have. @return |x| - e, not below zero
    [[nodiscard]] T least() const { return std::max(T(0), T(size_of_number(x) - e)); }
};

/// @brief Units in the last place that the library's exponential, sine, cosine and arc tangent are trusted with.
constexpr double library_units = 0.6;
/// @brief The same for hyperbolic functions and those of pi times x, which are made of others.
constexpr double composed_units = 2;

/// @brief Square root. @param a a number @return its root; of one that may be zero, or negative by its error, an error as large
template <class T>
[[nodiscard, gnu::noinline]] Bounded<T> sqrt(const Bounded<T>& a) {
    using std::sqrt;
    if (a.x < 0 && a.x + a.e >= 0) return Bounded<T>::of(T(0), sqrt(T(a.x + a.e)), T(0));
    const T root = sqrt(a.x);
    const T error = a.x > 4 * a.e ? T(a.e / (root + sqrt(T(a.x - a.e)))) : sqrt(T(a.x + a.e));
    if constexpr (std::floating_point<T>)
        return Bounded<T>::of(root, error, root > 0 ? std::abs(std::fma(-root, root, a.x)) / root : 0);
    else
        return Bounded<T>::rounded_correctly(root, error);
}
/// @brief Exponential. @param a a number @return exp(a)
template <class T>
[[nodiscard, gnu::noinline]] Bounded<T> exp(const Bounded<T>& a) {
    using std::exp;
    const T value = exp(a.x);
    return Bounded<T>::rounded(value, T(value * boost::math::expm1(a.e)), library_units);
}
/// @brief Sine. @param a radians @return sin(a)
template <class T>
[[nodiscard, gnu::noinline]] Bounded<T> sin(const Bounded<T>& a) {
    using std::cos, std::sin;
    const T error = a.e > 0 ? std::min(T(2), T(a.e * (size_of_number(T(cos(a.x))) + a.e))) : T(0);
    return Bounded<T>::rounded(sin(a.x), error, library_units);
}
/// @brief Cosine. @param a radians @return cos(a)
template <class T>
[[nodiscard, gnu::noinline]] Bounded<T> cos(const Bounded<T>& a) {
    using std::cos, std::sin;
    const T error = a.e > 0 ? std::min(T(2), T(a.e * (size_of_number(T(sin(a.x))) + a.e))) : T(0);
    return Bounded<T>::rounded(cos(a.x), error, library_units);
}
/// @brief Hyperbolic cosine. @param a a number @return cosh(a)
template <class T>
[[nodiscard, gnu::noinline]] Bounded<T> cosh(const Bounded<T>& a) {
    using std::cosh, std::sinh;
    return Bounded<T>::rounded(cosh(a.x), T(sinh(a.most()) * a.e), composed_units);
}
/// @brief Hyperbolic sine. @param a a number @return sinh(a)
template <class T>
[[nodiscard, gnu::noinline]] Bounded<T> sinh(const Bounded<T>& a) {
    using std::cosh, std::sinh;
    return Bounded<T>::rounded(sinh(a.x), T(cosh(a.most()) * a.e), composed_units);
}
/// @brief Angle of the point (x, y). @param y ordinate @param x abscissa @return radians in (-pi, pi]
template <class T>
[[nodiscard, gnu::noinline]] Bounded<T> atan2(const Bounded<T>& y, const Bounded<T>& x) {
    using std::atan, std::atan2;
    const T size = std::max(size_of_number(x.x), size_of_number(y.x));
    const T X = size_of_number(x.x) / size, Y = size_of_number(y.x) / size;
    const T across = X * (y.e / size) + Y * (x.e / size), along = X * X + Y * Y - X * (x.e / size) - Y * (y.e / size);
    const T error = along > 0 ? T(atan(T(across / along)) * (1 + 8 * unit_of<T>())) : T(2 * pi<T>());
    return Bounded<T>::rounded(atan2(y.x, x.x), error, library_units);
}
/// @brief Largest whole number not above the value. @param a a number @return an exact whole number
template <class T>
[[nodiscard]] Bounded<T> floor(const Bounded<T>& a) {
    using std::floor;
    return {T(floor(a.x))};
}
/// @brief The value without its sign. @param a a number @return |a|
template <class T>
[[nodiscard]] Bounded<T> abs(const Bounded<T>& a) {
    return a.x < 0 ? -a : a;
}
/// @brief \f$ \sin(\pi x) \f$. @param a a number @return sin(pi a)
template <class T>
[[nodiscard, gnu::noinline]] Bounded<T> sin_pi(const Bounded<T>& a) {
    return Bounded<T>::rounded(boost::math::sin_pi(a.x), std::min(T(2), T(4 * a.e)), composed_units);
}
/// @brief \f$ \cos(\pi x) \f$. @param a a number @return cos(pi a)
template <class T>
[[nodiscard, gnu::noinline]] Bounded<T> cos_pi(const Bounded<T>& a) {
    return Bounded<T>::rounded(boost::math::cos_pi(a.x), std::min(T(2), T(4 * a.e)), composed_units);
}
/// @brief \f$ e^x - 1 \f$. @param a a number @return exp(a) - 1
template <class T>
[[nodiscard, gnu::noinline]] Bounded<T> exp_minus_one(const Bounded<T>& a) {
    using std::exp;
    return Bounded<T>::rounded(boost::math::expm1(a.x), T(exp(a.x) * boost::math::expm1(a.e)), composed_units);
}
/// @brief Sine and cosine of \f$ \pi\,[1/(2R) - y] \f$. @param R a positive number @param y a number
/// @return both, with what the errors of R and y make of them
template <class T>
[[nodiscard]] SineCosine<Bounded<T>> sine_cosine_of_half_period(const Bounded<T>& R, const Bounded<T>& y) {
    const SineCosine<T> f = sine_cosine_of_half_period(R.x, y.x);
    const T by_R = R.e > 0 ? (R.e < R.x ? T(2 * R.e / (R.x * (R.x - R.e))) : T(2)) : T(0);      // 2 is more than pi / 2
    const T error = std::min(T(2), T(by_R + 4 * y.e + 8 * unit_of<T>() * size_of_number(y.x))); // y is rounded once more there
    return {Bounded<T>::rounded(f.s, error, 2.5), Bounded<T>::rounded(f.c, error, 2.5)};
}

/// @brief pi as a number with its error.
template <class T>
struct PiOf<Bounded<T>> {
    /// @return pi, and what its rounding lacks: of a double 1.2247e-16, of any other at most a unit of 1
    static Bounded<T> value() { return {pi<T>(), std::same_as<T, double> ? T(1.2247e-16) : unit_of<T>()}; }
};

/// @brief The number type inside a number with a bound, and the type itself of any other.
template <class T>
struct ValueOf {
    using type = T; ///< the type
};
/// @brief Of a number with a bound.
template <class T>
struct ValueOf<Bounded<T>> {
    using type = T; ///< the type inside
};

/// @brief A number of the input, one unit in the last place uncertain, as a decimal fraction or a quotient is.
/// @param x  the number
/// @return   the number with that error
template <class T>
[[nodiscard]] Bounded<T> as_input(const T& x) {
    return {x, T(unit_of<T>() * size_of_number(x))};
}

/// @brief A number in a narrower type, its rounding in the bound.
/// @param a  a number
/// @return   the number in double
template <class T>
[[nodiscard]] Bounded<double> in_double(const Bounded<T>& a) {
    if constexpr (std::same_as<T, double>) {
        return a;
    } else {
        const double value = static_cast<double>(a.x);
        const double error = static_cast<double>(T(size_of_number(T(a.x - T(value))) + a.e));
        return Bounded<double>::of(value, error * (1 + unit_of<double>()), 0);
    }
}

} // namespace denhartog

namespace std {

/// @brief The limits of the value.
template <class T>
class numeric_limits<denhartog::Bounded<T>> : public numeric_limits<T> {};

} // namespace std

namespace Eigen {

/// @brief What Eigen asks of a number that it stores.
template <class T>
struct NumTraits<denhartog::Bounded<T>> : GenericNumTraits<denhartog::Bounded<T>> {
    using Real = denhartog::Bounded<T>;       ///< the number type
    using NonInteger = denhartog::Bounded<T>; ///< the type of quotients
    using Literal = double;                   ///< the type of literals in Eigen's code
    enum { IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 1, ReadCost = 2, AddCost = 4, MulCost = 8 };
};

} // namespace Eigen

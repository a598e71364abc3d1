/// @file
/// @brief Functions of a number with a bound of its error, and what makes it a number type for the formulas and for Eigen.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include "denhartog/number/bounded_arithmetic.hpp"
#include "denhartog/number/number.hpp"
#include "denhartog/number/reduced_angle.hpp"

namespace denhartog {

/// @brief Units in the last place that the library's exponential, sine, cosine and arc tangent are trusted with.
constexpr double library_units = 0.6;
/// @brief Units in the last place for hyperbolic functions and those of pi times x, which are made of others.
constexpr double composed_units = 2;

/// @brief Square root; of a number that may be zero, or negative by its error, with an error as large.
template <class T>
[[nodiscard, gnu::noinline]] Bounded<T> sqrt(const Bounded<T>& a) {
    using std::sqrt;
    if (a.x < 0 && a.x + a.e >= 0) return Bounded<T>::of(T(0), sqrt(T(a.x + a.e)), T(0));
    const T root = sqrt(a.x);
    const T error = a.x > 4 * a.e ? T(a.e / (root + sqrt(T(a.x - a.e)))) : sqrt(T(a.x + a.e));
    return Bounded<T>::of(root, error, root > 0 ? std::abs(elementary::fused_product(-root, root, a.x)) / root : 0);
}
/// @brief Error of an exponential by the error of its exponent.
template <class T>
[[nodiscard]] T error_of_exponential(const Bounded<T>& a, const T& value) {
    // A large error is bounded by the largest value.
    return a.e < T(1) / 2 ? T(value * expm1(a.e)) : T(exp(T(a.x + a.e)));
}
/// @{
/// @brief Elementary functions, and what the errors of their arguments make of them.
template <class T>
[[nodiscard, gnu::noinline]] Bounded<T> exp(const Bounded<T>& a) {
    const T value = exp(a.x);
    return Bounded<T>::rounded(value, error_of_exponential(a, value), library_units);
}
/// @brief Error of a sine or cosine by the error of the angle; `rate` is the other of the two.
template <class T>
[[nodiscard]] T error_by_angle(const T& e, const T& rate) {
    return std::min(T(2), T(e * (size_of_number(rate) + e)));
}
template <class T>
[[nodiscard, gnu::noinline]] SineCosine<Bounded<T>> sine_cosine(const Bounded<T>& a) {
    const SineCosine<T> at = sine_cosine(a.x);
    return {Bounded<T>::rounded(at.s, error_by_angle(a.e, at.c), library_units),
            Bounded<T>::rounded(at.c, error_by_angle(a.e, at.s), library_units)};
}
/// @brief They share what those of the values share.
template <class T>
inline constexpr bool shares_sine_and_cosine<Bounded<T>> = shares_sine_and_cosine<T>;
template <class T>
[[nodiscard, gnu::noinline]] Bounded<T> sin(const Bounded<T>& a) {
    return a.e > 0 ? sine_cosine(a).s : Bounded<T>::rounded(sin(a.x), T(0), library_units);
}
template <class T>
[[nodiscard, gnu::noinline]] Bounded<T> cos(const Bounded<T>& a) {
    return a.e > 0 ? sine_cosine(a).c : Bounded<T>::rounded(cos(a.x), T(0), library_units);
}
template <class T>
[[nodiscard, gnu::noinline]] Bounded<T> cosh(const Bounded<T>& a) {
    return Bounded<T>::rounded(cosh(a.x), T(sinh(a.most()) * a.e), composed_units);
}
template <class T>
[[nodiscard, gnu::noinline]] Bounded<T> sinh(const Bounded<T>& a) {
    return Bounded<T>::rounded(sinh(a.x), T(cosh(a.most()) * a.e), composed_units);
}
template <class T>
[[nodiscard, gnu::noinline]] Bounded<T> atan2(const Bounded<T>& y, const Bounded<T>& x) {
    const T size = std::max(size_of_number(x.x), size_of_number(y.x));
    const T X = size_of_number(x.x) / size, Y = size_of_number(y.x) / size;
    const T across = X * (y.e / size) + Y * (x.e / size), along = X * X + Y * Y - X * (x.e / size) - Y * (y.e / size);
    const T error = along > 0 ? T(atan(T(across / along)) * (1 + 8 * unit_of<T>())) : T(2 * pi<T>());
    return Bounded<T>::rounded(atan2(y.x, x.x), error, library_units);
}
/// @brief Largest whole number not above the value, exact.
template <class T>
[[nodiscard]] Bounded<T> floor(const Bounded<T>& a) {
    using std::floor;
    return {T(floor(a.x))};
}
template <class T>
[[nodiscard]] Bounded<T> abs(const Bounded<T>& a) {
    return a.x < 0 ? -a : a;
}
template <class T>
[[nodiscard, gnu::noinline]] Bounded<T> sin_pi(const Bounded<T>& a) {
    return Bounded<T>::rounded(sine_of_half_turns(a.x), std::min(T(2), T(4 * a.e)), composed_units);
}
template <class T>
[[nodiscard, gnu::noinline]] Bounded<T> cos_pi(const Bounded<T>& a) {
    return Bounded<T>::rounded(cosine_of_half_turns(a.x), std::min(T(2), T(4 * a.e)), composed_units);
}
template <class T>
[[nodiscard, gnu::noinline]] Bounded<T> exp_minus_one(const Bounded<T>& a) {
    const T power = exp(a.x);
    const T value = a.x > 1 ? T(power - 1) : T(expm1(a.x));
    return Bounded<T>::rounded(value, error_of_exponential(a, power), composed_units);
}
/// @}
/// @brief Sine and cosine of \f$ \pi\,[1/(2R) - y] \f$, with what the errors of R and y make of them.
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
    /// @brief pi, and what its rounding lacks: of a double 1.2247e-16, of any other at most a unit of 1.
    static Bounded<T> value() { return {pi<T>(), T(1.2247e-16)}; }
};

/// @brief The number type inside a number with a bound, and the type itself of any other.
template <class T>
struct ValueOf {
    using type = T; ///< the type
    /// @brief The number itself.
    [[nodiscard]] static const T& of(const T& x) { return x; }
    /// @brief Its size.
    [[nodiscard]] static T most(const T& x) { return size_of_number(x); }
    /// @brief Its size.
    [[nodiscard]] static T least(const T& x) { return size_of_number(x); }
    /// @brief None.
    [[nodiscard]] static T error(const T&) { return T(0); }
};
/// @brief Of a number with a bound.
template <class T>
struct ValueOf<Bounded<T>> {
    using type = T; ///< the type inside
    /// @brief The value.
    [[nodiscard]] static const T& of(const Bounded<T>& a) { return a.x; }
    /// @brief The largest size that the number can have.
    [[nodiscard]] static T most(const Bounded<T>& a) { return a.most(); }
    /// @brief The least size that the number can have.
    [[nodiscard]] static T least(const Bounded<T>& a) { return a.least(); }
    /// @brief The bound.
    [[nodiscard]] static T error(const Bounded<T>& a) { return a.e; }
};

/// @brief A number with something neglected in it.
template <class T>
[[nodiscard]] T with_neglected(const T& value, const T& neglected) {
    (void)neglected;
    return value;
}
/// @brief The value with a bound that includes a neglected term; infinite if that is no number.
template <class T>
[[nodiscard]] Bounded<T> with_neglected(const Bounded<T>& value, const Bounded<T>& neglected) {
    const T bound = value.e + neglected.most();
    return {value.x, bound >= 0 ? bound : std::numeric_limits<T>::infinity()};
}

/// @brief A number of the input, one unit in the last place uncertain, as a decimal fraction or a quotient is.
template <class T>
[[nodiscard]] Bounded<T> as_input(const T& x) {
    return {x, T(unit_of<T>() * size_of_number(x))};
}

} // namespace denhartog

namespace std {

/// @brief The limits of the value.
template <class T>
class numeric_limits<denhartog::Bounded<T>> : public numeric_limits<T> {};

} // namespace std

namespace Eigen {

/// @brief The traits that Eigen requires of a number.
template <class T>
struct NumTraits<denhartog::Bounded<T>> : GenericNumTraits<denhartog::Bounded<T>> {
    using Real = denhartog::Bounded<T>;       ///< the number type
    using NonInteger = denhartog::Bounded<T>; ///< the type of quotients
    using Literal = double;                   ///< the type of literals in Eigen's code
    enum { IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 1, ReadCost = 2, AddCost = 4, MulCost = 8 };
};

} // namespace Eigen

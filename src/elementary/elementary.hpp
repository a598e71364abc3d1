/// @file
/// @brief Elementary functions of a double that have the same digits on every machine.
///
/// They are made of the operations of IEEE 754 and of tables, and call no function of the system: those of glibc differ from
/// processor to processor, and from version to version. Each is rounded within 0.55 units in the last place, `hypot` within 0.6,
/// the hyperbolic sine within 0.7; results below the normal range within 1. `tests/elementary/elementary.cpp` measures that against
/// MPFR. Arguments are reduced exactly, however large they are. Outside its domain a function gives what is no number, beyond the
/// range of a double infinity.
///
/// The templates of the formulas find them by the names in `number.hpp`.
#pragma once

#include <cmath>

namespace denhartog {

/// @brief Sine and cosine of one angle.
template <class T>
struct SineCosine {
    T s; ///< sine
    T c; ///< cosine
};

} // namespace denhartog

namespace denhartog::elementary {

/// @brief Exponential. @param x a number @return exp(x)
[[nodiscard, gnu::const]] double exp(double x) noexcept;
/// @brief Exponential less one. @param x a number @return exp(x) - 1, without cancellation near 0
[[nodiscard, gnu::const]] double expm1(double x) noexcept;
/// @brief Hyperbolic sine. @param x a number @return sinh(x)
[[nodiscard, gnu::const]] double sinh(double x) noexcept;
/// @brief Hyperbolic cosine. @param x a number @return cosh(x)
[[nodiscard, gnu::const]] double cosh(double x) noexcept;
/// @brief Natural logarithm. @param x a number, not negative @return log(x)
[[nodiscard, gnu::const]] double log(double x) noexcept;
/// @brief Decimal logarithm. @param x a number, not negative @return log(x) / log(10)
[[nodiscard, gnu::const]] double log10(double x) noexcept;
/// @brief Sine. @param x radians @return sin(x)
[[nodiscard, gnu::const]] double sin(double x) noexcept;
/// @brief Cosine. @param x radians @return cos(x)
[[nodiscard, gnu::const]] double cos(double x) noexcept;
/// @brief Both, for less than twice the time of one. @param x radians @return to the bit what `sin` and `cos` give
[[nodiscard, gnu::const]] SineCosine<double> sine_cosine(double x) noexcept;
/// @brief Sine of half turns. @param x half turns @return sin(pi x), exact at multiples of a quarter turn
[[nodiscard, gnu::const]] double sine_of_half_turns(double x) noexcept;
/// @brief Cosine of half turns. @param x half turns @return cos(pi x), exact at multiples of a quarter turn
[[nodiscard, gnu::const]] double cosine_of_half_turns(double x) noexcept;
/// @brief Angle of the point (x, y). @param y ordinate @param x abscissa @return radians, from -pi to pi
[[nodiscard, gnu::const]] double atan2(double y, double x) noexcept;
/// @brief Arc tangent. @param x a number @return radians, from -pi / 2 to pi / 2
[[nodiscard, gnu::const]] double atan(double x) noexcept;
/// @brief Length of (x, y). @param x a number @param y a number @return sqrt(x^2 + y^2), neither square beyond the range
[[nodiscard, gnu::const]] double hypot(double x, double y) noexcept;

} // namespace denhartog::elementary

/// @file
/// @brief (23), (28), (29) in the paper's forms and in those that callers get, and the digits that a value keeps.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "denhartog/evaluation/mode.hpp"
#include "tests/support/multiprecision.hpp"

namespace denhartog::figures {

/// @brief 400 digits: along zeta = x, |R - 1| = x = 1e-100 the paper's forms lose 200.
using Real400 = Multiprecision<400>;

/// @brief v, u, g.
template <class T>
using Three = std::array<T, 3>;
/// @brief Names of the functions.
inline const Three<std::string> names_of_functions{"v", "u", "g"};
/// @brief Numbers of their equations.
inline const Three<std::string> numbers_of_functions{"(23)", "(28)", "(29)"};

/// @brief The functions as the paper writes them. @return v, u, g
template <class T>
[[nodiscard]] Three<Complex<T>> printed_functions(const T& R, const T& zeta) {
    return {paper::complex_response(R, zeta), Complex<T>{paper::first_damping_function(R, zeta), T(0)},
            Complex<T>{paper::second_damping_function(R, zeta), T(0)}};
}

/// @brief The functions in the forms that callers get. @return v, u, g
template <class T>
[[nodiscard]] Three<Complex<T>> shipped_functions(const T& R, const T& zeta) {
    const evaluation::ModeFunctions<T> f = evaluation::mode_functions(R, zeta);
    return {f.v, Complex<T>{f.u, T(0)}, Complex<T>{f.g, T(0)}};
}

/// @brief The decimal digits of a number type: of its unit roundoff.
template <class T>
[[nodiscard]] double digits_of_type() {
    return -std::log10(static_cast<double>(std::numeric_limits<T>::epsilon() / 2));
}

/// @brief Decimal digits that a relative error leaves, at most those of the type.
template <class T, class Truth>
[[nodiscard]] double digits_left(const Truth& error) {
    return error == 0 ? digits_of_type<T>() : std::min(digits_of_type<T>(), std::max(0.0, -static_cast<double>(log10(error))));
}

/// @brief Decimal digits of a value, at most those of its type; none where it is no number.
template <class T, class Truth>
[[nodiscard]] double digits_kept(const T& value, const Truth& truth) {
    using std::isfinite;
    return isfinite(value) ? digits_left<T>(Truth(abs(Truth(Truth(value) / truth - 1)))) : 0;
}

/// @brief Decimal digits of a complex value, at most those of its type; none where it is no number.
template <class T, class Truth>
[[nodiscard]] double digits_kept(const Complex<T>& value, const Complex<Truth>& truth) {
    using std::isfinite;
    if (!isfinite(value.re) || !isfinite(value.im)) return 0;
    return digits_left<T>(Truth(modulus(Complex<Truth>{Truth(value.re), Truth(value.im)} + Truth(-1) * truth) / modulus(truth)));
}

} // namespace denhartog::figures

/// @file
/// @brief Elementary functions in forms that keep their digits: of pi times x, and without their leading term.
///
/// Each has an overload for the symbolic scalar in `derivation/symbolic.hpp`, so that the forms built on them can be proved.
#pragma once

#include <boost/math/special_functions/cos_pi.hpp>
#include <boost/math/special_functions/expm1.hpp>
#include <boost/math/special_functions/sin_pi.hpp>

#include "denhartog/number.hpp"

namespace denhartog::evaluation {

/// @brief \f$ \sin(\pi x) \f$, the argument reduced before it is multiplied. @param x a number @return sin(pi x)
template <class T>
[[nodiscard]] T sin_pi(const T& x) {
    return boost::math::sin_pi(x);
}

/// @brief \f$ \cos(\pi x) \f$, the argument reduced before it is multiplied. @param x a number @return cos(pi x)
template <class T>
[[nodiscard]] T cos_pi(const T& x) {
    return boost::math::cos_pi(x);
}

/// @brief \f$ e^x - 1 \f$. @param x a number @return exp(x) - 1 without cancellation near 0
template <class T>
[[nodiscard]] T exp_minus_one(const T& x) {
    return boost::math::expm1(x);
}

/// @brief \f$ 1 - \sqrt{1-\zeta^2} = \zeta^2/(1+\sqrt{1-\zeta^2}) \f$. @param zeta a number in [0, 1) @return the difference
template <class T>
[[nodiscard]] T one_minus_w(const T& zeta) {
    return zeta * zeta / (1 + sqrt(T((1 - zeta) * (1 + zeta))));
}

/// @brief Sum of \f$ \sum_{k\ge1} s^{k}/(2k+1)! \f$ with \f$ s = \pm x^2 \f$, for |s| at most 1.
/// @param s  signed square of the argument
/// @return   the sum
template <class T>
[[nodiscard]] T odd_series_without_leading_term(const T& s) {
    T sum = s / 6;
    T term = sum;
    for (int k = 2;; ++k) {
        term = term * s / (2 * k * (2 * k + 1));
        const T next = sum + term;
        if (next == sum) return sum;
        sum = next;
    }
}

/// @brief \f$ \sinh(x)/x - 1 \f$. @param x a number, not zero beyond |x| = 1 @return the difference, never negative
template <class T>
[[nodiscard]] T sinhc_minus_one(const T& x) {
    if (x * x <= 1) return odd_series_without_leading_term(T(x * x));
    return sinh(x) / x - 1;
}

/// @brief \f$ 1 - \sin(x)/x \f$. @param x a number, not zero beyond |x| = 1 @return the difference, never negative
template <class T>
[[nodiscard]] T one_minus_sinc(const T& x) {
    if (x * x <= 1) return -odd_series_without_leading_term(T(-x * x));
    return 1 - sin(x) / x;
}

} // namespace denhartog::evaluation

/// @file
/// @brief Elementary functions in forms that keep their digits: of pi times x, and without their leading term.
///
/// Those that compare numbers have a stand-in in `derivation/selections/stand_ins.hpp`, so that the forms built on them can be proved;
/// the others are proved as they stand.
#pragma once

#include "denhartog/number/number.hpp"
#include "denhartog/number/reduced_angle.hpp"

namespace denhartog::evaluation {

/// @brief \f$ \sin(\pi x) \f$, the argument reduced before it is multiplied. @param x a number @return sin(pi x)
template <class T>
[[nodiscard]] T sin_pi(const T& x) {
    return sine_of_half_turns(x);
}

/// @brief \f$ \cos(\pi x) \f$, the argument reduced before it is multiplied. @param x a number @return cos(pi x)
template <class T>
[[nodiscard]] T cos_pi(const T& x) {
    return cosine_of_half_turns(x);
}

/// @brief \f$ e^x - 1 \f$. @param x a number @return exp(x) - 1 without cancellation near 0
template <class T>
[[nodiscard]] T exp_minus_one(const T& x) {
    return expm1(x);
}

/// @brief \f$ w = \sqrt{1-\zeta^2} \f$ of a mode that oscillates, the square as a product. @param zeta a number in [0, 1) @return w
template <class T>
[[nodiscard]] T oscillating_w(const T& zeta) {
    return sqrt(T((1 - zeta) * (1 + zeta)));
}

/// @brief w of a mode that oscillates, and nothing of another. @param zeta a number, not negative @return w, or 0 from 1 on
template <class T>
[[nodiscard]] T w_if_oscillating(const T& zeta) {
    return zeta < 1 ? oscillating_w(zeta) : T(0);
}

/// @brief \f$ 1 - \sqrt{1-\zeta^2} = \zeta^2/(1+\sqrt{1-\zeta^2}) \f$. @param zeta a number in [0, 1) @return the difference
template <class T>
[[nodiscard]] T one_minus_w(const T& zeta) {
    return zeta * zeta / (1 + oscillating_w(zeta));
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

/// @brief \f$ (1-e^{-x})/x \f$, which is 1 at 0. @param x a number, not negative @return the quotient
template <class T>
[[nodiscard]] T one_minus_exp_over(const T& x) {
    if (x == 0) return T(1);
    return -exp_minus_one(T(-x)) / x;
}

/// @brief \f$ \sin(x)/x \f$, which is 1 at 0. @param x a number @return the quotient
template <class T>
[[nodiscard]] T sinc(const T& x) {
    if (x == 0) return T(1);
    return sin(x) / x;
}

/// @brief \f$ \sin(x)/x \f$ and \f$ \cos x \f$. @param x a number @return what `sinc` and `cos` give
template <class T>
[[nodiscard]] SineCosine<T> sinc_cosine(const T& x) {
    if constexpr (shares_sine_and_cosine<T>) {
        const SineCosine<T> at = sine_cosine(x);
        return {x == 0 ? T(1) : T(at.s / x), at.c};
    } else {
        return {sinc(x), cos(x)};
    }
}

/// @brief \f$ \frac{1}{q^2}\left[\frac{\sinh q\zeta}{q\zeta} - \frac{\sin qw}{qw}\right] \f$ without its cancellation.
///
/// The bracket is \f$ \sum_k [\zeta^{2k}-(-w^2)^k]\,q^{2k}/(2k+1)! \f$. As \f$ \zeta^2+w^2=1 \f$ its coefficients follow from
/// \f$ c_{k+1} = (2\zeta^2-1)c_k + \zeta^2w^2c_{k-1} \f$ with \f$ c_0=0, c_1=1 \f$: neither w nor a difference is formed, and the
/// value is 1/6 at q = 0.
/// @param q     a number, not much beyond pi
/// @param zeta  a number in [0, 1)
/// @return      the quotient
template <class T>
[[nodiscard]] T sinhc_less_sinc_over_square(const T& q, const T& zeta) {
    const T square = q * q;
    const T once = (2 * zeta * zeta - 1) * square;
    const T twice = zeta * zeta * ((1 - zeta) * (1 + zeta)) * square * square;
    T before(0), term = T(1) / 6, sum = term;
    for (int k = 1, still = 0;; ++k) {
        const T next_term = (once * term + twice * before / (2 * k * (2 * k + 1))) / ((2 * k + 2) * (2 * k + 3));
        before = term;
        term = next_term;
        const T next = sum + term;
        still = next == sum ? still + 1 : 0;
        if (still == 2) return sum; // one coefficient can be zero, not two in a row
        sum = next;
    }
}

} // namespace denhartog::evaluation

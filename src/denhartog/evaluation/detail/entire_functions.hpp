/// @file
/// @brief Cosine and sine of \f$ wx \f$ as entire functions of \f$ w^2 = 1-\zeta^2 \f$, for \f$ \zeta \ge 1 \f$.
///
/// There \f$ w = i w_1 \f$ with \f$ w_1 = \sqrt{\zeta^2-1} \f$, and \f$ \cos wx = \cosh w_1x \f$,
/// \f$ \sin(wx)/w = \sinh(w_1x)/w_1 \f$: real, and at \f$ \zeta = 1 \f$ no exception. The rates of decay are
/// \f$ a = \zeta - w_1 = 1/(\zeta+w_1) \f$ and \f$ 1/a \f$. The functions that compare numbers have a stand-in in
/// `derivation/selections/stand_ins.hpp`, which is the formula of their comment; the others are proved as they stand. The series
/// keep their digits where \f$ w_1x \f$ is not much beyond 1.
#pragma once

#include "denhartog/evaluation/special.hpp"

namespace denhartog::evaluation {

/// @brief \f$ w_1 = \sqrt{\zeta-1}\,\sqrt{\zeta+1} \f$, without the overflow of a square.
template <class T>
[[nodiscard]] T overdamped_w(const T& zeta) {
    return sqrt(T(zeta - 1)) * sqrt(T(zeta + 1));
}

/// @brief The slow rate \f$ a = 1/(\zeta+w_1) \f$, in which nothing cancels.
template <class T>
[[nodiscard]] T slow_rate(const T& zeta) {
    return 1 / (zeta + overdamped_w(zeta));
}

/// @brief \f$ (w_1 x)^2 \f$. @param zeta modal damping ratio, 1 or more @param x a number @return its square, no root taken
template <class T>
[[nodiscard]] T square_of_overdamped_angle(const T& zeta, const T& x) {
    return ((zeta - 1) * x) * ((zeta + 1) * x);
}

/// @brief \f$ \sinh(w_1x)/(w_1x) \f$ by its series in \f$ (w_1x)^2 \f$; 1 at \f$ \zeta = 1 \f$.
template <class T>
[[nodiscard]] T overdamped_sinc(const T& zeta, const T& x) {
    return 1 + odd_series_without_leading_term(square_of_overdamped_angle(zeta, x));
}

/// @brief \f$ \cosh w_1x - 1 = \tfrac12(w_1x)^2\left[\sinh(\tfrac12w_1x)/(\tfrac12w_1x)\right]^2 \f$.
template <class T>
[[nodiscard]] T overdamped_cosine_less_one(const T& zeta, const T& x) {
    const T half = overdamped_sinc(zeta, T(x / 2));
    return square_of_overdamped_angle(zeta, x) / 2 * half * half;
}

/// @brief \f$ \cosh w_1x \f$.
template <class T>
[[nodiscard]] T overdamped_cosine(const T& zeta, const T& x) {
    return 1 + overdamped_cosine_less_one(zeta, x);
}

/// @brief \f$ (1-e^{-2w_1x})/(2w_1) \f$, \f$ \zeta > 1 \f$, \f$ x \ge 0 \f$.
template <class T>
[[nodiscard]] T overdamped_difference(const T& zeta, const T& x) {
    const T w = overdamped_w(zeta);
    return -exp_minus_one(T(-2 * w * x)) / (2 * w);
}

/// @brief \f$ \frac{1}{q^2}\left[\frac{\sinh q\zeta}{q\zeta} - \frac{\sinh qw_1}{qw_1}\right] \f$ without its cancellation.
///
/// With \f$ X = (q\zeta)^2 \f$, \f$ Y = (qw_1)^2 \f$, \f$ X - Y = q^2 \f$ it is \f$ \sum_{k\ge1} D_k/(2k+1)! \f$, where
/// \f$ D_k = (X^k-Y^k)/(X-Y) \f$ follows from \f$ D_1 = 1 \f$, \f$ D_{k+1} = XD_k + Y^k \f$: every term is positive.
/// @param q     a number
/// @param zeta  modal damping ratio, 1 or more; q zeta not much beyond 4
/// @return      the quotient, 1/6 at q = 0
template <class T>
[[nodiscard]] T sinhc_less_sinhc_over_square(const T& q, const T& zeta) {
    const T X = (q * zeta) * (q * zeta), Y = square_of_overdamped_angle(zeta, q);
    T term = T(1) / 6, power = Y / 6, sum = term; // D_k / (2k + 1)! and Y^k / (2k + 1)!
    for (int k = 1;; ++k) {
        const int next_factors = (2 * k + 2) * (2 * k + 3);
        term = (X * term + power) / next_factors;
        power = power * Y / next_factors;
        const T next = sum + term;
        if (next == sum) return sum;
        sum = next;
    }
}

/// @brief \f$ pK/R \f$ in the order in which no intermediate result leaves the range of the number type.
/// @param p  a factor, at most 1
/// @param K  a positive number
/// @param R  a positive number
/// @return   p K / R
template <class T>
[[nodiscard]] T product_over(const T& p, const T& K, const T& R) {
    if (K < 1) return p * (K / R);
    return p * K / R;
}

} // namespace denhartog::evaluation

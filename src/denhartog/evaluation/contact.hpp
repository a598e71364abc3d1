/// @file
/// @brief The root of (38) and the phase (39) without the cancellation near the end of their domain.
///
/// Where \f$ \beta|U_{dj}| \f$ comes near \f$ |V_{dj}| \f$ the squares under the root cancel: what their roundings took is all
/// that is left. Here every product comes with what its rounding took, and is summed with it: the root is as exact as V, U and
/// beta are. In number types without a fused multiply-add the products stand as they are; the root is proved with both.
///
/// V_dj, U_dj, G_j are (33)-(35) of the mass in contact, beta is the friction ratio (11), mu that of static to kinetic friction
/// (3).
#pragma once

#include <cmath>
#include <concepts>

#include "denhartog/formulas/contact.hpp"

namespace denhartog::evaluation {

/// @brief Rounding error of a product: \f$ xy - \mathrm{fl}(xy) \f$. @param x a number @param y a number
/// @param xy  their product as rounded
/// @return    the rest, exact in binary floating-point types
template <class T>
[[nodiscard]] T product_error(const T& x, const T& y, const T& xy) {
    using std::fma;
    return fma(x, y, T(-xy));
}

/// @brief Rounding error of a sum. @param x a number @param y a number @param sum their sum as rounded
/// @return the rest, exact in binary floating-point types
template <class T>
[[nodiscard]] T sum_error(const T& x, const T& y, const T& sum) {
    const T y_part = sum - x;
    return (x - (sum - y_part)) + (y - y_part);
}

/// @brief A sum so far, and what its roundings took.
template <class T>
struct SumWithRest {
    T sum;  ///< as it was rounded
    T rest; ///< what is to be added to it
};

/// @brief A sum with one term more: nothing is lost, whatever the rounding.
/// @eq{73}  @derivation{forms/evaluation_forms}  @domain{any numbers}
/// @param s     the sum so far
/// @param term  the term
/// @param next  their sum as rounded
/// @return      the sum with the term; in exact arithmetic sum and rest together are those of `s` and the term
template <class T>
[[nodiscard]] SumWithRest<T> with_term(const SumWithRest<T>& s, const T& term, const T& next) {
    return {next, s.rest + sum_error(s.sum, term, next)};
}

/// @brief A sum with what its roundings took: as good as one that is rounded once.
/// @param terms  the terms
/// @return       the sum; as it is where it is beyond the range
template <class T, class Terms>
[[nodiscard]] T sum_with_rests(const Terms& terms) {
    SumWithRest<T> s{T(0), T(0)};
    for (const T& term : terms) s = with_term(s, term, T(s.sum + term));
    return s.rest - s.rest == 0 ? T(s.sum + s.rest) : s.sum;
}

/// @brief Parts of the root, each number as it was rounded.
template <class T>
struct RootParts {
    T b;             ///< beta U
    T re_2;          ///< square of the real part of V
    T im_2;          ///< square of its imaginary part
    T b_2;           ///< square of b
    T re_2_less_b_2; ///< their difference
    T all;           ///< that and im_2
};

/// @brief The square of the root from its parts; where rests are given back, whatever the roundings of the parts.
/// @eq{36,38}  @derivation{forms/evaluation_forms}  @domain{sliding regime, Eq. (69): |V_dj| >= beta |U_dj|}
/// @param V_dj  complex response function of the mass in contact, Eq. (33)
/// @param U_dj  first damping function of the mass in contact, Eq. (34)
/// @param beta  friction ratio, Eq. (11)
/// @param p     the parts as rounded
/// @tparam      rests_given_back  whether what each rounding took is added
/// @return      |V|^2 - (beta U)^2
template <bool rests_given_back, class T>
[[nodiscard]] T square_of_root(const Complex<T>& V_dj, const T& U_dj, const T& beta, const RootParts<T>& p) {
    if constexpr (rests_given_back) {
        const T b_rest = product_error(beta, U_dj, p.b);
        const T squares =
            product_error(V_dj.re, V_dj.re, p.re_2) + product_error(V_dj.im, V_dj.im, p.im_2) - product_error(p.b, p.b, p.b_2);
        const T sums = sum_error(p.re_2, T(-p.b_2), p.re_2_less_b_2) + sum_error(p.re_2_less_b_2, p.im_2, p.all);
        return p.all + (squares + sums - b_rest * (2 * p.b + b_rest));
    } else {
        return p.all;
    }
}

/// @brief \f$ \sqrt{|V_{dj}|^2-(\beta U_{dj})^2} \f$ with the roundings of the products made good.
/// @eq{36,38}  @derivation{forms/evaluation_forms}  @domain{sliding regime, Eq. (69): |V_dj| >= beta |U_dj|}
/// @param V_dj  complex response function of the mass in contact, Eq. (33)
/// @param U_dj  first damping function of the mass in contact, Eq. (34)
/// @param beta  friction ratio, Eq. (11)
/// @tparam      rests_given_back  whether the number type has the exact rests of its products and sums; both are proved
/// @return      the root for V, U and beta as they are; not a number beyond the domain
template <class T, bool rests_given_back = std::floating_point<T>>
[[nodiscard]] T contact_root(const Complex<T>& V_dj, const T& U_dj, const T& beta) {
    const T b = beta * U_dj;
    const T re_2 = V_dj.re * V_dj.re, im_2 = V_dj.im * V_dj.im, b_2 = b * b;
    const T difference = re_2 - b_2;
    const RootParts<T> parts{b, re_2, im_2, b_2, difference, T(difference + im_2)};
    return sqrt(square_of_root<rests_given_back>(V_dj, U_dj, beta, parts));
}

/// @brief (38) with the root above. @eq{38}  @derivation{forms/evaluation_forms}  @domain{sliding regime, Eq. (69)}
template <class T>
[[nodiscard]] T displacement_transmissibility_of_contact(const Complex<T>& V_dj, const T& U_dj, const T& G_j, const T& beta) {
    return contact_root(V_dj, U_dj, beta) - beta * G_j;
}

/// @brief (39) with the root above in place of the sine's cosine, which cancels where the sine comes near 1.
/// \f[ \phi_j = \mathrm{atan2}\left(-\beta U_{dj},\ \sqrt{|V_{dj}|^2-(\beta U_{dj})^2}\right) - \angle V_{dj} \f]
/// @eq{39}  @derivation{forms/evaluation_forms}  @domain{sliding regime, Eq. (69)}
template <class T>
[[nodiscard]] T phase_of_contact(const Complex<T>& V_dj, const T& U_dj, const T& beta) {
    return atan2(T(-(beta * U_dj)), contact_root(V_dj, U_dj, beta)) - argument(V_dj);
}

/// @brief The smallest friction ratio at which the contact never moves: \f$ |V_{dj}/Y_{jj}|/\mu \f$.
///
/// The contact can rest if a force of at most \f$ \mu\beta \f$ makes its displacement zero: \f$ V_{dj} - f\,Y_{jj} = 0 \f$.
/// @eq{88}  @derivation{paper/section_4_3_stuck}  @domain{Y_jj not zero}
template <class T>
[[nodiscard]] T sticking_limit_by_responses(const Complex<T>& V_dj, const Complex<T>& Y_jj, const T& mu) {
    return modulus(V_dj) / modulus(Y_jj) / mu;
}

} // namespace denhartog::evaluation

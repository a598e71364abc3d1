/// @file
/// @brief (23), (28), (29) as the arrays of `mode_arrays.hpp` compute them: no branch, nothing twice.
///
/// The forms are those of `mode.hpp` in the exponential, in \f$ sc \f$ and \f$ c^2 \f$ (sine and cosine of the half angle; a
/// half turn alters neither) and with one reciprocal for (28) and (29) together. As there, each is proved equal to the paper's,
/// in `derivation/forms/batch_forms.cpp`, by instantiating these very templates with symbols.
///
/// R is the modal frequency ratio (22), x is 1/(2R), m the mode, e its decay, h the half angle, `inverse` of the denominator,
/// and u, g are (28), (29).
#pragma once

#include "denhartog/evaluation/mode.hpp"

namespace denhartog::evaluation {

/// @brief Constants of a mode, which do not depend on R.
template <class T>
struct ArrayMode {
    T zeta;        ///< modal damping ratio
    T two_zeta;    ///< 2 zeta
    T two_pi_zeta; ///< 2 pi zeta
    T inverse_w;   ///< 1 / sqrt(1 - zeta^2)
};

/// @brief \f$ e^{-\delta} \f$ as a product, neither factor of which leaves the normal numbers, and without its leading term.
template <class T>
struct Exponential {
    T head;        ///< first factor
    T tail;        ///< second factor
    T E_minus_one; ///< exp(-delta) - 1, without cancellation near 0
};

/// @brief Products of the sine and cosine of a half angle.
template <class T>
struct HalfAngleProducts {
    T sine_cosine;   ///< sin cos
    T cosine_square; ///< cos^2
};

/// @brief The constants of a mode, which do not depend on R. @param zeta modal damping ratio @return the four numbers
template <class T>
[[nodiscard]] ArrayMode<T> array_mode(const T& zeta) {
    return {zeta, 2 * zeta, 2 * pi<T>() * zeta, 1 / oscillating_w(zeta)};
}

/// @brief \f$ v_{di} \f$ with \f$ a = (1-R)(1+R) \f$, \f$ b = 2\zeta R \f$ and one reciprocal: \f$ (a - ib)/(a^2+b^2) \f$.
/// @eq{23}  @derivation{forms/batch_forms}  @domain{0 < R <= 2^200; zeta = 0 or 2^-500 <= zeta < 1}
template <class T>
[[nodiscard, gnu::always_inline]] inline Complex<T> array_response(const T& R, const ArrayMode<T>& m) {
    const T a = (1 - R) * (1 + R);
    const T b = m.two_zeta * R;
    const T D = 1 / (a * a + b * b);
    return {a * D, -(b * D)};
}

/// @brief The denominator of (28) and (29) inverted: \f$ 1/[(1-E)^2+4Ec^2] \f$.
/// @eq{28,29}  @derivation{forms/batch_forms}  @domain{R > 0, 0 <= zeta < 1}
template <class T>
[[nodiscard, gnu::always_inline]] inline T inverse_denominator(const Exponential<T>& e, const HalfAngleProducts<T>& h) {
    return 1 / (e.E_minus_one * e.E_minus_one + 4 * (e.head * e.tail) * h.cosine_square);
}

/// @brief \f$ u_{di} = 4Esc\,/\,(R\,w\,[(1-E)^2+4Ec^2]) \f$, with the small factor of E last.
/// @eq{28}  @derivation{forms/batch_forms}  @domain{R > 0, 0 <= zeta < 1}
template <class T>
[[nodiscard, gnu::always_inline]] inline T array_first_damping_function(const T& x, const ArrayMode<T>& m,
                                                                        const Exponential<T>& e, const HalfAngleProducts<T>& h,
                                                                        const T& inverse) {
    return 8 * x * (e.head * (h.sine_cosine * m.inverse_w)) * inverse * e.tail;
}

/// @brief \f$ g_i = [(1-E)(1+E) - 4E\frac{\zeta}{w}sc]\,/\,[(1-E)^2+4Ec^2] \f$.
/// @eq{29}  @derivation{forms/batch_forms}  @domain{R > 0, 0 <= zeta < 1; keeps its digits for R below 5/4}
template <class T>
[[nodiscard, gnu::always_inline]] inline T array_second_damping_function(const ArrayMode<T>& m, const Exponential<T>& e,
                                                                         const HalfAngleProducts<T>& h, const T& inverse) {
    const T E = e.head * e.tail;
    return -(e.E_minus_one * (1 + E) + m.zeta * (4 * E * (h.sine_cosine * m.inverse_w))) * inverse;
}

/// @brief \f$ g_i = 2E\delta\left[\frac{\sinh\delta}{\delta}-\frac{\sin\theta}{\theta}\right]/[(1-E)^2+4Ec^2] \f$, the bracket as
/// one series in \f$ q = \pi/R \f$, whose coefficients are the mode's.
/// @eq{29}  @derivation{forms/batch_forms}  @domain{R > 0, 0 < zeta < 1; keeps its digits for R of 5/4 and more}
template <class T>
[[nodiscard, gnu::always_inline]] inline T array_second_damping_function_of_large_ratio(const T& delta, const T& square,
                                                                                        const T& series, const Exponential<T>& e,
                                                                                        const T& inverse) {
    return 2 * (e.head * e.tail) * (square * series) * inverse * delta;
}

/// @brief Form of the half angle of a mode: \f$ \pi\,(w-\lambda)/(2R) \f$.
template <class T>
struct AngleOfMode {
    T w;    ///< 1 if the angle is a difference, else sqrt(1 - zeta^2)
    T late; ///< \f$ \lambda \f$: 1 - sqrt(1 - zeta^2) where it is a difference, else 0
};

/// @brief The half angle as a difference where zeta is below 1/2, so that a small zeta is not rounded away, else as a product.
/// @eq{28,29}  @derivation{selections/solver_selections}  @domain{0 <= zeta < 1}
template <class T>
[[nodiscard]] AngleOfMode<T> angle_of_mode(const T& zeta) {
    if (2 * zeta >= 1) return {oscillating_w(zeta), T(0)};
    return {T(1), one_minus_w(zeta)};
}

/// @brief Range within which the arrays compute with vectors; beyond it the scalar forms answer.
template <class T>
struct VectorRange {
    T least_ratio;   ///< least R
    T largest_ratio; ///< largest R
    T least_damping; ///< least zeta beside 0
};

/// @brief Whether a mode is left to the scalar forms by its damping ratio. @param zeta modal damping ratio @param range the range
/// @return  whether it is
template <class T>
[[nodiscard]] bool damping_beyond_vectors(const T& zeta, const VectorRange<T>& range) {
    return zeta >= 1 || (zeta > 0 && zeta < range.least_damping);
}

/// @brief Whether the frequency ratio leaves a mode to the scalar forms. @param R modal frequency ratio @param range the range
/// @return  whether it is
template <class T>
[[nodiscard, gnu::always_inline]] inline bool ratio_beyond_vectors(const T& R, const VectorRange<T>& range) {
    return !(R >= range.least_ratio && R <= range.largest_ratio);
}

/// @brief Whether (29) is taken in its second form. @param R modal frequency ratio, Eq. (22) @return whether R is 5/4 and more
template <class T>
[[nodiscard, gnu::always_inline]] inline bool is_large_ratio(const T& R) {
    return 4 * R >= 5;
}

/// @brief (23), (28), (29) of a mode as the arrays have them.
/// @eq{23,28,29}  @derivation{selections/solver_selections}  @domain{0 < R <= 2^200; zeta = 0 or 2^-500 <= zeta < 1}
/// @param R       modal frequency ratio, Eq. (22)
/// @param m       the mode
/// @param x       1 / (2 R)
/// @param e       exponential of -delta
/// @param h       products of the half angle
/// @param series  of the second form of (29), the bracket over q^2
/// @tparam        large_ratios  whether R may be 5/4 and more
/// @return        v, u, g
template <bool large_ratios, class T>
[[nodiscard, gnu::always_inline]] inline ModeFunctions<T> array_mode_functions(const T& R, const ArrayMode<T>& m, const T& x,
                                                                               const Exponential<T>& e,
                                                                               const HalfAngleProducts<T>& h, const T& series) {
    const T inverse = inverse_denominator(e, h);
    const T u = array_first_damping_function(x, m, e, h, inverse);
    const T g = array_second_damping_function(m, e, h, inverse);
    const Complex<T> v = array_response(R, m);
    if constexpr (large_ratios) {
        const T q = 2 * pi<T>() * x;
        const T g_of_large_ratio =
            array_second_damping_function_of_large_ratio(T(m.two_pi_zeta * x), T(q * q), series, e, inverse);
        return {v, u, is_large_ratio(R) ? g_of_large_ratio : g};
    } else {
        return {v, u, g};
    }
}

/// @brief Factor of a mode in the sums over modes that does not depend on r:
/// \f$ \psi_{ki}\psi_{li}R_i^2=\phi_{ki}\phi_{li}/r_{n,i}^2 \f$.
template <class T>
struct ArrayWeights {
    T load;     ///< phi_j phi_l / r_n^2, of (33)
    T contact;  ///< phi_j^2 / r_n^2, of (34), (35)
    T square;   ///< phi_j^2: over r^2 that of (64), (65)
    T two_zeta; ///< 2 zeta
};

/// @brief The weights of a mode in the sums at the mass in contact.
/// @eq{33,34,35,64,65}  @derivation{forms/batch_forms}
/// @param phi_j  mode shape at the mass in contact, without the factor 1/r of (17)
/// @param phi_l  mode shape at the loaded mass
/// @param r_n    natural frequency ratio
/// @param zeta   modal damping ratio
/// @return       the weights
template <class T>
[[nodiscard]] ArrayWeights<T> array_weights(const T& phi_j, const T& phi_l, const T& r_n, const T& zeta) {
    const T psi_j = phi_j / r_n, psi_l = phi_l / r_n;
    return {psi_j * psi_l, psi_j * psi_j, phi_j * phi_j, 2 * zeta};
}

/// @brief A mode's term of (64), times r^2.
/// @eq{64}  @derivation{forms/batch_forms}
template <class T>
[[nodiscard, gnu::always_inline]] inline T term_of_H(const ArrayWeights<T>& m, const T& R, const T& u, const T& g) {
    return m.square * (g + m.two_zeta * R * u);
}

/// @brief If positive, (57) is largest at the start: \f$ R\,[\,u\,(4\zeta^2-1+R^2) - \frac{2\zeta}{R}(1-g)\,] \f$.
///
/// With N the velocity in (57), (57) is N / sin, and its derivative has the sign of W = N' sin - N cos, which is zero at both
/// ends and of which the derivative is Z sin, Z = N'' + N. Z is a damped sine with zeros \f$ \pi R/w \f$ apart. The expression is
/// \f$ R\,Z(\pi) \f$, and \f$ R\,Z(0) \f$ is its opposite less \f$ 4\zeta \f$. Where it is positive and 2 R > w, Z therefore goes
/// from negative to positive once in the half-period: W is nowhere positive, and (57) is largest for tau -> 0.
/// (`derivation/paper/section_2_6_largest_at_start.cpp` shows that 2 R >= w suffices; this condition is stricter than it need be.)
/// @eq{57,71}  @derivation{forms/batch_forms}  @domain{R > 0, 0 <= zeta < 1}
template <class T>
[[nodiscard, gnu::always_inline]] inline T excess_at_the_end(const T& two_zeta, const T& R, const T& u, const T& g) {
    return R * u * (two_zeta * two_zeta - (1 - R) * (1 + R)) - two_zeta * (1 - g);
}

/// @brief Margin with which (57) is largest for \f$ \tau\to0 \f$: `excess_at_the_end` less a billionth of its terms, or
/// the excess of R over w / 2 if that is less.
/// @eq{57,71}  @domain{R > 0, 0 <= zeta < 1}
/// @return positive if it is certain
[[nodiscard, gnu::always_inline]] inline double certainty_of_start(double R, double zeta, double u, double g) {
    const double terms = (u < 0 ? -u : u) * (1 + R) * (1 + R) * R + 2 * zeta * (1 + (g < 0 ? -g : g));
    const double excess = excess_at_the_end(2 * zeta, R, u, g) - 1e-9 * terms;
    const double room = 4 * R * R - (1 - zeta) * (1 + zeta) * (1 + 1e-9);
    return excess < room ? excess : room;
}

} // namespace denhartog::evaluation

/// @file
/// @brief Limits of the functions of one mode, (23), (28), (29), at the ends of their domain, each along a path.
///
/// A path has one small quantity x, which falls to zero. Along it each function is \f$ c\,x^n \f$ to leading order. Next to the
/// resonance n and c depend on the path: there the limits \f$ R \to 1 \f$ and \f$ \zeta \to 0 \f$ do not commute.
#pragma once

#include "denhartog/number/number.hpp"

namespace denhartog::limits {

/// @brief \f$ c\,x^n \f$.
template <class T>
struct Term {
    T coefficient; ///< c
    int power;     ///< n
};

/// @brief The leading terms of the functions of a mode along a path.
template <class T>
struct ModeTerms {
    Term<T> squared_v; ///< of the squared modulus of (23)
    Term<T> u;         ///< of (28)
    Term<T> g;         ///< of (29)
};

/// @brief \f$ \zeta = x \to 0 \f$ at a fixed R that is not 1/n, n odd.
/// \f[ |v|^2 \to \frac{1}{(1-R^2)^2}, \qquad u \to \frac{\sin\theta}{R\,(1+\cos\theta)}, \qquad
///     g \sim \frac{\theta-\sin\theta}{1+\cos\theta}\,x, \qquad \theta=\frac{\pi}{R} \f]
/// @eq{23,28,29}  @derivation{forms/mode_limits}  @domain{R > 0, R not 1/n, n odd}
/// @param R  modal frequency ratio, Eq. (22)
/// @return   leading terms
template <class T>
[[nodiscard]] ModeTerms<T> without_damping(const T& R) {
    const T theta = pi<T>() / R;
    const T a = (1 - R) * (1 + R);
    const T denominator = 1 + cos(theta);
    return {{1 / (a * a), 0}, {sin(theta) / (R * denominator), 0}, {(theta - sin(theta)) / denominator, 1}};
}

/// @brief \f$ R \to 1 \f$ at a fixed damping ratio: the values at R = 1.
/// @eq{23,28,29}  @derivation{forms/mode_limits}  @domain{0 < zeta < 1}
/// @param zeta  modal damping ratio
/// @return      leading terms
template <class T>
[[nodiscard]] ModeTerms<T> at_resonance(const T& zeta) {
    const T w = sqrt(T((1 - zeta) * (1 + zeta)));
    const T denominator = cosh(T(pi<T>() * zeta)) + cos(T(pi<T>() * w));
    return {{1 / (4 * zeta * zeta), 0},
            {sin(T(pi<T>() * w)) / (w * denominator), 0},
            {(sinh(T(pi<T>() * zeta)) - zeta / w * sin(T(pi<T>() * w))) / denominator, 0}};
}

/// @brief \f$ \zeta = x \to 0 \f$ at R = 1/n.
/// \f[ n \text{ odd:}\quad u \to \frac{1}{\pi}, \quad g \sim \frac{2}{n\pi x}; \qquad
///     n \text{ even:}\quad u \sim -\frac{n^2\pi}{4}\,x^2, \quad g \sim \frac{n\pi}{2}\,x \f]
/// @eq{23,28,29}  @derivation{forms/mode_limits}
/// @param n  a positive integer
/// @return   leading terms
template <class T>
[[nodiscard]] ModeTerms<T> at_harmonic(int n) {
    const T a = 1 - T(1) / (n * n);
    const Term<T> squared_v = n == 1 ? Term<T>{T(1) / 4, -2} : Term<T>{1 / (a * a), 0};
    if (n % 2 == 0) return {squared_v, {-n * n * pi<T>() / 4, 2}, {n * pi<T>() / 2, 1}};
    return {squared_v, {1 / pi<T>(), 0}, {2 / (n * pi<T>()), -1}};
}

/// @brief \f$ \zeta = c\,x \to 0 \f$ and \f$ R = (1+sx)/n \to 1/n \f$ in proportion.
/// \f[ n \text{ odd:}\quad u \sim \frac{2s}{\pi(1+c^2)\,x}, \quad g \sim \frac{2c}{n\pi(1+c^2)\,x}; \qquad
///     n \text{ even:}\quad u \sim -\frac{sn^2\pi}{2}\,x, \quad g \sim \frac{cn\pi}{2}\,x \f]
/// @eq{23,28,29}  @derivation{forms/mode_limits}
/// @param n     an integer, at least 2
/// @param side  s, 1 or -1
/// @param c     slope of the path
/// @return      leading terms
template <class T>
[[nodiscard]] ModeTerms<T> to_harmonic(int n, int side, const T& c) {
    const T a = 1 - T(1) / (n * n);
    const Term<T> squared_v{1 / (a * a), 0};
    if (n % 2 == 0) return {squared_v, {-side * n * n * pi<T>() / 2, 1}, {c * n * pi<T>() / 2, 1}};
    const T both = pi<T>() * (1 + c * c);
    return {squared_v, {2 * side / both, -1}, {2 * c / (n * both), -1}};
}

/// @brief \f$ \zeta = c\,|R-1|^{b/a} \f$, with \f$ R = 1 + s\,x^a \f$ and \f$ \zeta = c\,x^b \f$.
///
/// All follow from \f$ |v|^2 \sim \frac{1}{4D}, u \sim \frac{2sx^a+c^2x^{2b}}{\pi D}, g \sim \frac{2cx^b}{\pi D} \f$ with
/// \f$ D = x^{2a}+c^2x^{2b} \f$: |v| and g turn from one limit to the other where \f$ \zeta = |R-1| \f$, u once more where
/// \f$ \zeta^2 = 2|R-1| \f$.
/// @eq{23,28,29}  @derivation{forms/mode_limits}
/// @param a     power of the distance from resonance, at least 1
/// @param b     power of the damping ratio, at least 1
/// @param side  s, 1 or -1
/// @param c     factor of the path; where 2b = a, s = -1, not the root of 2
/// @return      leading terms
template <class T>
[[nodiscard]] ModeTerms<T> to_resonance(int a, int b, int side, const T& c) {
    const T square = b < a ? T(c * c) : b == a ? T(1 + c * c) : T(1);
    const int power = -2 * (b < a ? b : a);
    const T both = pi<T>() * square;
    Term<T> u{2 * side / both, a + power};
    if (2 * b < a) u = {c * c / both, 2 * b + power};
    if (2 * b == a) u = {(2 * side + c * c) / both, a + power};
    return {{1 / (4 * square), power}, u, {2 * c / both, b + power}};
}

/// @brief \f$ R = 1/x \to \infty \f$ at a fixed damping ratio.
/// \f[ |v|^2 \sim x^4, \qquad u \sim \frac{\pi}{2}\,x^2, \qquad g \sim \frac{\pi^3\zeta}{12}\,x^3 \f]
/// @eq{23,28,29}  @derivation{forms/mode_limits}  @domain{0 < zeta < 1}
/// @param zeta  modal damping ratio
/// @return      leading terms
template <class T>
[[nodiscard]] ModeTerms<T> at_high_frequency(const T& zeta) {
    return {{T(1), 4}, {pi<T>() / 2, 2}, {pi<T>() * pi<T>() * pi<T>() * zeta / 12, 3}};
}

/// @brief \f$ \zeta \to 1 \f$ at a fixed R.
/// \f[ |v|^2 \to \frac{1}{(1+R^2)^2}, \qquad u \to \frac{q}{R\,(\cosh q+1)}, \qquad g \to \frac{\sinh q-q}{\cosh q+1}, \qquad
///     q=\frac{\pi}{R} \f]
/// @eq{23,28,29}  @derivation{forms/mode_limits}  @domain{R > 0}
/// @param R  modal frequency ratio, Eq. (22)
/// @return   leading terms
template <class T>
[[nodiscard]] ModeTerms<T> at_critical_damping(const T& R) {
    const T q = pi<T>() / R;
    const T denominator = cosh(q) + 1;
    const T square = 1 + R * R;
    return {{1 / (square * square), 0}, {q / (R * denominator), 0}, {(sinh(q) - q) / denominator, 0}};
}

/// @brief \f$ \zeta = cR \to 0 \f$ through \f$ R = x = 1/n \f$: one limit for even n and another for odd n.
///
/// Hence u and g have none along this path.
/// \f[ n \text{ even:}\quad u \to -\frac{\pi c^2}{2(\cosh\pi c+1)}, \quad g \to \tanh\frac{\pi c}{2}; \qquad
///     n \text{ odd:}\quad u \to \frac{\pi c^2}{2(\cosh\pi c-1)}, \quad g \to \coth\frac{\pi c}{2} \f]
/// @eq{23,28,29}  @derivation{forms/mode_limits}  @domain{n -> infinity, all even or all odd; c > 0}
/// @param odd  whether n is odd
/// @param c    zeta over R
/// @return     leading terms
template <class T>
[[nodiscard]] ModeTerms<T> at_low_frequency_in_proportion(bool odd, const T& c) {
    const T pi_c = pi<T>() * c;
    const int sign = odd ? -1 : 1;
    const T denominator = cosh(pi_c) + sign;
    return {{T(1), 0}, {-sign * pi_c * c / (2 * denominator), 0}, {sinh(pi_c) / denominator, 0}};
}

/// @brief Leading term of (28) for \f$ R \to 0 \f$ at a fixed damping ratio: faster than every power of R.
/// \f[ u \sim \frac{2e^{-\delta}\sin\theta}{R\,w}, \qquad \theta = \pi w/R,\quad \delta = \pi\zeta/R \f]
/// @eq{28}  @derivation{forms/mode_limits}  @domain{R -> 0, 0 < zeta < 1}
/// @param R     modal frequency ratio, Eq. (22)
/// @param zeta  modal damping ratio
/// @return      what u is to leading order
template <class T>
[[nodiscard]] T first_function_at_low_frequency(const T& R, const T& zeta) {
    const T w = sqrt(T((1 - zeta) * (1 + zeta)));
    return 2 * exp(T(-(pi<T>() * zeta / R))) * sin(T(pi<T>() * w / R)) / (R * w);
}

/// @brief Leading term of (29) less 1 for \f$ R \to 0 \f$ at a fixed damping ratio: faster than every power of R.
/// \f[ g - 1 \sim -2e^{-\delta}\left(\cos\theta+\frac{\zeta}{w}\sin\theta\right), \qquad \theta = \pi w/R,\quad
///     \delta = \pi\zeta/R \f]
/// @eq{29}  @derivation{forms/mode_limits}  @domain{R -> 0, 0 < zeta < 1}
/// @param R     modal frequency ratio, Eq. (22)
/// @param zeta  modal damping ratio
/// @return      what g - 1 is to leading order
template <class T>
[[nodiscard]] T second_function_less_one_at_low_frequency(const T& R, const T& zeta) {
    const T w = sqrt(T((1 - zeta) * (1 + zeta)));
    const T theta = pi<T>() * w / R;
    return -2 * exp(T(-(pi<T>() * zeta / R))) * (cos(theta) + zeta / w * sin(theta));
}

} // namespace denhartog::limits

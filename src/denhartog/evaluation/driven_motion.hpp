/// @file
/// @brief The motion of a coordinate from its start under a constant and a harmonic force: (A.6), (A.7) regrouped.
///
/// The paper's terms are gathered by what changes with time: the rest under the constant force, the harmonic motion, and the
/// free motion of what the start has more than these. Next to resonance the harmonic and the free part are large and cancel;
/// there their sum, the response from rest, is formed as one. Every form is branch-free and proved.
///
/// R is the modal frequency ratio (22), `gap` is 1 - 1/R^2 as near to resonance as it is known, and a is the decay rate zeta/R.
/// The harmonic motion is Re{X exp(i tau)}, and `at_rest` is the displacement at rest under the constant force. The free motions
/// (A.8) are those over the time t from the start; `cosine` and `sine` are those of tau at the instant, cos_0 and sin_0 at the
/// start.
#pragma once

#include "denhartog/evaluation/mode.hpp"
#include "denhartog/formulas/modal_coordinate.hpp"

namespace denhartog::evaluation {

/// @brief Product of two complex numbers. @param a a factor @param b a factor @return a b
template <class T>
[[nodiscard]] Complex<T> product(const Complex<T>& a, const Complex<T>& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

/// @brief Quotient of two complex numbers. @param a the dividend @param b the divisor @return a / b
template <class T>
[[nodiscard]] Complex<T> quotient(const Complex<T>& a, const Complex<T>& b) {
    const T size = squared_modulus(b);
    return {(a.re * b.re + a.im * b.im) / size, (a.im * b.re - a.re * b.im) / size};
}

/// @brief \f$ (e^z-1)/z \f$ of a complex number, which is 1 at 0; `derivation/selections/stand_ins.hpp` has its stand-in.
template <class T>
[[nodiscard]] Complex<T> exp_minus_one_over(const Complex<T>& z) {
    const T nothing = std::numeric_limits<T>::epsilon() / 4;
    if (squared_modulus(z) < nothing * nothing) return {T(1), T(0)};
    const T e = exp_minus_one(z.re), s = sin(T(z.im / 2));
    const SineCosine<T> at = sine_cosine(z.im);
    return quotient(Complex<T>{e * at.c - 2 * s * s, (e + 1) * at.s}, z);
}

/// @brief \f$ R^2v_d \f$ from the gap \f$ 1-1/R^2 \f$ and the decay \f$ a = \zeta/R \f$.
/// \f[ R^2v_d = -\frac{(1-R^{-2}) + 2ia}{(1-R^{-2})^2+4a^2} \f]
/// @eq{23}  @derivation{forms/driven_motion}  @domain{R > 0, zeta >= 0; at zeta = 0 a pole at R = 1}
template <class T>
[[nodiscard]] Complex<T> response_by_R_squared(const T& gap, const T& a) {
    const T size = gap * gap + 4 * a * a;
    return {-gap / size, -(2 * a) / size};
}

/// @brief The free part of the start: the start less the place of rest under the constant force and less the harmonic motion.
/// @eq{A.5,A.6}  @derivation{forms/driven_motion}
template <class T>
[[nodiscard]] InitialValues<T> free_start(const InitialValues<T>& start, const T& at_rest, const Complex<T>& X, const T& cos_0,
                                          const T& sin_0) {
    return {start.eta_0 - at_rest - X.re * cos_0 + X.im * sin_0, start.eta_prime_0 + X.re * sin_0 + X.im * cos_0};
}

/// @brief Displacement and velocity under a constant and a harmonic force.
/// @eq{A.6,A.7,A.8,A.9}  @derivation{forms/driven_motion}  @domain{R > 0, zeta >= 0}
template <class T>
[[nodiscard]] InitialValues<T> driven_motion(const FreeMotion<T>& free, const T& R, const InitialValues<T>& start,
                                             const T& at_rest, const Complex<T>& X, const T& cosine, const T& sine) {
    return {at_rest + X.re * cosine - X.im * sine + start.eta_0 * free.d + start.eta_prime_0 * (R * free.q),
            start.eta_0 * free.d_prime + start.eta_prime_0 * (R * free.q_prime) - X.re * sine - X.im * cosine};
}

/// @brief By how much the damped frequency differs from that of the force.
/// \f[ 1-\frac{w}{R} = \frac{(1-R^{-2}) + \zeta^2R^{-2}}{1+w/R} \f]
/// @eq{A.8}  @derivation{forms/driven_motion}  @domain{R > 0, 0 <= zeta < 1; keeps its digits next to R = 1, zeta = 0}
template <class T>
[[nodiscard]] T detuning(const T& R, const T& zeta, const T& gap) {
    const T w = oscillating_w(zeta);
    const T a = zeta / R;
    return (gap + a * a) / (1 + w / R);
}

/// @brief The response to \f$ \cos\tau \f$ from rest, next to resonance.
///
/// With \f$ \lambda = -a+ib \f$ and the start at \f$ \tau_0 \f$
/// \f[ \frac{1}{b}\,\mathrm{Im}\left\{\frac{e^{i\tau_0}}{2}(E_1-E_2)\right\}, \qquad
///     E_1 = e^{\lambda t}\,\frac{e^{(i-\lambda)t}-1}{i-\lambda}, \quad E_2 = \frac{e^{it}-e^{\bar\lambda t}}{i-\bar\lambda} \f]
/// where \f$ i-\lambda = a+i(1-b) \f$ comes from `detuning`: as b goes to 1 and a to 0 the error stays some units in
/// the last place of 1 + t.
/// @eq{A.6,A.7}  @derivation{forms/driven_motion}  @domain{a >= 0, b > 0; keeps its digits next to a = 0, b = 1}
/// @param t        time from the start
/// @param a        decay rate zeta / R
/// @param b        damped frequency w / R
/// @param apart    1 - b, as `detuning` has it
/// @param decayed  exp(lambda t)
/// @param cos_0    cosine of tau at the start
/// @param sin_0    sine of tau at the start
/// @return         displacement and velocity
template <class T>
[[nodiscard]] InitialValues<T> response_from_rest(const T& t, const T& a, const T& b, const T& apart, const Complex<T>& decayed,
                                                  const T& cos_0, const T& sin_0) {
    const Complex<T> E_1 = t * product(decayed, exp_minus_one_over(Complex<T>{a * t, apart * t}));
    const SineCosine<T> at = sine_cosine(t);
    const Complex<T> E_2 = quotient(Complex<T>{at.c - decayed.re, at.s + decayed.im}, Complex<T>{a, 1 + b});
    const Complex<T> h{E_1.re - E_2.re, E_1.im - E_2.im};
    const Complex<T> h_prime{-a * h.re - b * (E_1.im + E_2.im), -a * h.im + b * (E_1.re + E_2.re)};
    return {(cos_0 * h.im + sin_0 * h.re) / (2 * b), (cos_0 * h_prime.im + sin_0 * h_prime.re) / (2 * b)};
}

/// @brief A driven coordinate, but for its start.
template <class T>
struct DrivenCoordinate {
    T omega;       ///< natural frequency 1 / R, in units of that of the force
    T decay;       ///< decay rate zeta / R
    T R;           ///< modal frequency ratio, Eq. (22)
    T zeta;        ///< modal damping ratio
    T w;           ///< as `w_if_oscillating` has it
    T F;           ///< amplitude of the harmonic force
    bool together; ///< whether the harmonic and the free part are taken together
    T apart;       ///< 1 - w / R where they are
    Complex<T> X;  ///< complex amplitude of the harmonic motion where they are not, else zero
};

/// @brief A coordinate under a harmonic force: next to resonance, where \f$ R^2|v_d| > 8 \f$, harmonic and free part together.
/// @eq{A.5,A.6}  @derivation{selections/solver_selections}  @domain{R > 0, zeta >= 0}
/// @param omega  natural frequency 1 / R
/// @param gap    1 - 1/R^2, as near to resonance as it is known
/// @param decay  decay rate zeta / R
/// @param F      amplitude of the harmonic force
/// @return       the coordinate
template <class T>
[[nodiscard]] DrivenCoordinate<T> driven_coordinate(const T& omega, const T& gap, const T& decay, const T& F) {
    const T R = 1 / omega, zeta = decay / omega, w = w_if_oscillating(zeta);
    if (64 * (gap * gap + 4 * decay * decay) < 1)
        return {omega, decay, R, zeta, w, F, true, detuning(R, zeta, gap), Complex<T>{T(0), T(0)}};
    return {omega, decay, R, zeta, w, F, false, T(0), F * response_by_R_squared(gap, decay)};
}

/// @brief The start of a stretch of motion.
template <class T>
struct DrivenStart {
    InitialValues<T> free; ///< start of the free motion, by `free_start`
    T at_rest;             ///< displacement at rest under the constant force
    T cos_0;               ///< cosine of tau at the start
    T sin_0;               ///< sine of tau at the start
};

/// @brief Displacement and velocity of a driven coordinate, in the form that it is prepared for.
/// @eq{A.6,A.7}  @derivation{selections/solver_selections}  @domain{t >= 0, R > 0, zeta >= 0}
template <class T>
[[nodiscard]] InitialValues<T> motion_of_coordinate(const FreeMotion<T>& free, const T& t, const DrivenCoordinate<T>& c,
                                                    const DrivenStart<T>& start, const T& cosine, const T& sine) {
    const InitialValues<T> now = driven_motion(free, c.R, start.free, start.at_rest, c.X, cosine, sine);
    if (!c.together) return now;
    const Complex<T> decayed{free.d - c.zeta * free.q, c.w * free.q};
    const InitialValues<T> h = response_from_rest(t, c.decay, T(c.w * c.omega), c.apart, decayed, start.cos_0, start.sin_0);
    return {now.eta_0 + c.F * h.eta_0, now.eta_prime_0 + c.F * h.eta_prime_0};
}

/// @brief The derivative of a coordinate two orders up, by its equation of motion: \f$ f - D - \eta/R^2 \f$.
/// @eq{20,A.1}  @derivation{forms/driven_motion}
/// @param eta      a derivative of the coordinate
/// @param omega    natural frequency 1 / R
/// @param damping  damping force D at the next derivative
/// @param force    the derivative f of the force, of the order of eta
/// @return         the derivative two orders up
template <class T>
[[nodiscard]] T acceleration(const T& eta, const T& omega, const T& damping, const T& force) {
    return force - damping - omega * omega * eta;
}

} // namespace denhartog::evaluation

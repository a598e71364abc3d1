/// @file
/// @brief Forms of the expression under the maximum in (57) that keep their digits.
///
/// The expression of (57) is a quotient whose numerator and denominator both vanish at the ends of the half-period. In the first
/// half of it, \f$ R_iq_i' - \cos\tau \f$ in the numerator is written as a sum of three terms that are small near the start. In
/// the second half time runs backwards from the end, and friction and damping change their signs: with
/// \f$ \sigma = \pi - \tau \f$ the expression is minus its value at \f$ \sigma \f$ for \f$ -\zeta_i \f$ and \f$ -g_i \f$.
/// If the mode decays much over the half-period, \f$ 1 - g_i \f$ and \f$ u_{di} \f$ are as small as the decay, which is then
/// factored out. Around the middle the terms cancel to half of their size or less, and their own rounding errors add up to five
/// units in the last place.
/// From \f$ \zeta_i = 1 \f$ on there is no form from the end: both exponentials decay, and backwards in time the faster one has
/// to cancel, so that next to \f$ \pi \f$ digits are lost. The number type carries its bound of the error, and if that does
/// not suffice the reference answers.
///
/// tau is the non-dimensional time (5), R the modal frequency ratio (22), zeta the modal damping ratio, h the half angle and the
/// exponent; u and g are (28) and (29), u_R2 is u times R^2, and sigma is pi - tau.
#pragma once

#include "denhartog/evaluation/friction_motion.hpp"

namespace denhartog::evaluation {

/// @brief \f$ u_{di}R_i^2 \f$ where neither R^2 nor u may be formed.
/// \f[ u_{di}R_i^2 = \frac{\pi}{2}\,\frac{\sin y}{y}\,\frac{c}{\sinh^2\frac{\delta}{2}+c^2}, \qquad y = \frac{\pi w}{2R_i} \f]
/// @eq{28}  @derivation{forms/evaluation_of_motion}  @domain{R > 0, 0 <= zeta < 1; keeps its digits for R of 5/4 and more}
template <class T>
[[nodiscard]] T first_damping_function_by_R_squared(const T& R, const T& zeta, const HalfAngle<T>& h) {
    const T sinh_half = sinh(T(h.delta / 2));
    const T w = oscillating_w(zeta);
    return pi<T>() / 2 * sinc(T(pi<T>() * w / (2 * R))) * (h.c / (sinh_half * sinh_half + h.c * h.c));
}

/// @brief Parts of the expression in (57) at an instant, without the cancellations at \f$ \tau \to 0 \f$.
template <class T>
struct HarmonicDifference {
    T value; ///< R q' - cos(tau)
    T Rq;    ///< R q
};

/// @brief \f$ \cos b - \cos\tau \f$ with \f$ b = w\tau/R_i \f$, where \f$ b - \tau = \tau\,[(1-R_i)-(1-w)]/R_i \f$.
/// @eq{57}  @derivation{forms/evaluation_of_motion}  @domain{tau >= 0, R > 0, |zeta| < 1}
/// @return the difference, as a product of two sines
template <class T>
[[nodiscard]] T difference_of_cosines(const T& tau, const T& R, const T& zeta) {
    const T w = oscillating_w(zeta);
    const T half_sum = (w / R + 1) * tau / 2, half_difference = ((1 - R) - one_minus_w(zeta)) / R * tau / 2;
    return -2 * sin(half_sum) * sin(half_difference);
}

/// @brief \f$ R_iq_i'(\tau) - \cos\tau \f$ and \f$ R_iq_i(\tau) \f$, \f$ b = w\tau/R_i \f$, \f$ a = \zeta_i\tau/R_i \f$.
/// \f[ (e^{-a}-1)\cos b + [\cos b - \cos\tau] - e^{-a}\zeta_i\frac{\sin b}{w}, \qquad e^{-a}\tau\,\frac{\sin b}{b} \f]
/// Minus zeta gives the motion backwards in time.
/// @eq{57}  @derivation{forms/evaluation_of_motion}  @domain{tau > 0, R > 0, |zeta| < 1}
template <class T>
[[nodiscard]] HarmonicDifference<T> harmonic_difference(const T& tau, const T& R, const T& zeta) {
    const T w = oscillating_w(zeta);
    const T x = tau / R;
    const T b = w * x;
    const T Rq = exp(T(-zeta * x)) * sinc(b) * tau;
    return {exp_minus_one(T(-zeta * x)) * cos(b) + difference_of_cosines(tau, R, zeta) - zeta * (Rq / R), Rq};
}

/// @brief The expression in (57) for the first quarter of the period, from differences that vanish at its start.
/// @eq{57}  @derivation{forms/evaluation_of_motion}  @domain{0 < tau < pi, R > 0, 0 <= zeta < 1; keeps its digits for tau up to pi/2}
template <class T>
[[nodiscard]] T s_d_integrand_from_start(const T& tau, const T& R, const T& zeta, const T& u_R2, const T& g) {
    const HarmonicDifference<T> f = harmonic_difference(tau, R, zeta);
    return ((1 + g) * f.Rq - u_R2 * f.value) / sin(tau);
}

/// @brief The expression in (57) for the second quarter of the period, backwards in time from \f$ \tau = \pi \f$.
/// @eq{57}  @derivation{forms/evaluation_of_motion}
/// @domain{0 < sigma < pi, R > 0, 0 <= zeta < 1; keeps its digits for sigma up to pi/2, delta up to 1}
template <class T>
[[nodiscard]] T s_d_integrand_from_end(const T& sigma, const T& R, const T& zeta, const T& u_R2, const T& g) {
    return -s_d_integrand_from_start(sigma, R, T(-zeta), u_R2, T(-g));
}

/// @brief \f$ (1-g_i)/E \f$ and \f$ u_{di}R_i^2/E \f$ with \f$ E = e^{-\delta} \f$, the decay over the half-period.
template <class T>
struct DecayTakenOut {
    T one_minus_g; ///< (1 - g) / E
    T u_R2;        ///< u R^2 / E
};

/// @brief The factors of \f$ 1-g_i \f$ and \f$ u_{di}R_i^2 \f$ beside the decay over the half-period.
/// \f[ \frac{1-g}{E} = \frac{2\,[2c^2-(1-E)+2\frac{\zeta}{w}sc]}{(1-E)^2+4Ec^2}, \qquad
///     \frac{uR^2}{E} = \frac{4Rsc}{w\,[(1-E)^2+4Ec^2]} \f]
/// @eq{28,29}  @derivation{forms/evaluation_of_motion}  @domain{R > 0, 0 <= zeta < 1; keeps its digits for delta of 1 and more}
template <class T>
[[nodiscard]] DecayTakenOut<T> decay_taken_out(const T& R, const T& zeta, const HalfAngle<T>& h) {
    const T E_minus_one = exp_minus_one(T(-h.delta));
    const T E = 1 + E_minus_one;
    const T denominator = E_minus_one * E_minus_one + 4 * E * h.c * h.c;
    return {2 * (2 * h.c * h.c + E_minus_one + 2 * (zeta / h.w) * h.s * h.c) / denominator,
            4 * R * h.s * h.c / (h.w * denominator)};
}

/// @brief The expression in (57) from the end of the half-period, for a decay that leaves few digits of \f$ 1-g_i \f$.
///
/// With \f$ b = w\sigma/R_i \f$, \f$ a = \zeta_i\sigma/R_i \f$ and the quotients of `decay_taken_out`
/// \f[ -\frac{e^{-\zeta_i(\pi-\sigma)/R_i}}{\sin\sigma}\left\{\frac{1-g}{E}R_i\frac{\sin b}{w}
///     - \frac{uR^2}{E}\left[\cos b + \zeta_i\frac{\sin b}{w} - e^{-a}\cos\sigma\right]\right\} \f]
/// @eq{57}  @derivation{forms/evaluation_of_motion}
/// @domain{0 < sigma < pi, R > 0, 0 <= zeta < 1; keeps its digits for sigma up to pi/2, delta of 1 and more}
template <class T>
[[nodiscard]] T s_d_integrand_after_decay(const T& sigma, const T& R, const T& zeta, const DecayTakenOut<T>& f) {
    const T w = oscillating_w(zeta);
    const T x = sigma / R;
    const T RS = sinc(T(w * x)) * sigma;
    const T difference = zeta * (RS / R) + difference_of_cosines(sigma, R, zeta) - exp_minus_one(T(-zeta * x)) * cos(sigma);
    const T root = exp(T(-zeta * ((pi<T>() - sigma) / R) / 2));
    return -(root * ((f.one_minus_g * RS - f.u_R2 * difference) / sin(sigma)) * root);
}

/// @brief The expression in (57) at the end of the half-period, \f$ -(1-g_i-2\zeta_iR_iu_{di}) \f$.
/// @eq{57,71}  @derivation{forms/evaluation_of_motion}  @domain{R > 0, 0 <= zeta < 1}
template <class T>
[[nodiscard]] T s_d_at_pi(const T& R, const T& zeta, const T& u, const T& g) {
    return -paper::s_d_at_zero(R, T(-zeta), u, T(-g));
}

/// @brief The expression in (57) at the end of the half-period, the decay over the half-period taken out.
/// @eq{57,71}  @derivation{forms/evaluation_of_motion}  @domain{R > 0, 0 <= zeta < 1; keeps its digits for delta of 1 and more}
template <class T>
[[nodiscard]] T s_d_at_pi_after_decay(const T& R, const T& zeta, const DecayTakenOut<T>& f) {
    return -exp(T(-pi<T>() * zeta / R)) * (f.one_minus_g - 2 * zeta * (f.u_R2 / R));
}

/// @brief The expression in (57) of a mode below \f$ \zeta = 1 \f$, its limits at both ends included: the form that keeps its
/// digits at this place.
/// @eq{57,71}  @derivation{forms/evaluation_of_motion}  @domain{0 <= tau <= pi, R > 0, 0 <= zeta < 1}
/// @return the expression; not finite at the poles at zeta = 0, R = 1/n, n odd
template <class T>
[[nodiscard]] T oscillating_s_d_integrand(const T& tau, const T& R, const T& zeta, const DampingFunctions<T>& f) {
    const bool heavy = 2 * zeta >= 1, large = 4 * R >= 5, late = 2 * tau > pi<T>();
    const T sigma = pi<T>() - tau, delta = pi<T>() * zeta / R;
    if (!(tau > 0)) return paper::s_d_at_zero(R, zeta, f.u, f.g);
    if (late && delta >= 1 && !large) {
        const DecayTakenOut<T> out = decay_taken_out(R, zeta, heavy ? half_angle_of_heavy_damping(R, zeta) : half_angle(R, zeta));
        return sigma > 0 ? s_d_integrand_after_decay(sigma, R, zeta, out) : s_d_at_pi_after_decay(R, zeta, out);
    }
    if (!(sigma > 0)) return s_d_at_pi(R, zeta, f.u, f.g);
    const T u_R2 =
        large ? first_damping_function_by_R_squared(R, zeta, heavy ? half_angle_of_heavy_damping(R, zeta) : half_angle(R, zeta))
              : T(f.u * R * R);
    return late ? s_d_integrand_from_end(sigma, R, zeta, u_R2, f.g) : s_d_integrand_from_start(tau, R, zeta, u_R2, f.g);
}

/// @brief The expression in (57) by the rate of the braces of (40): for any damping ratio, away from both ends.
/// \f[ \frac{R_i^2}{\sin\tau}\left\{\frac{d}{d\tau}\left[1-(1+g_i)d_i-u_{di}R_iq_i\right] + u_{di}\cos\tau\right\} \f]
/// @eq{57}  @derivation{forms/overdamped_modes}  @domain{0 < tau < pi, R > 0, zeta >= 0}
template <class T>
[[nodiscard]] T s_d_integrand_from_rate(const T& tau, const T& R, const T& u, const T& prime) {
    return R * R * (prime + u * cos(tau)) / sin(tau);
}

/// @brief The expression in (57) from the start of the half-period, from \f$ \zeta = 1 \f$ on: with \f$ x = \tau/R_i \f$ and
/// C, S of `overdamped.hpp`
/// \f[ \frac{R_i}{\sin\tau}\left\{(1+g_i)e^{-\zeta_ix}S - u_{di}R_i\left[(e^{-\zeta_ix}-1)C + (C-1) + 2\sin^2\frac{\tau}{2}
///     - \zeta_ie^{-\zeta_ix}S\right]\right\} \f]
/// The terms in brackets vanish at \f$ \tau \to 0 \f$ one by one.
/// @eq{57}  @derivation{forms/overdamped_modes}  @domain{0 < tau < pi, R > 0, zeta >= 1; keeps its digits for zeta tau / R up to 1}
template <class T>
[[nodiscard]] T overdamped_s_d_integrand_from_start(const T& tau, const T& R, const T& zeta, const T& u, const T& g) {
    const T x = tau / R;
    const T decayed = exp_minus_one(T(-zeta * x)), risen = overdamped_cosine_less_one(zeta, x);
    const T S = (1 + decayed) * x * overdamped_sinc(zeta, x);
    const T sine_half = sin(T(tau / 2));
    const T difference = decayed * (1 + risen) + risen + 2 * sine_half * sine_half - zeta * S;
    return R * ((1 + g) * S - u * R * difference) / sin(tau);
}

/// @brief The expression in (57) of a mode from \f$ \zeta = 1 \f$ on, its limits at both ends included.
/// @eq{57,71}  @derivation{forms/overdamped_modes}  @domain{0 <= tau <= pi, R > 0, zeta >= 1}
template <class T>
[[nodiscard]] T overdamped_s_d_integrand(const T& tau, const T& R, const T& zeta, const DampingFunctions<T>& f) {
    if (!(tau > 0)) return paper::s_d_at_zero(R, zeta, f.u, f.g);
    if (2 * tau < pi<T>() && zeta * tau < R) return overdamped_s_d_integrand_from_start(tau, R, zeta, f.u, f.g);
    if (tau < pi<T>())
        return s_d_integrand_from_rate(tau, R, f.u, friction_motion(tau, R, zeta, w_if_oscillating(zeta), f.u, f.g).prime);
    return -R * R * friction_motion(pi<T>(), R, zeta, w_if_oscillating(zeta), f.u, f.g).double_prime;
}

/// @brief The expression in (57) for any damping ratio, by (28) and (29) as found before: the form for callers.
/// @eq{57,71}  @derivation{forms/evaluation_of_motion}  @domain{0 <= tau <= pi, R > 0, zeta >= 0}
/// @return the expression; not finite at the poles at zeta = 0, R = 1/n, n odd
template <class T>
[[nodiscard]] T s_d_integrand_of(const T& tau, const T& R, const T& zeta, const DampingFunctions<T>& f) {
    return zeta >= 1 ? overdamped_s_d_integrand(tau, R, zeta, f) : oscillating_s_d_integrand(tau, R, zeta, f);
}

} // namespace denhartog::evaluation

#include "denhartog/sliding/steady_state.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/evaluation/contact.hpp"
#include "denhartog/formulas/motion.hpp"
#include "denhartog/formulas/other_masses.hpp"
#include "denhartog/model/point_rules.hpp"
#include "denhartog/number/bounded.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/multiprecision.hpp"
#include "denhartog/sliding/friction_motion.hpp"
#include "denhartog/sliding/maximum.hpp"

namespace denhartog {
namespace {

using std::floor;

// Displacement, velocity and acceleration of a mass.
template <class T>
struct Kinematics {
    T x, x_prime, x_double_prime;
};

// The harmonic part of (41): A cos tau + B sin tau.
template <class T>
struct Harmonic {
    T A, B;
};

template <class T>
Harmonic<T> harmonic_part(const ModeSums<T>& s, std::size_t k, const T& x0, const T& v0, const T& beta) {
    return {paper::V_k_cosine(x0, s.G[k], beta), T(-paper::V_k_sine(v0, s.U[k], beta))};
}

// Factors of the braces in (41), without beta.
template <class T>
std::vector<T> friction_weights(const ModeSums<T>& s, std::size_t k) {
    const auto psi_k = mode_shapes_at(s, Mass{k});
    const auto psi_j = mode_shapes_at(s, s.contact);
    std::vector<T> weights;
    weights.reserve(s.R.size());
    for (std::size_t i = 0; i < s.R.size(); ++i) weights.push_back(psi_k[i] * psi_j[i] * s.R[i] * s.R[i]);
    return weights;
}

template <class T>
Kinematics<T> kinematics(const ModeSums<T>& s, std::size_t k, const MassResponse<T>& m, const T& beta,
                         const std::vector<T>& weights, const std::vector<evaluation::FrictionMotion<T>>& y, const T& tau) {
    T F_k(0), F_prime(0), F_double_prime(0);
    for (std::size_t i = 0; i < y.size(); ++i) {
        F_k += weights[i] * y[i].value;
        F_prime += weights[i] * y[i].prime;
        F_double_prime += weights[i] * y[i].double_prime;
    }
    const Harmonic<T> h = harmonic_part(s, k, m.x0, m.v0, beta);
    const T C = cos(tau);
    const T S = sin(tau);
    return {paper::displacement(tau, m.x0, m.v0, s.G[k], s.U[k], beta, F_k), h.B * C - h.A * S + beta * F_prime,
            beta * F_double_prime - h.A * C - h.B * S};
}

template <class T>
void check_sliding(const RegimeBoundary<T>& boundary, const T& beta) {
    check_friction_ratio(beta);
    if (beta < boundary.exact) return;
    throw DomainError("the contact does not slide throughout: beta = " + number_to_text(beta) +
                      " is not below beta_lim = " + number_to_text(boundary.exact) + ", Eq. (69)");
}

// An instant that rounding may have put a little outside the half-period, in it.
template <class T>
T in_half_period(const T& tau) {
    return std::clamp(tau, T(0), pi<T>());
}
Bounded in_half_period(const Bounded& tau) {
    const double inside = std::clamp(tau.x, 0.0, pi<double>());
    return {inside, tau.e + std::abs(tau.x - inside)};
}

template <class T>
void set_maximum(MassResponse<T>& m, const T& phi_j, const T& instant, const T& displacement) {
    m.instant = instant;
    m.amplitude = displacement < 0 ? T(-displacement) : displacement;
    m.phase = wrapped(paper::phase_of_mass(phi_j, instant, displacement < 0 ? 1 : 0));
}

template <class T>
void find_maximum(const ModeSums<T>& s, FrictionMotions<T>& y, SteadyState<T>& state, std::size_t k) {
    MassResponse<T>& m = state.masses[k];
    const T& beta = state.beta;
    const std::vector<T> weights = friction_weights(s, k);
    const Harmonic<T> h = harmonic_part(s, k, m.x0, m.v0, beta);
    const T harmonic_size = modulus(Complex<T>{h.A, h.B});
    Curve<T> curve;
    curve.sample = [&](const T& tau) {
        const Kinematics<T> at = kinematics(s, k, m, beta, weights, y.at(tau).y, tau);
        return Sample<T>{at.x < 0 ? T(-at.x) : at.x, at.x_prime, at.x_double_prime};
    };
    curve.rate = [&](const T& a, const T&) {
        const FrictionMotionsAt<T>& now = y.at(a);
        T bound(0);
        for (std::size_t i = 0; i < weights.size(); ++i)
            bound += (weights[i] < 0 ? T(-weights[i]) : weights[i]) * now.size[i] / (s.R[i] * s.R[i] * s.R[i]);
        return T(harmonic_size + beta * bound);
    };
    curve.rise = [](const T& a, const T& b, const T& z_bound) { return T(z_bound * (b - a) * (b - a) / 8); };
    const T instant = global_maximum(curve, T(0), pi<T>()).instant;
    set_maximum(m, state.phi_j, instant, kinematics(s, k, m, beta, weights, y.at(instant).y, instant).x);
}

} // namespace

template <class T>
T wrapped(const T& angle) {
    const T turn = 2 * pi<T>();
    T a = angle;
    if (a > pi<T>() || a <= -pi<T>()) a = angle - turn * floor(T((angle + pi<T>()) / turn));
    if (a > pi<T>()) a -= turn;
    if (a <= -pi<T>()) a += turn;
    return a;
}

template <class T>
SteadyState<T> steady_state_without_maxima(const ModeSums<T>& s, const T& beta) {
    const std::size_t j = s.contact.index;
    SteadyState<T> state;
    state.beta = beta;
    state.X_j = evaluation::displacement_transmissibility_of_contact(s.V[j], s.U[j], s.G[j], beta);
    if (!(state.X_j >= 0)) throw DomainError("beta lies beyond the sliding regime: the amplitude (38) is not a positive number");
    state.phi_j = wrapped(evaluation::phase_of_contact(s.V[j], s.U[j], beta));
    for (std::size_t k = 0; k < s.V.size(); ++k) {
        MassResponse<T> m{};
        if (k == j) {
            m = {state.X_j, T(0), state.X_j, T(0), state.phi_j, state.X_j, state.phi_j, T(0)};
        } else {
            const evaluation::InitialState<T> at_0 = evaluation::initial_state(s.V[k], s.V[j], s.U[j], s.U[k], s.G[k], beta);
            m.x0 = at_0.x_k0;
            m.v0 = at_0.x_prime_k0;
            m.amplitude_monoharmonic = modulus(Complex<T>{m.x0, m.v0});
            m.phase_monoharmonic = wrapped(T(state.phi_j + paper::phase_behind_contact(m.x0, m.v0)));
        }
        state.masses.push_back(m);
    }
    return state;
}

template <class T>
SteadyState<T> steady_state(const ModeSums<T>& s, const RegimeBoundary<T>& boundary, const T& beta, std::optional<Mass> only) {
    check_sliding(boundary, beta);
    SteadyState<T> state = steady_state_without_maxima(s, beta);
    FrictionMotions<T> y(s, 0, s.R.size());
    for (std::size_t k = 0; k < state.masses.size(); ++k)
        if (k != s.contact.index && (!only || k == only->index)) find_maximum(s, y, state, k);
    return state;
}

template <class T>
SteadyState<T> steady_state_at(const ModeSums<T>& s, const T& beta, const std::vector<T>& instants, std::optional<Mass> only) {
    SteadyState<T> state = steady_state_without_maxima(s, beta);
    for (std::size_t k = 0; k < state.masses.size(); ++k) {
        if (k == s.contact.index || (only && k != only->index)) continue;
        MassResponse<T>& m = state.masses[k];
        const std::vector<T> weights = friction_weights(s, k);
        T instant = instants[k];
        const Kinematics<T> at = kinematics(s, k, m, beta, weights, friction_motions(s, instant), instant);
        T displacement = at.x;
        if (at.x_double_prime != 0 && instant > 0 && instant < pi<T>()) {
            displacement = at.x - at.x_prime * at.x_prime / (2 * at.x_double_prime);
            instant = instant - at.x_prime / at.x_double_prime;
        }
        set_maximum(m, state.phi_j, instant, displacement);
    }
    return state;
}

template <class T>
Motion<T> motion(const ModeSums<T>& s, const SteadyState<T>& state, const T& tau) {
    const T halves = floor(T(tau / pi<T>()));
    const T instant = in_half_period(T(tau - halves * pi<T>()));
    const bool mirrored = halves - 2 * floor(T(halves / 2)) != 0;
    const std::vector<evaluation::FrictionMotion<T>> y = friction_motions(s, instant);
    Motion<T> all;
    const T C = cos(instant), S = sin(instant);
    for (std::size_t k = 0; k < state.masses.size(); ++k) {
        const T A = times_cosine(s.V[k], state.phi_j), B = -times_sine(s.V[k], state.phi_j);
        const std::vector<T> weights = friction_weights(s, k);
        T F_k(0), F_prime(0);
        for (std::size_t i = 0; i < y.size(); ++i) {
            F_k += weights[i] * y[i].value;
            F_prime += weights[i] * y[i].prime;
        }
        const T x = A * C + B * S + state.beta * F_k, x_prime = B * C - A * S + state.beta * F_prime;
        all.x.push_back(mirrored ? T(-x) : x);
        all.x_prime.push_back(mirrored ? T(-x_prime) : x_prime);
    }
    return all;
}

template double wrapped(const double&);
template long double wrapped(const long double&);
template Real50 wrapped(const Real50&);
template Real100 wrapped(const Real100&);
template SteadyState<double> steady_state(const ModeSums<double>&, const RegimeBoundary<double>&, const double&,
                                          std::optional<Mass>);
template SteadyState<long double> steady_state(const ModeSums<long double>&, const RegimeBoundary<long double>&,
                                               const long double&, std::optional<Mass>);
template SteadyState<Real50> steady_state(const ModeSums<Real50>&, const RegimeBoundary<Real50>&, const Real50&,
                                          std::optional<Mass>);
template SteadyState<Real100> steady_state(const ModeSums<Real100>&, const RegimeBoundary<Real100>&, const Real100&,
                                           std::optional<Mass>);
template SteadyState<double> steady_state_at(const ModeSums<double>&, const double&, const std::vector<double>&,
                                             std::optional<Mass>);
template SteadyState<long double> steady_state_at(const ModeSums<long double>&, const long double&,
                                                  const std::vector<long double>&, std::optional<Mass>);
template SteadyState<Real50> steady_state_at(const ModeSums<Real50>&, const Real50&, const std::vector<Real50>&,
                                             std::optional<Mass>);
template SteadyState<Real100> steady_state_at(const ModeSums<Real100>&, const Real100&, const std::vector<Real100>&,
                                              std::optional<Mass>);
template SteadyState<Bounded> steady_state_at(const ModeSums<Bounded>&, const Bounded&, const std::vector<Bounded>&,
                                              std::optional<Mass>);
template SteadyState<Bounded> steady_state_without_maxima(const ModeSums<Bounded>&, const Bounded&);
template SteadyState<Real50> steady_state_without_maxima(const ModeSums<Real50>&, const Real50&);
template SteadyState<Real100> steady_state_without_maxima(const ModeSums<Real100>&, const Real100&);
template Motion<Bounded> motion(const ModeSums<Bounded>&, const SteadyState<Bounded>&, const Bounded&);
template Motion<double> motion(const ModeSums<double>&, const SteadyState<double>&, const double&);
template Motion<long double> motion(const ModeSums<long double>&, const SteadyState<long double>&, const long double&);
template Motion<Real50> motion(const ModeSums<Real50>&, const SteadyState<Real50>&, const Real50&);
template Motion<Real100> motion(const ModeSums<Real100>&, const SteadyState<Real100>&, const Real100&);

} // namespace denhartog

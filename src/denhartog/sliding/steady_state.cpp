// How do the masses move as long as the contact slides? `steady_state_without_maxima` is (38), (39), (44), (45), (52), (53);
// `settle_maximum` corrects the instants at which the other masses are farthest out, and `motions` is (46) at any instants.
#include "denhartog/sliding/steady_state.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "denhartog/evaluation/contact.hpp"
#include "denhartog/evaluation/mass.hpp"
#include "denhartog/formulas/motion.hpp"
#include "denhartog/formulas/other_masses.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/sliding/instants_of_maxima.hpp"
#include "denhartog/sliding/mass_in_motion.hpp"
#include "denhartog/sums/bounded_modes.hpp"
#include "denhartog/sums/friction_motion.hpp"

namespace denhartog {
namespace {

using std::floor;

void check_sliding(const RegimeBoundary<double>& boundary, double beta) {
    check_friction_ratio(beta);
    if (beta < boundary.exact) return;
    throw DomainError({Why::not_sliding, beta, boundary.exact});
}

// An instant that rounding may have put a little outside the half-period, in it.
double in_half_period(double tau) { return std::clamp(tau, 0.0, pi<double>()); }
Bounded<double> in_half_period(const Bounded<double>& tau) {
    const double inside = in_half_period(tau.x);
    return {inside, tau.e + std::abs(tau.x - inside)};
}

template <class T>
void set_maximum(MassResponse<T>& m, const T& phi_j, const T& instant, const T& displacement) {
    m.instant = instant;
    m.amplitude = displacement < 0 ? T(-displacement) : displacement;
    m.phase = wrapped(paper::phase_of_mass(phi_j, instant, displacement < 0 ? 1 : 0));
}

// A bound of the third derivative of a mass over a step from an instant: its terms there in size, and what the step may add to
// them. Between stops R^2 y''^2 + y'^2 of a mode under friction falls in time.
template <class T>
double size_of_jerk(const ModeSums<T>& s, const MassInMotion<T>& mass, std::size_t k, const T& tau, const T& step,
                    const FrictionShare<T>& share) {
    constexpr double slack = 1 + 1.0 / 1024; // more than the roundings here
    const std::vector<evaluation::FrictionMotion<T>>& y = share.of_modes;
    double sum = 0;
    if (s.coupled)
        sum = s.coupled->largest_derivative(k, 3, s.coupled->at(ValueOf<T>::of(in_half_period(step < 0 ? T(tau + step) : tau))));
    const double length = ValueOf<T>::most(step);
    for (std::size_t i = 0; i < y.size(); ++i) {
        const double R = ValueOf<T>::most(s.R[i]), rate = 1 / ValueOf<T>::least(s.R[i]),
                     damping = 2 * ValueOf<T>::most(s.zeta[i]), turns = length * rate;
        const double y_prime = ValueOf<T>::most(y[i].prime), R_y_double_prime = R * ValueOf<T>::most(y[i].double_prime);
        const double lost = step < 0 ? damping * turns : 0, growth = lost < 1 ? 1 + 2 * lost : exp(lost);
        const double added = turns * (1 + damping + damping * damping) * (y_prime + R_y_double_prime) * growth;
        sum += ValueOf<T>::most(mass.weights[i]) * (damping * R_y_double_prime + y_prime + added) * rate * rate;
    }
    return (ValueOf<T>::most(mass.h.A) + ValueOf<T>::most(mass.h.B) + ValueOf<T>::most(mass.beta) * sum) * slack;
}

// A step of Newton's method towards the extremum; none if the acceleration is zero.
template <class T>
T newton_step(const evaluation::MotionOfMass<T>& at) {
    return at.x_double_prime == 0 ? T(0) : T(-(at.x_prime / at.x_double_prime));
}

// Largest step in the wrong direction, if the error of the step hides its direction.
double may_lead_back(double) { return 0; }
Bounded<double> may_lead_back(const Bounded<double>& step) { return {std::max(0.0, step.e - std::abs(step.x))}; }

// The maximum next to an instant: one more step of Newton's method, with a bound of what the step neglects. The motion continues
// mirrored at both ends of the half-period. A step out of it at one end is a step into it at the other, and an end from which
// both steps lead out is itself the maximum.
template <class T>
void settle_maximum(const ModeSums<T>& s, SteadyState<T>& state, std::size_t k, T instant) {
    const MassInMotion<T> mass(s, k, state.beta);
    const auto leads_out = [](const T& tau, const T& step) { return (tau <= 0 && step < 0) || (tau >= pi<T>() && step > 0); };
    FrictionShare<T> share = friction_share(s, k, instant);
    evaluation::MotionOfMass<T> now = motion_with(mass, share);
    T step = newton_step(now);
    if (leads_out(instant, step)) {
        const T other = instant <= 0 ? pi<T>() : T(0);
        FrictionShare<T> share_there = friction_share(s, k, other);
        const evaluation::MotionOfMass<T> there = motion_with(mass, share_there);
        const T from_there = newton_step(there);
        if (leads_out(other, from_there)) {
            step = with_neglected(T(0), T(may_lead_back(step) + may_lead_back(from_there)));
        } else {
            instant = other;
            share = std::move(share_there);
            now = there;
            step = from_there;
        }
    }
    const T largest = found_by_search(T(now.x + now.x_prime * step / 2));
    const double reach = ValueOf<T>::most(step);
    if (!(reach - reach == 0)) { // rounding hides the acceleration; what it makes of the displacement hides the maximum
        const double hidden = 8 * std::max(ValueOf<T>::error(state.masses[k].x0), ValueOf<T>::error(state.masses[k].v0));
        set_maximum(state.masses[k], state.phi_j, with_neglected(instant, pi<T>()),
                    with_neglected(found_by_search(now.x), T(hidden)));
        return;
    }
    const double change_of_acceleration = reach * size_of_jerk(s, mass, k, instant, step, share),
                 change_of_displacement = reach * change_of_acceleration, least = ValueOf<T>::least(now.x_double_prime);
    // A step over which the acceleration may vanish proves nothing about the maximum.
    const bool tells = least > 0 && (change_of_displacement == 0 || 2 * change_of_acceleration < least);
    const double error_of_instant = !tells ? pi<double>() : change_of_displacement == 0 ? 0 : change_of_displacement / least;
    set_maximum(state.masses[k], state.phi_j, with_neglected(T(instant + step), T(error_of_instant)),
                with_neglected(largest, T(change_of_displacement * reach)));
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
    if (!(state.X_j >= 0)) throw DomainError(Why::beyond_sliding);
    state.phi_j = wrapped(evaluation::phase_of_contact(s.V[j], s.U[j], beta));
    state.masses.reserve(s.V.size());
    for (std::size_t k = 0; k < s.V.size(); ++k) {
        MassResponse<T> m{};
        if (k == j) {
            m = {state.X_j, T(0), state.X_j, T(0), state.phi_j, state.X_j, state.phi_j};
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

SteadyState<double> steady_state(const ModeSums<double>& s, const RegimeBoundary<double>& boundary, double beta,
                                 std::optional<Mass> only) {
    check_sliding(boundary, beta);
    FrictionMotions y(s);
    return with_maxima(s, steady_state_without_maxima(s, beta), instants_of_maxima(y, beta, only).instants, only);
}

template <class T>
SteadyState<T> with_maxima(const ModeSums<T>& s, SteadyState<T> state, const std::vector<T>& instants, std::optional<Mass> only) {
    for (std::size_t k = 0; k < state.masses.size(); ++k)
        if (k != s.contact.index && (!only || k == only->index)) settle_maximum(s, state, k, instants[k]);
    return state;
}

template <class T>
std::vector<Motion<T>> motions(const ModeSums<T>& s, const SteadyState<T>& state, std::span<const T> tau) {
    std::vector<MassInMotion<T>> masses;
    for (std::size_t k = 0; k < state.masses.size(); ++k) masses.emplace_back(s, k, state.beta);
    std::vector<Motion<T>> all(tau.size());
    for (std::size_t n = 0; n < tau.size(); ++n) {
        const T halves = floor(T(tau[n] / pi<T>()));
        const T instant = in_half_period(T(tau[n] - halves * pi<T>()));
        const bool mirrored = halves - 2 * floor(T(halves / 2)) != 0;
        FrictionShare<T> share = friction_share(s, 0, instant);
        for (std::size_t k = 0; k < masses.size(); ++k) {
            if (k > 0) share.of_mass = share_of_no_mode(s, k, instant);
            const evaluation::MotionOfMass<T> at = motion_with(masses[k], share);
            all[n].x.push_back(mirrored ? T(-at.x) : at.x);
            all[n].x_prime.push_back(mirrored ? T(-at.x_prime) : at.x_prime);
        }
    }
    return all;
}

template <class T>
Motion<T> motion(const ModeSums<T>& s, const SteadyState<T>& state, const T& tau) {
    return motions(s, state, std::span<const T>(&tau, 1)).front();
}

template double wrapped(const double&);
template Motion<double> motion(const ModeSums<double>&, const SteadyState<double>&, const double&);
template SteadyState<Bounded<double>> with_maxima(const ModeSums<Bounded<double>>&, SteadyState<Bounded<double>>,
                                                  const std::vector<Bounded<double>>&, std::optional<Mass>);
template SteadyState<Bounded<double>> steady_state_without_maxima(const ModeSums<Bounded<double>>&, const Bounded<double>&);
template std::vector<Motion<Bounded<double>>> motions(const ModeSums<Bounded<double>>&, const SteadyState<Bounded<double>>&,
                                                      std::span<const Bounded<double>>);
template Motion<Bounded<double>> motion(const ModeSums<Bounded<double>>&, const SteadyState<Bounded<double>>&,
                                        const Bounded<double>&);

template SteadyState<double> with_maxima(const ModeSums<double>&, SteadyState<double>, const std::vector<double>&,
                                         std::optional<Mass>);
template Bounded<double> wrapped(const Bounded<double>&);

} // namespace denhartog

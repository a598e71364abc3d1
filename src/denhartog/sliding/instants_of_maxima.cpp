// Instants of the largest demand (57), and of each mass farthest out while the contact slides. Searches over the half-period find
// the instants, on numbers without bounds; `with_maxima` then has the largest displacements with bounds of what the instants leave
// open. Read `instants_of_demands`, `regime_at`, `instants_of_maxima` and `settle_maximum`, in this order.
#include "denhartog/sliding/instants_of_maxima.hpp"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <tuple>
#include <utility>

#include "denhartog/evaluation/batch_forms.hpp"
#include "denhartog/formulas/motion.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/sliding/bounded_modes.hpp"
#include "denhartog/sliding/coupled_sums.hpp"

namespace denhartog {
namespace {

// Bound of the rise of the demand between two samples above the larger of them.
//
// F sin solves y'' + y = Z, so that between two samples it exceeds the sine through them by at most z_bound (cos(tau - m) /
// cos(h / 2) - 1); over the sine this is at most z_bound tan(h / 2) next to an end of the half-period. In place of the sines and
// cosines stand the first terms of their series that bound them. The ends are at most 2 apart, and z_bound bounds |Z| between
// them.
double rise_of_demand(double a, double b, double z_bound) {
    const double half = (b - a) / 2, square = half * half;
    if (!(a > 0) || !(b < pi<double>())) return z_bound * half / (1 - square / 2);
    const double from_end = std::min(a, pi<double>() - b);
    return z_bound * square / (2 - square) / (from_end * (1 - from_end * from_end / 6));
}

// Some modes, with their weights, as a function of tau to be maximised: F = N / sin, where N = sum weight R^2 (y' + u cos).
//
// W = N' sin - N cos has the sign of F', and W' = (N'' + N) sin. In Z = N'' + N the cosine drops out, and the equation of free
// motion of y leaves Z = -sum weight (2 zeta R y'' + (1 - R^2) y') = sum weight R^2 (y''' + y'). With y' made of exp(rho tau) its
// rate is at most sum weight |c| |rho^2 + 1|, where |rho^2 + 1| R^2 = |1 - R^2 + 2 i zeta R|: little next to resonance, where |c|
// is large. Without oscillations it is at most sum weight |c| (1 / R^2 + 1).
struct Demand {
    FrictionMotions& y;                   // of the modes from `first` on, as many as there are weights
    std::size_t first;                    // the first mode
    const std::vector<double>& weights;   // their weights
    const ModeSums<double>& s = y.sums(); // modes at a frequency ratio

    // F, W, Z and the slope of W at an instant in [0, pi].
    Sample operator()(double tau) const {
        const FrictionMotionsAt& at = y.at(tau);
        const std::pmr::vector<evaluation::FrictionMotion<double>>& now = at.y;
        const double &C = at.cosine, &S = at.sine;
        double N(0), N_prime(0), Z(0);
        for (std::size_t n = 0; n < weights.size(); ++n) {
            const double& R = s.R[first + n];
            const double& u = s.u[first + n];
            N += weights[n] * R * R * (now[n].prime + u * C);
            N_prime += weights[n] * R * R * (now[n].double_prime - u * S);
            Z -= weights[n] * (2 * s.zeta[first + n] * R * now[n].double_prime + (1 - R) * (1 + R) * now[n].prime);
        }
        if (tau > 0 && tau < pi<double>()) return {N / S, N_prime * S - N * C, Z, Z * S};
        return {value(tau), 0.0, Z};
    }

    // F, the limits at 0 and pi included.
    double value(double tau) const {
        double sum(0);
        for (std::size_t n = 0; n < weights.size(); ++n) sum += weights[n] * s_d_of_mode(s, first + n, tau);
        return sum;
    }

    // A bound of how fast Z changes from an instant on.
    double rate(double a) const {
        const FrictionMotionsAt& now = y.at(a, true);
        double bound(0);
        for (std::size_t n = 0; n < weights.size(); ++n) {
            const double &R = s.R[first + n], &zeta = s.zeta[first + n];
            const double from_resonance = modulus(Complex<double>{(1 - R) / R * ((1 + R) / R), 2 * zeta / R});
            bound += weights[n] * now.size[n] * (zeta < 1 ? from_resonance : 1 / (R * R) + 1);
        }
        return bound;
    }
};

// The maximum of a demand that rises at the start and turns next to it; zero if it does not. There W is the difference of
// two nearly equal numbers, and its rounding hides where it is zero. As W' = Z sin, W is the integral of Z sin; if Z is linear in
// tau, it is zero at -3 Z / (2 Z'). The slope Z' is that of a secant from the start to the instant found before. Next to pi no
// demand is largest: by (57) the limit there is below that at the start by twice (65).
double instant_next_to_start(const Curve& curve) {
    const double Z = curve.sample(0.0).z;
    double instant(0), next = 3 * Z / (2 * curve.rate(0.0, pi<double>())); // the rate bounds |Z'|: no zero is nearer
    for (int n = 0; n < 4 && next > 0 && next < 1; ++n) {
        instant = next;
        next = 3 * Z * instant / (2 * (Z - curve.sample(instant).z));
    }
    return instant;
}

// The instant of the largest demand. Next to the start the samples are quotients of two small numbers, whose rounding errors can
// look like a maximum or hide one. A maximum there is therefore decided by the demand itself.
template <class Demanded>
double instant_of_largest(Curve curve, const Demanded& demanded) {
    ++work_counted.demand_searches;
    curve.rise = [](double a, double b, double z_bound) { return rise_of_demand(a, b, z_bound); };
    double largest(0), demand = demanded(largest);
    const auto look = [&](double instant) {
        const double there = demanded(instant);
        if (there > demand) {
            largest = instant;
            demand = there;
        }
    };
    const double found = global_maximum(curve, 0.0, pi<double>()).instant;
    look(found);
    if (found < 1.0 / 256) look(instant_next_to_start(curve));
    return largest;
}

double instant_of_largest(FrictionMotions& y, std::size_t first, const std::vector<double>& weights) {
    const Demand demand{y, first, weights};
    Curve curve;
    curve.sample = [&](double tau) { return demand(tau); };
    curve.rate = [&](double a, double) { return demand.rate(a); };
    curve.cost = static_cast<long>(weights.size() + 2); // two for the search itself
    curve.question = y.effort();
    return instant_of_largest(std::move(curve), [&](double tau) { return demand.value(tau); });
}

double instant_of_largest_where_coupled(FrictionMotions& y) {
    const ModeSums<double>& s = y.sums();
    const CoupledFriction& friction = *s.coupled;
    const std::size_t j = s.contact.index;
    const double start = friction.derivative(j, 1, friction.at(0.0));
    Curve curve;
    curve.sample = [&](double tau) {
        const CoupledState& now = friction.at(tau);
        const auto [S, C] = sine_cosine(tau);
        const double first = friction.derivative(j, 1, now), second = friction.derivative(j, 2, now);
        const double N = first - start * C, N_prime = second + start * S, Z = friction.derivative(j, 3, now) + first;
        if (tau > 0 && tau < pi<double>()) return Sample{N / S, N_prime * S - N * C, Z, Z * S};
        return Sample{coupled_demand(friction, s.contact, tau), 0.0, Z};
    };
    curve.rate = [&](double a, double) { return friction.rate_of_demand(j, friction.at(a)); };
    curve.cost = friction.cost();
    curve.share = default_effort(friction.size()) / 4;
    curve.question = y.effort();
    return instant_of_largest(std::move(curve), [&](double tau) { return coupled_demand(friction, s.contact, tau); });
}

// True if (57) of a mode is certain to be largest for tau -> 0, by numbers in double and with a margin for their rounding.
template <class T>
bool mode_is_largest_at_start(const ModeSums<T>& s, std::size_t i) {
    const auto narrow = [](const T& x) { return static_cast<double>(ValueOf<T>::of(x)); };
    return evaluation::certainty_of_start(narrow(s.R[i]), narrow(s.zeta[i]), narrow(s.u[i]), narrow(s.g[i])) > 0;
}

// A bound of the third derivative of the sum over modes of the friction motions on a stretch of length h. The terms of a mode may
// exceed the sum by far: far above the natural frequencies the sums of the first derivatives all but vanish. Taylor's formula
// with more and more of those sums bounds the rest, each derivative of a mode being smaller by R_i than the one before.
double rate_of_friction(const ModeSums<double>& s, const std::vector<double>& weights, const FrictionMotionsAt& at, double h) {
    constexpr int most_terms = 16;
    const std::size_t N = weights.size();
    struct Term {
        double size;     // bound of a derivative
        double one, two; // the derivatives one and two below it
    };
    boost::container::small_vector<Term, 8> terms(N);
    bool oscillates = true;
    double rest(0);
    for (std::size_t i = 0; i < N; ++i) {
        terms[i] = {size_of_number(weights[i]) * at.size[i] / (s.R[i] * s.R[i] * s.R[i]), weights[i] * at.y[i].double_prime,
                    weights[i] * at.y[i].prime};
        rest += terms[i].size;
        oscillates = oscillates && s.zeta[i] < 1;
    }
    if (!oscillates) return rest; // the sizes are those of this derivative alone
    double known(0), best = rest, power(1);
    for (int n = 1; n <= most_terms; ++n) {
        double sum(0), rounding(0);
        rest = 0.0;
        for (std::size_t i = 0; i < N; ++i) {
            const double& R = s.R[i];
            Term& term = terms[i];
            const double next = -(2 * s.zeta[i] * term.one + term.two / R) / R;
            term.two = term.one;
            term.one = next;
            sum += next;
            rounding += term.size;
            term.size = term.size / R;
            rest += term.size;
        }
        known += power * (size_of_number(sum) + 16 * unit_of<double>() * rounding);
        power = power * h / n;
        const double bound = known + power * rest;
        const bool halved = 2 * bound < best;
        best = std::min(best, bound);
        if (!halved) break;
    }
    return best;
}

std::pair<double, double> instant_and_spread(FrictionMotions& y, double beta, std::size_t k, double error) {
    const ModeSums<double>& s = y.sums();
    const MassInMotion<double> mass(s, k, beta);
    const double harmonic_size = modulus(Complex<double>{mass.h.A, mass.h.B});
    Curve curve;
    curve.question = y.effort();
    if (s.coupled) { // the bounds come from the free motion, which never grows
        const CoupledFriction& friction = *s.coupled;
        curve.rate = [&](double a, double) { return harmonic_size + beta * friction.largest_derivative(k, 3, friction.at(a)); };
        curve.cost = friction.cost();
        curve.share = default_effort(friction.size()) / 4;
        const double noise = 2 * unit_of<double>() * (harmonic_size + beta * friction.compliance(k).most());
        return instant_and_spread(
            curve, [&](double tau) { return motion_with(mass, friction_share(s, k, tau)); }, noise, error);
    }
    const auto at = [&](double tau) {
        const FrictionMotionsAt& now = y.at(tau);
        return mass.at(now.cosine, now.sine, now.y);
    };
    curve.rate = [&](double a, double b) {
        return harmonic_size + beta * rate_of_friction(s, mass.weights, y.at(a, true), b - a);
    };
    // A displacement within its rounding error is no reason to look further.
    const FrictionMotionsAt& start = y.at(0.0, true);
    double terms = harmonic_size;
    for (std::size_t i = 0; i < mass.weights.size(); ++i) terms += beta * size_of_number(mass.weights[i]) * (1 + start.size[i]);
    curve.cost = static_cast<long>(s.R.size() + 2); // two for the search itself
    return instant_and_spread(curve, at, 2 * unit_of<double>() * terms, error);
}

// A bound of the third derivative of a mass over a step from an instant: its terms there in size, and what the step may add to
// them. Between stops R^2 y''^2 + y'^2 of a mode under friction falls in time.
template <class T>
double size_of_jerk(const ModeSums<T>& s, const MassInMotion<T>& mass, std::size_t k, const T& tau, const T& step,
                    const FrictionShare<T>& share) {
    constexpr double slack = 1 + 1.0 / 1024; // more than the roundings here
    const std::vector<evaluation::FrictionMotion<T>>& y = share.modes;
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

// Amplitude and phase (47) of a mass whose largest displacement, in size, and its instant are known.
template <class T>
void set_maximum(MassResponse<T>& m, const T& phi_j, const T& instant, const T& displacement) {
    m.instant = instant;
    m.amplitude = displacement < 0 ? T(-displacement) : displacement;
    m.phase = wrapped(paper::phase_of_mass(phi_j, instant, displacement < 0 ? 1 : 0));
}

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
bool largest_at_start(const ModeSums<T>& s) {
    if (s.coupled) return false;
    for (std::size_t i = 0; i < s.R.size(); ++i)
        if (!mode_is_largest_at_start(s, i)) return false;
    return true;
}

double instant_of_largest_demand(FrictionMotions& y) {
    const ModeSums<double>& s = y.sums();
    if (s.coupled) return instant_of_largest_where_coupled(y);
    if (largest_at_start(s)) return 0.0;
    std::vector<double> squares;
    squares.reserve(s.R.size());
    for (const double psi_ji : mode_shapes_at(s, s.contact)) squares.push_back(psi_ji * psi_ji);
    return instant_of_largest(y, 0, squares);
}

double instant_of_largest_demand(const ModeSums<double>& s, Effort* effort) {
    FrictionMotions y(s, effort);
    return instant_of_largest_demand(y);
}

RegimeBoundary<Bounded<double>> regime_boundary(const ModeSums<Bounded<double>>& s, const Bounded<double>& mu) {
    const double instant = largest_at_start(s) ? 0.0 : instant_of_largest_demand(values_of(s));
    return regime_boundary_at(s, mu, found_by_search(sliding_demand(s, Bounded<double>(instant))));
}

RegimeAtPoint regime_at(const Boundary<Bounded<double>>& b, double beta) {
    check_friction_ratio(beta);
    const Bounded<double> sticking = b.sticking.value_or(Bounded<double>(0));
    const bool can_rest = b.sticking && beta >= sticking.x;
    const auto is_on = [beta](const Bounded<double>& limit) { return beta - limit.x < limit.e && limit.x - beta < limit.e; };
    RegimeAtPoint point;
    point.regime = regime_of(static_cast<const RegimeBoundary<Bounded<double>>&>(b), Bounded<double>(beta));
    if (point.regime == Regime::continuous) {
        point.reason = {Why::slides, beta, b.exact.x, b.exact.e, can_rest};
        if (can_rest) point.reason += {Why::can_rest, sticking.x, sticking.e};
        if (can_rest) point.other.push_back(Regime::permanent_sticking);
    } else {
        point.reason = {Why::no_closed_form, beta, b.exact.x, b.exact.e, static_cast<int>(b.binding)};
        if (b.sticking)
            point.reason += {can_rest ? Why::never_moves : Why::rests_only_from, sticking.x, sticking.e};
        else
            point.reason += Why::nothing_holds;
    }
    point.on_boundary = is_on(b.exact) || (b.sticking && beta >= b.exact.x && is_on(sticking));
    if (point.on_boundary) point.reason += Why::near_boundary;
    return point;
}

std::vector<double> instants_of_demands(FrictionMotions& y) {
    const ModeSums<double>& s = y.sums();
    std::vector<double> instants;
    instants.reserve(s.R.size() + 1);
    instants.push_back(instant_of_largest_demand(y));
    const auto instant_of_mode = [&y](std::size_t i) {
        FrictionMotions alone(y, i);
        return instant_of_largest(alone, i, std::vector<double>{1.0});
    };
    for (std::size_t i = 0; i < s.R.size(); ++i)
        instants.push_back(s.R.size() == 1 ? instants.front() : mode_is_largest_at_start(s, i) ? 0.0 : instant_of_mode(i));
    return instants;
}

InstantsOfMaxima instants_of_maxima(FrictionMotions& y, double beta, std::optional<Mass> only,
                                    const std::vector<double>& errors) {
    const ModeSums<double>& s = y.sums();
    InstantsOfMaxima all{std::vector<double>(s.V.size(), 0.0), std::vector<double>(s.V.size(), 0.0)};
    for (std::size_t k = 0; k < s.V.size(); ++k) {
        if (k == s.contact.index || (only && k != only->index)) continue;
        const double error = errors.empty() ? 0.0 : errors[k];
        std::tie(all.instants[k], all.spreads[k]) = instant_and_spread(y, beta, k, error);
    }
    return all;
}

template <class T>
SteadyState<T> with_maxima(const ModeSums<T>& s, SteadyState<T> state, const std::vector<T>& instants, std::optional<Mass> only) {
    for (std::size_t k = 0; k < state.masses.size(); ++k)
        if (k != s.contact.index && (!only || k == only->index)) settle_maximum(s, state, k, instants[k]);
    return state;
}

template bool largest_at_start(const ModeSums<double>&);
template bool largest_at_start(const ModeSums<Bounded<double>>&);
template SteadyState<Bounded<double>> with_maxima(const ModeSums<Bounded<double>>&, SteadyState<Bounded<double>>,
                                                  const std::vector<Bounded<double>>&, std::optional<Mass>);
template SteadyState<double> with_maxima(const ModeSums<double>&, SteadyState<double>, const std::vector<double>&,
                                         std::optional<Mass>);

} // namespace denhartog

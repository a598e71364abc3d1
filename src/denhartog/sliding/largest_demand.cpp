// Where in the half-period the sum over modes of (57)'s expression is largest, and where that of each mode is. The functions are
// declared in boundary.hpp.
#include <algorithm>
#include <utility>

#include "denhartog/evaluation/batch_forms.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/search/largest.hpp"
#include "denhartog/sliding/boundary.hpp"
#include "denhartog/sums/coupled_friction.hpp"

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
        double limit(0);
        for (std::size_t n = 0; n < weights.size(); ++n) limit += weights[n] * s_d_of_mode(s, first + n, tau);
        return {limit, 0.0, Z};
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
    const ModeSums<double>& s = y.sums();
    const Demand demand{y, first, weights};
    Curve curve;
    curve.sample = [&](double tau) { return demand(tau); };
    curve.rate = [&](double a, double) { return demand.rate(a); };
    curve.cost = static_cast<long>(weights.size() + 2); // two for the search itself
    curve.question = y.effort();
    return instant_of_largest(std::move(curve), [&](double tau) {
        double sum(0);
        for (std::size_t n = 0; n < weights.size(); ++n) sum += weights[n] * s_d_of_mode(s, first + n, tau);
        return sum;
    });
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

// Whether (57) of a mode is certain to be largest for tau -> 0, by numbers in double and with a margin for their rounding.
template <class T>
bool mode_is_largest_at_start(const ModeSums<T>& s, std::size_t i) {
    const auto narrow = [](const T& x) { return static_cast<double>(ValueOf<T>::of(x)); };
    return evaluation::certainty_of_start(narrow(s.R[i]), narrow(s.zeta[i]), narrow(s.u[i]), narrow(s.g[i])) > 0;
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

template bool largest_at_start(const ModeSums<double>&);
template bool largest_at_start(const ModeSums<Bounded<double>>&);

} // namespace denhartog

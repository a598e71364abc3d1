#include "tests/support/closed_form.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <utility>

#include "denhartog/evaluation/contact.hpp"
#include "denhartog/evaluation/mass.hpp"
#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/motion.hpp"
#include "denhartog/formulas/other_masses.hpp"
#include "denhartog/formulas/stuck.hpp"
#include "denhartog/formulas/superposition.hpp"

namespace denhartog {
namespace {

using Index = Eigen::Index;

// Where a smooth function is largest between two instants, to half its digits.
template <class T, class Function>
T instant_of_peak(const Function& f, const T& a, const T& b) {
    return boost::math::tools::brent_find_minima([&f](const T& tau) { return T(-f(tau)); }, a, b, std::numeric_limits<T>::digits)
        .first;
}

// Where a smooth function on [0, pi] is largest, to half its digits. It is looked at closely next to each sample in double
// that may be next to the largest value.
template <class T, class Function, class InDouble>
T instant_of_largest(const Function& f, const InDouble& in_double, int steps) {
    std::vector<double> samples;
    for (int n = 0; n <= steps; ++n) samples.push_back(in_double(n == steps ? pi<double>() : pi<double>() * n / steps));
    const auto at = [&](int n) { return samples[static_cast<std::size_t>(std::clamp(n, 0, steps))]; };
    const auto instant = [&](int n) { return n >= steps ? pi<T>() : n <= 0 ? T(0) : T(pi<T>() * n / steps); };
    const double best_sample = *std::max_element(samples.begin(), samples.end()), noise = 1e-9 * std::abs(best_sample);
    T best(0), largest = f(best);
    const auto take = [&](const T& tau) {
        if (const T value = f(tau); value > largest) {
            best = tau;
            largest = value;
        }
    };
    for (int n = 0; n <= steps; ++n) {
        if (at(n - 1) > at(n) || at(n + 1) > at(n)) continue;
        if (2 * at(n) - std::min(at(n - 1), at(n + 1)) + noise < best_sample) continue;
        take(instant(n));
        take(instant_of_peak(f, instant(n - 1), instant(n + 1)));
    }
    return best;
}

// Steps that half a period is sampled in: a few dozen an oscillation of the fastest mode, but for modes so fast that they move
// nothing.
template <class T>
int steps_for(std::span<const T> R) {
    return 64 + static_cast<int>(std::min(32 / static_cast<double>(*std::min_element(R.begin(), R.end())), 0x1p13));
}

template <class T>
T demand_of_mode(const ModeSums<T>& s, std::size_t i, const T& tau) {
    return evaluation::s_d_integrand_of(tau, s.R[i], s.zeta[i], evaluation::DampingFunctions<T>{s.u[i], s.g[i]});
}

// The demand of a mode in double, for samples.
template <class T>
double rough_demand(const ModeSums<T>& s, std::size_t i, double tau) {
    const auto narrow = [](const T& x) { return static_cast<double>(x); };
    return evaluation::s_d_integrand_of(tau, narrow(s.R[i]), narrow(s.zeta[i]),
                                        evaluation::DampingFunctions<double>{narrow(s.u[i]), narrow(s.g[i])});
}

// The braces of (40) of all modes at an instant.
template <class T>
struct FrictionAt {
    T tau, cosine, sine;
    std::vector<evaluation::FrictionMotion<T>> y;

    FrictionAt(const ModeSums<T>& s, const T& instant) : tau(instant), cosine(cos(instant)), sine(sin(instant)) {
        for (std::size_t i = 0; i < s.R.size(); ++i)
            y.push_back(evaluation::friction_motion(tau, s.R[i], s.zeta[i], s.w[i], s.u[i], s.g[i]));
    }
};

// A mass over the half-period.
template <class T>
struct MovingMass {
    const ModeSums<T>& s;
    T beta;
    evaluation::HarmonicPart<T> harmonic;
    std::vector<T> weights;

    MovingMass(const ModeSums<T>& sums, std::size_t k, const T& beta_)
        : s(sums), beta(beta_), harmonic(evaluation::harmonic_part(s.V[k], s.V[s.contact.index], s.U[s.contact.index], beta_)) {
        for (std::size_t i = 0; i < s.R.size(); ++i)
            weights.push_back(mode_shapes_at(s, Mass{k})[i] * mode_shapes_at(s, s.contact)[i] * s.R[i] * s.R[i]);
    }
    [[nodiscard]] evaluation::MotionOfMass<T> at(const FrictionAt<T>& f) const {
        return evaluation::motion_of_mass(f.cosine, f.sine, harmonic, beta, std::span<const T>(weights),
                                          std::span<const evaluation::FrictionMotion<T>>(f.y));
    }
    [[nodiscard]] evaluation::MotionOfMass<T> at(const T& tau) const { return at(FrictionAt<T>(s, tau)); }
};

// Where a mass is farthest out: of the instants at which it turns those are looked at that may be farther out than all samples.
template <class T>
T instant_farthest_out(const MovingMass<T>& mass, const std::vector<FrictionAt<T>>& instants) {
    std::vector<evaluation::MotionOfMass<T>> samples;
    T best(0), largest(0), farthest(0);
    for (const FrictionAt<T>& each : instants) {
        samples.push_back(mass.at(each));
        farthest = std::max(farthest, T(abs(samples.back().x)));
    }
    const auto take = [&](const T& tau, const T& x) {
        if (abs(x) > largest) {
            best = tau;
            largest = abs(x);
        }
    };
    take(T(0), samples.front().x);
    for (std::size_t n = 1; n < samples.size(); ++n) {
        const evaluation::MotionOfMass<T>&a = samples[n - 1], &b = samples[n];
        const T &from = instants[n - 1].tau, &to = instants[n].tau;
        const T speed = std::max(T(abs(a.x_prime)), T(abs(b.x_prime)));
        if ((a.x_prime < 0) == (b.x_prime < 0) || std::max(T(abs(a.x)), T(abs(b.x))) + (to - from) * speed < farthest) continue;
        T low = from, high = to;
        while (high - low > ldexp(T(1), -24)) {
            const T middle = (low + high) / 2;
            ((mass.at(middle).x_prime < 0) == (a.x_prime < 0) ? low : high) = middle;
        }
        T tau = (low + high) / 2;
        for (int step = 0; step < 5; ++step) {
            const evaluation::MotionOfMass<T> now = mass.at(tau);
            if (now.x_double_prime != 0) tau = std::clamp(T(tau - now.x_prime / now.x_double_prime), from, to);
        }
        take(tau, mass.at(tau).x);
    }
    return best;
}

} // namespace

template <ManyDigits T>
ModeSums<T> mode_sums(const ModalBasis<T>& basis, Mass contact, const LoadRows& rows_of_load, const T& r) {
    const Mass load = rows_of_load.re;
    const std::size_t N = basis.r_n.size(), rows = static_cast<std::size_t>(basis.phi.rows());
    ModeSums<T> s;
    s.r = r;
    s.contact = contact;
    s.load = load;
    s.zeta = basis.zeta;
    for (std::size_t k = 0; k < rows; ++k)
        for (std::size_t i = 0; i < N; ++i) s.psi.push_back(basis.phi(static_cast<Index>(k), static_cast<Index>(i)) / r);
    for (std::size_t i = 0; i < N; ++i) {
        s.R.push_back(r / basis.r_n[i]);
        s.w.push_back(evaluation::w_if_oscillating(s.zeta[i]));
        const evaluation::ModeFunctions<T> f = evaluation::mode_functions(s.R[i], s.zeta[i]);
        s.v.push_back(f.v);
        s.u.push_back(f.u);
        s.g.push_back(f.g);
    }
    const std::span<const T> R(s.R), zeta(s.zeta), u(s.u), g(s.g), psi_j = mode_shapes_at(s, contact);
    const std::span<const Complex<T>> v(s.v);
    const std::size_t masses = load.index < N || load == contact ? rows : load.index;
    for (std::size_t k = 0; k < masses; ++k) {
        const std::span<const T> psi_k = mode_shapes_at(s, Mass{k});
        Complex<T> V = paper::complex_response_of_mass(psi_k, mode_shapes_at(s, load), R, v);
        if (rows_of_load.im) { // V_re + i V_im
            const Complex<T> ahead = paper::complex_response_of_mass(psi_k, mode_shapes_at(s, *rows_of_load.im), R, v);
            V = {V.re - ahead.im, V.im + ahead.re};
        }
        s.V.push_back(V);
        s.U.push_back(paper::damping_function_of_mass(psi_k, psi_j, R, u));
        s.G.push_back(paper::damping_function_of_mass(psi_k, psi_j, R, g));
    }
    s.Y_jj = paper::complex_response_of_mass(psi_j, psi_j, R, v);
    s.H_j = paper::H(psi_j, R, zeta, u, g);
    s.sum_of_squares = paper::sum_over_contact(psi_j, std::span<const T>(std::vector<T>(N, T(1))));
    return s;
}

template <ManyDigits T>
T sliding_demand(const ModeSums<T>& s, const T& tau) {
    T sum(0);
    for (std::size_t i = 0; i < s.R.size(); ++i) {
        const T& psi_ji = mode_shapes_at(s, s.contact)[i];
        sum += psi_ji * psi_ji * demand_of_mode(s, i, tau);
    }
    return sum;
}

template <ManyDigits T>
T instant_of_largest_demand(const ModeSums<T>& s) {
    std::vector<double> squares;
    for (const T& psi_ji : mode_shapes_at(s, s.contact)) squares.push_back(static_cast<double>(T(psi_ji * psi_ji)));
    const auto in_double = [&](double tau) {
        double sum = 0;
        for (std::size_t i = 0; i < squares.size(); ++i) sum += squares[i] * rough_demand(s, i, tau);
        return sum;
    };
    return instant_of_largest<T>([&](const T& tau) { return sliding_demand(s, tau); }, in_double,
                                 steps_for(std::span<const T>(s.R)));
}

template <ManyDigits T>
Boundary<T> boundary_at(const ModeSums<T>& s, const T& mu, const T& instant, std::vector<T> instants) {
    const std::size_t j = s.contact.index;
    const T held = paper::static_friction_demand(s.H_j, mu, s.sum_of_squares);
    // The sums cancel where the load does not reach the contact, and where the system resonates with the contact held.
    const auto nothing = [&](const Complex<T>& sum, Mass force) {
        T size(0);
        for (std::size_t i = 0; i < s.R.size(); ++i)
            size += abs(T(mode_shapes_at(s, s.contact)[i] * mode_shapes_at(s, force)[i] * s.R[i] * s.R[i])) * modulus(s.v[i]);
        return modulus(sum) <= static_cast<int>(s.R.size()) * std::numeric_limits<T>::epsilon() * size;
    };
    const Complex<T> V = nothing(s.V[j], s.load) ? Complex<T>{T(0), T(0)} : s.V[j];
    Boundary<T> b{};
    b.S_exact = sliding_demand(s, instant);
    std::vector<T> demands;
    for (std::size_t i = 0; i < s.R.size(); ++i) demands.push_back(demand_of_mode(s, i, instants[i]));
    b.S_paper = paper::sum_over_contact(mode_shapes_at(s, s.contact), std::span<const T>(demands));
    b.exact = paper::friction_ratio_limit(V, s.U[j], std::max(b.S_exact, held));
    b.paper = paper::friction_ratio_limit(V, s.U[j], std::max(b.S_paper, held));
    b.approximate = paper::friction_ratio_limit(V, s.U[j], held);
    if (s.load == s.contact)
        b.sticking = paper::sticking_limit_under_load(mu);
    else if (!nothing(s.Y_jj, s.contact))
        b.sticking = evaluation::sticking_limit_by_responses(V, s.Y_jj, mu);
    b.instant = instant;
    b.instants = std::move(instants);
    if (instant == 0)
        b.binding = mu > 1 ? BindingCondition::static_friction : BindingCondition::both;
    else
        b.binding = b.S_exact > held ? BindingCondition::velocity : BindingCondition::static_friction;
    return b;
}

template <ManyDigits T>
Boundary<T> boundary(const ModeSums<T>& s, const T& mu) {
    std::vector<T> instants;
    for (std::size_t i = 0; i < s.R.size(); ++i)
        instants.push_back(instant_of_largest<T>([&](const T& tau) { return demand_of_mode(s, i, tau); },
                                                 [&](double tau) { return rough_demand(s, i, tau); },
                                                 steps_for(std::span<const T>(s.R).subspan(i, 1))));
    return boundary_at(s, mu, instant_of_largest_demand(s), std::move(instants));
}

template <ManyDigits T>
SteadyState<T> steady_state_without_maxima(const ModeSums<T>& s, const T& beta) {
    const std::size_t j = s.contact.index;
    SteadyState<T> state;
    state.beta = beta;
    state.X_j = evaluation::displacement_transmissibility_of_contact(s.V[j], s.U[j], s.G[j], beta);
    state.phi_j = wrapped(evaluation::phase_of_contact(s.V[j], s.U[j], beta));
    for (std::size_t k = 0; k < s.V.size(); ++k) {
        MassResponse<T> m{};
        if (k == j) {
            m = {state.X_j, T(0), state.X_j, T(0), state.phi_j, state.X_j, state.phi_j};
        } else {
            const evaluation::InitialState<T> start = evaluation::initial_state(s.V[k], s.V[j], s.U[j], s.U[k], s.G[k], beta);
            m.x0 = start.x_k0;
            m.v0 = start.x_prime_k0;
            m.amplitude_monoharmonic = modulus(Complex<T>{m.x0, m.v0});
            m.phase_monoharmonic = wrapped(T(state.phi_j + paper::phase_behind_contact(m.x0, m.v0)));
        }
        state.masses.push_back(m);
    }
    return state;
}

template <ManyDigits T>
SteadyState<T> steady_state(const ModeSums<T>& s, const RegimeBoundary<T>& boundary, const T& beta, std::optional<Mass> only) {
    if (!(beta < boundary.exact)) throw DomainError("the contact does not slide throughout");
    SteadyState<T> state = steady_state_without_maxima(s, beta);
    std::vector<FrictionAt<T>> instants;
    for (int n = 0, steps = steps_for(std::span<const T>(s.R)); n <= steps; ++n)
        instants.emplace_back(s, n == steps ? pi<T>() : T(pi<T>() * n / steps));
    for (std::size_t k = 0; k < state.masses.size(); ++k) {
        if (k == s.contact.index || (only && k != only->index)) continue;
        const MovingMass<T> mass(s, k, beta);
        MassResponse<T>& m = state.masses[k];
        m.instant = instant_farthest_out(mass, instants);
        const T x = mass.at(m.instant).x;
        m.amplitude = abs(x);
        m.phase = wrapped(paper::phase_of_mass(state.phi_j, m.instant, x < 0 ? 1 : 0));
    }
    return state;
}

template <ManyDigits T>
Motion<T> motion(const ModeSums<T>& s, const SteadyState<T>& state, const T& tau) {
    const T halves = floor(T(tau / pi<T>())), instant = std::clamp(T(tau - halves * pi<T>()), T(0), pi<T>());
    const int sign = halves - 2 * floor(T(halves / 2)) != 0 ? -1 : 1;
    const FrictionAt<T> friction(s, instant);
    Motion<T> all;
    for (std::size_t k = 0; k < state.masses.size(); ++k) {
        const evaluation::MotionOfMass<T> now = MovingMass<T>(s, k, state.beta).at(friction);
        all.x.push_back(sign * now.x);
        all.x_prime.push_back(sign * now.x_prime);
    }
    return all;
}

template ModeSums<Real50> mode_sums(const ModalBasis<Real50>&, Mass, const LoadRows&, const Real50&);
template ModeSums<Real100> mode_sums(const ModalBasis<Real100>&, Mass, const LoadRows&, const Real100&);
template Real50 sliding_demand(const ModeSums<Real50>&, const Real50&);
template Real100 sliding_demand(const ModeSums<Real100>&, const Real100&);
template Real50 instant_of_largest_demand(const ModeSums<Real50>&);
template Real100 instant_of_largest_demand(const ModeSums<Real100>&);
template Boundary<Real50> boundary_at(const ModeSums<Real50>&, const Real50&, const Real50&, std::vector<Real50>);
template Boundary<Real50> boundary(const ModeSums<Real50>&, const Real50&);
template Boundary<Real100> boundary(const ModeSums<Real100>&, const Real100&);
template SteadyState<Real50> steady_state_without_maxima(const ModeSums<Real50>&, const Real50&);
template SteadyState<Real100> steady_state_without_maxima(const ModeSums<Real100>&, const Real100&);
template SteadyState<Real50> steady_state(const ModeSums<Real50>&, const RegimeBoundary<Real50>&, const Real50&,
                                          std::optional<Mass>);
template SteadyState<Real100> steady_state(const ModeSums<Real100>&, const RegimeBoundary<Real100>&, const Real100&,
                                           std::optional<Mass>);
template Motion<Real50> motion(const ModeSums<Real50>&, const SteadyState<Real50>&, const Real50&);
template Motion<Real100> motion(const ModeSums<Real100>&, const SteadyState<Real100>&, const Real100&);

} // namespace denhartog

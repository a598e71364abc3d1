// Motion of the masses as long as the contact slides. `steady_state_without_maxima` is (38), (39), (44), (45), (52), (53), and
// `motions` is (46) at any instants. The largest displacements come from `instants_of_maxima.cpp`.
#include "denhartog/sliding/steady_state.hpp"

#include <cmath>
#include <utility>

#include "denhartog/evaluation/contact.hpp"
#include "denhartog/evaluation/mass.hpp"
#include "denhartog/formulas/other_masses.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/sliding/bounded_modes.hpp"
#include "denhartog/sliding/friction_motion.hpp"
#include "denhartog/sliding/instants_of_maxima.hpp"

namespace denhartog {
namespace {
using std::floor;
}

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
    check_friction_ratio(beta);
    if (!(beta < boundary.exact)) throw DomainError({Why::not_sliding, beta, boundary.exact});
    FrictionMotions y(s);
    return with_maxima(s, steady_state_without_maxima(s, beta), instants_of_maxima(y, beta, only).instants, only);
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
            if (k > 0) share.mass = share_of_no_mode(s, k, instant);
            const evaluation::MotionOfMass<T> at = motion_with(masses[k], share);
            all[n].x.push_back(mirrored ? T(-at.x) : at.x);
            all[n].x_prime.push_back(mirrored ? T(-at.x_prime) : at.x_prime);
        }
    }
    return all;
}

template double wrapped(const double&);
template Bounded<double> wrapped(const Bounded<double>&);
template SteadyState<Bounded<double>> steady_state_without_maxima(const ModeSums<Bounded<double>>&, const Bounded<double>&);
template SteadyState<double> steady_state_without_maxima(const ModeSums<double>&, const double&);
template std::vector<Motion<Bounded<double>>> motions(const ModeSums<Bounded<double>>&, const SteadyState<Bounded<double>>&,
                                                      std::span<const Bounded<double>>);
template std::vector<Motion<double>> motions(const ModeSums<double>&, const SteadyState<double>&, std::span<const double>);

} // namespace denhartog

/// @file
/// @brief The numbers of one point from sums over modes, in any number type. Included by sources only.
#pragma once

#include "denhartog/formulas/boundary.hpp"
#include "denhartog/sliding/bounded_modes.hpp"
#include "denhartog/sliding/coupled_sums.hpp"
#include "denhartog/sliding/instants_of_maxima.hpp"
#include "denhartog/solve/quantities.hpp"

namespace denhartog {

/// @brief What friction does not change: V, U, G, H, and S with the boundary. The sum over modes of (57)'s expression is largest
/// at `instant`, where 0 stands for the limit. @eq{33,34,35,56,64,69}
template <class T>
[[nodiscard]] Quantities<T> quantities_without_motion(const ModeSums<T>& s, const T& mu, const T& instant) {
    const std::size_t j = s.contact.index;
    Quantities<T> q;
    q.V = s.V;
    q.U = s.U;
    q.G = s.G;
    q.H_j = s.H_j;
    q.S = found_by_search(sliding_demand(s, instant));
    q.beta_lim =
        paper::friction_ratio_limit(s.V[j], s.U[j], larger(q.S, paper::static_friction_demand(s.H_j, mu, s.sum_of_squares)));
    return q;
}

/// @brief Adds the motion, where the friction ratio is below the boundary: X_j, phi_j, and x, x' at any instants, of which zero
/// is at a maximum of x_j. @eq{38,39,41,52}
template <class T>
void add_motion(Quantities<T>& q, const ModeSums<T>& s, const T& beta, const std::vector<T>& tau) {
    if (!(beta < q.beta_lim)) return;
    const SteadyState<T> state = steady_state_without_maxima(s, beta);
    q.X_j = state.X_j;
    q.phi_j = state.phi_j;
    for (const Motion<T>& at : motions(s, state, std::span<const T>(tau))) {
        q.x.insert(q.x.end(), at.x.begin(), at.x.end());
        q.x_prime.insert(q.x_prime.end(), at.x_prime.begin(), at.x_prime.end());
    }
    for (const MassResponse<T>& m : state.masses) q.x_size.push_back(m.amplitude_monoharmonic);
}

/// @brief All numbers of a point in double, of a contact between two masses too, which comes last. A search has its
/// share of `effort`.
[[nodiscard]] inline Quantities<Bounded<double>> quantities_in_double(const Scene<double>& scene,
                                                                      const ModeSums<Bounded<double>>& sums,
                                                                      std::span<const double> tau, Effort* effort = nullptr) {
    const double instant = instant_of_largest_demand(values_of(sums), effort);
    Quantities<Bounded<double>> q =
        quantities_without_motion(sums, as_input(scene.mu), Bounded<double>(std::min(instant, pi<double>())));
    if (!scene.beta) return q;
    std::vector<Bounded<double>> instants;
    for (const double each : tau) instants.push_back(as_input(each));
    add_motion(q, sums, as_input(*scene.beta), instants);
    return q;
}

} // namespace denhartog

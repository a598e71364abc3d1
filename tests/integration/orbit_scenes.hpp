/// @file
/// @brief Scenes for the exact solver and the periodic orbit, the same in every number type.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "denhartog/number/errors.hpp"
#include "denhartog/orbit/periodic_orbit.hpp"
#include "tests/catch.hpp"
#include "tests/support/multiprecision.hpp"
#include "tests/support/plain_response.hpp"
#include "tests/support/sample_scenes.hpp"

namespace denhartog::tests {

/// @brief A system with excitation and the name that a failing message shows.
template <class T>
struct Prepared {
    std::string name;         ///< where the scene is from
    ContactSystem<T> system;  ///< the system
    Excitation<T> excitation; ///< frequency and friction
};

/// @brief A chain with contact and load counted from 1; numbers are exact in binary.
template <class T = double>
Prepared<T> prepared_chain(const std::vector<double>& gamma, const std::vector<double>& kappa, const std::vector<double>& zeta,
                           std::size_t j, std::size_t l, double r, double beta, double mu = 1) {
    System<T> s;
    s.mass_ratios.assign(gamma.begin(), gamma.end());
    s.stiffness_ratios.assign(kappa.begin(), kappa.end());
    s.damping_ratios.assign(zeta.begin(), zeta.end());
    s.contact = Mass{j - 1};
    s.load = Mass{l - 1};
    return {"", contact_system(s), {T(r), T(beta), T(mu)}};
}

/// @brief One mass.
template <class T = double>
Prepared<T> prepared_oscillator(double zeta, double r, double beta, double mu = 1) {
    return prepared_chain<T>({1}, {1}, {zeta}, 1, 1, r, beta, mu);
}

/// @brief Three masses whose stuck modes do not diagonalise their damping.
template <class T = double>
Prepared<T> prepared_three_masses(double r, double beta, double mu = 1) {
    return prepared_chain<T>({1, 2.5, 0.75}, {1, 0.625, 1.875}, {0.03125, 0.0625, 0.09375}, 2, 1, r, beta, mu);
}

/// @brief The same random scene in double and in 50 digits.
struct Twin {
    Prepared<double> in_double;    ///< in double
    Prepared<Real50> in_50_digits; ///< in 50 digits
};

/// @brief Random scenes between the boundary of sliding and that of sticking.
/// @param seed    their seed
/// @param most_N  most masses
/// @param mu      static over kinetic friction; 0 for that of the scene
/// @return        the scenes
inline std::vector<Twin> between_the_boundaries(std::uint64_t seed, std::size_t most_N, double mu) {
    const std::vector<RandomScene<double>> scenes = random_scenes<double>(seed);
    const std::vector<RandomScene<Real50>> wide = random_scenes<Real50>(seed);
    std::vector<Twin> twins;
    for (std::size_t n = 0; n < scenes.size(); ++n) {
        Scene<double> scene = scenes[n].scene;
        if (number_of_masses(scene.system) > most_N) break;
        if (mu > 0) scene.mu = mu;
        Boundary<double> limits;
        try {
            limits = response(scene).boundary;
        } catch (const DomainError&) {
            continue; // at a pole of a mode without damping
        }
        if (!limits.sticking) continue;
        const double beta =
            friction_ratio_at(63.0 / 64, limits.exact + scenes[n].fraction_of_limit * (*limits.sticking - limits.exact));
        if (!(beta > limits.exact)) continue;
        twins.push_back(
            {{scenes[n].name, contact_system(scene.system), {*scene.r, beta, scene.mu}},
             {scenes[n].name, contact_system(wide[n].scene.system), {*wide[n].scene.r, Real50(beta), Real50(scene.mu)}}});
    }
    return twins;
}

/// @brief The orbit from rest, or from a start.
template <class T>
PeriodicOrbit<T> orbit_of(const Prepared<T>& p, const OrbitSearch<T>& search = {}) {
    ExactSolver<T> solver(p.system, p.excitation);
    return periodic_orbit(solver, at_rest<T>(p.system.basis.r_n.size()), search);
}

/// @brief The orbit from a start.
template <class T>
PeriodicOrbit<T> orbit_from(const Prepared<T>& p, const State<T>& start, const OrbitSearch<T>& search = {}) {
    ExactSolver<T> solver(p.system, p.excitation);
    return periodic_orbit(solver, start, search);
}

/// @brief The same orbit in 50 digits, by Newton's method from the one in double.
inline PeriodicOrbit<Real50> widened(const PeriodicOrbit<double>& orbit, const Prepared<Real50>& p, bool with_stability = false) {
    OrbitSearch<Real50> search;
    search.periods_before = 0;
    search.most_periods = 1;
    search.follow_start = false;
    search.with_stability = with_stability;
    State<Real50> start;
    start.x.assign(orbit.start.x.begin(), orbit.start.x.end());
    start.x_prime.assign(orbit.start.x_prime.begin(), orbit.start.x_prime.end());
    return orbit_from(p, start, search);
}

/// @brief State after a number of half-periods of propagation alone, mirrored where the number is odd.
inline State<double> propagated(const Prepared<double>& p, State<double> z, int half_periods) {
    ExactSolver<double> solver(p.system, p.excitation);
    for (int n = 0; n < half_periods; ++n) {
        z = solver.run(z, 0, pi<double>()).end;
        for (double& x : z.x) x = -x;
        for (double& v : z.x_prime) v = -v;
    }
    return z;
}

/// @brief Largest difference of two states.
inline double distance(const State<double>& a, const State<double>& b) {
    double largest = 0;
    for (std::size_t k = 0; k < a.x.size(); ++k)
        largest = std::max({largest, std::abs(a.x[k] - b.x[k]), std::abs(a.x_prime[k] - b.x_prime[k])});
    return largest;
}

} // namespace denhartog::tests

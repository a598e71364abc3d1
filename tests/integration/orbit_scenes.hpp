/// @file
/// @brief Scenes for the exact solver and the periodic orbit.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "denhartog/paper_algorithm/paper_algorithm.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/unit/response_fixtures.hpp"

namespace denhartog::tests {

/// @brief A system with excitation and the name that a failing message shows.
struct PreparedMotion {
    std::string name;      ///< where the scene is from
    ContactSystem system;  ///< the system
    Excitation excitation; ///< frequency and friction
    Scene<double> scene{}; ///< the same as a scene, where a proof is asked for
};

/// @brief A chain with contact and load counted from 1; numbers are exact in binary.
inline PreparedMotion prepared_chain(const std::vector<double>& gamma, const std::vector<double>& kappa,
                                     const std::vector<double>& zeta, std::size_t j, std::size_t l, double r, double beta,
                                     double mu = 1) {
    const Scene<double> scene = scene_of(chain_of(gamma, kappa, zeta, j, l), r, beta, mu);
    return {"", contact_system(scene.system), {r, beta, mu}, scene};
}

/// @brief One mass.
inline PreparedMotion prepared_oscillator(double zeta, double r, double beta, double mu = 1) {
    return prepared_chain({1}, {1}, {zeta}, 1, 1, r, beta, mu);
}

/// @brief Three masses whose stuck modes do not diagonalise their damping.
inline PreparedMotion prepared_three_masses(double r, double beta, double mu = 1) {
    return prepared_chain({1, 2.5, 0.75}, {1, 0.625, 1.875}, {0.03125, 0.0625, 0.09375}, 2, 1, r, beta, mu);
}

/// @brief Random scenes between the boundary of sliding and that of sticking.
inline std::vector<PreparedMotion> between_the_boundaries(std::uint64_t seed, std::size_t most_N, double mu) {
    std::vector<PreparedMotion> all;
    for (const RandomScene<double>& random : random_scenes<double>(seed)) {
        Scene<double> scene = random.scene;
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
            friction_ratio_at(63.0 / 64, limits.exact + random.fraction_of_limit * (*limits.sticking - limits.exact));
        if (!(beta > limits.exact)) continue;
        scene.beta = beta;
        all.push_back({random.name, contact_system(scene.system), {*scene.r, beta, scene.mu}, scene});
    }
    return all;
}

/// @brief The orbit from a start.
inline PeriodicOrbit orbit_from(const PreparedMotion& p, const State& start, const OrbitSearch& search = {}) {
    ExactSolver solver(p.system, p.excitation);
    return periodic_orbit(solver, start, search);
}

/// @brief The orbit from rest.
inline PeriodicOrbit orbit_of(const PreparedMotion& p, const OrbitSearch& search = {}) {
    return orbit_from(p, at_rest(p.system.basis.r_n.size()), search);
}

/// @brief State after a number of half-periods of propagation alone, mirrored where the number is odd.
inline State propagated(const PreparedMotion& p, State z, int half_periods) {
    ExactSolver solver(p.system, p.excitation);
    for (int n = 0; n < half_periods; ++n) {
        z = solver.run(z, 0, pi<double>()).end;
        for (double& x : z.x) x = -x;
        for (double& v : z.x_prime) v = -v;
    }
    return z;
}

/// @brief Settings of the paper's algorithm.
inline PaperSettings settings_with(double tolerance, int cycles = 200) {
    PaperSettings settings;
    settings.absolute_tolerance = tolerance;
    settings.cycles = cycles;
    return settings;
}

} // namespace denhartog::tests

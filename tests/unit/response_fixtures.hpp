/// @file
/// @brief Scenes, their sums and samples, and a route to their response that knows nothing of modes.
#pragma once

#include <Eigen/Dense>
#include <atomic>
#include <complex>
#include <optional>
#include <utility>
#include <vector>

#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/contact.hpp"
#include "denhartog/formulas/stuck.hpp"
#include "denhartog/map/regime_map.hpp"
#include "denhartog/model/stuck_configuration.hpp"
#include "denhartog/number/certified.hpp"
#include "denhartog/sliding/bounded_modes.hpp"
#include "denhartog/sliding/coupled_sums.hpp"
#include "denhartog/solve/solve.hpp"
#include "denhartog/stick_slip/stuck_response.hpp"
#include "tests/catch.hpp"
#include "tests/support/multiprecision.hpp"
#include "tests/support/named_scenes.hpp"
#include "tests/support/plain_response.hpp"
#include "tests/support/scene_builder.hpp"

namespace denhartog::tests {

/// @brief A chain by ratios with contact and load counted from 1.
template <class T = double>
Scene<T> chain(const std::vector<double>& gamma, const std::vector<double>& kappa, const std::vector<double>& zeta, std::size_t j,
               std::size_t l, double mu, double r, std::optional<double> beta = std::nullopt) {
    return scene_of(chain_of<T>(gamma, kappa, zeta, j, l), r, beta, mu);
}

/// @brief One mass, load and contact on it.
inline Scene<double> oscillator(double zeta, double r, double mu = 1, std::optional<double> beta = std::nullopt) {
    return chain({1}, {1}, {zeta}, 1, 1, mu, r, beta);
}

/// @brief Two equal masses and springs, the contact on the second, the load on the first.
inline Scene<double> equal_pair(double r, std::optional<double> beta = std::nullopt, double mu = 1) {
    return chain({1, 1}, {1, 1}, {0.03125, 0.0625}, 2, 1, mu, r, beta);
}

/// @brief Equal masses and springs with one damping ratio, the contact on the second, the load on the third.
inline Scene<double> equal_masses(std::size_t N, double zeta, double r, std::optional<double> beta = std::nullopt) {
    const std::vector<double> ones(N, 1);
    return chain(ones, ones, std::vector<double>(N, zeta), 2, 3, 1, r, beta);
}

/// @brief Three unequal masses, springs and damping ratios, the contact on the second, the load on the first.
template <class T = double>
Scene<T> three_masses(double r = 1.125, std::optional<double> beta = std::nullopt, double mu = 1.375) {
    return chain<T>({1, 2.5, 0.75}, {1, 0.625, 1.875}, {0.03125, 0.0625, 0.09375}, 2, 1, mu, r, beta);
}

/// @brief A scene at a friction ratio.
inline Scene<double> with_beta(Scene<double> scene, double beta) {
    scene.beta = beta;
    return scene;
}

/// @brief The stuck configuration of a system.
inline StuckConfiguration stuck_of(const System<double>& s) { return stuck_configuration(s, modal_basis(s)); }

/// @brief The boundary of permanent sticking of a scene, as it is and as (88) has it.
inline StickingBoundary sticking_limits(const Scene<double>& scene) {
    const StuckConfiguration stuck = stuck_of(scene.system);
    return sticking_boundary(stuck_response(stuck, scene.system.load, *scene.r), stuck_chain(scene.system, stuck), scene.mu);
}

/// @brief Modes of a scene at its frequency ratio.
template <class T>
ModeSums<T> sums_of(const Scene<T>& scene) {
    return mode_sums(modal_basis(scene.system), contact_row(scene.system), load_row(scene.system), *scene.r);
}

/// @brief A scene at a frequency ratio in 50 digits: the same binary fractions.
inline Scene<Real50> in_50_digits(Scene<double> scene, double r) {
    scene.r = r;
    return converted<Real50>(scene);
}

/// @brief Matrices of (6) of a scene.
inline NonDimensionalMatrices matrices_of(const Scene<double>& scene) {
    return non_dimensional_matrices(scene.system, modal_basis(scene.system), *scene.r);
}

/// @brief Complex displacements of all masses under harmonic unit load of n times the frequency on one mass: a dense solve.
inline Eigen::VectorXcd harmonic_response(const NonDimensionalMatrices& m, std::size_t load, int n = 1) {
    const std::complex<double> i(0, 1);
    const Eigen::MatrixXcd D = m.K.cast<std::complex<double>>() - double(n) * n * m.M + i * double(n) * m.C;
    return D.partialPivLu().solve(Eigen::VectorXcd::Unit(D.rows(), static_cast<Eigen::Index>(load)));
}

/// @brief The frequency ratios, damping ratios and functions of the modes, as the formulas take them.
template <class T>
struct Rows {
    std::span<const T> R, zeta, u, g;
    std::span<const Complex<T>> v;
    explicit Rows(const ModeSums<T>& s) : R(s.R), zeta(s.zeta), u(s.u), g(s.g), v(s.v) {}
};

/// @brief Largest difference of two states.
inline double distance(const State& a, const State& b) {
    double largest = 0;
    for (std::size_t k = 0; k < a.x.size(); ++k)
        largest = std::max({largest, std::abs(a.x[k] - b.x[k]), std::abs(a.x_prime[k] - b.x_prime[k])});
    return largest;
}

/// @brief Velocity of the contact over -sin(tau) at a friction ratio, whether or not the contact slides there.
inline double margin(const ModeSums<double>& s, double beta, double tau) {
    const std::size_t j = s.contact.index;
    const double X_j = paper::displacement_transmissibility_of_contact(s.V[j], s.U[j], s.G[j], beta);
    return paper::sliding_margin(X_j, s.G[j], sliding_demand(s, tau), beta);
}

/// @brief Largest absolute displacement of a mass on a grid over the half-period.
inline double largest_sample(const ModeSums<double>& s, const SteadyState<double>& state, std::size_t k, int samples) {
    double largest = 0;
    for (int n = 0; n <= samples; ++n) {
        const double tau = std::min(pi<double>(), pi<double>() * n / samples);
        largest = std::max(largest, std::abs(motion(s, state, tau).x[k]));
    }
    return largest;
}

/// @brief The sums of a scene at its frequency ratio, with bounds. @param scene the scene, with r @return the sums
inline ModeSums<Bounded<double>> bounded_sums_of(const Scene<double>& scene) {
    return bounded_sums(scene.system, *modes_with_errors(scene.system), as_input(*scene.r));
}

/// @brief The decimals of a number, where it has some; else its value. @param x a number of an answer @return all of its digits
inline Real100 decimals_of(const Certified& x) { return x.decimal.empty() ? Real100(x.value) : Real100(x.decimal); }

/// @brief Checks that a number lies within its bound of another that is far more exact.
inline void check_within(const Certified& found, const Certified& exact) {
    INFO(found.value << " +- " << found.error << " and " << exact.value << " +- " << exact.error);
    CHECK(abs(Real100(decimals_of(found) - decimals_of(exact))) <= Real100(found.error));
}

/// @brief Checks that two numbers agree within their bounds.
inline void check_agree(const Certified& a, const Certified& b) {
    INFO(a.value << " +- " << a.error << " and " << b.value << " +- " << b.error);
    CHECK(abs(Real100(decimals_of(a) - decimals_of(b))) <= Real100(a.error) + Real100(b.error));
}

/// @brief Checks that the amplitudes and phases of an answer lie within their bounds of those of one that is far more exact.
inline void check_masses_within(const Solution& found, const Solution& exact) {
    REQUIRE(found.masses.size() == exact.masses.size());
    for (std::size_t k = 0; k < found.masses.size(); ++k) {
        INFO("mass " << k + 1);
        check_within(found.masses[k].amplitude, exact.masses[k].amplitude);
        if (found.masses[k].phase && exact.masses[k].phase) check_within(*found.masses[k].phase, *exact.masses[k].phase);
    }
}

/// @brief A map of one point.
inline RegimeMap map_of_point(const Scene<double>& scene, std::vector<Mass> masses = {Mass{0}}, MapStart start = MapStart::rest,
                              bool phases = false) {
    MapRequest request{{*scene.r}, {*scene.beta}, std::move(masses), start, 1};
    request.phases = phases;
    return regime_map(scene, request, std::atomic<bool>(false));
}

} // namespace denhartog::tests

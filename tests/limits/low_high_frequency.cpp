// The boundary for r -> infinity and r -> 0: limits and rates, in 50 digits.
#include <cmath>

#include "denhartog/formulas/high_frequency.hpp"
#include "denhartog/sliding/boundary.hpp"
#include "tests/catch.hpp"
#include "tests/support/multiprecision.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

/// A chain of four unequal masses, the load on the first.
System<Real50> four_masses(std::size_t j, const std::vector<Real50>& zeta) {
    System<Real50> system = chain<Real50>({1, 2.5, 0.75, 1.25}, {1, 0.625, 1.875, 0.875}, {0, 0, 0, 0}, j, 1, 1, 1).system;
    system.damping_ratios = zeta;
    return system;
}

Real50 approximate_limit(const System<Real50>& system, const Real50& r, const Real50& mu) {
    return boundary(mode_sums(modal_basis(system), system.contact, system.load, r), mu).approximate;
}

/// The power with which (67) falls at high frequency ratios.
double rate(const System<Real50>& system) {
    const Real50 r = ldexp(Real50(1), 12), mu(1.375);
    return static_cast<double>(log2(Real50(approximate_limit(system, r, mu) / approximate_limit(system, Real50(2 * r), mu))));
}

} // namespace

TEST_CASE("with the load on the contact the boundary approaches its limit at high frequencies like 1/r",
          "[eq:69][eq:86][limit]") {
    for (const double m : {1.0, 1.375, 3.0}) {
        const Real50 mu(m), limit = paper::friction_ratio_limit_at_high_frequency(mu);
        const System<Real50> system = four_masses(1, {Real50(1) / 8, Real50(1) / 4, Real50(1) / 16, Real50(3) / 8});
        const auto error = [&](const Real50& r) { return Real50(approximate_limit(system, r, mu) - limit); };
        const Real50 r = ldexp(Real50(1), 16);
        CHECK(std::abs(static_cast<double>(error(r))) < 1e-4);
        CHECK(static_cast<double>(error(r) / error(Real50(2 * r))) == Approx(2).epsilon(1e-3));
    }
}

TEST_CASE("with the load elsewhere the boundary falls to zero at a rate that depends on the damping", "[eq:69][eq:86][limit]") {
    for (const std::size_t j : {2, 3, 4}) {
        const double distance = static_cast<double>(j - 1);
        INFO("j = " << j);
        const System<Real50> undamped = four_masses(j, std::vector<Real50>(4, Real50(0)));
        CHECK(rate(undamped) == Approx(2 * distance).epsilon(1e-5));
        CHECK(rate(four_masses(j, std::vector<Real50>(4, Real50(1) / 16))) == Approx(1).epsilon(1e-2));
        const ModalBasis<Real50> basis = modal_basis(undamped);
        std::vector<Real50> by_mass, by_stiffness; // damping in proportion to the mass, and to the stiffness
        for (const Real50& r_n : basis.r_n) by_mass.push_back(1 / (16 * r_n)), by_stiffness.push_back(r_n / 16);
        CHECK(rate(four_masses(j, by_mass)) == Approx(2 * distance).epsilon(1e-5));
        CHECK(rate(four_masses(j, by_stiffness)) == Approx(distance).epsilon(1e-2));
    }
}

TEST_CASE("with the load elsewhere and damping the boundary falls with the factor that the derivation has",
          "[eq:69][eq:86][limit]") {
    const Real50 mu(1.375), r = ldexp(Real50(1), 20);
    for (const std::size_t j : {2, 3, 4}) {
        INFO("j = " << j);
        const System<Real50> system = four_masses(j, {Real50(1) / 8, Real50(1) / 4, Real50(1) / 16, Real50(3) / 8});
        const ModalBasis<Real50> basis = modal_basis(system);
        Real50 coupling(0), squares(0);
        for (Eigen::Index i = 0; i < 4; ++i) {
            const std::size_t mode = static_cast<std::size_t>(i);
            const Real50 phi_ji = basis.phi(static_cast<Eigen::Index>(j - 1), i), phi_li = basis.phi(0, i);
            coupling += phi_ji * phi_li * basis.zeta[mode] * basis.r_n[mode], squares += phi_ji * phi_ji;
        }
        const Real50 limit = 4 * abs(coupling) / (sqrt(Real50(4 * mu * mu + pi<Real50>() * pi<Real50>())) * squares * r);
        CHECK(static_cast<double>(approximate_limit(system, r, mu) / limit) == Approx(1).epsilon(1e-4));
    }
}

TEST_CASE("with damping the boundary of a single mass tends to r^2 / (1 + mu) for r -> 0", "[eq:69][limit]") {
    for (const double mu : {1.0, 1.375, 3.0})
        for (const double zeta : {0.05, 0.1, 0.5}) {
            const double r = 0.01;
            INFO("mu = " << mu << ", zeta = " << zeta);
            CHECK(boundary(sums_of(oscillator(zeta, r, mu)), mu).exact / (r * r) == Approx(1 / (1 + mu)).epsilon(1e-3));
        }
}

TEST_CASE("with damping the boundary of a chain tends to the formula for low frequency ratios", "[eq:69][limit]") {
    const Real50 mu(1.375), r = ldexp(Real50(1), -8);
    for (const std::size_t j : {1, 2, 3, 4}) {
        INFO("j = " << j);
        const System<Real50> system = four_masses(j, {Real50(1) / 8, Real50(1) / 4, Real50(1) / 16, Real50(3) / 8});
        const Real50 stretch(1); // a static load on mass 1 stretches the first spring, k_1, and moves all masses alike
        const Real50 limit = paper::friction_ratio_limit_at_low_frequency(stretch, system.mass_ratios[j - 1], r, mu);
        const ModeSums<Real50> sums = mode_sums(modal_basis(system), system.contact, system.load, r);
        CHECK(static_cast<double>(boundary(sums, mu).exact / limit) == Approx(1).epsilon(1e-3));
    }
}

TEST_CASE("without damping the boundary of a single mass over r^2 has no limit for r -> 0", "[eq:69][limit]") {
    for (const double mu : {1.0, 1.375, 3.0})
        for (int n = 1; n <= 40; n += 3) {
            const double between = 1.0 / (2 * n), pole = 1.0 / (2 * n + 1) * (1 + 1e-9);
            INFO("mu = " << mu << ", n = " << n);
            CHECK(boundary(sums_of(oscillator(0, between, mu)), mu).exact ==
                  Approx(between * between / (mu * (1 - between * between))).epsilon(1e-9));
            CHECK(boundary(sums_of(oscillator(0, pole, mu)), mu).exact / (pole * pole) < 1e-6);
        }
}

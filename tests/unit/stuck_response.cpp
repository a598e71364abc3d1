#include "denhartog/stick_slip/stuck_response.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <complex>

#include "denhartog/formulas/stuck.hpp"
#include "denhartog/number/errors.hpp"
#include "tests/catch.hpp"
#include "tests/support/half_period.hpp"
#include "tests/support/held_contact.hpp"
#include "tests/support/multiprecision.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/support/second_witness.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

StuckResponse response_of(const Scene<double>& scene) {
    return stuck_response(stuck_of(scene.system), scene.system.load, *scene.r);
}

// How far from zero the contact may rest for ever; below zero none.
double half_of_rest(const Scene<double>& scene, double beta) {
    return paper::sticking_margin(modulus(response_of(scene).contact_load), scene.mu, beta) / stuck_of(scene.system).k_contact;
}

/// Complex displacements with the contact held, from the matrices of (6): no modes.
Eigen::VectorXcd dense_response(const Scene<double>& scene) {
    NonDimensionalMatrices m = matrices_of(scene);
    const auto j = static_cast<Eigen::Index>(scene.system.contact.index);
    for (Matrix<double>* A : {&m.M, &m.C, &m.K}) {
        A->row(j).setZero();
        A->col(j).setZero();
    }
    m.K(j, j) = 1;
    Eigen::VectorXcd X = harmonic_response(m, scene.system.load.index);
    X(j) = 0;
    return X;
}

std::complex<double> number(const Complex<double>& x) { return {x.re, x.im}; }

} // namespace

TEST_CASE("the stuck response solves the equations of motion of the masses that move, whether or not their modes are coupled",
          "[eq:88][stuck]") {
    double worst = 0, worst_phase = 0;
    int coupled = 0;
    for (const RandomScene<double>& scene : random_scenes<double>(21)) {
        const StuckResponse response = response_of(scene.scene);
        coupled += !stuck_of(scene.scene.system).modes_diagonalise_damping;
        const Eigen::VectorXcd X = dense_response(scene.scene);
        const double size = X.cwiseAbs().maxCoeff();
        if (scene.scene.system.load == scene.scene.system.contact) {
            for (const StuckMass& mass : response.masses) REQUIRE(mass.amplitude == 0);
            continue;
        }
        for (std::size_t k = 0; k < response.masses.size(); ++k) {
            const StuckMass& mass = response.masses[k];
            const std::complex<double> expected = X(static_cast<Eigen::Index>(k));
            worst = std::max(worst, std::abs(number(mass.X) - expected) / size);
            if (!mass.phase || std::abs(expected) < 1e-6 * size) continue;
            worst_phase = std::max(worst_phase, std::abs(std::polar(1.0, -*mass.phase) - expected / std::abs(expected)));
        }
    }
    CHECK(coupled > 100);
    CHECK(worst < 1e-11);
    CHECK(worst_phase < 1e-8);
}

TEST_CASE("the stuck response is the periodic solution that the exponential of the state matrix has", "[eq:88][stuck]") {
    for (const std::size_t j : {1u, 2u, 3u}) {
        Scene<double> scene = three_masses<double>(1.125);
        scene.system.contact = Mass{j - 1};
        scene.system.load = Mass{j % 3};
        const StuckConfiguration stuck = stuck_of(scene.system);
        const double r = *scene.r;
        const Eigen::MatrixXd M = r * r * stuck.M, C = r * stuck.C, K = stuck.K;
        // x, x', cos tau, sin tau: one linear system; over a period the motion must come back to itself
        Eigen::MatrixXd A = Eigen::MatrixXd::Zero(6, 6);
        A.block(0, 2, 2, 2).setIdentity();
        A.block(2, 0, 2, 2) = -M.inverse() * K;
        A.block(2, 2, 2, 2) = -M.inverse() * C;
        const std::size_t l = scene.system.load.index;
        A.block(2, 4, 2, 1) = M.inverse().col(static_cast<Eigen::Index>(l < j - 1 ? l : l - 1));
        A(4, 5) = -1;
        A(5, 4) = 1;
        const Eigen::MatrixXd period = matrix_exponential(Matrix<double>(A * 2 * pi<double>()));
        const Eigen::VectorXd start =
            (Eigen::MatrixXd::Identity(4, 4) - period.topLeftCorner(4, 4)).fullPivLu().solve(period.block(0, 4, 4, 1));
        const StuckResponse response = response_of(scene);
        for (std::size_t a = 0; a < 2; ++a) {
            const Complex<double> X = response.masses[stuck.masses[a].index].X; // Re{X exp(i tau)} and its rate at tau = 0
            CHECK(X.re == Approx(start(static_cast<Eigen::Index>(a))).margin(1e-12));
            CHECK(-X.im == Approx(start(static_cast<Eigen::Index>(a) + 2)).margin(1e-12));
        }
    }
}

TEST_CASE("the amplitude of the load on the held contact is the largest Sigma_j over a period", "[eq:75][eq:88][stuck]") {
    Scene<double> scene = three_masses<double>(0.875);
    const std::size_t j = scene.system.contact.index;
    const NonDimensionalMatrices m = matrices_of(scene);
    for (const std::size_t l : {0u, 1u, 2u}) {
        scene.system.load = Mass{l};
        const StuckResponse response = response_of(scene);
        double largest = 0;
        std::vector<double> C_j, K_j;
        for (Eigen::Index k = 0; k < 3; ++k) {
            C_j.push_back(m.C(static_cast<Eigen::Index>(j), k));
            K_j.push_back(m.K(static_cast<Eigen::Index>(j), k));
        }
        for (int n = 0; n < 20000; ++n) {
            const double tau = 2 * pi<double>() * n / 20000;
            std::vector<double> x, x_prime;
            for (const StuckMass& mass : response.masses) {
                const std::complex<double> now = number(mass.X) * std::polar(1.0, tau);
                x.push_back(now.real());
                x_prime.push_back(-now.imag());
            }
            largest = std::max(largest, std::abs(paper::dynamic_load_on_contact<double>(C_j, K_j, x, x_prime, l == j, tau)));
        }
        CHECK(modulus(response.contact_load) == Approx(largest).epsilon(1e-7));
    }
}

TEST_CASE("the boundary of permanent sticking is the friction that makes the free motion of the contact vanish",
          "[eq:88][stuck]") {
    Real50 worst = 0;
    double worst_in_double = 0;
    const std::vector<RandomScene<double>> in_double = random_scenes<double>(22);
    const std::vector<RandomScene<Real50>> in_50 = random_scenes<Real50>(22);
    for (std::size_t n = 0; n < in_50.size() && number_of_masses(in_50[n].scene.system) <= 4; ++n) {
        const ModeSums<Real50> sums = sums_of(in_50[n].scene);
        const std::vector<Real50> anywhere(sums.R.size(), Real50(0));
        const Real50 by_force = boundary_at(sums, in_50[n].scene.mu, Real50(0), anywhere).sticking.value();
        Scene<Real50> held = in_50[n].scene;
        held.beta = Real50(0);
        const Real50 load(modulus(held_contact(half_period_problem(held)).load));
        worst = std::max(worst, Real50(abs(load / in_50[n].scene.mu / by_force - 1)));
        worst_in_double =
            std::max(worst_in_double, std::abs(sticking_limits(in_double[n].scene).exact / static_cast<double>(by_force) - 1));
    }
    CHECK(worst < Real50("1e-42")); // the sums over the sliding modes cancel where the contact hardly moves
    CHECK(worst_in_double < 1e-12);
}

TEST_CASE("load on the contact: the boundary of permanent sticking is 1/mu, damped or not, and no other mass moves",
          "[eq:88][stuck]") {
    Scene<double> scene = three_masses<double>();
    scene.system.load = scene.system.contact;
    const StickingBoundary b = sticking_limits(scene);
    CHECK(b.exact == 1 / scene.mu);
    CHECK(*b.paper == 1 / scene.mu);
    CHECK(b.without_damping_load == 1 / scene.mu);
    CHECK(paper::sticking_limit_under_load(scene.mu) == b.exact);
    for (const StuckMass& mass : response_of(scene).masses) CHECK_FALSE(mass.phase);
}

TEST_CASE("without damping, or with damping proportional to the masses, the springs alone load the held contact",
          "[eq:88][stuck]") {
    for (const double z : {0.0, 0.0625}) {
        Scene<double> scene = three_masses<double>(0.75);
        const ModalBasis<double> basis = modal_basis(scene.system);
        for (std::size_t i = 0; i < 3; ++i) scene.system.damping_ratios[i] = z / basis.r_n[i];
        for (const std::size_t l : {0u, 2u}) {
            scene.system.load = Mass{l};
            const StickingBoundary b = sticking_limits(scene);
            CHECK(*b.paper == Approx(b.exact).epsilon(1e-13));
            CHECK(b.without_damping_load == Approx(b.exact).epsilon(1e-13));
            CHECK(response_of(scene).masses[2 - l].amplitude < 1e-15); // nothing reaches the far side
        }
    }
}

TEST_CASE("(88) speaks of chains only", "[eq:88][stuck]") {
    Scene<double> scene = three_masses<double>();
    scene.system.stiffness_ratios.clear();
    scene.system.stiffness_matrix = Matrix<double>{{2, -1, -0.5}, {-1, 2, 0}, {-0.5, 0, 1}};
    CHECK_FALSE(stuck_chain(scene.system, stuck_of(scene.system)));
    CHECK_FALSE(sticking_limits(scene).paper);
}

TEST_CASE("an undamped stuck resonance has no response where the load excites it, and one where it does not", "[eq:88][stuck]") {
    Scene<double> scene = chain({1, 1, 1}, {1, 1, 1}, {0, 0, 0}, 2, 1, 1, 1);
    scene.r = std::sqrt(2.0); // the first mass between two springs
    CHECK_THROWS_AS(response_of(scene), DomainError);
    scene.system.load = Mass{2}; // the third mass hangs on one: 1 / (1 - r^2)
    CHECK(response_of(scene).masses[2].amplitude == Approx(1).epsilon(1e-14));
    CHECK(response_of(scene).masses[0].amplitude == 0);
    CHECK(*response_of(scene).masses[2].phase == pi<double>());
    scene.r = 1;
    CHECK_THROWS_AS(response_of(scene), DomainError);
}

TEST_CASE("at both ends of the interval of rest the load just reaches the static friction", "[eq:74][eq:88][stuck]") {
    const Scene<double> scene = three_masses<double>(0.875);
    const StuckResponse response = response_of(scene);
    const double limit = sticking_limits(scene).exact, beta = 1.5 * limit;
    const double half = half_of_rest(scene, beta);
    // displaced by `half` the others follow statically: the force that holds the contact there, from the full stiffness matrix
    const NonDimensionalMatrices m = matrices_of(scene);
    const Eigen::VectorXd unit = Eigen::VectorXd::Unit(3, 1);
    const double force = half / unit.dot(m.K.fullPivLu().solve(unit));
    CHECK(paper::sticking_margin(force + modulus(response.contact_load), scene.mu, beta) == Approx(0).margin(1e-14));
    CHECK(half_of_rest(scene, limit) == Approx(0).margin(1e-15));
    CHECK(half_of_rest(scene, limit * (1 - 1e-9)) < 0);
}

TEST_CASE("the stuck response is that of a dense system in 50 digits", "[eq:88][stuck]") {
    const StuckResponse in_double = response_of(three_masses<double>());
    const HeldContact<Real50> truth = held_contact(half_period_problem(with_beta(three_masses<double>(), 0)));
    for (const std::size_t k : {0u, 2u}) {
        CHECK(abs(Real50(in_double.masses[k].X.re - truth.X[k].re)) < 1e-14);
        CHECK(abs(Real50(in_double.masses[k].X.im - truth.X[k].im)) < 1e-14);
    }
    CHECK(abs(Real50(in_double.contact_load.re + truth.load.re)) < 1e-14); // what holds the contact acts against it
    CHECK(abs(Real50(in_double.contact_load.im + truth.load.im)) < 1e-14);
}

TEST_CASE("arguments of the stuck response that break a rule are named", "[stuck]") {
    const Scene<double> scene = three_masses<double>();
    const StuckConfiguration stuck = stuck_of(scene.system);
    CHECK_THROWS_AS(stuck_response(stuck, Mass{0}, 0.0), InputError);
    CHECK_THROWS_AS(stuck_response(stuck, Mass{3}, 1.0), InputError);
}

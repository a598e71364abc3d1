#include <Eigen/Dense>
#include <cmath>
#include <complex>

#include "denhartog/stick_slip/stuck_response.hpp"
#include "tests/support/held_contact.hpp"
#include "tests/support/rotations.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/support/second_witness.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog::tests;
using namespace denhartog;

namespace {

// By Denman and Beavers' iteration: no eigenvalue is asked for.
Eigen::MatrixXd square_root(const Eigen::MatrixXd& A) {
    Eigen::MatrixXd root = A, inverse = Eigen::MatrixXd::Identity(A.rows(), A.cols());
    for (int n = 0; n < 12; ++n) {
        const Eigen::MatrixXd next = (root + inverse.inverse()) / 2;
        inverse = (inverse + root.inverse()).eval() / 2;
        root = next;
    }
    return root;
}

// Modes with the contact held, by Jacobi's rotations of the matrices without its row and column.
template <class T>
ModesByRotations<T> held_modes(const System<T>& s) {
    const Matrix<T> M = mass_of<T>(s), K = stiffness_of<T>(s);
    std::vector<Eigen::Index> others;
    for (Eigen::Index k = 0; k < M.rows(); ++k)
        if (k != static_cast<Eigen::Index>(s.contact.index)) others.push_back(k);
    return modes_by_rotations(Matrix<T>(M(others, others)), Matrix<T>(K(others, others)));
}

} // namespace

TEST_CASE("with the contact of a single mass held nothing moves", "[eq:88][stuck]") {
    const System<double> s = chain({1}, {1}, {0.125}, 1, 1, 1, 1).system;
    const ModalBasis<double> basis = modal_basis(s);
    const long before = eigen_solves();
    const StuckConfiguration stuck = stuck_configuration(s, basis);
    CHECK(eigen_solves() == before);
    CHECK(stuck.masses.empty());
    CHECK(stuck.r_n.empty());
    CHECK(stuck.modes_diagonalise_damping);
    CHECK(stuck.k_contact == 1);
    CHECK(stuck.k_jj == 1);
}

TEST_CASE("one of two masses vibrates between its springs, which takes no eigenproblem", "[eq:88][stuck]") {
    const std::vector<double> gamma{1, 2.5}, kappa{1, 0.625};
    for (const std::size_t j : {1u, 2u}) {
        const System<double> s = chain(gamma, kappa, {0.03125, 0.0625}, j, 1, 1, 1).system;
        const ModalBasis<double> basis = modal_basis(s);
        const long before = eigen_solves();
        const StuckConfiguration stuck = stuck_configuration(s, basis);
        CHECK(eigen_solves() == before);
        REQUIRE(stuck.masses == std::vector<Mass>{Mass{2 - j}});
        CHECK(stuck.r_n[0] == Approx(j == 2 ? std::sqrt(kappa[0] + kappa[1]) : std::sqrt(kappa[1] / gamma[1])).epsilon(1e-15));
        CHECK(stuck.phi(0, 0) == Approx(1 / std::sqrt(gamma[2 - j])).epsilon(1e-15));
        CHECK(stuck.k_j[0] == -kappa[1]);
        CHECK(largest_coupling(stuck.damping) == 0);
    }
}

TEST_CASE("three masses and more take one eigenproblem, and the stuck modes solve it", "[eq:15][eq:88][stuck]") {
    double worst = 0;
    for (const RandomScene<double>& scene : random_scenes<double>(11)) {
        const System<double>& s = scene.scene.system;
        if (number_of_masses(s) < 3) continue;
        const ModalBasis<double> basis = modal_basis(s);
        const long before = eigen_solves();
        const StuckConfiguration stuck = stuck_configuration(s, basis);
        REQUIRE(eigen_solves() == before + 1);
        const auto n = static_cast<Eigen::Index>(stuck.masses.size());
        const Eigen::VectorXd squares = Eigen::Map<const Eigen::VectorXd>(stuck.r_n.data(), n).array().square();
        const double highest = squares.maxCoeff();
        const Matrix<double> orthonormal = stuck.phi.transpose() * stuck.M * stuck.phi - Matrix<double>::Identity(n, n);
        const Matrix<double> diagonal = stuck.phi.transpose() * stuck.K * stuck.phi - Matrix<double>(squares.asDiagonal());
        worst = std::max({worst, orthonormal.cwiseAbs().maxCoeff(), diagonal.cwiseAbs().maxCoeff() / highest});
        for (std::size_t i = 0; i < stuck.r_n.size(); ++i) { // the frequencies interlace
            REQUIRE(stuck.r_n[i] >= basis.r_n[i] * (1 - 1e-12));
            REQUIRE(stuck.r_n[i] <= basis.r_n[i + 1] * (1 + 1e-12));
        }
    }
    CHECK(worst < 1e-13);
}

TEST_CASE("a chain falls into two, and has the modes of its matrices", "[eq:15][eq:88][stuck]") {
    for (const std::size_t j : {1u, 2u, 3u, 5u}) {
        const System<double> s =
            chain({1, 2.5, 0.75, 1.5, 3}, {1, 0.625, 1.875, 0.25, 2}, {0.01, 0.02, 0.03, 0.04, 0.05}, j, 1, 1, 1).system;
        const StuckConfiguration two = stuck_of(s), one = stuck_of(with_stiffness_matrix(s));
        for (std::size_t i = 0; i < 4; ++i) {
            CAPTURE(j, i);
            CHECK(two.r_n[i] == Approx(one.r_n[i]).epsilon(1e-14));
            for (Eigen::Index k = 0; k < 4; ++k)
                CHECK(two.phi(k, static_cast<Eigen::Index>(i)) == Approx(one.phi(k, static_cast<Eigen::Index>(i))).margin(1e-13));
        }
        CHECK(largest_coupling(two.damping) == Approx(largest_coupling(one.damping)).epsilon(1e-12));
    }
}

TEST_CASE("a stuck chain keeps the digits of every frequency however stiff its springs", "[eq:15][stuck][accuracy]") {
    const std::vector<double> gamma{1, 0.5, 2, 1, 3, 1}, kappa{1, 0x1p+40, 1, 0.5, 0x1p-30, 0x1p+20}, zeta(6, 0.01);
    const StuckConfiguration in_double = stuck_of(chain<double>(gamma, kappa, zeta, 4, 1, 1, 1).system);
    const std::vector<Real100> exact = held_modes(chain<Real100>(gamma, kappa, zeta, 4, 1, 1, 1).system).r_n;
    for (std::size_t i = 0; i < in_double.r_n.size(); ++i) {
        CAPTURE(i, in_double.r_n[i]);
        CHECK(std::abs(static_cast<double>(in_double.r_n[i] / exact[i] - 1)) < 4e-15);
    }
}

TEST_CASE("the static stiffness of the contact is that of the springs between it and the ground", "[eq:88][stuck]") {
    const System<double> s = three_masses<double>().system;
    const double in_series = 1 / (1 / 1.0 + 1 / 0.625);
    CHECK(stuck_of(s).k_contact == Approx(in_series).epsilon(1e-15));
    for (const RandomScene<double>& scene : random_scenes<double>(12)) {
        const System<double>& system = scene.scene.system;
        const auto j = static_cast<Eigen::Index>(system.contact.index);
        const Matrix<double> K = matrices_of(scene.scene).K;
        const double expected = 1 / K.fullPivLu().inverse()(j, j);
        REQUIRE(stuck_of(system).k_contact == Approx(expected).epsilon(1e-11));
    }
}

TEST_CASE("damping proportional to mass and stiffness leaves the stuck modes uncoupled", "[eq:18][eq:88][stuck]") {
    double largest = 0;
    int proportional = 0;
    for (const RandomScene<double>& scene : random_scenes<double>(13)) {
        if (scene.scene.system.damping_matrix.size() == 0) continue;
        ++proportional;
        const StuckConfiguration stuck = stuck_of(scene.scene.system);
        CAPTURE(scene.name, largest_coupling(stuck.damping));
        REQUIRE(stuck.modes_diagonalise_damping);
        largest = std::max(largest, largest_coupling(stuck.damping));
    }
    CHECK(proportional > 50);
    CHECK(largest < 1e-12);
}

TEST_CASE("equal damping ratios couple the stuck modes of more than two masses", "[eq:18][eq:19][eq:88][stuck]") {
    for (const std::size_t N : {3u, 4u, 5u, 8u})
        for (std::size_t j = 1; j <= N; ++j) {
            const System<double> s = chain_of(std::vector<double>(N, 1), std::vector<double>(N, 1), 0.01, j);
            const StuckConfiguration stuck = stuck_of(s);
            CAPTURE(N, j, largest_coupling(stuck.damping));
            CHECK_FALSE(stuck.modes_diagonalise_damping);
            CHECK(largest_coupling(stuck.damping) > 0.02);
            // by the square root of the stiffness matrix: with M = 1 and equal ratios C = 2 zeta sqrt(K)
            const Eigen::MatrixXd K = matrices_of(Scene<double>{s, 1.0, 1.0, {}, {}, {}}).K;
            const Eigen::MatrixXd C = 0.02 * square_root(K);
            for (std::size_t a = 0; a < stuck.masses.size(); ++a) {
                const auto row = static_cast<Eigen::Index>(stuck.masses[a].index);
                CHECK(stuck.c_j[a] == Approx(C(static_cast<Eigen::Index>(j) - 1, row)).margin(1e-15));
                for (std::size_t b = 0; b < stuck.masses.size(); ++b)
                    CHECK(stuck.C(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) ==
                          Approx(C(row, static_cast<Eigen::Index>(stuck.masses[b].index))).margin(1e-15));
            }
        }
}

TEST_CASE("stuck modes with one frequency are turned to those that damping does not couple", "[eq:18][eq:88][stuck]") {
    System<double> s = chain_of({1, 1, 1}, {1, 1, 1}, 0.01, 2);
    s.stiffness_ratios.clear();
    s.stiffness_matrix = Matrix<double>{{2, -1, 0}, {-1, 2, -1}, {0, -1, 2}}; // symmetric about the contact
    s.damping_ratios = {0.0625, 0.125, 0.03125};
    const StuckConfiguration stuck = stuck_of(s);
    CHECK(stuck.r_n[0] == Approx(stuck.r_n[1]).epsilon(1e-15));
    CHECK(std::abs(stuck.C(0, 1)) > 0.01); // each mass on its own would be coupled
    CHECK(stuck.modes_diagonalise_damping);
    CHECK(std::abs(stuck.phi(0, 0)) == Approx(std::sqrt(0.5)).epsilon(1e-12));
}

namespace {

StuckResponse response_of(const Scene<double>& scene) {
    return stuck_response(stuck_of(scene.system), scene.system.load, *scene.r);
}

// Largest distance from zero at which the contact may rest for ever; negative if there is none.
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

TEST_CASE("the boundary of permanent sticking is the force that holds the contact over mu, in 50 digits",
          "[eq:88][stuck][sticking]") {
    for (const RandomScene<double>& random : random_scenes<double>(22)) {
        const Scene<double>& scene = random.scene;
        if (number_of_masses(scene.system) > 4) break;
        const Real50 load(modulus(held_contact(half_period_problem(with_beta(scene, 0))).load));
        INFO(random.name);
        CHECK(sticking_limits(scene).exact == Approx(static_cast<double>(load) / scene.mu).epsilon(1e-12));
        const std::optional<double> by_sums = boundary(sums_of(scene), scene.mu).sticking;
        CHECK(by_sums.value() == Approx(static_cast<double>(load) / scene.mu).epsilon(1e-9));
        if (scene.system.contact == scene.system.load) CHECK(by_sums == 1 / scene.mu);
    }
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

TEST_CASE("arguments of the stuck response that break a rule are named", "[stuck]") {
    const Scene<double> scene = three_masses<double>();
    const StuckConfiguration stuck = stuck_of(scene.system);
    CHECK_THROWS_AS(stuck_response(stuck, Mass{0}, 0.0), InputError);
    CHECK_THROWS_AS(stuck_response(stuck, Mass{3}, 1.0), InputError);
}

#include "denhartog/model/stuck_configuration.hpp"

#include <Eigen/Dense>
#include <cmath>

#include "tests/catch.hpp"
#include "tests/support/rotations.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

System<double> equal_chain(std::size_t N, std::size_t j, double zeta) {
    const std::vector<double> ones(N, 1.0);
    return chain_of(ones, ones, zeta, j);
}

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

std::vector<Eigen::Index> all_but(Mass contact, Eigen::Index N) {
    std::vector<Eigen::Index> others;
    for (Eigen::Index k = 0; k < N; ++k)
        if (k != static_cast<Eigen::Index>(contact.index)) others.push_back(k);
    return others;
}

// Modes with the contact held, by Jacobi's rotations of the matrices without its row and column.
template <class T>
ModesByRotations<T> held_modes(const System<T>& s) {
    const Matrix<T> M = mass_of<T>(s), K = stiffness_of<T>(s);
    const std::vector<Eigen::Index> others = all_but(s.contact, M.rows());
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

TEST_CASE("damping proportional to mass and stiffness leaves the stuck modes uncoupled, in every precision",
          "[eq:18][eq:88][stuck]") {
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
    for (const RandomScene<Real50>& scene : random_scenes<Real50>(13)) {
        if (scene.scene.system.damping_matrix.size() == 0 || number_of_masses(scene.scene.system) != 4) continue;
        const Matrix<Real50> phi = held_modes(scene.scene.system).phi;
        const std::vector<Eigen::Index> others = all_but(scene.scene.system.contact, 4);
        const Matrix<Real50> D = phi.transpose() * scene.scene.system.damping_matrix(others, others) * phi;
        for (Eigen::Index i = 0; i < 3; ++i)
            for (Eigen::Index k = 0; k < i; ++k) REQUIRE(abs(D(i, k)) < Real50("1e-45") * sqrt(Real50(D(i, i) * D(k, k))));
    }
}

TEST_CASE("equal damping ratios couple the stuck modes of more than two masses", "[eq:18][eq:19][eq:88][stuck]") {
    for (const std::size_t N : {3u, 4u, 5u, 8u})
        for (std::size_t j = 1; j <= N; ++j) {
            const System<double> s = equal_chain(N, j, 0.01);
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
    System<double> s = equal_chain(3, 2, 0.01);
    s.stiffness_ratios.clear();
    s.stiffness_matrix = Matrix<double>{{2, -1, 0}, {-1, 2, -1}, {0, -1, 2}}; // symmetric about the contact
    s.damping_ratios = {0.0625, 0.125, 0.03125};
    const StuckConfiguration stuck = stuck_of(s);
    CHECK(stuck.r_n[0] == Approx(stuck.r_n[1]).epsilon(1e-15));
    CHECK(std::abs(stuck.C(0, 1)) > 0.01); // each mass on its own would be coupled
    CHECK(stuck.modes_diagonalise_damping);
    CHECK(std::abs(stuck.phi(0, 0)) == Approx(std::sqrt(0.5)).epsilon(1e-12));
}

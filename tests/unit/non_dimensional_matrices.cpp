#include <Eigen/LU>
#include <cmath>
#include <complex>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <span>

#include "denhartog/formulas/mode.hpp"
#include "denhartog/formulas/system.hpp"
#include "denhartog/model/modal_basis.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/scene/scene_json.hpp"
#include "tests/catch.hpp"
#include "tests/support/scene_builder.hpp"

using namespace denhartog;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

} // namespace

TEST_CASE("the non-dimensional equation of motion is the dimensional one over P",
          "[model][eq:1][eq:2][eq:4][eq:5][eq:6][eq:7][eq:8][eq:9][eq:10][eq:11][eq:73]") {
    const double m[] = {3, 7.5, 2};
    const double k[] = {40, 25, 90, 0};
    const double a = 0.375;
    const double b = 0.015625;
    const double P = 5.5;
    const double F = 1.25;
    const double omega = 2.75;
    nlohmann::json text = {{"masses", {m[0], m[1], m[2]}}, {"stiffnesses", {k[0], k[1], k[2]}}, {"contact", 3}, {"load", 2}};
    text.update({{"force", P}, {"friction", F}, {"frequency", omega}});
    Matrix<double> M = Matrix<double>::Zero(3, 3);
    Matrix<double> K = Matrix<double>::Zero(3, 3);
    for (int i = 0; i < 3; ++i) {
        M(i, i) = m[i];
        K(i, i) = k[i] + k[i + 1];
        if (i > 0) K(i, i - 1) = K(i - 1, i) = -k[i];
    }
    const Matrix<double> C = a * M + b * K;
    for (int i = 0; i < 3; ++i) text["damping_matrix"].push_back({C(i, 0), C(i, 1), C(i, 2)});
    const Scene<double> scene = read_scene<double>(text.dump());
    const NonDimensionalMatrices bar = non_dimensional_matrices(scene.system, modal_basis(scene.system), *scene.r);
    for (int i = 0; i < 3; ++i)
        for (int n = 0; n < 3; ++n) {
            REQUIRE(std::abs(paper::non_dimensional_mass(M(i, n), omega, k[0]) - bar.M(i, n)) < 16 * eps);
            REQUIRE(std::abs(paper::non_dimensional_damping(C(i, n), omega, k[0]) - bar.C(i, n)) < 16 * eps);
            REQUIRE(std::abs(paper::stiffness_ratio(K(i, n), k[0]) - bar.K(i, n)) < 16 * eps);
        }

    std::mt19937_64 random(4);
    const auto any = [&] { return static_cast<double>(random() % 2001) / 1000 - 1; };
    for (int trial = 0; trial < 20; ++trial) {
        Matrix<double> x(3, 1);
        Matrix<double> v(3, 1);
        Matrix<double> acceleration(3, 1);
        for (int i = 0; i < 3; ++i) {
            x(i) = any();
            v(i) = any();
            acceleration(i) = any();
        }
        const double t = 3 * any();
        const double sgn = v(2) > 0 ? 1 : -1;
        Matrix<double> dimensional = M * acceleration + C * v + K * x;
        dimensional(2) -= paper::friction_force(F, sgn);
        dimensional(1) -= P * std::cos(omega * t);
        const double unit = paper::non_dimensional_displacement(1.0, k[0], P);
        Matrix<double> bare = bar.M * acceleration * unit / (omega * omega) + bar.C * v * unit / omega + bar.K * x * unit;
        bare(2) += *scene.beta * sgn;
        bare(1) -= std::cos(paper::non_dimensional_time(omega, t));
        REQUIRE((dimensional / P - bare).cwiseAbs().maxCoeff() < 1024 * eps);
    }
}

TEST_CASE("mode shapes over r are normalised by the non-dimensional mass matrix", "[model][eq:8][eq:17][eq:22]") {
    const System<double> s = chain_of({1, 2.5, 0.75}, {1, 0.625, 1.875}, 0.03125);
    const ModalBasis<double> basis = modal_basis(s);
    for (const double r : {0.125, 1.0, 3.5}) {
        const NonDimensionalMatrices matrices = non_dimensional_matrices(s, basis, r);
        const Matrix<double> psi = basis.phi / r;
        const Matrix<double> modal_mass = psi.transpose() * matrices.M * psi;
        const Matrix<double> modal_stiffness = psi.transpose() * matrices.K * psi;
        for (Eigen::Index i = 0; i < 3; ++i)
            for (Eigen::Index k = 0; k < 3; ++k) {
                const double Omega = basis.r_n[static_cast<std::size_t>(i)] / r;
                REQUIRE(std::abs(modal_mass(i, k) - (i == k ? 1 : 0)) < 64 * eps);
                REQUIRE(std::abs(modal_stiffness(i, k) - (i == k ? Omega * Omega : 0)) < 64 * eps * 16 / (r * r));
                REQUIRE(std::abs(paper::modal_frequency_ratio(Omega) - r / basis.r_n[static_cast<std::size_t>(i)]) <
                        4 * eps * r * 4);
            }
    }
}

TEST_CASE("the damping matrix (19) gives the damping ratios back through (18)", "[model][eq:18][eq:19]") {
    System<double> s = chain_of({1, 2.5, 0.75, 1}, {1, 0.625, 1.875, 2});
    s.damping_ratios = {0.03125, 0.5, 0, 0.125};
    const ModalBasis<double> basis = modal_basis(s);
    const double r = 1.375;
    const NonDimensionalMatrices matrices = non_dimensional_matrices(s, basis, r);
    REQUIRE(matrices.C == Matrix<double>(matrices.C.transpose()));
    const Matrix<double> psi = basis.phi / r;
    const Matrix<double> modal_damping = psi.transpose() * matrices.C * psi;
    for (Eigen::Index i = 0; i < 4; ++i)
        for (Eigen::Index k = 0; k < 4; ++k) {
            const auto mode = static_cast<std::size_t>(i);
            REQUIRE(std::abs(modal_damping(i, k) - (i == k ? 2 * s.damping_ratios[mode] * basis.r_n[mode] / r : 0)) < 256 * eps);
        }
    System<double> by_matrix = s;
    by_matrix.damping_ratios.clear();
    by_matrix.damping_matrix = matrices.C / r;
    const ModalBasis<double> again = modal_basis(by_matrix);
    for (std::size_t i = 0; i < 4; ++i) REQUIRE(std::abs(again.zeta[i] - s.damping_ratios[i]) < 64 * eps);
    REQUIRE((non_dimensional_matrices(by_matrix, again, r).C - matrices.C).cwiseAbs().maxCoeff() < 4 * eps);
}

TEST_CASE("modal superposition gives the harmonic response of the coupled equations", "[model][eq:13][eq:16][eq:18][eq:19]") {
    System<double> s = chain_of({1, 2.5, 0.75}, {1, 0.625, 1.875});
    s.damping_ratios = {0.03125, 0.25, 0.125};
    const ModalBasis<double> basis = modal_basis(s);
    const double r = 1.125;
    const NonDimensionalMatrices matrices = non_dimensional_matrices(s, basis, r);
    const std::complex<double> i_unit(0, 1);
    const Matrix<std::complex<double>> dynamic =
        (matrices.K - matrices.M).cast<std::complex<double>>() + i_unit * matrices.C.cast<std::complex<double>>();
    for (Eigen::Index l = 0; l < 3; ++l) {
        const Matrix<std::complex<double>> direct =
            dynamic.partialPivLu().solve(Matrix<std::complex<double>>::Identity(3, 3).col(l));
        for (Eigen::Index k = 0; k < 3; ++k) {
            std::complex<double> sum = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                const double Omega = basis.r_n[i] / r;
                sum += basis.phi(k, i) * basis.phi(l, i) / (r * r) / (Omega * Omega - 1 + 2.0 * i_unit * basis.zeta[i] * Omega);
            }
            REQUIRE(std::abs(sum - direct(k, 0)) < 128 * eps * direct.cwiseAbs().maxCoeff());
        }
    }
}

TEST_CASE("a frequency ratio that is no positive number gives no matrices", "[model][bad-input]") {
    const System<double> s = chain_of({1}, {1}, 0.125);
    const ModalBasis<double> basis = modal_basis(s);
    for (const double r : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        REQUIRE_THROWS_AS(non_dimensional_matrices(s, basis, r), InputError);
}

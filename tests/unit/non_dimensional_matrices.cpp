#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>

#include "denhartog/formulas/mode.hpp"
#include "denhartog/formulas/system.hpp"
#include "denhartog/model/modal_basis.hpp"
#include "denhartog/model/natural_modes.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/scene/scene_json.hpp"
#include "tests/catch.hpp"
#include "tests/support/multiprecision.hpp"
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

TEST_CASE("a frequency ratio that is no positive number gives no matrices", "[model][bad-input]") {
    const System<double> s = chain_of({1}, {1}, 0.125);
    const ModalBasis<double> basis = modal_basis(s);
    for (const double r : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        REQUIRE_THROWS_AS(non_dimensional_matrices(s, basis, r), InputError);
}

namespace {

/// An upper bidiagonal matrix in doubles.
struct Bidiagonal {
    std::vector<double> d;
    std::vector<double> e;
};

std::vector<std::size_t> all_rows(std::size_t N) {
    std::vector<std::size_t> rows(N);
    std::iota(rows.begin(), rows.end(), std::size_t(0));
    return rows;
}

Bidiagonal random_bidiagonal(std::mt19937_64& random, std::size_t N, int binary_orders) {
    const auto entry = [&] {
        const double fraction = 1 + std::ldexp(static_cast<double>(random() >> 12), -52);
        const double sign = random() % 2 == 0 ? 1 : -1;
        return sign *
               std::ldexp(fraction, static_cast<int>(random() % static_cast<unsigned>(2 * binary_orders + 1)) - binary_orders);
    };
    Bidiagonal B;
    for (std::size_t i = 0; i < N; ++i) B.d.push_back(entry());
    for (std::size_t i = 0; i + 1 < N; ++i) B.e.push_back(entry());
    return B;
}

/// Number of singular values below s, by Sylvester's law of inertia: the symmetric tridiagonal matrix with zeros on its
/// diagonal and d[0], e[0], d[1], e[1], ... beside it has the eigenvalues +-sigma. Its negative pivots less s are counted in 50
/// digits: a route that shares no step with the iteration.
std::size_t singular_values_below(const Bidiagonal& B, const Real50& s) {
    std::size_t negative = 1;
    Real50 pivot = -s;
    for (std::size_t i = 0; i + 1 < 2 * B.d.size(); ++i) {
        const Real50 beside = i % 2 == 0 ? B.d[i / 2] : B.e[i / 2];
        pivot = -s - beside * beside / pivot;
        if (pivot < 0) ++negative;
    }
    return negative - B.d.size();
}

/// Singular value i of the computed ones lies within a relative `margin` of the exact one.
bool bracketed(const Bidiagonal& B, double sigma, std::size_t i, double margin) {
    const Real50 s = sigma;
    return singular_values_below(B, s * (1 - Real50(margin))) <= i && singular_values_below(B, s * (1 + Real50(margin))) > i;
}

void require_high_relative_accuracy(const Bidiagonal& B) {
    const std::size_t N = B.d.size();
    const NaturalModes found = bidiagonal_singular_values(B.d, B.e, all_rows(B.d.size()));
    const double margin = 4 * static_cast<double>(N) * std::numeric_limits<double>::epsilon();
    for (std::size_t i = 0; i < N; ++i) {
        INFO("singular value " << i << " of " << N << ": " << tests::hexadecimal(found.r_n[i]) << ", d[0] "
                               << tests::hexadecimal(B.d[0]));
        REQUIRE(bracketed(B, found.r_n[i], i, margin));
    }
}

} // namespace

TEST_CASE("the count of singular values below a number notices a relative error of a few units in the last place",
          "[bidiagonal]") {
    const Bidiagonal B{{1e8, 1, 1e-8}, {1e8, 1}};
    const NaturalModes found = bidiagonal_singular_values(B.d, B.e, all_rows(B.d.size()));
    for (std::size_t i = 0; i < 3; ++i) {
        REQUIRE(bracketed(B, found.r_n[i], i, 1e-15));
        REQUIRE_FALSE(bracketed(B, found.r_n[i] * (1 + 4e-15), i, 1e-15));
        REQUIRE_FALSE(bracketed(B, found.r_n[i] * (1 - 4e-15), i, 1e-15));
    }
}

TEST_CASE("every singular value has high relative accuracy however far apart the entries lie", "[bidiagonal]") {
    std::mt19937_64 random(20220535);
    const int binary_orders = GENERATE(1, 4, 13, 27, 40, 100);
    for (int trial = 0; trial < 60; ++trial)
        require_high_relative_accuracy(random_bidiagonal(random, 1 + random() % 12, binary_orders));
    require_high_relative_accuracy(random_bidiagonal(random, 40, binary_orders));
}

TEST_CASE("graded, clustered and nearly reducible matrices keep the relative accuracy", "[bidiagonal]") {
    Bidiagonal graded_down;
    Bidiagonal graded_up;
    Bidiagonal ones;
    Bidiagonal clustered;
    for (int i = 0; i < 24; ++i) {
        graded_down.d.push_back(std::ldexp(1.0, -4 * i));
        graded_up.d.push_back(std::ldexp(1.0, 4 * i));
        ones.d.push_back(1);
        clustered.d.push_back(1);
        if (i == 23) break;
        graded_down.e.push_back(std::ldexp(1.0, -4 * i - 2));
        graded_up.e.push_back(std::ldexp(1.0, 4 * i + 2));
        ones.e.push_back(-1);
        clustered.e.push_back(std::ldexp(1.0, -30 - i));
    }
    require_high_relative_accuracy(graded_down);
    require_high_relative_accuracy(graded_up);
    require_high_relative_accuracy(ones);
    require_high_relative_accuracy(clustered);
    require_high_relative_accuracy({{1, 1}, {1e-14}});
    require_high_relative_accuracy({{1, 1, 1}, {0, 1}});
    require_high_relative_accuracy({{1, 1e-150}, {1}});
    require_high_relative_accuracy({{1e-150, 1}, {1e150}});
    require_high_relative_accuracy({{-3}, {}});
}

TEST_CASE("right singular vectors are orthonormal and stretch to their singular values", "[bidiagonal]") {
    std::mt19937_64 random(7);
    for (int trial = 0; trial < 40; ++trial) {
        const std::size_t N = 2 + random() % 20;
        const Bidiagonal B = random_bidiagonal(random, N, 3);
        const NaturalModes found = bidiagonal_singular_values(B.d, B.e, all_rows(B.d.size()));
        Matrix<double> dense = Matrix<double>::Zero(static_cast<Eigen::Index>(N), static_cast<Eigen::Index>(N));
        for (std::size_t i = 0; i < N; ++i) {
            dense(i, i) = B.d[i];
            if (i + 1 < N) dense(i, i + 1) = B.e[i];
        }
        const double eps = std::numeric_limits<double>::epsilon();
        const Matrix<double> BV = dense * found.phi;
        const Matrix<double> squares = BV.transpose() * BV;
        Matrix<double> residual = squares;
        Matrix<double> identity = found.phi.transpose() * found.phi;
        for (std::size_t i = 0; i < N; ++i) {
            residual(i, i) -= found.r_n[i] * found.r_n[i];
            identity(i, i) -= 1;
        }
        INFO("N " << N << ", d[0] " << tests::hexadecimal(B.d[0]));
        REQUIRE(identity.cwiseAbs().maxCoeff() <= 8 * static_cast<double>(N) * eps);
        REQUIRE(residual.cwiseAbs().maxCoeff() <= 16 * static_cast<double>(N) * eps * squares.maxCoeff());
    }
}

TEST_CASE("an iteration that cannot converge ends with an error", "[bidiagonal]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    REQUIRE_THROWS_AS(bidiagonal_singular_values({1, nan, 1}, {1, 1}, all_rows(3)), PrecisionError);
}

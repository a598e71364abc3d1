#include "denhartog/model/modal_basis.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>

#include "denhartog/scene/converted.hpp"
#include "denhartog/sliding/bounded_modes.hpp"
#include "tests/catch.hpp"
#include "tests/support/closed_form.hpp"
#include "tests/support/named_scenes.hpp"
#include "tests/support/rotations.hpp"
#include "tests/support/scene_builder.hpp"

using namespace denhartog;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

std::vector<double> equal(std::size_t N) { return std::vector<double>(N, 1.0); }

/// Largest relative error of natural frequency ratios in units of N eps, against 100 digits.
double worst_error(const System<double>& s, const std::vector<double>& r_n) {
    const std::vector<Real100> exact = modal_basis(chain_of<Real100>(s.mass_ratios, s.stiffness_ratios)).r_n;
    double worst = 0;
    for (std::size_t i = 0; i < r_n.size(); ++i)
        worst = std::max(worst, std::abs(static_cast<double>(Real100(r_n[i]) / exact[i] - 1)));
    return worst / (static_cast<double>(r_n.size()) * eps);
}

/// Natural frequency ratios by an eigensolver for dense symmetric matrices.
std::vector<double> dense_frequencies(const System<double>& s) {
    Matrix<double> A = matrix_of_chain(s.stiffness_ratios);
    for (Eigen::Index i = 0; i < A.rows(); ++i)
        for (Eigen::Index k = 0; k < A.cols(); ++k) A(i, k) /= std::sqrt(s.mass_ratios[i] * s.mass_ratios[k]);
    const Eigen::SelfAdjointEigenSolver<Matrix<double>> solved(A);
    std::vector<double> r_n;
    for (Eigen::Index i = 0; i < A.rows(); ++i) r_n.push_back(std::sqrt(std::max(0.0, solved.eigenvalues()(i))));
    return r_n;
}

/// Chains with one entry that is far from the others.
std::vector<System<double>> stiff_chains() {
    return {chain_of({1, 1}, {1, 1e8}),
            chain_of({1, 1, 1}, {1, 1e8, 1}),
            chain_of({1, 2.5, 0.75}, {1, 0.625, 1e8}),
            chain_of({1, 1, 1, 1, 1}, {1, 1, 1e12, 1, 1}),
            chain_of({1, 0.5, 3, 2, 1}, {1, 1e12, 1e12, 0.25, 2}),
            chain_of({1, 1, 1, 1, 1}, {1, 1e-8, 1, 1e-12, 1}),
            chain_of({1, 1e8, 1, 1, 1}, {1, 1, 1, 1, 1}),
            chain_of({1, 1e-8, 1, 1e8, 1}, {1, 1e8, 1, 1e-8, 1e12})};
}

template <class T>
void require_basis(const System<T>& s, const ModalBasis<T>& basis) {
    const Matrix<T> M = mass_of<T>(s);
    const Matrix<T> K = stiffness_of<T>(s);
    const int N = static_cast<int>(basis.r_n.size());
    const T unit = std::numeric_limits<T>::epsilon() * N;
    Matrix<T> modal_mass = basis.phi.transpose() * M * basis.phi;
    for (int i = 0; i < N; ++i) modal_mass(i, i) -= T(1);
    REQUIRE(modal_mass.cwiseAbs().maxCoeff() <= 16 * unit);
    for (int i = 0; i < N; ++i) {
        const T square = basis.r_n[static_cast<std::size_t>(i)] * basis.r_n[static_cast<std::size_t>(i)];
        const Matrix<T> residual = K * basis.phi.col(i) - square * (M * basis.phi.col(i));
        const T size = (K.cwiseAbs() * basis.phi.col(i).cwiseAbs()).maxCoeff();
        REQUIRE(residual.cwiseAbs().maxCoeff() <= 32 * unit * size);
        if (i > 0) REQUIRE(basis.r_n[static_cast<std::size_t>(i)] >= basis.r_n[static_cast<std::size_t>(i - 1)]);
    }
}

} // namespace

TEST_CASE("natural frequency ratios of a chain of equal masses and springs are known in closed form", "[model][eq:1][eq:15]") {
    for (const std::size_t N : {2u, 3u, 5u, 10u, 60u, 1000u}) {
        const ModalBasis<double> basis = modal_basis(chain_of<double>(equal(N), equal(N)));
        for (std::size_t i = 0; i < N; ++i) {
            const long double angle =
                pi<long double>() * static_cast<long double>(2 * i + 1) / static_cast<long double>(2 * (2 * N + 1));
            const auto exact = 2 * std::sin(angle);
            INFO("N " << N << ", mode " << i + 1 << ": " << tests::hexadecimal(basis.r_n[i]));
            REQUIRE(std::abs(basis.r_n[i] / exact - 1) <= 2 * static_cast<double>(N) * eps);
        }
    }
}

TEST_CASE("a stiff spring does not cost the low natural frequencies their digits", "[model][eq:15]") {
    for (const System<double>& s : stiff_chains()) {
        const std::vector<double> r_n = modal_basis(s).r_n;
        INFO("N " << r_n.size() << ", r_n,1 " << tests::hexadecimal(r_n[0]));
        CHECK(worst_error(s, r_n) <= 2);
        CHECK(worst_error(s, dense_frequencies(s)) > 1e4);
    }
    for (const System<double>& light :
         {chain_of<double>({1, 1, 1, 1, 1e-8}, equal(5)), chain_of<double>({1, 1e-8, 1, 1, 1}, equal(5))})
        CHECK(worst_error(light, modal_basis(light).r_n) <= 2);
}

TEST_CASE("mode shapes are orthonormal and solve the eigenproblem in every number type", "[model][eq:14][eq:15][eq:17]") {
    const auto with = [](auto number) {
        using T = decltype(number);
        const System<T> s = chain_of<T>({1, 2.5, 0.75, 0.125}, {1, 0.625, 1.875, 4});
        require_basis(s, modal_basis(s));
        System<T> general = with_stiffness_matrix(s);
        require_basis(general, modal_basis(general));
        general.mass_ratios.clear();
        general.mass_matrix = mass_of<T>(s);
        general.mass_matrix(0, 1) = general.mass_matrix(1, 0) = T(1) / 2;
        require_basis(general, modal_basis(general));
    };
    with(0.0);
    with(Real50());
    with(Real100());
}

TEST_CASE("one mass needs no eigen-solve, a system of more needs one", "[model]") {
    const long before = eigen_solves();
    System<double> s = chain_of<double>({1}, {1}, 0.125);
    const ModalBasis<double> basis = modal_basis(s);
    REQUIRE(basis.r_n[0] == 1);
    REQUIRE(basis.phi(0, 0) == 1);
    REQUIRE(basis.zeta[0] == 0.125);
    s.mass_ratios.clear();
    s.mass_matrix = Matrix<double>::Constant(1, 1, 4);
    s.stiffness_ratios.clear();
    s.stiffness_matrix = Matrix<double>::Constant(1, 1, 9);
    s.damping_ratios.clear();
    s.damping_matrix = Matrix<double>::Constant(1, 1, 3);
    const ModalBasis<double> by_matrices = modal_basis(s);
    REQUIRE(by_matrices.r_n[0] == 1.5);
    REQUIRE(by_matrices.phi(0, 0) == 0.5);
    REQUIRE(by_matrices.zeta[0] == 0.25);
    REQUIRE(eigen_solves() == before);
    (void)modal_basis(chain_of<double>({1, 1}, {1, 1}));
    REQUIRE(eigen_solves() == before + 1);
}

TEST_CASE("the mode shapes of a thousand masses are those of the closed form", "[model][eq:14]") {
    const std::size_t N = 1000;
    const ModalBasis<double> basis = modal_basis(chain_of<double>(equal(N), equal(N)));
    for (const std::size_t i : {0u, 1u, 500u, 998u, 999u}) {
        const double angle = pi<double>() * static_cast<double>(2 * i + 1) / static_cast<double>(2 * N + 1);
        const double factor = 2 / std::sqrt(static_cast<double>(2 * N + 1));
        double worst = 0;
        for (std::size_t k = 0; k < N; ++k) {
            const double exact = factor * std::sin(angle * static_cast<double>(k + 1));
            worst = std::max(worst, std::min(std::abs(basis.phi(k, i) - exact), std::abs(basis.phi(k, i) + exact)));
        }
        INFO("mode " << i + 1);
        REQUIRE(worst < 1e-9);
        const double norm = basis.phi.col(static_cast<Eigen::Index>(i)).norm();
        REQUIRE(std::abs(norm - 1) <= static_cast<double>(N) * eps);
    }
}

TEST_CASE("a diagonal mass matrix on a stiff chain keeps the chain's accuracy", "[model]") {
    System<double> s = chain_of<double>({1, 1e8, 1, 1, 1}, {1, 1, 1e12, 1, 1});
    const std::vector<double> expected = modal_basis(s).r_n;
    s.mass_matrix = mass_of<double>(s);
    s.mass_ratios.clear();
    REQUIRE(modal_basis(s).r_n == expected);
}

TEST_CASE("a ring has the natural frequencies of the circulant matrix", "[model][topology]") {
    constexpr std::size_t N = 8;
    const System<double> s = tests::named_scene("ring of eight").system;
    const ModalBasis<double> basis = modal_basis(s);
    const double orders[] = {0, 1, 1, 2, 2, 3, 3, 4};
    for (std::size_t i = 0; i < N; ++i)
        REQUIRE(std::abs(basis.r_n[i] - std::sqrt(2.5 - 2 * std::cos(pi<double>() * orders[i] / 4))) < 16 * eps);
    require_basis(s, basis);
}

TEST_CASE("the sign of a mode shape does not depend on the number type or the way the system is given", "[model]") {
    std::mt19937_64 random(5);
    for (int trial = 0; trial < 20; ++trial) {
        std::vector<double> gamma{1};
        std::vector<double> kappa{1};
        for (std::size_t i = 0; i < 1 + random() % 6; ++i) {
            gamma.push_back(static_cast<double>(1 + random() % 64) / 16);
            kappa.push_back(static_cast<double>(1 + random() % 64) / 16);
        }
        const ModalBasis<double> basis = modal_basis(chain_of<double>(gamma, kappa));
        const ModalBasis<Real50> fifty = modal_basis(chain_of<Real50>(gamma, kappa));
        const ModalBasis<double> general = modal_basis(with_stiffness_matrix(chain_of<double>(gamma, kappa)));
        REQUIRE((basis.phi - fifty.phi.cast<double>()).cwiseAbs().maxCoeff() < 1e-11);
        REQUIRE((basis.phi - general.phi).cwiseAbs().maxCoeff() < 1e-11);
    }
}

TEST_CASE("a stiffness matrix that is singular to working precision is refused", "[model][bad-input]") {
    System<double> s = chain_of<double>({1, 1, 1}, {1, 1, 1});
    s.stiffness_ratios.clear();
    s.stiffness_matrix = Matrix<double>{{1, -1, 0}, {-1, 2, -1}, {0, -1, 1}};
    REQUIRE_THROWS_AS(modal_basis(s), InputError);
    REQUIRE_THROWS_WITH(modal_basis(s), Catch::StartsWith("stiffness_matrix") && Catch::Contains("singular"));
}

TEST_CASE("modes that double does not tell from those of a singular matrix are refused, but for those of light masses",
          "[model]") {
    REQUIRE_THROWS_AS(modal_basis(with_stiffness_matrix(chain_of<double>({1, 1, 1}, {1, 1e15, 1}))), PrecisionError);
    const System<double> light = chain_of<double>({1, 1e-18}, {1, 1});
    const ModalBasis<double> exact = modal_basis(light);
    const ModalBasis<double> general = modal_basis(with_stiffness_matrix(light));
    for (const std::size_t i : {0U, 1U}) REQUIRE_THAT(general.r_n[i], Catch::Matchers::WithinRel(exact.r_n[i], 1e-15));
    REQUIRE((general.phi - exact.phi).cwiseAbs().maxCoeff() < 1e-15 * exact.phi.cwiseAbs().maxCoeff());
}

TEST_CASE("modes beyond the range of the number type are an error and not infinite", "[model][bad-input]") {
    REQUIRE_THROWS_AS(modal_basis(chain_of<double>({1, 1e-300}, {1, 1e300})), PrecisionError);
}

TEST_CASE("masses of very different size keep the digits of every mode in double, within their bounds",
          "[modes][eq:15][accuracy]") {
    for (const double light : {1e-4, 1e-9, 1e-16, 1e-30}) {
        for (const std::size_t place : {0, 1, 2, 3}) { // of the light mass
            System<double> s;
            s.mass_ratios = {1, 2.1, 0.7, 3};
            s.mass_ratios[place] = light;
            for (double& each : s.mass_ratios) each /= place == 0 ? light : 1.0;
            s.stiffness_matrix =
                Matrix<double>{{2.9, -0.1, -0.8, -0.2}, {-0.1, 1.1, -0.3, 0}, {-0.8, -0.3, 2.2, -0.4}, {-0.2, 0, -0.4, 1.7}};
            s.damping_ratios.assign(4, 0.01);
            const auto found = modes_with_errors(s);
            const ModalBasis<Real50> exact = modal_basis(in_type<Real50>(s));
            for (std::size_t i = 0; i < 4; ++i) {
                INFO("mass " << place + 1 << " of " << light << ", mode " << i + 1);
                const Bounded<double>& r_n = found->r_n[i];
                CHECK(r_n.e <= 1e-11 * r_n.x);
                CHECK(std::abs(static_cast<double>(Real50(exact.r_n[i] - r_n.x))) <= std::min(r_n.e, 1e-14 * r_n.x));
                for (Eigen::Index k = 0; k < 4; ++k) {
                    const Bounded<double>& entry = found->phi(k, static_cast<Eigen::Index>(i));
                    CHECK(std::abs(static_cast<double>(Real50(exact.phi(k, static_cast<Eigen::Index>(i)) - entry.x))) <= entry.e);
                }
            }
        }
    }
}

TEST_CASE("how different the masses of a full mass matrix are does not widen the bounds of its modes",
          "[modes][eq:15][accuracy]") {
    const Matrix<double> scaled{{1, 0.3, -0.2}, {0.3, 1, 0.25}, {-0.2, 0.25, 1}};
    for (const double light : {1.0, 1e-6, 1e-12}) {
        INFO("masses 1, " << light << ", 2");
        const Eigen::Vector3d roots(1, std::sqrt(light), std::sqrt(2.0));
        System<double> s;
        s.mass_matrix = roots.asDiagonal() * scaled * roots.asDiagonal();
        s.mass_matrix = Matrix<double>((s.mass_matrix + s.mass_matrix.transpose()) / 2);
        s.stiffness_matrix = Matrix<double>{{1, -0.3, 0}, {-0.3, 1.5, -0.4}, {0, -0.4, 2}};
        s.damping_ratios.assign(3, 0.01);
        const auto found = modes_with_errors(s);
        const ModalBasis<Real50> exact = modal_basis(in_type<Real50>(s));
        const double highest = found->r_n.back().x;
        for (std::size_t i = 0; i < 3; ++i) {
            const Bounded<double>& r_n = found->r_n[i];
            CHECK(std::abs(static_cast<double>(Real50(exact.r_n[i] - r_n.x))) <= r_n.e);
            CHECK(2 * r_n.x * r_n.e <= 64 * std::numeric_limits<double>::epsilon() * highest * highest);
        }
    }
}

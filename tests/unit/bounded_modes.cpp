// Bounds of the modes and of their functions against 50 and 100 digits, light and heavy masses among them.
#include "denhartog/sliding/bounded_modes.hpp"

#include <cmath>
#include <random>

#include "denhartog/evaluation/mode.hpp"
#include "tests/catch.hpp"
#include "tests/support/closed_form.hpp"

using namespace denhartog;

namespace {

/// The largest error over its bound.
struct Used {
    double most = 0;

    void note(const Bounded<double>& a, const Real100& truth) {
        const double error = std::abs(static_cast<double>(Real100(truth - Real100(a.x))));
        if (error > 0) most = std::max(most, error / a.e);
    }
};

double power_of_ten(std::mt19937_64& random, double least, double most) {
    return std::pow(10.0, std::uniform_real_distribution<double>(least, most)(random));
}

/// A random symmetric matrix with positive eigenvalues, its condition number at most ten to the decades.
Matrix<double> random_definite(std::mt19937_64& random, Eigen::Index N, double decades) {
    std::normal_distribution<double> normal;
    Matrix<double> a(N, N);
    for (Eigen::Index i = 0; i < N; ++i)
        for (Eigen::Index k = 0; k < N; ++k) a(i, k) = normal(random) * (i == 0 ? std::pow(10.0, -decades / 2) : 1);
    const Matrix<double> square = a * a.transpose(), unit = Matrix<double>::Identity(N, N);
    return square / square(N - 1, N - 1) + unit * std::pow(10.0, -decades);
}

Matrix<double> symmetric(const Matrix<double>& a) { return (a + a.transpose()) / 2; }

/// A system of N masses: a chain, one with a full stiffness matrix, one with a full mass matrix too.
Scene<double> random_scene(std::mt19937_64& random, int kind, std::size_t N) {
    Scene<double> scene;
    System<double>& s = scene.system;
    const auto n = static_cast<Eigen::Index>(N);
    for (std::size_t i = 0; i < N; ++i) {
        if (kind < 2) s.mass_ratios.push_back(i == 0 ? 1 : power_of_ten(random, -12, 3));
        if (kind == 0) s.stiffness_ratios.push_back(i == 0 ? 1 : power_of_ten(random, -3, 3));
        s.damping_ratios.push_back(power_of_ten(random, -3, -1));
    }
    if (kind > 0) s.stiffness_matrix = symmetric(random_definite(random, n, 2));
    if (kind > 1) s.mass_matrix = symmetric(random_definite(random, n, 6));
    return scene;
}

/// The largest part of the bounds that errors of a basis use.
double used_by_basis(const Scene<double>& scene) {
    const ModalBasis<Bounded<double>> basis = with_errors(scene.system, modal_basis(scene.system));
    const ModalBasis<Real100> truth = modal_basis(converted<Real100>(scene).system);
    Used used;
    for (Eigen::Index i = 0; i < basis.phi.cols(); ++i) {
        used.note(basis.r_n[static_cast<std::size_t>(i)], truth.r_n[static_cast<std::size_t>(i)]);
        Eigen::Index largest = 0;
        truth.phi.col(i).cwiseAbs().maxCoeff(&largest);
        const bool opposite = (truth.phi(largest, i) > 0) != (basis.phi(largest, i).x > 0);
        for (Eigen::Index k = 0; k < basis.phi.rows(); ++k)
            used.note(basis.phi(k, i), opposite ? Real100(-truth.phi(k, i)) : truth.phi(k, i));
    }
    return used.most;
}

} // namespace

TEST_CASE("bounds of natural frequencies and mode shapes hold, with light masses and full matrices too",
          "[eq:14][eq:15][error_bound]") {
    std::mt19937_64 random(7);
    double most = 0;
    for (const int kind : {0, 1, 2})
        for (int n = 0; n < 60; ++n) {
            const double used = used_by_basis(random_scene(random, kind, 2 + static_cast<std::size_t>(n) % 4));
            INFO("kind " << kind << ", system " << n);
            CHECK(used <= 1);
            most = std::max(most, used);
        }
    CHECK(most > 1e-3); // a thousandth of the bounds is refuted
}

TEST_CASE("bounds of the functions of a mode hold for all numbers within those of R and zeta",
          "[eq:23][eq:28][eq:29][error_bound]") {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> part(-1, 1);
    Used used;
    for (int n = 0; n < 4000; ++n) {
        const double R =
            n % 2 == 0 ? power_of_ten(random, -2, 2) : (1 + part(random) * power_of_ten(random, -12, -1)) / (1 + n % 7);
        const double zeta = power_of_ten(random, -12, 0.3), off = power_of_ten(random, -16, -5);
        const Bounded<double> R_i{R, R * off}, zeta_i{zeta, zeta * off};
        const evaluation::ModeFunctions<Bounded<double>> f = bounded_mode_functions(R_i, zeta_i);
        for (const double side : {-1.0, 0.0, part(random), 1.0}) {
            const Real100 r = Real100(R) + Real100(R_i.e) * side, z = Real100(zeta) + Real100(zeta_i.e) * part(random);
            const evaluation::ModeFunctions<Real100> truth = evaluation::mode_functions(r, z);
            Used here;
            here.note(f.v.re, truth.v.re);
            here.note(f.v.im, truth.v.im);
            here.note(f.u, truth.u);
            here.note(f.g, truth.g);
            INFO("R = " << R << ", zeta = " << zeta << ", off by " << off);
            CHECK(here.most <= 1);
            used.most = std::max(used.most, here.most);
        }
    }
    CHECK(used.most > 0.1); // a tenth of the bounds is refuted
}

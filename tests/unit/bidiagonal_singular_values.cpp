#include "denhartog/model/natural_modes.hpp"

#include <cmath>
#include <numeric>
#include <random>

#include "denhartog/number/errors.hpp"
#include "tests/catch.hpp"
#include "tests/support/multiprecision.hpp"

using namespace denhartog;

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
    const SingularValues found = bidiagonal_singular_values(B.d, B.e, all_rows(B.d.size()));
    const double margin = 4 * static_cast<double>(N) * std::numeric_limits<double>::epsilon();
    for (std::size_t i = 0; i < N; ++i) {
        INFO("singular value " << i << " of " << N << ": " << tests::hexadecimal(found.sigma[i]) << ", d[0] "
                               << tests::hexadecimal(B.d[0]));
        REQUIRE(bracketed(B, found.sigma[i], i, margin));
    }
}

} // namespace

TEST_CASE("the count of singular values below a number notices a relative error of a few units in the last place",
          "[bidiagonal]") {
    const Bidiagonal B{{1e8, 1, 1e-8}, {1e8, 1}};
    const SingularValues found = bidiagonal_singular_values(B.d, B.e, all_rows(B.d.size()));
    for (std::size_t i = 0; i < 3; ++i) {
        REQUIRE(bracketed(B, found.sigma[i], i, 1e-15));
        REQUIRE_FALSE(bracketed(B, found.sigma[i] * (1 + 4e-15), i, 1e-15));
        REQUIRE_FALSE(bracketed(B, found.sigma[i] * (1 - 4e-15), i, 1e-15));
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
        const SingularValues found = bidiagonal_singular_values(B.d, B.e, all_rows(B.d.size()));
        Matrix<double> dense = Matrix<double>::Zero(static_cast<Eigen::Index>(N), static_cast<Eigen::Index>(N));
        for (std::size_t i = 0; i < N; ++i) {
            dense(i, i) = B.d[i];
            if (i + 1 < N) dense(i, i + 1) = B.e[i];
        }
        const double eps = std::numeric_limits<double>::epsilon();
        const Matrix<double> BV = dense * found.V;
        const Matrix<double> squares = BV.transpose() * BV;
        Matrix<double> residual = squares;
        Matrix<double> identity = found.V.transpose() * found.V;
        for (std::size_t i = 0; i < N; ++i) {
            residual(i, i) -= found.sigma[i] * found.sigma[i];
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

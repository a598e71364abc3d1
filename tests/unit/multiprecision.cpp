#include "denhartog/number/multiprecision.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <string>

#include "denhartog/model/symmetric_eigenproblem.hpp"
#include "tests/catch.hpp"

using namespace denhartog;

namespace {

/// 16 arctan(1/5) - 4 arctan(1/239), summed in the number type.
template <class T>
T machin() {
    const auto arctan_of_inverse = [](int n) {
        T power = T(1) / n;
        T sum = power;
        for (int k = 1; power > std::numeric_limits<T>::epsilon() / 1000; ++k) {
            power = power / (n * n);
            sum = k % 2 == 1 ? T(sum - power / (2 * k + 1)) : T(sum + power / (2 * k + 1));
        }
        return sum;
    };
    return 16 * arctan_of_inverse(5) - 4 * arctan_of_inverse(239);
}

template <class T>
void require_eigen_solves() {
    using Square = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;
    const int N = 7;
    Square K = Square::Zero(N, N);
    for (int i = 0; i < N; ++i) {
        K(i, i) = i + 1 < N ? 2 : 1;
        if (i > 0) K(i, i - 1) = K(i - 1, i) = -1;
    }
    const SymmetricEigenproblem<T> solved = symmetric_eigenproblem(K); // Eigen's solver, in the library compiled once
    const T tolerance = 64 * std::numeric_limits<T>::epsilon();
    for (int i = 0; i < N; ++i) {
        const T root = 2 * sin(T((2 * i + 1) * pi<T>() / (2 * (2 * N + 1))));
        REQUIRE(abs(T(solved.values[static_cast<std::size_t>(i)] - root * root)) < tolerance);
    }
    const Square L = Eigen::LLT<Square>(K).matrixL();
    REQUIRE(Square(L * L.transpose() - K).cwiseAbs().maxCoeff() < tolerance);
}

} // namespace

TEST_CASE("pi has all the digits of the number type", "[multiprecision]") {
    REQUIRE(abs(pi<Real50>() - machin<Real50>()) < 8 * std::numeric_limits<Real50>::epsilon());
    REQUIRE(abs(pi<Real100>() - machin<Real100>()) < 8 * std::numeric_limits<Real100>::epsilon());
    REQUIRE(std::abs(pi<long double>() - machin<long double>()) < 8 * std::numeric_limits<long double>::epsilon());
    REQUIRE(static_cast<double>(pi<Real50>()) == pi<double>());
}

TEST_CASE("the multiprecision types have the digits they are named after", "[multiprecision]") {
    REQUIRE(std::numeric_limits<Real50>::digits10 >= 50);
    REQUIRE(std::numeric_limits<Real100>::digits10 >= 100);
    REQUIRE(Eigen::NumTraits<Real50>::epsilon() == std::numeric_limits<Real50>::epsilon());
    REQUIRE(Eigen::NumTraits<Real50>::lowest() == -Eigen::NumTraits<Real50>::highest());
    REQUIRE(Eigen::NumTraits<Real100>::digits10() == std::numeric_limits<Real100>::digits10);
}

TEST_CASE("Eigen solves eigenproblems to the digits of the number type", "[multiprecision]") {
    require_eigen_solves<double>();
    require_eigen_solves<long double>();
    require_eigen_solves<Real50>();
    require_eigen_solves<Real100>();
}

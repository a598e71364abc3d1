#include "tests/support/multiprecision.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <random>
#include <vector>

#include "tests/catch.hpp"
#include "tests/support/rotations.hpp"

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
    Square values = K, vectors;
    diagonalise(values, vectors);
    const T tolerance = 64 * std::numeric_limits<T>::epsilon();
    for (int i = 0; i < N; ++i) {
        const T root = 2 * sin(T((2 * i + 1) * pi<T>() / (2 * (2 * N + 1))));
        REQUIRE(abs(T(values(i, i) - root * root)) < tolerance);
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

TEMPLATE_TEST_CASE("the multiprecision types keep within their limits", "[multiprecision]", Real50, Real100) {
    using Limits = std::numeric_limits<TestType>;
    const TestType one = 1, zero = 0, eps = Limits::epsilon(), nan = Limits::quiet_NaN(), infinity = Limits::infinity();
    CHECK(TestType(one + eps) > one);
    CHECK(TestType(one + eps / 2) == one);
    CHECK(isfinite((Limits::max)()));
    CHECK((Limits::max)() * (one + eps) == infinity);
    CHECK((Limits::min)() > 0);
    CHECK((Limits::min)() / 2 == 0);
    CHECK(one / zero == infinity);
    CHECK(one / TestType(-zero) == -infinity);
    CHECK(TestType(-zero) == zero);
    CHECK(isnan(TestType(zero / zero)));
    CHECK_FALSE((nan == nan || nan < one || nan > one || nan <= one || nan >= one));
    CHECK(nan != nan);
}

TEMPLATE_TEST_CASE("a multiprecision number is rounded to the nearest double", "[multiprecision]", Real50, Real100) {
    const TestType half_a_unit = ldexp(TestType(1), -53), least = ldexp(TestType(1), -1074);
    CHECK(static_cast<double>(TestType(1 + half_a_unit)) == 1);
    CHECK(static_cast<double>(TestType(1 + half_a_unit + ldexp(TestType(1), -160))) == 1 + 0x1p-52);
    CHECK(static_cast<double>(least) == 0x1p-1074);
    CHECK(static_cast<double>(TestType(least / 2)) == 0);
    CHECK(static_cast<double>(TestType(least * 3 / 4)) == 0x1p-1074);
    CHECK(static_cast<double>(ldexp(TestType(-1), 1024)) == -std::numeric_limits<double>::infinity());
}

TEST_CASE("the elementary functions in 50 digits are the nearest numbers to their values", "[multiprecision]") {
    std::mt19937_64 random(50);
    for (int n = 0; n < 500; ++n) {
        const double x = 40 * (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5);
        const Real50 narrow = Real50(x) / 3, size = abs(narrow);
        const Real100 wide = narrow, wide_size = size;
        CAPTURE(x);
        CHECK(Real50(sin(wide)) == sin(narrow));
        CHECK(Real50(cos(wide)) == cos(narrow));
        CHECK(Real50(exp(wide)) == exp(narrow));
        CHECK(Real50(expm1(wide)) == expm1(narrow));
        CHECK(Real50(sinh(wide)) == sinh(narrow));
        CHECK(Real50(cosh(wide)) == cosh(narrow));
        CHECK(Real50(sqrt(wide_size)) == sqrt(size));
        CHECK(Real50(atan2(wide, Real100(1))) == atan2(narrow, Real50(1)));
    }
}

TEST_CASE("MPFR keeps what it has to remember apart for every thread", "[multiprecision]") {
    REQUIRE(mpfr_buildopt_tls_p() != 0);
}

TEST_CASE("a vector that grows keeps its multiprecision numbers", "[multiprecision]") {
    std::vector<Real50> numbers;
    for (int n = 0; n < 100; ++n) numbers.push_back(Real50(n) / 7);
    for (int n = 0; n < 100; ++n) REQUIRE(numbers[static_cast<std::size_t>(n)] == Real50(n) / 7);
}

TEST_CASE("rotations solve eigenproblems, and Eigen factors matrices, to the digits of the number type", "[multiprecision]") {
    require_eigen_solves<double>();
    require_eigen_solves<Real50>();
    require_eigen_solves<Real100>();
}

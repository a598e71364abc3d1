#include <Eigen/Cholesky>
#include <boost/math/special_functions/cos_pi.hpp>
#include <boost/math/special_functions/sin_pi.hpp>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <limits>
#include <random>

#include "denhartog/formulas/complex.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/number/reduced_angle.hpp"
#include "tests/catch.hpp"
#include "tests/support/multiprecision.hpp"
#include "tests/support/rotations.hpp"

using namespace denhartog;

using denhartog::Complex;
using denhartog::tests::hexadecimal;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Runs a comparison with std::complex on random numbers and checks the worst error in units of epsilon times the scale.
template <class Error>
void check_worst(Error error, double allowed) {
    std::mt19937_64 generator(20220117085);
    std::uniform_real_distribution<double> part(-4, 4);
    std::uniform_real_distribution<double> angle(-10, 10);
    double worst = -1;
    std::string where;
    for (int i = 0; i < 10000; ++i) {
        const Complex<double> v{part(generator), part(generator)};
        const double alpha = angle(generator);
        const double e = error(v, std::complex<double>(v.re, v.im), alpha);
        if (!(e <= worst)) {
            worst = e;
            where = "v = " + hexadecimal(v.re) + " + i " + hexadecimal(v.im) + ", alpha = " + hexadecimal(alpha);
            if (std::isnan(e)) break;
        }
    }
    INFO("worst at " << where);
    CHECK(worst <= allowed);
}

} // namespace

TEST_CASE("v times a cosine and a sine are the parts of v exp(i alpha), modulus and argument those of the standard library",
          "[complex]") {
    using V = Complex<double>;
    using Z = std::complex<double>;
    const auto relative = [](double found, double expected, const Z& z) {
        return std::abs(found - expected) / (epsilon * std::abs(z));
    };
    check_worst(
        [&](const V& v, const Z& z, double a) { return relative(times_cosine(v, a), (z * std::polar(1.0, a)).real(), z); }, 4);
    check_worst([&](const V& v, const Z& z, double a) { return relative(times_sine(v, a), (z * std::polar(1.0, a)).imag(), z); },
                4);
    check_worst([&](const V& v, const Z& z, double) { return relative(modulus(v), std::abs(z), z); }, 4);
    check_worst([](const V& v, const Z& z, double) { return std::abs(argument(v) - std::arg(z)); }, 4 * epsilon);
}

TEST_CASE("the argument lies in the quadrant of the number", "[complex]") {
    const double quarter = denhartog::pi<double>() / 4;
    CHECK(argument(Complex<double>{1, 1}) == quarter);
    CHECK(argument(Complex<double>{-1, 1}) == 3 * quarter);
    CHECK(argument(Complex<double>{-1, -1}) == -3 * quarter);
    CHECK(argument(Complex<double>{1, -1}) == -quarter);
    CHECK(argument(Complex<double>{-1, 0}) == 4 * quarter);
}

TEST_CASE("sum and real multiple act on both parts", "[complex]") {
    const Complex<double> sum = Complex<double>{1, 2} + 0.5 * Complex<double>{4, -8};
    CHECK(sum.re == 3);
    CHECK(sum.im == -2);
    CHECK(squared_modulus(sum) == 13);
}

namespace {

// Quarters of a turn are exact, however many turns there are before them.
template <class T>
void check_quarters(const T& whole_turns) {
    for (const int sign : {1, -1}) {
        const auto at = [&](double quarters) { return T(sign * (2 * whole_turns + T(quarters) / 2)); };
        REQUIRE(sine_of_half_turns(at(1)) == sign);
        REQUIRE(sine_of_half_turns(at(3)) == -sign);
        REQUIRE(cosine_of_half_turns(at(0)) == 1);
        REQUIRE(cosine_of_half_turns(at(1)) == 0);
        REQUIRE(cosine_of_half_turns(at(2)) == -1);
    }
}

} // namespace

TEST_CASE("half turns are counted beyond the largest int", "[number]") {
    for (const double whole_turns : {0.0, 3.0, 0x1p29, 0x1p30, 0x1p31, 0x1p33, 0x1p49}) {
        check_quarters(whole_turns);
        check_quarters(Real50(whole_turns));
    }
    check_quarters(Real100("1e60"));
}

TEST_CASE("few half turns have the sine and cosine of 50 digits, rounded once", "[number]") {
    std::mt19937_64 random(5);
    const auto units = [](double value, const Real50& exact) {
        const double unit = std::ldexp(1.0, std::ilogb(static_cast<double>(exact)) - 52);
        return static_cast<double>(abs(Real50(value - exact))) / unit;
    };
    for (int trial = 0; trial < 2000; ++trial) {
        const double x =
            std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 60) - 98) * (trial % 2 == 0 ? 1 : -1);
        REQUIRE(units(sine_of_half_turns(x), boost::math::sin_pi(Real50(x))) < 0.51);
        REQUIRE(units(cosine_of_half_turns(x), boost::math::cos_pi(Real50(x))) < 0.51);
    }
}

TEST_CASE("an angle that is not finite has neither sine nor cosine", "[number]") {
    for (const double x : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        REQUIRE(std::isnan(sine_of_half_turns(x)));
        REQUIRE(std::isnan(cosine_of_half_turns(-x)));
    }
}

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

TEST_CASE("MPFR keeps what it has to remember apart for every thread", "[multiprecision]") {
    REQUIRE(mpfr_buildopt_tls_p() != 0);
}

TEST_CASE("rotations solve eigenproblems, and Eigen factors matrices, to the digits of the number type", "[multiprecision]") {
    require_eigen_solves<double>();
    require_eigen_solves<Real50>();
    require_eigen_solves<Real100>();
}

namespace {

double read(std::string_view text) {
    double x = -7;
    INFO(text);
    REQUIRE(number_from_text(text, x) == NumberFault::none);
    return x;
}

} // namespace

TEST_CASE("decimal text is rounded to the nearest double", "[scene][number]") {
    std::mt19937_64 random(11);
    for (int trial = 0; trial < 2000; ++trial) {
        std::string text = random() % 2 == 0 ? "-" : "";
        text += std::to_string(random() % 10) + "." + std::to_string(random()) + std::to_string(random() % 1000);
        text += (random() % 2 == 0 ? "e" : "E-") + std::to_string(random() % 300);
        REQUIRE(read(text) == std::strtod(text.c_str(), nullptr));
    }
}

TEST_CASE("a number written as text is read again as the same number", "[scene][number]") {
    std::mt19937_64 random(12);
    for (int trial = 0; trial < 200; ++trial) {
        const double x = std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 400) - 230);
        REQUIRE(read(number_to_text(x)) == x);
    }
}

TEST_CASE("text that is no number is refused", "[scene][number]") {
    const std::string text = GENERATE("", " ", "nan", "NaN", "inf", "-inf", "Infinity", "abc", "1 ", " 1", "1,5", "0x1p3", "1e",
                                      "1e+", "--1", "+1", ".5", "5.", "007", "-", "1.2.3", "1e5.0", "1e+-5", "1_000", "½");
    double x = 3;
    INFO(text);
    REQUIRE(number_from_text(text, x) == NumberFault::no_number);
    REQUIRE(x == 3);
}

TEST_CASE("a number beyond the type is refused and not rounded to zero or infinity", "[scene][number]") {
    double x = 3;
    REQUIRE(number_from_text("1e309", x) == NumberFault::too_large);
    REQUIRE(number_from_text("-1e309", x) == NumberFault::too_large);
    REQUIRE(number_from_text("1e-400", x) == NumberFault::too_small);
    REQUIRE(number_from_text("0." + std::string(400, '0') + "1", x) == NumberFault::too_small);
    REQUIRE(number_from_text("0." + std::string(800, '0') + "1e400", x) == NumberFault::too_small);
    REQUIRE(number_from_text("1" + std::string(400, '0'), x) == NumberFault::too_large);
    REQUIRE(number_from_text("1" + std::string(800, '0') + "e-400", x) == NumberFault::too_large);
    REQUIRE(number_from_text("0.0e-400", x) == NumberFault::none);
    REQUIRE(x == 0);
    REQUIRE(read("4.9406564584124654e-324") == std::numeric_limits<double>::denorm_min());
    REQUIRE(read("1.7976931348623157e308") == std::numeric_limits<double>::max());
    double y = 3;
    REQUIRE(number_from_text("1e1000000000", y) == NumberFault::too_long);
    REQUIRE(number_from_text("1e99999999999999999999", y) == NumberFault::too_long);
    REQUIRE(number_from_text(std::string(6000, '1'), y) == NumberFault::too_long);
    REQUIRE(y == 3);
}

TEST_CASE("numbers that are none are named", "[scene][number]") {
    REQUIRE(number_to_text(std::numeric_limits<double>::quiet_NaN()) == "nan");
    REQUIRE(number_to_text(-std::numeric_limits<double>::infinity()) == "-inf");
    REQUIRE(number_to_text(0.1) == "0.1");
}

TEST_CASE("a number for people has the digits that its error leaves", "[number]") {
    const auto certain = [](double x, double error) { return number_in_certain_digits(x, error, x); };
    CHECK(certain(0.63974569583012345, 0.0) == "0.63974569583");
    CHECK(certain(0.63974569583012345, 1e-16) == "0.63974569583");
    CHECK(certain(0.63974569583012345, 4e-10) == "0.639745696");
    CHECK(certain(-0.63974569583012345, 0.03) == "-0.6");
    CHECK(certain(1e-51, 7.9e-46) == "0 to within 7.9e-46");
    CHECK(certain(-1e-51, 1e300 * 1e300) == "0 to within inf");
    CHECK(certain(0.0, 1e-50) == "0");
    // Another number is told from it, if that is farther away than the error.
    CHECK(number_in_certain_digits(0.79, 0, 0.79 * (1 + 1e-14)) == "0.79");
    CHECK(number_in_certain_digits(0.79 * (1 + 1e-14), 0, 0.79) == "0.79000000000001");
    CHECK(number_in_certain_digits(0.79 * (1 + 1e-14), 1e-13, 0.79) == "0.79");
    CHECK(number_in_certain_digits(std::nextafter(1.0, 2.0), 0, 1) == "1.0000000000000002");
}

#include "denhartog/formulas/complex.hpp"

#include <complex>
#include <limits>
#include <random>

#include "tests/catch.hpp"

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

TEST_CASE("v times a cosine is the real part of v exp(i alpha)", "[complex]") {
    check_worst(
        [](const Complex<double>& v, const std::complex<double>& z, double alpha) {
            return std::abs(times_cosine(v, alpha) - (z * std::polar(1.0, alpha)).real()) / (epsilon * std::abs(z));
        },
        4);
}

TEST_CASE("v times a sine is the imaginary part of v exp(i alpha)", "[complex]") {
    check_worst(
        [](const Complex<double>& v, const std::complex<double>& z, double alpha) {
            return std::abs(times_sine(v, alpha) - (z * std::polar(1.0, alpha)).imag()) / (epsilon * std::abs(z));
        },
        4);
}

TEST_CASE("v times a cosine is the modulus times the cosine of the angle plus the argument", "[complex]") {
    check_worst(
        [](const Complex<double>& v, const std::complex<double>& z, double alpha) {
            const double expected = modulus(v) * std::cos(alpha + argument(v));
            return std::abs(times_cosine(v, alpha) - expected) / (epsilon * std::abs(z));
        },
        16);
}

TEST_CASE("modulus and argument are those of the standard library", "[complex]") {
    check_worst([](const Complex<double>& v, const std::complex<double>& z,
                   double) { return std::abs(modulus(v) - std::abs(z)) / (epsilon * std::abs(z)); },
                4);
    check_worst(
        [](const Complex<double>& v, const std::complex<double>& z, double) { return std::abs(argument(v) - std::arg(z)); },
        4 * epsilon);
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

#include "denhartog/evaluation/vector_functions.hpp"

#include <cmath>
#include <random>

#include "denhartog/number.hpp"
#include "tests/catch.hpp"

using namespace denhartog;

namespace {

/// The largest error of a function over seeded arguments, relative, in eps.
template <class Found, class Exact>
double worst_in_eps(double from, double to, std::string& where, Found found, Exact exact) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> argument(from, to);
    double worst = 0;
    for (int n = 0; n <= 100000; ++n) {
        const double x = n == 0 ? from : n == 1 ? to : argument(random);
        const long double truth = exact(static_cast<long double>(x));
        const double error = static_cast<double>(std::abs(found(x) / truth - 1)) / std::numeric_limits<double>::epsilon();
        if (error <= worst) continue;
        worst = error;
        where = tests::hexadecimal(x);
    }
    return worst;
}

} // namespace

TEST_CASE("exponentials, sines and cosines for vectors keep their digits", "[accuracy]") {
    using evaluation::exponential_of_negative;
    using evaluation::half_angle_products;
    const long double half_circle = pi<long double>();
    std::string where;
    const auto check = [&](double worst, double most) {
        INFO(worst << " eps at " << where);
        CHECK(worst <= most);
    };
    for (const double least : {-0x1p-30, -0.5, -2.0, -700.0}) {
        INFO("from " << least);
        check(worst_in_eps(
                  least, least / 1024, where, [](double x) { return exponential_of_negative(x).E; },
                  [](long double x) { return std::exp(x); }),
              1);
        check(worst_in_eps(
                  least, least / 1024, where, [](double x) { return exponential_of_negative(x).E_minus_one; },
                  [](long double x) { return std::expm1(x); }),
              1);
    }
    // pi, its product and the sine are rounded by 0.18, 0.5 and 0.5 eps, which a square doubles, and by 0.5 eps itself.
    for (const double largest : {0x1p-30, 0x1p-4, 0.25}) {
        INFO("up to " << largest);
        check(worst_in_eps(
                  largest / 1024, largest, where, [](double z) { return half_angle_products(z, 0).sine_cosine; },
                  [&](long double z) { return std::sin(half_circle * z) * std::cos(half_circle * z); }),
              2);
        check(worst_in_eps(
                  0.5 - largest, 0.5 - largest / 1024, where, [](double z) { return half_angle_products(z, 0).cosine_square; },
                  [&](long double z) { return std::pow(std::sin(half_circle * (0.5L - z)), 2); }),
              3);
    }
    check(worst_in_eps(
              -2.5, 2.5, where, [](double s) { return evaluation::odd_series(s); },
              [](long double s) {
                  long double sum = 0, term = 1;
                  for (int k = 1; k < 20; ++k) {
                      term *= s / (2 * k * (2 * k + 1));
                      sum += term;
                  }
                  return sum;
              }),
          2);
}

TEST_CASE("an exponential underflows gradually and ends at zero", "[accuracy]") {
    using evaluation::exponential_of_negative;
    for (const double x : {-708.5, -720.0, -740.0, -744.0})
        CHECK(std::abs(exponential_of_negative(x).E - std::exp(x)) <= 0x1p-1074);
    for (const double x : {-746.0, -1e4, -1e300}) {
        CHECK(exponential_of_negative(x).E == 0);
        CHECK(exponential_of_negative(x).E_minus_one == -1);
    }
    CHECK(exponential_of_negative(0).E == 1);
    CHECK(exponential_of_negative(0).E_minus_one == 0);
}

TEST_CASE("a lateness below the rounding of half a turn is not lost at the zero of the cosine", "[eq:28]") {
    const evaluation::HalfAngleProducts h = evaluation::half_angle_products(0.5, 0x1p-60);
    CHECK(h.sine_cosine == Approx(pi<double>() * 0x1p-60).epsilon(1e-15));
    CHECK(h.cosine_square == Approx(pi<double>() * pi<double>() * 0x1p-120).epsilon(1e-15));
}

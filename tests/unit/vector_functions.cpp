#include "denhartog/evaluation/detail/vector_functions.hpp"

#include <cmath>
#include <random>

#include "denhartog/evaluation/special.hpp"
#include "denhartog/number/number.hpp"
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

double value(const evaluation::Exponential<double>& e) { return e.head * e.tail; }

/// Products of the half angle at pi z, for z up to 1/2.
evaluation::HalfAngleProducts<double> products_at(double z, double late) {
    return evaluation::half_angle_products(0.5 / z, z, 1, 2 * late * (0.5 / z));
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
                  least, least / 1024, where, [](double x) { return value(exponential_of_negative(x)); },
                  [](long double x) { return std::exp(x); }),
              1);
        check(worst_in_eps(
                  least, least / 1024, where, [](double x) { return exponential_of_negative(x).E_minus_one; },
                  [](long double x) { return std::expm1(x); }),
              1);
    }
    // R of a power of two, so that the angle is known without rounding. pi, its products and the sine are rounded by 0.18, 1 and
    // 0.5 eps, which a square doubles, and by 0.5 eps itself.
    for (const double R : {0.015625, 0.25, 1.0, 4.0, 1024.0}) {
        INFO("R = " << R);
        const auto at = [R](double w) { return half_angle_products(R, 0.5 / R, w, 0); };
        const auto angle = [R, half_circle](long double w) { return half_circle * w / (2 * R); };
        // next to the zeros of the sine and of the cosine, and between
        const double whole = R < 0.5 ? std::floor(0.75 / (2 * R)) * 2 * R : 0;
        for (const double size : {0x1p-30, 0x1p-4, 0.25}) {
            const double width = std::min(1.0, 2 * R) * size;
            check(worst_in_eps(
                      whole + width / 1024, whole + width, where, [&](double w) { return at(w).sine_cosine; },
                      [&](long double w) { return std::sin(angle(w - whole)) * std::cos(angle(w - whole)); }),
                  3);
            if (R > 1 || whole + R - width < 0x1p-26) continue;
            check(worst_in_eps(
                      whole + R - width, whole + R - width / 1024, where, [&](double w) { return at(w).cosine_square; },
                      [&](long double w) { return std::pow(std::sin(angle(R - (w - whole))), 2); }),
                  4);
        }
    }
    for (const double zeta : {0.0, 0x1p-30, 0.125, 0.5, 0.75, 1 - 0x1p-53}) {
        INFO("zeta = " << zeta);
        const evaluation::BracketSeries series = evaluation::bracket_series(zeta);
        check(worst_in_eps(
                  1e-9, 2.51, where, [&](double q) { return evaluation::bracket_over_square(series, q * q); },
                  [&](long double q) { return evaluation::sinhc_less_sinc_over_square<long double>(q, zeta); }),
              3);
    }
}

TEST_CASE("an exponential underflows gradually and ends at zero, its head does not", "[accuracy]") {
    using evaluation::exponential_of_negative;
    for (const double x : {-708.5, -720.0, -740.0, -744.0})
        CHECK(std::abs(value(exponential_of_negative(x)) - std::exp(x)) <= 0x1p-1074);
    for (const double x : {-746.0, -1e4, -1e300}) {
        const evaluation::Exponential<double> e = exponential_of_negative(x);
        CHECK(value(e) == 0);
        CHECK(e.head > std::numeric_limits<double>::min());
        CHECK(e.tail > std::numeric_limits<double>::min());
        CHECK(e.E_minus_one == -1);
    }
    CHECK(value(exponential_of_negative(0)) == 1);
    CHECK(exponential_of_negative(0).E_minus_one == 0);
}

TEST_CASE("a lateness below the rounding of half a turn is not lost at the zero of the cosine", "[eq:28]") {
    const evaluation::HalfAngleProducts<double> h = products_at(0.5, 0x1p-60);
    CHECK(h.sine_cosine == Approx(pi<double>() * 0x1p-60).epsilon(1e-15));
    CHECK(h.cosine_square == Approx(pi<double>() * pi<double>() * 0x1p-120).epsilon(1e-15));
}

TEST_CASE("an angle that is late by many turns is reduced anew", "[eq:28]") {
    for (const double R : {0.001, 0.0101, 0.03, 0.4}) {
        const double late = 0.125;
        const long double angle = pi<long double>() * (1 - static_cast<long double>(late)) / (2 * static_cast<long double>(R));
        const evaluation::HalfAngleProducts<double> h = evaluation::half_angle_products(R, 0.5 / R, 1, late);
        CHECK(h.sine_cosine == Approx(static_cast<double>(std::sin(angle) * std::cos(angle))).margin(1e-13));
        CHECK(h.cosine_square == Approx(static_cast<double>(std::cos(angle) * std::cos(angle))).margin(1e-13));
    }
}

// The limits zeta -> 0 and R -> 1 of the mode functions, probed in 50 and 100 digits, and what double keeps of them.
#include <boost/math/special_functions/next.hpp>
#include <cmath>

#include "denhartog/evaluation/mode.hpp"
#include "tests/catch.hpp"
#include "tests/limits/digits_of.hpp"
#include "tests/support/multiprecision.hpp"

using namespace denhartog;
using namespace denhartog::tests;

TEST_CASE("for zeta -> 0 at a fixed R the first damping function tends to the undamped one, with an error of second order",
          "[eq:28][limit]") {
    const Real50 R = Real50(3) / 4;
    const Real50 undamped = sin(Real50(pi<Real50>() / R)) / (R * (1 + cos(Real50(pi<Real50>() / R))));
    const auto error = [&](const Real50& zeta) { return Real50(paper::first_damping_function(R, zeta) - undamped); };
    for (int k = 20; k <= 60; k += 20) {
        const Real50 zeta = ldexp(Real50(1), -k);
        CHECK(static_cast<double>(error(zeta) / error(Real50(zeta / 2))) == Approx(4).epsilon(1e-9));
    }
}

TEST_CASE("for zeta -> 0 at a fixed R the second damping function vanishes in proportion to zeta", "[eq:29][limit]") {
    const Real50 R = Real50(3) / 4;
    const Real50 theta = pi<Real50>() / R;
    const Real50 slope = (theta - sin(theta)) / (1 + cos(theta));
    for (int k = 20; k <= 100; k += 20) {
        const Real50 zeta = ldexp(Real50(1), -k);
        const Real50 quotient = evaluation::mode_functions(R, zeta).g / zeta;
        CHECK(static_cast<double>(abs(Real50(quotient / slope - 1))) < std::ldexp(64.0, -2 * k) + 1e-45);
    }
}

TEST_CASE("a mode without damping has no second damping function", "[eq:29][limit]") {
    for (const double R : {0.3, 0.6, 0.875, 1.25, 2.5, 40.0}) CHECK(evaluation::mode_functions(R, 0.0).g == 0);
}

TEST_CASE("the limits zeta -> 0 and R -> 1 of the first damping function do not commute", "[eq:28][limit]") {
    // along R = 1 first: 1 / pi
    for (int k = 10; k <= 70; k += 20) {
        const Real100 u = evaluation::mode_functions(Real100(1), ldexp(Real100(1), -k)).u;
        CHECK(static_cast<double>(abs(Real100(u * pi<Real100>() - 1))) < std::ldexp(4.0, -2 * k));
    }
    // along zeta = 0 first: a pole, u (1 - 1/R) tends to 2 / pi from either side
    for (int k = 10; k <= 70; k += 20)
        for (const int side : {-1, 1}) {
            const Real100 R = 1 + side * ldexp(Real100(1), -k);
            const Real100 u = evaluation::mode_functions(R, Real100(0)).u;
            CHECK(static_cast<double>(u * (1 - 1 / R) * pi<Real100>() / 2) == Approx(1).epsilon(std::ldexp(4.0, -k)));
        }
    // along zeta = c |R - 1| the limit of u (R - 1) depends on c
    const auto along = [](int c) {
        const Real100 h = ldexp(Real100(1), -60);
        return static_cast<double>(evaluation::mode_functions(Real100(1 + h), Real100(c * h)).u * h);
    };
    CHECK(along(1) != Approx(along(2)).epsilon(0.1));
}

TEST_CASE("the printed form of the first damping function loses its digits at a resonance, the shipped form does not",
          "[eq:28][limit][form]") {
    const Real100 one(1);
    const double zeta = std::ldexp(1.0, -20); // about 1e-6
    const Real100 truth = paper::first_damping_function(one, Real100(zeta));
    CHECK(digits_of(paper::first_damping_function(1.0, zeta), truth) < 6);
    CHECK(digits_of(evaluation::mode_functions(1.0, zeta).u, truth) > 15);
    // at 1e-9 the printed form divides by zero
    CHECK_FALSE(std::isfinite(paper::first_damping_function(1.0, std::ldexp(1.0, -30))));
    CHECK(digits_of(evaluation::mode_functions(1.0, std::ldexp(1.0, -30)).u,
                    paper::first_damping_function(one, ldexp(Real100(1), -30))) > 15);
}

namespace {

/// Relative change of a mode function for a relative change of R or zeta, the larger of the two: its condition number.
template <class Function>
double condition(const Function& f, const Real100& R, const Real100& zeta) {
    const Real100 h = ldexp(Real100(1), -150), value = f(R, zeta);
    const Real100 by_R = abs(Real100((f(Real100(R * (1 + h)), zeta) - value) / (h * value)));
    const Real100 by_zeta = abs(Real100((f(R, Real100(zeta * (1 + h))) - value) / (h * value)));
    return static_cast<double>(by_R > by_zeta ? by_R : by_zeta);
}

} // namespace

TEST_CASE("the shipped forms keep the digits that their conditioning leaves, where the printed ones overflow or cancel",
          "[eq:28][eq:29][limit][form]") {
    struct Place {
        double R, zeta;
    };
    // R small: cosh and sinh of more than 710 overflow; R large: the numerator of (29) cancels; near 1/3, 1/5: poles at zeta = 0
    for (const Place& p : {Place{1.0 / 64, 0.125}, Place{1.0 / 4096, 0.125}, Place{64, 0.125}, Place{4096, 0.125}, Place{1, 1e-7},
                           Place{1.0 / 3, 1e-7}, Place{0.2, 1e-7}, Place{0.2, 1e-3}, Place{1.0009765625, 1e-4}}) {
        const evaluation::ModeFunctions<double> f = evaluation::mode_functions(p.R, p.zeta);
        const auto u = [](const Real100& R, const Real100& zeta) { return paper::first_damping_function(R, zeta); };
        const auto g = [](const Real100& R, const Real100& zeta) { return paper::second_damping_function(R, zeta); };
        const Real100 R(p.R), zeta(p.zeta);
        const double epsilon = std::numeric_limits<double>::epsilon();
        INFO("R = " << p.R << ", zeta = " << p.zeta << ", condition of u " << condition(u, R, zeta) << ", of g "
                    << condition(g, R, zeta));
        CHECK(std::pow(10, -digits_of(f.g, g(R, zeta))) <= 8 * epsilon * (1 + condition(g, R, zeta)));
        if (abs(u(R, zeta)) > std::numeric_limits<double>::min())
            CHECK(std::pow(10, -digits_of(f.u, u(R, zeta))) <= 8 * epsilon * (1 + condition(u, R, zeta)));
        else
            CHECK(f.u == Approx(0).margin(std::numeric_limits<double>::min()));
    }
    CHECK_FALSE(std::isfinite(paper::second_damping_function(1.0 / 4096, 0.125)));
    const Real100 large(4096), eighth(0.125);
    CHECK(digits_of(paper::second_damping_function(4096.0, 0.125), paper::second_damping_function(large, eighth)) < 11);
}

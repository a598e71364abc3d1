#include "denhartog/number/bounded.hpp"

#include <random>

#include "denhartog/evaluation/mode.hpp"
#include "tests/catch.hpp"
#include "tests/support/multiprecision.hpp"

using namespace denhartog;

namespace {

// A number within its error, and the true one somewhere in there.
struct Pair {
    Bounded<double> bounded;
    Real50 exact;
};

class Source {
public:
    double uniform(double from, double to) { return from + (to - from) * static_cast<double>(generator() >> 11) * 0x1p-53; }
    Pair number(double from, double to) {
        const double x = uniform(from, to), e = std::abs(x) * std::ldexp(uniform(0, 1), -20 - static_cast<int>(generator() % 30));
        return {{x, e}, Real50(x) + Real50(e) * Real50(uniform(-1, 1))};
    }

private:
    std::mt19937_64 generator{5};
};

bool holds(const Bounded<double>& a, const Real50& exact) { return abs(Real50(Real50(a.x) - exact)) <= Real50(a.e); }

} // namespace

TEST_CASE("the error bound of every operation holds and is not idle", "[accuracy]") {
    Source source;
    double least_used = 1; // how much of the bound was needed at the most, over the operations
    for (int n = 0; n < 2000; ++n) {
        const Pair a = source.number(-4, 4), b = source.number(0.5, 4), c = source.number(0.01, 2);
        const std::vector<std::pair<Bounded<double>, Real50>> results{{a.bounded + b.bounded, a.exact + b.exact},
                                                                      {a.bounded - b.bounded, a.exact - b.exact},
                                                                      {a.bounded * b.bounded, a.exact * b.exact},
                                                                      {a.bounded / b.bounded, a.exact / b.exact},
                                                                      {sqrt(c.bounded), sqrt(c.exact)},
                                                                      {exp(a.bounded), exp(a.exact)},
                                                                      {sin(a.bounded), sin(a.exact)},
                                                                      {cos(a.bounded), cos(a.exact)},
                                                                      {sinh(a.bounded), sinh(a.exact)},
                                                                      {cosh(a.bounded), cosh(a.exact)},
                                                                      {atan2(a.bounded, b.bounded), atan2(a.exact, b.exact)},
                                                                      {sin_pi(c.bounded), sin(Real50(pi<Real50>() * c.exact))},
                                                                      {cos_pi(c.bounded), cos(Real50(pi<Real50>() * c.exact))},
                                                                      {exp_minus_one(c.bounded), Real50(exp(c.exact) - 1)}};
        double used = 0;
        for (std::size_t i = 0; i < results.size(); ++i) {
            INFO("operation " << i << ", run " << n);
            REQUIRE(holds(results[i].first, results[i].second));
            used = std::max(used, static_cast<double>(Real50(abs(Real50(Real50(results[i].first.x) - results[i].second)) /
                                                             Real50(results[i].first.e))));
        }
        least_used = std::min(least_used, used);
    }
    CHECK(least_used > 0.01);
}

TEST_CASE("sine and cosine together are what they are apart, in 50 digits and with bounds too", "[accuracy]") {
    Source draw;
    for (int n = 0; n < 500; ++n) {
        const Pair angle = draw.number(-30, 30);
        const SineCosine<Real50> together = sine_cosine(angle.exact);
        CHECK((together.s == sin(angle.exact) && together.c == cos(angle.exact)));
        const SineCosine<Bounded<double>> bounded = sine_cosine(angle.bounded);
        CHECK((bounded.s.x == elementary::sin(angle.bounded.x) && bounded.c.x == elementary::cos(angle.bounded.x)));
        CHECK(abs(together.s - bounded.s.x) <= bounded.s.e);
        CHECK(abs(together.c - bounded.c.x) <= bounded.c.e);
        const double change = angle.bounded.e / 2; // a bound below it would be none
        CHECK(bounded.s.e >= change * std::abs(bounded.c.x));
        CHECK(bounded.c.e >= change * std::abs(bounded.s.x));
    }
}

TEST_CASE("a quotient by what may be zero and an angle of what may be the origin have no useful bound", "[accuracy]") {
    CHECK_FALSE((Bounded<double>(1) / Bounded<double>(0.5, 0.5)).e < 1e300);
    CHECK(atan2(Bounded<double>(0.1, 0.2), Bounded<double>(0.1)).e > 6);
    CHECK(sqrt(Bounded<double>(0.0, 1e-8)).e >= 1e-4);
}

TEST_CASE("where nothing bounds an error the bound is infinite, never not a number", "[accuracy]") {
    const double infinite = std::numeric_limits<double>::infinity();
    const Bounded<double> open = Bounded<double>(1) / Bounded<double>(0.0, 1.0), wide(1.0, infinite);
    for (const Bounded<double>& b :
         {Bounded<double>(Bounded<double>(0) * wide), Bounded<double>(wide - wide), Bounded<double>(wide * Bounded<double>(0)),
          Bounded<double>(wide / wide), Bounded<double>(open * Bounded<double>(0)), sqrt(Bounded<double>(-1.0)),
          exp(Bounded<double>(-1e4, infinite)), Bounded<double>(Bounded<double>(0) / 0)})
        CHECK(b.e == infinite);
    CHECK(sqrt(Bounded<double>(-1e-20, 1e-16)).e > 0.99e-8); // negative by its error
    CHECK(sqrt(Bounded<double>(-1e-20, 1e-16)).x == 0);
}

TEST_CASE("the functions of a mode on bounded numbers hold their bounds", "[eq:23][eq:28][eq:29][accuracy]") {
    Source source;
    for (int n = 0; n < 300; ++n) {
        const Pair R = source.number(0.05, 6), zeta = source.number(0.001, 0.9);
        const evaluation::ModeFunctions<Bounded<double>> f = evaluation::mode_functions(R.bounded, zeta.bounded);
        const evaluation::ModeFunctions<Real50> exact = evaluation::mode_functions(R.exact, zeta.exact);
        INFO("R = " << R.bounded.x << ", zeta = " << zeta.bounded.x);
        REQUIRE(holds(f.v.re, exact.v.re));
        REQUIRE(holds(f.v.im, exact.v.im));
        REQUIRE(holds(f.u, exact.u));
        REQUIRE(holds(f.g, exact.g));
    }
}

// (86) and the boundary at high frequency ratios.
#include "denhartog/formulas/high_frequency.hpp"

#include <cmath>

#include "tests/catch.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

TEST_CASE("the limit at high frequencies is 0.537 for mu = 1 and falls with mu", "[eq:86][high-frequency]") {
    CHECK(paper::friction_ratio_limit_at_high_frequency(1.0) == Approx(0.537).epsilon(1e-3));
    // a free mass comes to rest after half a period where sin(phi) = pi beta / 2, and starts again where |cos(phi)| = mu beta
    for (const double mu : {1.0, 1.375, 2.0, 3.0}) {
        const double beta = paper::friction_ratio_limit_at_high_frequency(mu);
        CHECK(std::hypot(pi<double>() * beta / 2, mu * beta) == Approx(1).epsilon(1e-14));
    }
}

TEST_CASE("with the load on the contact the boundary tends to it, whatever the damping and the number of masses",
          "[eq:69][eq:86][high-frequency]") {
    for (const double mu : {1.0, 1.375, 3.0}) {
        const double limit = paper::friction_ratio_limit_at_high_frequency(mu);
        for (const double zeta : {0.0, 0.001, 0.1, 0.5}) {
            CHECK(boundary(sums_of(oscillator(zeta, 1e5, mu)), mu).exact == Approx(limit).epsilon(1e-4));
            CHECK(boundary(sums_of(chain({1, 2.5, 0.75}, {1, 0.625, 1.875}, {zeta, zeta, zeta}, 2, 2, mu, 1e5)), mu).exact ==
                  Approx(limit).epsilon(1e-4));
        }
    }
}

TEST_CASE("with the load elsewhere the boundary tends to zero", "[eq:69][eq:86][high-frequency]") {
    double last = 1;
    for (const double r : {10.0, 100.0, 1000.0, 10000.0}) {
        const double limit = boundary(sums_of(three_masses(r)), 1.375).exact;
        CHECK(limit < last / 5);
        last = limit;
    }
}

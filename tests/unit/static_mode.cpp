#include "denhartog/sums/static_mode.hpp"

#include <random>

#include "tests/catch.hpp"

using namespace denhartog;

TEST_CASE("a mode that counts as static is within its bounds of what it is, and near the limit R to 0 they are narrow",
          "[eq:23][eq:28][eq:29][limit]") {
    std::mt19937_64 random(23);
    std::uniform_real_distribution<double> unit(0, 1);
    int narrow = 0, overdamped = 0;
    for (int n = 0; n < 20000; ++n) {
        const double R = std::exp2(-12 + 13 * unit(random)), zeta = std::exp2(-10 + 12 * unit(random));
        const evaluation::ModeFunctions<double> exact = evaluation::mode_functions(R, zeta);
        const evaluation::ModeFunctions<Bounded<double>> f = static_mode_functions(R, zeta);
        INFO("R = " << tests::hexadecimal(R) << ", zeta = " << tests::hexadecimal(zeta));
        CHECK(std::abs(exact.v.re - f.v.re.x) <= f.v.re.e);
        CHECK(std::abs(exact.v.im - f.v.im.x) <= f.v.im.e);
        CHECK(std::abs(exact.u - f.u.x) <= f.u.e);
        CHECK(std::abs(exact.g - f.g.x) <= f.g.e + 1e-15);
        overdamped += zeta >= 1;
        narrow += f.v.re.e < 1e-2 && f.u.e < 1e-2 && f.g.e < 1e-2;
    }
    CHECK(overdamped > 1000);
    CHECK(narrow > 1000);
}

TEST_CASE("an undamped mode has no bound by its static value", "[eq:28][limit]") {
    const evaluation::ModeFunctions<Bounded<double>> f = static_mode_functions(0.01, 0);
    CHECK_FALSE(f.u.e < 1e300);
    CHECK_FALSE(f.g.e < 1e300);
}

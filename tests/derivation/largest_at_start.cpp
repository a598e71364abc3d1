// `57/largest-at-start` by numbers: from half the damped natural frequency on, the demand is largest at the start.
#include <cmath>

#include "denhartog/evaluation/demand.hpp"
#include "denhartog/evaluation/mode.hpp"
#include "denhartog/formulas/boundary.hpp"
#include "tests/catch.hpp"

using namespace denhartog;

TEST_CASE("the demand (57) is largest for tau -> 0 where 2 R is at least w, and need not be below", "[eq:57][eq:71]") {
    double most = 0, most_below = 0;
    for (int z = 0; z < 64; ++z)
        for (int n = 0; n < 96; ++n) {
            const double zeta = z / 64.0, w = std::sqrt((1 - zeta) * (1 + zeta));
            for (const bool below : {false, true}) {
                const double R = below ? w / 2 * (n + 1) / 97 : w / 2 * (1 + n / 32.0);
                const evaluation::ModeFunctions<double> f = evaluation::mode_functions(R, zeta);
                if (!std::isfinite(f.u) || std::abs(f.u) > 1e6) continue; // next to a pole
                const double at_start = paper::s_d_at_zero(R, zeta, f.u, f.g);
                for (int i = 1; i < 64; ++i) {
                    const double excess = evaluation::s_d_integrand_of(pi<double>() * i / 64, R, zeta, {f.u, f.g}) / at_start - 1;
                    double& worst = below ? most_below : most;
                    worst = std::max(worst, excess);
                }
            }
        }
    CHECK(most < 1e-9);
    CHECK(most_below > 1);
}

// Amplitudes against dense samples, over seeded random systems.
#include <cmath>

#include "tests/catch.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

TEST_CASE("no sample of the motion exceeds an amplitude, and samples come up to it", "[eq:46][eq:47][maximum]") {
    constexpr std::uint64_t seed = 535;
    int n = 0;
    for (RandomScene<double> random : random_scenes<double>(seed)) {
        if (++n % 3 != 0) continue;
        const ModeSums<double> s = sums_of(random.scene);
        const Boundary<double> b = boundary(s, random.scene.mu);
        random.scene.beta = friction_ratio_at(random.fraction_of_limit, b.exact);
        const SteadyState<double> state = steady_state(s, b, *random.scene.beta);
        constexpr int samples = 1000;
        std::vector<double> largest(state.masses.size());
        for (int i = 0; i <= samples; ++i) {
            const Motion<double> now = motion(s, state, std::min(pi<double>(), pi<double>() * i / samples));
            for (std::size_t k = 0; k < largest.size(); ++k) largest[k] = std::max(largest[k], std::abs(now.x[k]));
        }
        for (std::size_t k = 0; k < largest.size(); ++k) {
            const double amplitude = state.masses[k].amplitude;
            INFO(random.name << ", mass " << k + 1 << ": " << hexadecimal(amplitude) << " and " << hexadecimal(largest[k]));
            CHECK(largest[k] <= amplitude * (1 + 1e-11));
            CHECK(largest[k] >= amplitude * (1 - 1e-3));
        }
    }
}

TEST_CASE("many oscillations in a half-period do not hide the largest", "[eq:57][eq:47][maximum]") {
    for (const double r : {0.02, 0.0201, 0.0303})
        for (const double zeta : {0.0, 0.0009765625}) {
            Scene<double> scene = chain({1, 2.5, 0.75}, {1, 0.625, 1.875}, {zeta, zeta, zeta}, 2, 1, 1, r);
            const ModeSums<double> s = sums_of(scene);
            const Boundary<double> b = boundary(s, scene.mu);
            double demand = 0;
            for (int n = 1; n < 100000; ++n) demand = std::max(demand, sliding_demand(s, pi<double>() * n / 100000));
            INFO("r = " << hexadecimal(r) << ", zeta = " << hexadecimal(zeta));
            CHECK(demand <= b.S_exact * (1 + 1e-10));
            CHECK(demand >= b.S_exact * (1 - 1e-2));
            const SteadyState<double> state = steady_state(s, b, 0.5 * b.exact);
            for (std::size_t k = 0; k < 3; ++k) {
                const double sampled = largest_sample(s, state, k, 20000);
                CHECK(sampled <= state.masses[k].amplitude * (1 + 1e-12));
                CHECK(sampled >= state.masses[k].amplitude * (1 - 1e-4));
            }
        }
}

// The phases of the paper's algorithm: that they end, where they are counted, and what is said where they do not end.
#include <algorithm>
#include <cmath>

#include "denhartog/paper_algorithm/paper_algorithm.hpp"
#include "tests/catch.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

PaperSettings settings_with(double tolerance, int cycles) {
    PaperSettings settings;
    settings.absolute_tolerance = tolerance;
    settings.cycles = cycles;
    return settings;
}

} // namespace

TEST_CASE("no tolerance is so coarse that a contact set in motion is taken to stop at once", "[eq:74][paper-algorithm]") {
    // With mu = 1 a contact leaves a stop with velocity and acceleration zero: a long step does not resolve how.
    int runs = 0;
    long phases = 0;
    for (const RandomScene<double>& random : random_scenes<double>(7)) {
        if (number_of_masses(random.scene.system) > 4) continue;
        for (const double beta : {0.1, 0.6})
            for (const double tolerance : {9e-2, 1e-2, 1e-4}) {
                Scene<double> scene = with_beta(random.scene, beta);
                scene.mu = 1;
                const PaperMotion motion = paper_algorithm(scene, settings_with(tolerance, 10));
                INFO(random.name << ", beta " << beta << ", tolerance " << tolerance << ": " << motion.reason);
                CHECK(motion.status == IntegrationStatus::complete);
                ++runs;
                phases += motion.phases;
            }
    }
    CHECK(runs >= 900);
    CHECK(phases >= 20 * runs); // there was something to decide
}

TEST_CASE("a stop across the start of the last period is one stop, wherever the period starts", "[eq:74][paper-algorithm]") {
    const Scene<double> scene = with_beta(oscillator(0.01, 0.1), 0.2);
    const PaperMotion motion = paper_algorithm(scene, settings_with(1e-10, 60));
    REQUIRE(motion.stops.size() == 4);
    for (const double tau_0 : {0.5, 3.0, 3.75, 6.0}) { // within a stop all but the second
        PaperSettings settings = settings_with(1e-10, 60);
        settings.tau_0 = tau_0;
        const PaperMotion later = paper_algorithm(scene, settings);
        REQUIRE(later.stops.size() == 4);
        for (std::size_t n = 0; n < 4; ++n) {
            const Stop& stop = later.stops[n];
            CHECK(stop.start >= 0);
            CHECK(stop.start < 2 * pi<double>());
            if (n > 0) CHECK(stop.start > later.stops[n - 1].end);
            const auto same = std::ranges::find_if(
                motion.stops, [&](const Stop& other) { return std::abs(wrapped(stop.start + tau_0 - other.start)) <= 1e-8; });
            INFO("tau_0 " << tau_0 << ", stop " << n << " from " << stop.start << " to " << stop.end);
            REQUIRE(same != motion.stops.end());
            CHECK(std::abs(stop.end - stop.start - (same->end - same->start)) <= 1e-8);
            CHECK(std::abs(stop.x - same->x) <= 1e-8);
        }
        CHECK(std::abs(later.masses[0].amplitude - motion.masses[0].amplitude) <= 1e-9);
    }
}

TEST_CASE("what cannot be finished has a status, a reason and no numbers", "[paper-algorithm]") {
    const Scene<double> scene = with_beta(oscillator(0.01, 0.1), 0.2);
    PaperSettings few_phases;
    few_phases.most_phases_per_cycle = 7;
    PaperSettings few_steps;
    few_steps.most_steps = 1000;
    few_steps.history = true;
    PaperSettings too_large;
    too_large.start = State{{1e308}, {1e308}};
    PaperSettings too_small;
    too_small.absolute_tolerance = 1e-300;
    too_small.most_steps = 100'000;
    for (const auto& [settings, status] : {std::pair{few_phases, IntegrationStatus::chattering},
                                           {few_steps, IntegrationStatus::step_limit},
                                           {too_large, IntegrationStatus::overflow},
                                           {too_small, IntegrationStatus::step_limit}}) {
        const PaperMotion motion = paper_algorithm(scene, settings);
        INFO(motion.reason);
        CHECK(motion.status == status);
        CHECK(motion.reason.find("at tau = ") != std::string::npos);
        CHECK(motion.masses.empty());
        CHECK(motion.stops.empty());
        CHECK(motion.history.empty());
        CHECK(motion.end.x.empty());
    }
}

TEST_CASE("the history of the contact ends with the last period", "[paper-algorithm]") {
    for (const double beta : {0.0, 0.2}) {
        PaperSettings settings = settings_with(1e-8, 40);
        settings.history = true;
        settings.samples = 500;
        const PaperMotion motion = paper_algorithm(with_beta(oscillator(0.01, 0.1), beta), settings);
        REQUIRE(motion.history.size() == 40);
        CHECK(std::abs(motion.history.back().amplitude - motion.masses[0].amplitude) <= 1e-14);
        CHECK(motion.history.back().stops == static_cast<int>(motion.stops.size()));
        CHECK(motion.history.front().amplitude != motion.history.back().amplitude);
        double sampled = 0;
        for (const State& s : motion.samples) sampled = std::max(sampled, std::abs(s.x[0]));
        CHECK(sampled <= motion.masses[0].amplitude);
        CHECK(sampled >= motion.masses[0].amplitude * (1 - 1e-2));
    }
}

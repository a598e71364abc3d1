// The paper's algorithm against the closed form, and its 200 cycles against the periodic orbit: samples of the surveys
// `speed-accuracy tolerance` and `speed-accuracy cycles`.
#include <cmath>

#include "denhartog/number/number.hpp"
#include "tests/catch.hpp"
#include "tests/speed_accuracy/cycles_survey.hpp"
#include "tests/speed_accuracy/tolerance_survey.hpp"
#include "tests/support/paper_systems.hpp"

using namespace denhartog;
using namespace denhartog::tests;

TEST_CASE("on the paper's scenes the paper's algorithm tends to the closed form as its tolerance is tightened",
          "[eq:38][eq:39][eq:47][paper-algorithm]") {
    for (const auto& [group, scenes] : paper_scene_groups()) {
        std::vector<NamedScene<double>> sample;
        for (std::size_t n = 0; n < scenes.size(); n += 5) sample.push_back(scenes[n]);
        const ToleranceErrors rough = tolerance_errors(sample, {1e-6, 1e-3}, 40, false);
        const ToleranceErrors own = tolerance_errors(sample, {1e-6, 1e-6}, 40, false);
        const ToleranceErrors tight = tolerance_errors(sample, {1e-10, 1e-10}, 40, false);
        std::printf("%s: %d amplitudes; 1e-6 with 1e-3: %.1e, 1e-6: %.1e, 1e-10: %.1e; phases at 1e-10: %.1e\n", group.c_str(),
                    own.on_closed.count, rough.on_closed.error, own.on_closed.error, tight.on_closed.error, tight.phase.error);
        INFO(group << ": " << tight.on_closed.where);
        CHECK(tight.on_closed.count > 0);
        CHECK(rough.failed + own.failed + tight.failed == 0);
        CHECK(own.on_closed.error <= 1e-3);
        CHECK(tight.on_closed.error <= 1e-7);
        CHECK(tight.phase.error <= 1e-7);
        CHECK(tight.on_closed.error <= own.on_closed.error / 300);
    }
}

TEST_CASE("near a resonance with zeta = 0.001 the amplitude after 200 cycles is far from that of the steady state",
          "[exact-solver][cycles]") {
    const std::vector<double> r = {0.5, 0.9, 1.0, 1.1, 2.0};
    for (const double zeta : {0.001, 0.01, 0.1}) {
        const CyclesSurvey survey = survey_cycles("SDOF", single_mass(zeta), zeta, 0.2, r, 200);
        REQUIRE(survey.errors.size() == r.size());
        const CyclesError& largest = worst(survey);
        std::printf("SDOF zeta = %g: largest error %.3e at r = %g\n", zeta, largest.contact, largest.r);
        // At resonance friction takes the same share of the load in every cycle: what is missing decays with the free motion.
        const double missing = std::exp(-400 * pi<double>() * zeta);
        if (zeta < 0.1) {
            CHECK(largest.r == 1.0);
            CHECK(largest.contact == Approx(missing).epsilon(0.02));
        } else {
            CHECK(largest.contact <= 1e-12);
        }
    }
    for (const NamedSystem<double>& s : paper_systems(0.001)) {
        const CyclesSurvey survey = survey_cycles(s.name, s.system, 0.001, 0.2, {0.6, 1.0, 1.3, 1.61}, 200);
        std::printf("%s zeta = 0.001: largest error %.3e at r = %g\n", s.name.c_str(), worst(survey).contact, worst(survey).r);
        CHECK(survey.unanswered == 0);
        CHECK(worst(survey).contact > 0.01);
    }
}

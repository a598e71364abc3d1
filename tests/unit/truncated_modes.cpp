#include "denhartog/solve/truncated_modes.hpp"

#include "denhartog/answer/scene_source.hpp"
#include "tests/catch.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

// A chain of equal masses and springs, damped the more the higher the mode.
Scene<double> long_chain(std::size_t N, double r, double beta) {
    std::vector<double> ones(N, 1), zeta;
    for (std::size_t i = 0; i < N; ++i) zeta.push_back(0.125 + static_cast<double>(i) / 64);
    Scene<double> scene = chain(ones, ones, zeta, 5, 1, 1, r);
    scene.beta = beta;
    return scene;
}

} // namespace

TEST_CASE("amplitudes and phases from few modes keep their bounds against all of them", "[eq:38][eq:39][accuracy]") {
    int scenes = 0, answered = 0;
    for (const RandomScene<double>& each : random_scenes<double>(11)) {
        Scene<double> scene = each.scene;
        if (scene.system.damping_ratios.empty() || ++scenes % 3 != 0) continue;
        scene.mu = 1;
        scene.beta = boundary(sums_of(scene), 1.0).exact * each.fraction_of_limit / 8;
        BoundedModes<double> modes = modes_of(scene);
        const std::optional<TruncatedModesSolution> few = truncated_modes_solution(scene, modes, 1, true);
        if (!few) continue;
        ++answered;
        const Response<double> all = response(scene);
        INFO(each.name);
        CHECK(few->slides_below <= all.boundary.exact);
        for (std::size_t k = 0; k < few->masses.size(); ++k) {
            const MassResponse<double>& m = all.steady_state->masses[k];
            CHECK(std::abs(few->masses[k].amplitude.value - m.amplitude) <= few->masses[k].amplitude.error);
            CHECK(std::abs(wrapped(few->masses[k].phase->value - m.phase)) <= few->masses[k].phase->error);
        }
    }
    CHECK(answered > 30);
}

TEST_CASE("far above the frequency of the force modes are left out, the fewer the digits the more", "[eq:38]") {
    Scene<double> scene = long_chain(40, 0.02, 0x1p-15);
    std::vector<std::size_t> taken;
    for (const int digits : {1, 2}) {
        BoundedModes<double> modes = modes_of(scene);
        const long before = mode_evaluations();
        const std::optional<TruncatedModesSolution> few = truncated_modes_solution(scene, modes, digits, false);
        REQUIRE(few);
        CHECK(mode_evaluations() - before == static_cast<long>(few->modes));
        taken.push_back(few->modes);
    }
    CHECK(taken[0] <= taken[1]);
    CHECK(taken[1] < 40);
}

TEST_CASE("at the boundary of sliding, or where static friction is larger, few modes have no answer", "[eq:69]") {
    Scene<double> scene = oscillator(0.0625, 1.5);
    scene.beta = boundary(sums_of(scene), 1.0).exact;
    BoundedModes<double> modes = modes_of(scene);
    CHECK_FALSE(truncated_modes_solution(scene, modes, 3, false));
    scene.beta = 0.125;
    scene.mu = 1.5;
    CHECK_FALSE(truncated_modes_solution(scene, modes, 3, false));
    scene.mu = 1;
    CHECK(truncated_modes_solution(scene, modes, 3, false));
}

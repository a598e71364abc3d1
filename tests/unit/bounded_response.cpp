#include "denhartog/solve/bounded_response.hpp"

#include "denhartog/number/errors.hpp"
#include "denhartog/solve/scene_source.hpp"
#include "tests/catch.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

TEST_CASE("error bounds known beforehand hold against 50 digits and leave more than six digits",
          "[eq:38][eq:44][eq:52][eq:69][accuracy]") {
    for (const double r : {0.0625, 0.3125, 0.875, 1.125, 4.0}) {
        Scene<double> scene = three_masses(r);
        scene.beta = 0.75 * boundary(sums_of(scene), scene.mu).exact;
        BoundedModes modes(scene, modal_basis(scene.system));
        const BoundedResponse low = bounded_response(scene, modes);
        const Response<Real50> high = response(scene_source(scene).in_50_digits());
        CHECK(low.relative < 1e-7);
        REQUIRE(low.response.steady_state);
        for (std::size_t k = 0; k < 3; ++k) {
            const MassResponse<double>& m = low.response.steady_state->masses[k];
            const MassResponse<Real50>& w = high.steady_state->masses[k];
            INFO("r = " << hexadecimal(r) << ", mass " << k + 1 << ", bound " << hexadecimal(m.error_bound));
            CHECK(abs(Real50(m.x0 - w.x0)) <= m.error_bound);
            CHECK(abs(Real50(m.v0 - w.v0)) <= m.error_bound);
            CHECK(abs(Real50(m.amplitude - w.amplitude)) <= m.error_bound);
            CHECK(abs(Real50(m.amplitude_monoharmonic - w.amplitude_monoharmonic)) <= m.error_bound);
            CHECK(abs(wrapped(Real50(m.phase - w.phase))) <= low.phase_error[k]);
        }
    }
}

TEST_CASE("error bounds known beforehand hold on random systems", "[eq:38][eq:69][accuracy]") {
    int number = 0, compared = 0;
    for (const RandomScene<double>& each : random_scenes<double>(17)) {
        Scene<double> scene = each.scene;
        if (scene.system.damping_ratios.empty() || ++number % 16 != 0) continue;
        scene.beta = each.fraction_of_limit * boundary(sums_of(scene), scene.mu).exact;
        BoundedModes modes(scene, modal_basis(scene.system));
        const BoundedResponse low = bounded_response(scene, modes);
        const Response<Real50> high = response(scene_source(scene).in_50_digits());
        REQUIRE(low.response.steady_state);
        ++compared;
        INFO(each.name);
        CHECK(low.relative < 1e-6);
        for (std::size_t k = 0; k < high.steady_state->masses.size(); ++k) {
            const MassResponse<double>& m = low.response.steady_state->masses[k];
            CHECK(abs(Real50(m.amplitude - high.steady_state->masses[k].amplitude)) <= m.error_bound);
            CHECK(abs(wrapped(Real50(m.phase - high.steady_state->masses[k].phase))) <= low.phase_error[k]);
        }
    }
    CHECK(compared > 15);
}

TEST_CASE("the bounds widen where the modes lie close together", "[accuracy]") {
    Scene<double> near = three_masses(), far = near;
    near.system.stiffness_ratios.clear();
    near.system.stiffness_matrix.resize(3, 3); // the third mass apart from the others, its frequency near one of theirs
    near.system.stiffness_matrix << 1.625, -0.625, 0, -0.625, 0.625, 0, 0, 0, 0.1125;
    near.beta = far.beta = 0.03125;
    BoundedModes near_modes(near, modal_basis(near.system)), far_modes(far, modal_basis(far.system));
    const auto error = [](const BoundedModes& modes) {
        double largest = 0;
        for (Eigen::Index i = 0; i < 3; ++i)
            for (Eigen::Index k = 0; k < 3; ++k) largest = std::max(largest, modes.basis().phi(k, i).e);
        return largest;
    };
    CHECK(error(near_modes) > 4 * error(far_modes));
}

TEST_CASE("next to the pole of a mode without damping there is no bound, and solve takes more digits", "[domain][accuracy]") {
    for (const double r : {1.0 / 3, 1.0 / 3 * (1 + 0x1p-50), 1 + 0x1p-52}) {
        Scene<double> scene = oscillator(0, r);
        scene.beta = 0.001;
        BoundedModes modes(scene, modal_basis(scene.system));
        double relative = std::numeric_limits<double>::infinity();
        try {
            relative = bounded_response(scene, modes).relative;
        } catch (const DomainError&) {
        } catch (const PrecisionError&) {
        }
        INFO("r = " << hexadecimal(r));
        CHECK(relative > 0.01);
    }
}

#include "denhartog/answer/models_in_double.hpp"

#include "denhartog/answer/scene_source.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/solve/solve.hpp"
#include "tests/catch.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

SlidingPoint bounded_point(const Scene<double>& scene) { return sliding_point(scene, *modes_with_errors(scene.system), {}); }

} // namespace

TEST_CASE("error bounds known beforehand hold on random systems", "[eq:38][eq:69][accuracy]") {
    int number = 0, compared = 0;
    for (const RandomScene<double>& each : random_scenes<double>(17)) {
        Scene<double> scene = each.scene;
        if (scene.system.damping_ratios.empty() || ++number % 16 != 0) continue;
        scene.beta = each.fraction_of_limit * boundary(sums_of(scene), scene.mu).exact;
        const SlidingPoint low = bounded_point(scene);
        const Response<Real50> high = response(scene_in<Real50>(scene));
        REQUIRE(low.state);
        ++compared;
        INFO(each.name);
        CHECK(low.attempted.relative < 1e-6);
        for (std::size_t k = 0; k < high.steady_state->masses.size(); ++k) {
            const MassResponse<Bounded<double>>& m = low.state->masses[k];
            CHECK(abs(Real50(m.amplitude.x - high.steady_state->masses[k].amplitude)) <= m.amplitude.e);
            CHECK(abs(wrapped(Real50(m.phase.x - high.steady_state->masses[k].phase))) <= m.phase.e);
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
    const auto error = [](const Scene<double>& scene) {
        const ModalBasis<Bounded<double>> basis = with_errors(scene.system, modal_basis(scene.system));
        double largest = 0;
        for (Eigen::Index i = 0; i < 3; ++i)
            for (Eigen::Index k = 0; k < 3; ++k) largest = std::max(largest, basis.phi(k, i).e);
        return largest;
    };
    CHECK(error(near) > 4 * error(far));
}

TEST_CASE("next to the pole of a mode without damping there is no bound, and solve takes more digits", "[domain][accuracy]") {
    for (const double r : {1.0 / 3, 1.0 / 3 * (1 + 0x1p-50), 1 + 0x1p-52}) {
        Scene<double> scene = oscillator(0, r);
        scene.beta = 0.001;
        double relative = std::numeric_limits<double>::infinity();
        try {
            relative = bounded_point(scene).attempted.relative;
        } catch (const DomainError&) {
        } catch (const PrecisionError&) {
        }
        INFO("r = " << hexadecimal(r));
        CHECK(relative > 0.01);
    }
}

TEST_CASE("phases at frequencies far below all natural ones keep their bounds, at the ends of the half-period too",
          "[eq:47][accuracy]") {
    for (const double r : {1e-9, 1e-7, 1e-5, 1e-3})
        for (const double part : {0.0, 0.5}) {
            Scene<double> scene = chain({1, 1}, {1, 1}, {0.05, 0.05}, 2, 1, 1, r);
            scene.beta = part * boundary(sums_of(scene), 1.0).exact;
            const SlidingPoint low = bounded_point(scene);
            const Response<Real100> high = response(scene_in<Real100>(scene));
            REQUIRE(low.state);
            for (std::size_t k = 0; k < 2; ++k) {
                const Bounded<double>& phase = low.state->masses[k].phase;
                INFO("r = " << r << ", beta = " << *scene.beta << ", mass " << k + 1 << ", bound " << phase.e);
                CHECK(abs(wrapped(Real100(Real100(phase.x) - high.steady_state->masses[k].phase))) <= Real100(phase.e));
                // With friction the modes ring: at r = 1e-9 the maxima of that ripple differ by less than double can tell.
                CHECK(phase.e < (part > 0 && r == 1e-9 ? 1e-7 : 1e-12));
                const Certified sure = *solve(scene_source(scene), {Asked::phase, 12}).masses[k].phase;
                CHECK(sure.error < 1e-12);
                CHECK(abs(wrapped(Real100(Real100(sure.value) - high.steady_state->masses[k].phase))) <= Real100(sure.error));
            }
        }
}

// Far above the natural frequencies of a chain double has no digit of what a far mass does, and the reference answers.
#include "denhartog/solve/decision.hpp"
#include "denhartog/solve/quantities.hpp"
#include "denhartog/solve/solve.hpp"
#include "tests/catch.hpp"
#include "tests/unit/response_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

Scene<double> undamped_chain(std::size_t N, double r) {
    const std::vector<double> ones(N, 1), zeros(N, 0);
    return chain(ones, ones, zeros, N, 1, 1, r);
}

// The two chains whose sums over modes have no digit in double.
std::vector<Scene<double>> lost_chains() { return {undamped_chain(5, 100), undamped_chain(12, 30)}; }

double error_over(const Real100& truth, const Real100& value) {
    return static_cast<double>(Real100(abs(Real100((value - truth) / truth))));
}

} // namespace

TEST_CASE("at high r the sums over modes in double have no digit of V and U of a far mass, and their bounds say so",
          "[eq:33][eq:34][accuracy]") {
    for (const Scene<double>& scene : lost_chains()) {
        const std::size_t N = scene.system.mass_ratios.size();
        const ModeSums<Real100> truth = sums_of(scene_in<Real100>(scene));
        const ModeSums<Bounded<double>> sums = bounded_sums_of(scene);
        CHECK(error_over(truth.V[N - 1].re, sums.V[N - 1].re.x) > 0.1);
        CHECK(error_over(truth.U[0], sums.U[0].x) > 0.1);
        for (std::size_t k = 0; k < N; ++k) {
            INFO("N = " << N << ", mass " << k + 1);
            CHECK(abs(Real100(truth.V[k].re - Real100(sums.V[k].re.x))) <= Real100(sums.V[k].re.e));
            CHECK(abs(Real100(truth.U[k] - Real100(sums.U[k].x))) <= Real100(sums.U[k].e));
        }
    }
}

TEST_CASE("both chains are answered to 14 digits by the reference, and right", "[eq:38][accuracy]") {
    for (Scene<double> scene : lost_chains()) {
        const std::size_t N = scene.system.mass_ratios.size();
        const Boundary<Real100> limit = boundary(sums_of(scene_in<Real100>(scene)), Real100(1));
        scene.beta = static_cast<double>(limit.exact) / 2;
        const Response<Real100> truth = response(scene_in<Real100>(scene));
        REQUIRE(truth.steady_state);
        const Real100 X_j = truth.steady_state->X_j;
        const long before = precision_steps();
        const Solution measured = sliding_answer(scene_source(scene), Question{Asked::motion, 14});
        CHECK(precision_steps() > before);
        CHECK(measured.digits_reached);
        CHECK(measured.method.precision == "reference");
        CHECK(in_words(measured.method.why).find("in double: the error bound does not guarantee the 14 digits") == 0);
        CHECK(error_over(X_j, Real100(measured.masses[N - 1].amplitude.value)) < 1e-14);
        for (const int digits : {12, 14}) {
            const Solution solved = solve(scene_source(scene), {Asked::motion, digits});
            INFO("N = " << N << ", " << digits << " digits: " << in_words(solved.method.why));
            CHECK(solved.method.precision == "reference");
            CHECK(solved.regime.regime == Regime::continuous);
            CHECK(solved.relative_error <= std::pow(10.0, -digits));
            CHECK(error_over(X_j, Real100(solved.masses[N - 1].amplitude.value)) < std::pow(10.0, -digits));
        }
        const QuantitiesAnswer all = quantities(scene_source(scene), std::array{0.5}, 12);
        INFO(all.method.precision << ", " << in_words(all.method.why));
        CHECK(error_over(X_j, Real100(all.numbers.X_j->x)) < 1e-12);
        CHECK(all.relative <= 1e-12);
    }
}

#include "denhartog/sums/chain_sums.hpp"

#include "denhartog/solve/quantities.hpp"
#include "denhartog/solve/solve.hpp"
#include "denhartog/solve/solve_by_reference.hpp"
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

TEST_CASE("at high r the sum over modes in double has no digit of V and U of a far mass; the chain's own sums have 14",
          "[eq:33][eq:34][accuracy]") {
    for (const Scene<double>& scene : lost_chains()) {
        const std::size_t N = scene.system.mass_ratios.size();
        const ModeSums<double> plain = sums_of(scene);
        const ModeSums<Real100> truth = sums_of(scene_in<Real100>(scene));
        BoundedModes<double> modes = modes_of(scene);
        const ModeSums<Bounded<double>> sums = bounded_sums(scene.system, modes);
        const ModeSums<Bounded<double>> by_modes =
            mode_sums(modes.basis(), scene.system.contact, scene.system.load, modes.r(), modes.all());
        CHECK(error_over(truth.V[N - 1].re, plain.V[N - 1].re) > 0.1);
        CHECK(error_over(truth.U[0], plain.U[0]) > 0.1);
        CHECK(by_modes.V[N - 1].re.e > std::abs(by_modes.V[N - 1].re.x));
        for (std::size_t k = 0; k < N; ++k) {
            INFO("N = " << N << ", mass " << k + 1);
            const Real100 of_V = abs(Real100(truth.V[k].re - Real100(sums.V[k].re.x)));
            const Real100 of_U = abs(Real100(truth.U[k] - Real100(sums.U[k].x)));
            CHECK(of_V <= Real100(sums.V[k].re.e));
            CHECK(of_U <= Real100(sums.U[k].e));
            CHECK(error_over(truth.V[k].re, sums.V[k].re.x) < 1e-14);
            CHECK(error_over(truth.U[k], sums.U[k].x) < 1e-14);
        }
    }
}

TEST_CASE("the response of a chain by elimination is that of its modes, grounded at one end or at both", "[eq:33][accuracy]") {
    for (const bool grounded : {false, true})
        for (const double r : {0.25, 0.875, 1.375, 8.0}) {
            Scene<double> scene = chain({1, 2.5, 0.75, 3}, {1, 0.625, 1.875, 0.5}, {0, 0, 0, 0}, 4, 2, 1, r);
            const std::vector<double> gamma = scene.system.mass_ratios;
            std::vector<double> kappa = scene.system.stiffness_ratios;
            scene.system = with_stiffness_matrix(scene.system);
            if (grounded) {
                kappa.push_back(0.25);
                connect(scene.system.stiffness_matrix, 3, -1, 0.25);
            }
            const ModeSums<Real100> truth = sums_of(scene_in<Real100>(scene));
            const std::vector<Bounded<double>> V = undamped_response_of_chain(
                {gamma.begin(), gamma.end()}, {kappa.begin(), kappa.end()}, Mass{1}, Bounded<double>(r));
            for (std::size_t k = 0; k < 4; ++k) {
                INFO("r = " << hexadecimal(r) << ", mass " << k + 1 << ", grounded " << grounded);
                CHECK(V[k].e < 1e-12 * std::abs(V[k].x));
                CHECK(abs(Real100(truth.V[k].re - Real100(V[k].x))) <= Real100(V[k].e));
            }
        }
}

TEST_CASE("both chains are answered to 14 digits, in double or in more with the reason said, and right", "[eq:38][accuracy]") {
    for (Scene<double> scene : lost_chains()) {
        const std::size_t N = scene.system.mass_ratios.size();
        const Boundary<Real100> limit = boundary(sums_of(scene_in<Real100>(scene)), Real100(1));
        scene.beta = static_cast<double>(limit.exact) / 2;
        const Response<Real100> truth = response(scene_in<Real100>(scene));
        REQUIRE(truth.steady_state);
        const Real100 X_j = truth.steady_state->X_j;
        const long before = precision_steps();
        const Solution measured = sliding_answer(scene_source(scene), SlidingQuestion{Asked::motion, 14, {}});
        CHECK(precision_steps() > before);
        CHECK(measured.digits_reached);
        CHECK(measured.method.precision != "double");
        CHECK(measured.method.why.find("in double: the error bound does not guarantee the 14 digits") == 0);
        CHECK(error_over(X_j, Real100(measured.masses[N - 1].amplitude.value)) < 1e-14);
        for (const int digits : {12, 14}) {
            const Solution solved = solve(scene_source(scene), {Asked::motion, digits});
            INFO("N = " << N << ", " << digits << " digits: " << solved.method.precision << ", " << solved.method.why);
            std::printf("chain of %zu, %d digits: %s, %s\n", N, digits, solved.method.precision.c_str(),
                        solved.method.why.c_str());
            CHECK(solved.regime.regime == Regime::continuous);
            CHECK(solved.relative_error <= std::pow(10.0, -digits));
            CHECK(error_over(X_j, Real100(solved.masses[N - 1].amplitude.value)) < std::pow(10.0, -digits));
        }
        const QuantitiesAnswer all = quantities(scene_source(scene), std::array{0.5}, 12);
        INFO(all.method.precision << ", " << all.method.why);
        CHECK(error_over(X_j, Real100(all.numbers.X_j->x)) < 1e-12);
        CHECK(all.relative <= 1e-12);
    }
}

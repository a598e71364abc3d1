// Damping that couples the modes, against routes that know no modes: the half-period by the exponential of the state in more
// digits, and the paper's Runge-Kutta.
#include "tests/properties/against_witness.hpp"
#include "tests/support/coupled_scenes.hpp"

using namespace denhartog;

namespace {

constexpr std::uint64_t seed_of_dashpots = 20262;

// A chain with dashpots 20, 0, 60: the figure error_of_neglected_coupling says how far it is off where the coupling is left out.
Scene<double> chain_with_dashpots(double beta, double tolerance = 0) {
    Scene<double> s =
        scene(R"({"masses": [10, 10, 10], "stiffnesses": [1000, 1000, 1000], "force": 100, "friction": 1, "frequency": 4,
        "damping_matrix": [[20, 0, 0], [0, 60, -60], [0, -60, 60]], "contact": 2, "load": 1})");
    s.beta = beta;
    s.system.damping_tolerance = tolerance;
    return s;
}

} // namespace

TEST_CASE("sliding with damping that couples the modes agrees with the second witness to 12 digits",
          "[eq:33][eq:34][eq:35][eq:38][eq:46][coupled-damping][witness]") {
    check_by_witness<double>(random_coupled_scenes(seed_of_dashpots), 7, 12, 60);
}

TEST_CASE("sliding with damping that couples the modes agrees with the second witness to 45 digits",
          "[eq:33][eq:38][coupled-damping][witness]") {
    std::vector<RandomScene<double>> scenes = random_coupled_scenes(seed_of_dashpots + 1);
    scenes.resize(80);
    check_by_witness<Real50>(scenes, 20, 45, 3);
}

TEST_CASE("every scene with damping that couples the modes agrees with the second witness",
          "[.][sweep][coupled-damping][witness]") {
    for (const std::uint64_t seed : {seed_of_dashpots, seed_of_dashpots + 1}) survey_by_witness(random_coupled_scenes(seed));
}

TEST_CASE("stick-slip with damping that couples the modes is the paper's algorithm's", "[eq:74][eq:75][coupled-damping]") {
    CHECK(compare_stick_slip_with_paper(random_coupled_scenes(seed_of_dashpots + 2), 3, 40) == 40);
}

TEST_CASE("damping of proportions, one coefficient changed in its last place, is nearly that of its ratios",
          "[eq:18][coupled-damping]") {
    const std::string text = R"({"mass_ratios": [1, 2], "stiffness_ratios": [1, 0.75], "contact": 2, "load": 1, "r": 0.75,
        "beta": 0.125, "damping_matrix": [[0.275, -0.075], [-0.075, )";
    const Solution classical = solve(scene(text + "0.275]]}")), coupled = solve(scene(text + "0.27500000001]]}"));
    CHECK(coupled.regime.regime == Regime::continuous);
    for (std::size_t k = 0; k < 2; ++k) {
        CHECK(coupled.masses[k].amplitude.value != classical.masses[k].amplitude.value);
        CHECK(coupled.masses[k].amplitude.value == Approx(classical.masses[k].amplitude.value).epsilon(1e-10));
        CHECK(coupled.masses[k].phase->value == Approx(classical.masses[k].phase->value).epsilon(1e-10));
    }
    CHECK(coupled.limits->exact.value == Approx(classical.limits->exact.value).epsilon(1e-10));
    CHECK(coupled.limits->approximate.value == Approx(classical.limits->approximate.value).epsilon(1e-10));
    CHECK(coupled.limits->sticking->value == Approx(classical.limits->sticking->value).epsilon(1e-10));
}

TEST_CASE("a tolerance of the damping matrix takes the ratios of its diagonal", "[eq:18][coupled-damping]") {
    const Solution left_out = solve(chain_with_dashpots(0.01, 2)), taken_in = solve(chain_with_dashpots(0.01));
    Scene<double> ratios = chain_with_dashpots(0.01);
    ratios.system.damping_ratios = modal_basis(ratios.system).zeta;
    ratios.system.damping_matrix.resize(0, 0);
    const Solution by_ratios = solve(ratios);
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(left_out.masses[k].amplitude.value == Approx(by_ratios.masses[k].amplitude.value).epsilon(1e-12));
        CHECK(std::abs(taken_in.masses[k].amplitude.value - left_out.masses[k].amplitude.value) >
              1e-3 * taken_in.masses[k].amplitude.value);
    }
}

TEST_CASE("the map of a system whose damping couples the modes is that of solve", "[coupled-damping]") {
    CHECK(check_map_by_solve(chain_with_dashpots(0), {0.3, 0.5, 1.5}, {0.01, 0.3, 0.9, 4}) > 0);
}

TEST_CASE("dashpots that leave a motion undamped but for the rounding of their sums are answered to any digits",
          "[coupled-damping]") {
    const Solution s =
        solve(scene(R"({"mass_ratios": [1, 1.5, 2], "stiffness_ratios": [1, 0.75, 1.25], "contact": 1, "load": 3, "r": 0.7,
        "beta": 0.01, "damping_matrix": [[0.1, -0.1, 0], [-0.1, 0.30000000000000004, -0.2], [0, -0.2, 0.2]]})"),
              {.digits = 30});
    CHECK(s.regime.regime == Regime::continuous);
    CHECK_FALSE(s.unique);
}

TEST_CASE("a damping matrix that feeds energy into the motion is refused", "[bad-input][coupled-damping]") {
    Scene<double> s = chain_with_dashpots(0.01);
    s.system.damping_matrix(0, 0) = -1;
    CHECK_THROWS_WITH(solve(s), Catch::Contains("damping_matrix") && Catch::Contains("energy"));
}

TEST_CASE("dashpots that leave no mode a damping ratio of its own reach no closed form of a mode", "[coupled-damping]") {
    const Scene<double> s = chain_with_dashpots(0.01);
    CHECK_THROWS_WITH(mode_sums(modal_basis(s.system), s.system.contact, s.system.load, *s.r),
                      Catch::Contains("must not couple the modes"));
}

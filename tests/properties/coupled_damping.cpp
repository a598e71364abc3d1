// Damping that couples the modes, beside damping that leaves them by themselves.
#include "denhartog/answer/modes_in_double.hpp"
#include "tests/properties/against_witness.hpp"
#include "tests/support/named_scenes.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

// A chain with dashpots 20, 0, 60: the figure error_of_neglected_coupling says how far it is off where the coupling is left out.
Scene<double> chain_with_dashpots(double beta, double tolerance = 0) {
    Scene<double> s = named_scene("dashpots");
    s.beta = beta;
    s.system.damping_tolerance = tolerance;
    return s;
}

// A chain with damping in proportion to masses and springs, as a matrix and as the ratios of its modes.
std::pair<Scene<double>, Scene<double>> proportional(std::size_t contact, std::size_t load, double r, double beta, double mu) {
    Scene<double> by_matrix;
    System<double>& s = by_matrix.system;
    s.mass_ratios = {1, 1.7, 0.6};
    s.stiffness_ratios = {1, 0.45, 1.3};
    s.contact = Mass{contact};
    s.load = Mass{load};
    by_matrix.r = r;
    by_matrix.beta = beta;
    by_matrix.mu = mu;
    Scene<double> by_ratios = by_matrix;
    by_ratios.system.damping_ratios.assign(3, 0.0);
    const std::vector<double> r_n = modal_basis(by_ratios.system).r_n;
    for (std::size_t i = 0; i < 3; ++i) by_ratios.system.damping_ratios[i] = (0.06 / r_n[i] + 0.03 * r_n[i]) / 2;
    s.damping_matrix = 0.03 * stiffness_matrix(s);
    for (Eigen::Index k = 0; k < 3; ++k) s.damping_matrix(k, k) += 0.06 * s.mass_ratios[static_cast<std::size_t>(k)];
    return {by_matrix, by_ratios};
}

} // namespace

TEST_CASE("damping of proportions, one coefficient changed in its last place, is nearly that of its ratios",
          "[eq:18][coupled-damping]") {
    const auto with = [](const std::string& last) {
        return solve(named_scene(R"(coupled {"mass_ratios": [1, 2], "stiffness_ratios": [1, 0.75], "r": 0.75, "beta": 0.125,
            "damping_matrix": [[0.275, -0.075], [-0.075, )" +
                                 last + "]]}"));
    };
    const Solution classical = with("0.275"), coupled = with("0.27500000001");
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

TEST_CASE("a damping matrix that leaves the modes by themselves gives what its ratios give", "[eq:18][eq:56][coupled-damping]") {
    int regimes[3] = {}, other_by_56 = 0;
    for (std::size_t n = 0; n < 48; ++n) {
        const double r = std::array{0.35, 0.8, 1.2, 2.1}[n % 4], beta = std::array{0.01, 0.2, 0.7}[n / 4 % 3];
        const auto [by_matrix, by_ratios] = proportional(n % 3, n / 2 % 3, r, beta, n < 24 ? 1 : 1.25);
        INFO("scene " << n);
        const Solution a = solve(by_matrix), b = solve(by_ratios);
        const auto same = [](const char* what, const Certified& one, const Certified& other) {
            INFO(what << ": " << one.value << " +- " << one.error << ", " << other.value << " +- " << other.error);
            CHECK(std::abs(one.value - other.value) <= one.error + other.error + 1e-13 * std::abs(other.value));
        };
        ++regimes[static_cast<int>(b.regime.regime)];
        REQUIRE(a.regime.regime == b.regime.regime);
        CHECK(a.method.precision == "double");
        CHECK(a.unique == b.unique);
        CHECK(a.regime_by_56 == b.regime_by_56);
        REQUIRE(a.limits);
        same("exact", a.limits->exact, b.limits->exact);
        same("paper", a.limits->paper, b.limits->paper);
        same("approximate", a.limits->approximate, b.limits->approximate);
        CHECK(a.limits->exact.error <= 1e-9 * a.limits->exact.value);
        other_by_56 += b.limits->paper.value < 0.999 * b.limits->exact.value;
        for (std::size_t k = 0; k < 3; ++k) {
            same("amplitude", a.masses[k].amplitude, b.masses[k].amplitude);
            CHECK(a.masses[k].amplitude.error <= 1e-8 * (a.masses[k].amplitude.value + a.masses[0].amplitude.value));
            REQUIRE(a.masses[k].phase.has_value() == b.masses[k].phase.has_value());
            if (a.masses[k].phase) same("phase", *a.masses[k].phase, *b.masses[k].phase);
        }
        REQUIRE(a.stops.size() == b.stops.size());
        for (std::size_t k = 0; k < a.stops.size(); ++k) same("stop", a.stops[k].start, b.stops[k].start);
        REQUIRE(a.stability.has_value() == b.stability.has_value());
        for (std::size_t k = 0; a.stability && k < a.stability->multipliers.size(); ++k)
            same("multiplier", a.stability->multipliers[k], b.stability->multipliers[k]);
        const SceneSource matrix = scene_source(by_matrix), ratios = scene_source(by_ratios);
        CHECK_FALSE(coupled_damping(matrix));
        const auto of_matrix = certain_mode_functions(matrix, modes_in_double(matrix).basis),
                   of_ratios = certain_mode_functions(ratios, modes_in_double(ratios).basis);
        for (std::size_t i = 0; i < 3; ++i) {
            CHECK(of_matrix[i].v.re.x == Approx(of_ratios[i].v.re.x).epsilon(1e-11));
            CHECK(of_matrix[i].u.x == Approx(of_ratios[i].u.x).epsilon(1e-11));
            CHECK(of_matrix[i].g.x == Approx(of_ratios[i].g.x).epsilon(1e-11).margin(1e-14));
        }
    }
    for (const int count : regimes) CHECK(count > 2);
    CHECK(other_by_56 > 1);
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

TEST_CASE("dashpots that leave a motion undamped but for the rounding of their sums are answered to any digits",
          "[coupled-damping]") {
    const Solution s = solve(named_scene("undamped but for rounding"), {.digits = 30});
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

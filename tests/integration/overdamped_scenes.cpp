// Scenes with critically damped and overdamped modes: every route of the program that takes a mode, against one that knows no
// modes: the half-period as a matrix exponential, the paper's Runge-Kutta algorithm, events from phase to phase.
#include <cmath>

#include "denhartog/answer/from_a_start.hpp"
#include "tests/integration/orbit_scenes.hpp"
#include "tests/support/second_witness.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

/// One mode below, one at or above critical damping; both above; both at it; far above.
const std::vector<std::vector<double>> damping{{0.0625, 1.5}, {2.5, 0.125}, {1, 0.03125}, {1, 1}, {1.25, 3}, {40, 0.25}};

std::vector<Scene<double>> scenes(double mu = 1) {
    std::vector<Scene<double>> all;
    for (const std::vector<double>& zeta : damping)
        for (const double r : {0.125, 0.5, 1.125, 2.5})
            for (const std::size_t j : {1, 2}) all.push_back(chain({1, 0.75}, {1, 1.5}, zeta, j, 1, mu, r));
    return all;
}

std::string text(const Scene<double>& s) {
    char line[160];
    std::snprintf(line, sizeof line, "zeta = %a, %a; r = %a, j = %d, beta = %a", s.system.damping_ratios[0],
                  s.system.damping_ratios[1], *s.r, static_cast<int>(s.system.contact.index + 1), s.beta ? *s.beta : -1);
    return line;
}

/// Between the boundaries of sliding and of sticking, a quarter of the way.
std::optional<Scene<double>> sticking_and_slipping(Scene<double> scene) {
    const Boundary<double> limits = response(scene).boundary;
    if (!limits.sticking || !(*limits.sticking > 1.01 * limits.exact)) return std::nullopt;
    scene.beta = limits.exact + (*limits.sticking - limits.exact) / 4;
    return scene;
}

double amplitude_of_contact(const Solution& s, const Scene<double>& scene) {
    return mass_of(s, scene.system.contact).amplitude.value;
}

/// Stops longer than rounding: at a breakaway the velocity rises from zero without a slope.
long stops_that_last(const PaperMotion& motion) {
    return std::count_if(motion.stops.begin(), motion.stops.end(), [](const Stop& s) { return s.end - s.start > 1e-9; });
}

} // namespace

TEST_CASE("with overdamped modes the closed form is the half-period by a matrix exponential",
          "[eq:38][eq:44][eq:45][eq:46][second-witness][overdamped]") {
    double largest = 0;
    for (Scene<double> scene : scenes()) {
        scene.beta = friction_ratio_at(0.5, response(scene).boundary.exact);
        INFO(text(scene));
        const double error = worst(compare_with_second_witness(scene, 16));
        CHECK(error < 1e-12);
        largest = std::max(largest, error);
    }
    std::printf("overdamped, closed form against the second witness: %.2e\n", largest);
    // The comparison tells another damping ratio.
    Scene<double> scene = scenes()[0];
    scene.beta = friction_ratio_at(0.5, response(scene).boundary.exact);
    Scene<double> other = scene;
    other.system.damping_ratios[1] = 1.5078125;
    const SampledMotion<double> moved = sampled_motion(sums_of(other), *response(other).steady_state, 16);
    CHECK(worst(compare(moved, half_period_motion(half_period_problem(scene), 16))) > 1e-6);
}

TEST_CASE("with overdamped and with critical modes the closed form in 50 digits is the half-period in 100",
          "[eq:38][eq:46][second-witness][overdamped]") {
    for (const std::vector<double>& zeta : {damping[0], damping[3]}) {
        Scene<Real50> scene = chain<Real50>({1, 0.75}, {1, 1.5}, zeta, 2, 1, 1, 0.5);
        scene.beta = Real50(1) / 64;
        CHECK(worst(compare_with_second_witness(scene, 4)) < Real50("1e-46"));
    }
}

TEST_CASE("with overdamped modes sliding ends where the exact solver sees the first stop", "[eq:69][exact-solver][overdamped]") {
    for (Scene<double> scene : scenes()) {
        const double limit = response(scene).boundary.exact;
        if (!(limit > 0.001)) continue; // the closed form does not hold at any friction worth the name
        const ContactSystem system = contact_system(scene.system);
        INFO(text(scene) << ", limit " << hexadecimal(limit));
        const PeriodicOrbit below = orbit_of({"", system, {*scene.r, limit * 0.999, 1}});
        const PeriodicOrbit above = orbit_of({"", system, {*scene.r, limit * 1.001, 1}});
        REQUIRE(below.status == OrbitStatus::periodic);
        CHECK(below.stops.empty());
        CHECK((above.status != OrbitStatus::periodic || !above.stops.empty()));
        scene.beta = limit * 0.999;
        CHECK(std::abs(response(scene).steady_state->X_j - below.contact.amplitude) < 1e-10 * below.contact.amplitude);
    }
}

TEST_CASE("with overdamped modes solve sticks and slips as the paper's algorithm does",
          "[eq:6][eq:74][eq:75][paper-algorithm][exact-solver][overdamped]") {
    int compared = 0;
    double largest = 0;
    for (const Scene<double>& sliding : scenes()) {
        const std::optional<Scene<double>> scene = sticking_and_slipping(sliding);
        if (!scene || scene->system.damping_ratios[0] > 10) continue; // too stiff for an explicit algorithm
        const Solution s = solve(scene_source(*scene), {Asked::amplitude, std::nullopt, false});
        PaperSettings settings;
        settings.cycles = 100;
        settings.absolute_tolerance = 1e-10;
        const PaperMotion by_paper = paper_algorithm(*scene, settings), by_events = exact_cycles(scene_source(*scene), settings);
        INFO(text(*scene));
        REQUIRE(s.regime.regime == Regime::stick_slip);
        REQUIRE(by_paper.status == IntegrationStatus::complete);
        const double X = amplitude_of_contact(s, *scene);
        const std::size_t j = scene->system.contact.index;
        CHECK(std::abs(by_paper.masses[j].amplitude - X) < 1e-7);
        CHECK(std::abs(by_paper.masses[j].amplitude - by_events.masses[j].amplitude) < 1e-7);
        CHECK(stops_that_last(by_paper) == stops_that_last(by_events));
        largest = std::max(largest, std::abs(by_paper.masses[j].amplitude - X));
        ++compared;
    }
    std::printf("overdamped, stick-slip by solve against the paper's algorithm: %d scenes, %.1e\n", compared, largest);
    CHECK(compared >= 12);
}

TEST_CASE("what bounds the derivatives of the braces from an instant on holds for overdamped modes", "[eq:40][overdamped]") {
    double nearest = 0;
    int broken_by_half = 0;
    for (const std::vector<double>& zeta : damping) {
        const ModeSums<double> s = sums_of(chain({1, 0.75}, {1, 1.5}, zeta, 2, 1, 1, 0.75));
        FrictionMotions y(s);
        for (std::size_t i = 0; i < 2; ++i) {
            if (s.zeta[i] < 1) continue;
            for (int start = 0; start < 32; ++start) {
                const double size = y.at(pi<double>() * start / 32, true).size[i];
                double largest = 0;
                for (int n = start; n <= 256; n += n < 64 ? 1 : 8) {
                    const evaluation::FrictionMotion<double> f = y.at(pi<double>() * std::max(n / 256.0, start / 32.0)).y[i];
                    const double y_1 = s.R[i] * f.prime, y_2 = s.R[i] * s.R[i] * f.double_prime;
                    const double y_3 = -2 * s.zeta[i] * y_2 - y_1, y_4 = -2 * s.zeta[i] * y_3 - y_2;
                    largest = std::max({largest, std::abs(y_2), std::abs(y_3), std::abs(y_4)});
                }
                INFO("zeta = " << s.zeta[i] << ", from " << start << " / 32 of the half-period");
                CHECK(largest <= size * (1 + 1e-12));
                nearest = std::max(nearest, largest / size);
                broken_by_half += largest > size / 2 ? 1 : 0;
            }
        }
    }
    CHECK(nearest > 0.9);
    CHECK(broken_by_half > 50); // half the bound would not hold
}

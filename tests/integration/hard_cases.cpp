// Scenes that are hard on the time-domain solvers, by name. The witness of an orbit is the paper's algorithm: started on it with
// a tolerance of 1e-12 it must come back after a period. The witness of a sliding motion is the closed form.
#include <cmath>
#include <functional>

#include "denhartog/denhartog.hpp"
#include "denhartog/orbit/periodic_orbit.hpp"
#include "denhartog/paper_algorithm/paper_algorithm.hpp"
#include "denhartog/solve/solve.hpp"
#include "tests/catch.hpp"
#include "tests/support/paper_systems.hpp"
#include "tests/support/plain_response.hpp"
#include "tests/support/sample_scenes.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

PeriodicOrbit orbit_of(const Scene<double>& scene, int most_periods = 2000) {
    const ContactSystem system = contact_system(scene.system);
    ExactSolver solver(system, {*scene.r, *scene.beta, scene.mu});
    OrbitSearch search;
    search.most_periods = most_periods;
    return periodic_orbit(solver, at_rest(system.basis.r_n.size()), search);
}

std::string text(const Scene<double>& scene, const PeriodicOrbit& orbit) {
    return "N = " + std::to_string(number_of_masses(scene.system)) + ", r = " + hexadecimal(*scene.r) +
           ", beta = " + hexadecimal(*scene.beta) + ", mu = " + hexadecimal(scene.mu) + "; " + in_words(orbit.reason);
}

void check_finite(const PeriodicOrbit& orbit) {
    for (const MassMotion& mass : orbit.masses) {
        CHECK(std::isfinite(mass.amplitude));
        CHECK(mass.amplitude >= 0);
        CHECK(std::abs(mass.phase) <= 3.1415926535897936);
    }
    CHECK(std::isfinite(orbit.error_bound));
}

/// The orbit from rest; the paper's algorithm stays on it.
PeriodicOrbit witnessed_orbit(const Scene<double>& scene) {
    const PeriodicOrbit orbit = orbit_of(scene);
    INFO(text(scene, orbit));
    REQUIRE(orbit.status == OrbitStatus::periodic);
    check_finite(orbit);
    PaperSettings settings;
    settings.absolute_tolerance = 1e-12;
    settings.cycles = orbit.periods;
    settings.start = orbit.start;
    const PaperMotion paper = paper_algorithm(scene, settings);
    REQUIRE(paper.status == IntegrationStatus::complete);
    double size = 0, difference = 0;
    for (std::size_t k = 0; k < orbit.masses.size(); ++k) {
        size = std::max(size, orbit.masses[k].amplitude);
        difference = std::max(difference, std::abs(paper.end.x[k] - orbit.start.x[k]));
        if (orbit.periods == 1)
            CHECK(std::abs(paper.masses[k].amplitude - orbit.masses[k].amplitude) <= 1e-10 * (1 + orbit.masses[k].amplitude));
    }
    CHECK(difference <= 1e-10 * (1 + size));
    CHECK(orbit.error_bound <= 1e-8 * (1 + size));
    if (orbit.periods == 1) CHECK(paper.stops.size() == orbit.stops.size());
    return orbit;
}

/// The orbit from rest is the closed form.
void check_closed_form(const Scene<double>& scene) {
    const Response<double> closed = response(scene);
    const PeriodicOrbit orbit = orbit_of(scene);
    INFO(text(scene, orbit));
    REQUIRE(closed.steady_state);
    REQUIRE(orbit.status == OrbitStatus::periodic);
    CHECK(orbit.stops.empty());
    for (std::size_t k = 0; k < orbit.masses.size(); ++k) {
        const double X = closed.steady_state->masses[k].amplitude;
        CHECK(std::abs(orbit.masses[k].amplitude - X) <= 1e-11 * X + orbit.error_bound);
        CHECK(orbit.error_bound <= 1e-9 * (1 + X));
    }
}

/// Two neighbouring numbers between which an integer function changes.
std::pair<double, double> bisect(double low, double high, const std::function<int(double)>& f) {
    const int at_low = f(low);
    REQUIRE(at_low != f(high));
    for (;;) {
        const double middle = low + (high - low) / 2;
        if (middle == low || middle == high) return {low, high};
        (f(middle) == at_low ? low : high) = middle;
    }
}

int stops_of(const Scene<double>& scene) {
    const PeriodicOrbit orbit = orbit_of(scene);
    return orbit.status == OrbitStatus::periodic ? static_cast<int>(orbit.stops.size()) : -1;
}

} // namespace

TEST_CASE("without damping friction alone brings a steady stick-slip motion", "[hard][exact-solver][paper-algorithm]") {
    for (const double r : {0.5, 0.25})
        for (const double beta : {0.5, 0.7, 0.9}) CHECK(witnessed_orbit(scene_of(single_mass(0.0), r, beta)).stops.size() == 2);
    CHECK(witnessed_orbit(scene_of(single_mass(0.0), 1, 0.9)).stops.size() == 2); // at resonance, friction above pi/4
    CHECK(witnessed_orbit(scene_of(equal_chain<double>(3, 2, 1, {0, 0, 0}), 0.3, 0.3)).stops.size() == 2);
}

TEST_CASE("with zeta = 0.001 the steady state is found though transients last hundreds of cycles", "[hard][exact-solver]") {
    check_closed_form(scene_of(single_mass(0.001), 1, 0.2));
    check_closed_form(scene_of(two_masses(0.001), 1.61, 0.2));
    check_closed_form(scene_of(five_masses<double>(3, 0.001), 0.9, 0.2));
    CHECK(witnessed_orbit(scene_of(single_mass(0.001), 0.3, 0.6)).stops.size() == 2);
    CHECK_FALSE(witnessed_orbit(scene_of(five_masses<double>(1, 0.001), 0.4, 0.5)).stops.empty());
}

TEST_CASE("just below the boundary (69) the contact slides as the closed form has it, just above it stops",
          "[hard][eq:69][exact-solver]") {
    int points = 0;
    for (const NamedSystem<double>& named : paper_systems(0.01))
        for (const double r : {0.25, 0.5, 0.9, 1.3}) {
            Scene<double> scene = scene_of(named.system, r, 0);
            const double limit = response(scene).boundary.exact;
            scene.beta = limit * (1 - 1e-9);
            check_closed_form(scene);
            const double below = orbit_of(scene).contact.amplitude;
            scene.beta = limit * (1 + 1e-9);
            const PeriodicOrbit above = witnessed_orbit(scene);
            CHECK_FALSE(above.stops.empty());
            CHECK(above.contact.amplitude == Approx(below).epsilon(1e-6));
            ++points;
        }
    CHECK(points == 16);
}

TEST_CASE("just above the boundary of permanent sticking the contact rests, just below nothing but a creep is left",
          "[hard][regime][exact-solver]") {
    for (const NamedSystem<double>& named : paper_systems(0.01))
        for (const double r : {0.25, 0.5, 0.9, 1.3}) {
            Scene<double> scene = scene_of(named.system, r, 0);
            const double limit = *response(scene).boundary.sticking;
            for (const double side : {-1e-9, 1e-9}) {
                scene.beta = limit * (1 + side);
                const PeriodicOrbit orbit = orbit_of(scene, 300);
                INFO(named.name << ": " << text(scene, orbit));
                if (side > 0) CHECK(orbit.status == OrbitStatus::permanently_stuck);
                if (side < 0) CHECK(orbit.status != OrbitStatus::permanently_stuck);
                if (orbit.status == OrbitStatus::periodic) CHECK(orbit.contact.amplitude <= 1e-9);
                if (orbit.status == OrbitStatus::not_converged) CHECK_FALSE(orbit.reason.empty());
                const Regime wanted = side > 0 ? Regime::permanent_sticking : Regime::stick_slip;
                const Solution regime = solve(scene_source(scene), {Asked::regime, std::nullopt, false});
                CHECK(regime.regime.regime == wanted);
            }
            scene.beta = limit * (1 + 1e-9); // `solve` knows the boundary
            CHECK(solve(scene_source(scene), {Asked::amplitude, 6, false}).regime.regime == Regime::permanent_sticking);
        }
}

TEST_CASE("a contact that slips by less and less for ever is said to rest, and how well it is known where",
          "[hard][exact-solver]") {
    Scene<double> scene = random_scenes<double>(12420666948315711836U)[108].scene;
    scene.mu = 1;
    scene.beta = 0x1.c498ap-3;
    const ContactSystem system = contact_system(scene.system);
    const std::size_t N = system.basis.r_n.size(), j = system.contact.index;
    ExactSolver solver(system, {*scene.r, *scene.beta, 1});
    const PeriodicOrbit orbit = orbit_of(scene);
    INFO(text(scene, orbit));
    REQUIRE(orbit.status == OrbitStatus::permanently_stuck);
    check_finite(orbit);
    State z = at_rest(N);
    const auto follow = [&](int periods) {
        for (int n = 0; n < periods; ++n) z = solver.run(z, 0, 2 * pi<double>()).end;
        return z.x[j];
    };
    const double early = follow(500), late = follow(20000);
    std::printf("rests at %.9g within %.1e; after 500 periods at %.9g, after 20500 at %.9g\n", orbit.start.x[j],
                orbit.error_bound, early, late);
    CHECK(early != late);
    CHECK(std::abs(late - orbit.start.x[j]) <= orbit.error_bound);
    CHECK(orbit.error_bound <= 1e-2 * std::abs(late));
}

TEST_CASE("far below resonance the contact stops many times a period", "[hard][exact-solver][paper-algorithm]") {
    CHECK(witnessed_orbit(scene_of(single_mass(0.01), 0.02, 0.2)).stops.size() >= 6);
    CHECK(witnessed_orbit(scene_of(single_mass(0.001), 0.02, 0.05)).stops.size() >= 6);
    CHECK(witnessed_orbit(scene_of(two_masses(0.01), 0.02, 0.2)).stops.size() >= 6);
    CHECK(witnessed_orbit(scene_of(five_masses<double>(3, 0.01), 0.02, 0.2)).stops.size() >= 4);
}

TEST_CASE("static friction three times the kinetic one", "[hard][eq:3][exact-solver][paper-algorithm]") {
    CHECK_FALSE(witnessed_orbit(scene_of(single_mass(0.05), 0.3, 0.2, 3)).stops.empty());
    CHECK_FALSE(witnessed_orbit(scene_of(two_masses(0.05), 0.3, 0.1, 3)).stops.empty());
    CHECK_FALSE(witnessed_orbit(scene_of(five_masses<double>(3, 0.1), 0.5, 0.1, 3)).stops.empty());
}

TEST_CASE("load on the contact and not, in stick-slip", "[hard][exact-solver][paper-algorithm]") {
    for (const std::size_t j : {1, 2, 3})
        for (const std::size_t l : {1, 2, 3}) {
            Scene<double> scene = scene_of(equal_chain<double>(3, j, l, {0.02, 0.05, 0.03}), 0.3, 0);
            const Boundary<double> limits = response(scene).boundary;
            REQUIRE(limits.sticking);
            scene.beta = limits.exact + (*limits.sticking - limits.exact) / 2;
            CHECK_FALSE(witnessed_orbit(scene).stops.empty());
        }
}

TEST_CASE("where the velocity of the contact touches zero within the half-period, shooting finds the boundary (69)",
          "[hard][grazing][eq:54][eq:69][exact-solver]") {
    Scene<double> scene = scene_of(two_masses(0.01), 0.25, 0);
    const Boundary<double> limits = response(scene).boundary;
    REQUIRE(limits.binding == BindingCondition::velocity);
    REQUIRE(limits.instant > 0.1);
    const auto [slides, stops] = bisect(limits.exact * 0.999, limits.exact * 1.001, [&](double beta) {
        scene.beta = beta;
        return stops_of(scene);
    });
    std::printf("grazing at beta = %.17g, by (69) %.17g\n", slides, limits.exact);
    CHECK(std::abs(slides - limits.exact) <= 1e-12 * limits.exact);
    scene.beta = slides;
    const PeriodicOrbit below = orbit_of(scene);
    scene.beta = stops;
    const PeriodicOrbit above = orbit_of(scene);
    CHECK(below.stops.empty());
    CHECK(above.stops.size() == 2);
    CHECK(std::abs(above.contact.amplitude - below.contact.amplitude) <= 1e-6);
    for (const Stop& stop : above.stops) CHECK(stop.end - stop.start <= 1e-4);
}

TEST_CASE("where a stop appears or goes as friction rises, the motion on both sides is found and is the same",
          "[hard][grazing][exact-solver]") {
    struct Change {
        double r, from, to;
    };
    for (const auto& [r, from, to] : {Change{0.2, 0.30, 0.32}, Change{0.2, 0.42, 0.44}, Change{0.07, 0.50, 0.52}}) {
        Scene<double> scene = scene_of(single_mass(0.01), r, 0);
        const auto stops = [&](double beta) {
            scene.beta = beta;
            return stops_of(scene);
        };
        const int at_start = stops(from);
        const auto [a, b] = bisect(from, to, [&](double beta) { return stops(beta) == at_start ? 1 : 0; });
        scene.beta = a;
        const PeriodicOrbit before = orbit_of(scene);
        scene.beta = b;
        const PeriodicOrbit after = orbit_of(scene);
        std::printf("r = %g: %zu stops at beta = %.17g, %zu at the next number\n", r, before.stops.size(), a, after.stops.size());
        INFO(text(scene, after));
        REQUIRE(before.status == OrbitStatus::periodic);
        REQUIRE(after.status == OrbitStatus::periodic);
        CHECK(before.contact.amplitude == Approx(after.contact.amplitude).epsilon(1e-7));
    }
}

TEST_CASE("fifty masses, sliding and in stick-slip", "[hard][exact-solver][paper-algorithm]") {
    const std::vector<double> zeta(50, 0.03125);
    check_closed_form(scene_of(equal_chain<double>(50, 25, 1, zeta), 0.5, 0.001));
    CHECK_FALSE(witnessed_orbit(scene_of(equal_chain<double>(50, 1, 1, zeta), 0.1, 0.5)).stops.empty());
}

TEST_CASE("a motion that does not settle in the time allowed has a status and a reason, and leaves the orbit that was found",
          "[hard][non-convergence]") {
    const System<double> chain = equal_chain<double>(4, 4, 3, {0.01, 0.005, 0.01, 0.1});
    const PeriodicOrbit orbit = orbit_of(scene_of(chain, 0.671875, 0.57, 3), 40);
    INFO(in_words(orbit.reason));
    CHECK(orbit.status == OrbitStatus::not_from_start);
    CHECK_THAT(in_words(orbit.reason), Catch::Contains("no periodic motion within"));
    CHECK_THAT(in_words(orbit.reason), Catch::Contains("not certainly stable"));
    CHECK_FALSE(orbit.stable);
    CHECK(orbit.masses.size() == 4);
    CHECK(orbit.error_bound < 1e-9 * orbit.contact.amplitude);
}

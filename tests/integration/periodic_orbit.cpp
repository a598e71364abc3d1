// The steady motion by shooting: against the closed form, against long propagation, and by what it must obey.
#include "denhartog/orbit/periodic_orbit.hpp"

#include <cmath>

#include "tests/integration/orbit_scenes.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

double angle_between(double a, double b) { return std::abs(std::remainder(a - b, 2 * pi<double>())); }

} // namespace

TEST_CASE("an oscillator driven at a tenth of its frequency stops four times a period, whatever the start",
          "[eq:2][eq:74][exact-solver][shooting]") {
    const PreparedMotion p = prepared_oscillator(0.01, 0.1, 0.2);
    const PeriodicOrbit orbit = orbit_of(p);
    REQUIRE(orbit.status == OrbitStatus::periodic);
    CHECK(orbit.symmetric);
    CHECK(orbit.periods == 1);
    CHECK(orbit.stable);
    CHECK(orbit.newton_steps <= 5);
    CHECK(orbit.periods_propagated <= 5);
    REQUIRE(orbit.stops.size() == 4);
    for (std::size_t n = 0; n < 4; ++n) {
        // It breaks away where the load reaches the friction; it came to rest where the load was below.
        const Stop& s = orbit.stops[n];
        INFO(n << " " << hexadecimal(s.start) << " " << hexadecimal(s.end));
        CHECK(std::abs(std::abs(std::cos(s.end) - s.x) - 0.2) < 1e-14);
        CHECK(std::abs(std::cos(s.start) - s.x) < 0.2);
        const Stop& mirrored = orbit.stops[(n + 2) % 4];
        CHECK(std::abs(s.x + mirrored.x) < 1e-14);
        CHECK(angle_between(s.start + pi<double>(), mirrored.start) < 1e-13);
    }
    CHECK(orbit.contact.amplitude == std::abs(orbit.stops[0].x));
    for (const double x : {-3.0, 0.5, 40.0}) {
        const PeriodicOrbit other = orbit_from(p, {{x}, {-x}});
        REQUIRE(other.status == OrbitStatus::periodic);
        CHECK(distance(other.start, orbit.start) < 1e-13);
    }
}

TEST_CASE("a stop across the maximum of the force is one stop", "[exact-solver][shooting]") {
    // Slow forcing with little inertia of its own: the contact rests about the extrema of the force.
    const PeriodicOrbit orbit = orbit_of(prepared_oscillator(0.75, 0.0625, 0.25));
    REQUIRE(orbit.status == OrbitStatus::periodic);
    REQUIRE(orbit.stops.size() == 2);
    for (const Stop& s : orbit.stops) {
        CHECK(s.start >= 0);
        CHECK(s.start < 2 * pi<double>());
        CHECK(s.end > s.start);
    }
    CHECK(std::abs(orbit.stops[1].end - orbit.stops[0].end - pi<double>()) < 1e-13);
    CHECK(std::abs(orbit.stops[1].x + orbit.stops[0].x) < 1e-15);
}

TEST_CASE("where the stuck modes are coupled by damping, shooting ends where long propagation does",
          "[eq:74][exact-solver][shooting]") {
    const PreparedMotion p = prepared_three_masses(0.6875, 0.25);
    REQUIRE_FALSE(p.system.stuck.modes_diagonalise_damping);
    const PeriodicOrbit orbit = orbit_of(p);
    REQUIRE(orbit.status == OrbitStatus::periodic);
    CHECK(orbit.stops.size() >= 2);
    CHECK(orbit.stable);
    CHECK(distance(propagated(p, at_rest(3), 1200), orbit.start) < 1e-12);
}

TEST_CASE("a contact that comes to rest for ever stays within the interval of rest", "[eq:74][eq:88][exact-solver][shooting]") {
    const double r = 0.75, beta = 4;
    const PreparedMotion p = prepared_three_masses(r, beta);
    const StuckResponse stuck = stuck_response(p.system.stuck, Mass{0}, r);
    const double reach = paper::sticking_margin(modulus(stuck.contact_load), 1.0, beta) / p.system.stuck.k_contact;
    const PeriodicOrbit from_rest = orbit_of(p);
    REQUIRE(from_rest.status == OrbitStatus::permanently_stuck);
    CHECK(from_rest.contact.amplitude == 0);
    CHECK(from_rest.stable);
    CHECK(from_rest.multipliers.size() == 4);
    for (const std::size_t k : {0, 2}) {
        CHECK(std::abs(from_rest.masses[k].amplitude - stuck.masses[k].amplitude) < 1e-14);
        CHECK(angle_between(from_rest.masses[k].phase, stuck.masses[k].phase.value_or(0)) < 1e-13);
    }
    for (const double x : {-30.0, 12.0, 50.0}) {
        const State start{{0, x, 0}, {0, 0, 0}};
        const PeriodicOrbit orbit = orbit_from(p, start);
        INFO(x << " " << in_words(orbit.reason));
        REQUIRE(orbit.status == OrbitStatus::permanently_stuck);
        REQUIRE(orbit.stops.size() == 1);
        CHECK(std::abs(orbit.stops[0].x) <= reach);
        const State later = propagated(p, start, 1200);
        CHECK(distance(later, orbit.start) < 1e-11);
    }
}

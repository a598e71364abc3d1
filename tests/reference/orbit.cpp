/// @file
/// @brief Proved motions with stops: their numbers are those of the exact solver and of the physical coordinates in 50 digits,
/// and no wrong guess is proved.
#include "denhartog/reference/orbit.hpp"

#include <cmath>
#include <limits>

#include "denhartog/denhartog.hpp"
#include "orbit_cases.hpp"
#include "tests/benchmark/generator/motion.hpp"
#include "tests/catch.hpp"
#include "tests/reference/truth.hpp"
#include "tests/support/plain_response.hpp"
#include "tests/support/sample_scenes.hpp"

namespace denhartog::tests {
namespace {

using reference::Disproved;
using reference::OrbitInBalls;
using reference::proved_orbit;
using reference::Unproved;

constexpr slong bits = 160;

// A number of double within its error of the proved one, which is narrow.
void check_same(const Ball& proved, double x, double error) {
    const Ball apart = abs(proved - Ball(x));
    CAPTURE(static_cast<double>(proved), x, error, proved.radius());
    CHECK(apart.low() <= error);
    CHECK(proved.radius() <= 1e-30);
}

void check_same_angle(const Ball& proved, double x, double error, int half_turns) {
    const Ball period = Ball(half_turns) * PiOf<Ball>::value(), apart = proved - Ball(x);
    const Ball turned = apart - Ball(std::round(static_cast<double>(apart) / static_cast<double>(period))) * period;
    CAPTURE(static_cast<double>(proved), x);
    CHECK(abs(turned).low() <= error);
    CHECK(proved.radius() <= 1e-18);
}

// A motion against the exact solver in double.
void check_in_double(const Scene<double>& scene) {
    const OrbitGuess guess = guess_for(scene);
    REQUIRE(!guess.directions.empty());
    const OrbitInBalls proved = proved_orbit(in_bits(scene), guess, bits);
    FollowedMotion motion(scene);
    PeriodicOrbit& orbit = motion.orbit;
    REQUIRE(orbit.status == OrbitStatus::periodic);
    CHECK(proved.mirrored == orbit.symmetric);
    CHECK(proved.periods == orbit.periods);
    const Bits many(256);
    const std::size_t N = number_of_masses(scene.system);
    for (std::size_t k = 0; k < N; ++k) {
        INFO("mass " << k + 1);
        check_same(proved.masses[k].size, orbit.masses[k].amplitude, orbit.error_bound);
        REQUIRE(proved.masses[k].phase);
        check_same_angle(*proved.masses[k].phase, orbit.masses[k].phase, 1e-7 + orbit.masses[k].spread, 2);
    }
    check_same(proved.masses[N].size, orbit.contact.amplitude, orbit.error_bound);
    for (std::size_t k = 0; k < N; ++k) check_same(proved.x[k], orbit.start.x[k], 4 * orbit.error_bound);
    REQUIRE(proved.stops.size() == orbit.stops.size());
    for (std::size_t n = 0; n < proved.stops.size(); ++n) {
        check_same(proved.stops[n].x, orbit.stops[n].x, orbit.error_bound);
        check_same_angle(proved.stops[n].start, orbit.stops[n].start, 1e-9, 2 * proved.periods);
        check_same_angle(proved.stops[n].end, orbit.stops[n].end, 1e-9, 2 * proved.periods);
    }
    CHECK(proved.stable == orbit.stable);
    REQUIRE(proved.multipliers.size() == orbit.multipliers.size());
    for (std::size_t n = 0; n < orbit.multipliers.size(); ++n) {
        const Ball apart = abs(proved.multipliers[n] - Ball(size_of(orbit.multipliers[n].value)));
        CHECK(apart.low() <= orbit.multipliers[n].error);
        CHECK(proved.multipliers[n].radius() < 1e-9);
    }
}

// The same, and against the boundary-value problem on the physical coordinates in 50 digits, which knows of no modes.
void check_orbit(const Scene<double>& scene) {
    check_in_double(scene);
    const benchmark::Motion motion = benchmark::library_motion(scene);
    CHECK(benchmark::agreement(motion, benchmark::physical_motion(scene, motion)) >= 30);
}

TEST_CASE("a proved motion with stops has the numbers of the exact solver", "[reference][orbit]") {
    const System<double> light = chain_of({1}, {1}, 0.01), one = chain_of({1}, {1}, 0.03125);
    for (const Scene<double>& scene : {scene_of(light, 0.75, 0.75), scene_of(light, 0.125, 0.25), scene_of(one, 0.25, 0.25, 1.5),
                                       scene_of(one, 0.125, 0.1875, 1.5), // which does not mirror itself
                                       scene_of(two_masses(), 0.3125, 0.25), scene_of(two_masses(), 0.375, 0.3125, 1.25),
                                       scene_of(chain_of({1, 2, 0.5, 1.5}, {1, 0.75, 2, 1}, 0.03125, 3, 1), 0.4375, 0.3125),
                                       scene_of(coupled_masses(), 0.375, 0.25)}) {
        INFO(number_of_masses(scene.system) << " masses, r = " << *scene.r << ", beta = " << *scene.beta);
        check_orbit(scene);
    }
    check_in_double(scene_of(rubbing_masses(), 0.4375, 0.25)); // between two masses
}

TEST_CASE("a proved motion without stops is the closed form to 45 digits",
          "[eq:38][eq:39][eq:41][eq:44][eq:45][eq:47][reference][orbit]") {
    const Bits many(256);
    int compared = 0;
    for (const std::uint64_t seed : {13, 14}) {
        const std::vector<RandomScene<double>> scenes = random_scenes<double>(seed);
        for (std::size_t n = 0; n < scenes.size(); n += 17) {
            Scene<double> scene = scenes[n].scene;
            scene.mu = 1; // the steady velocities are unique
            scene.beta = friction_ratio_at(scenes[n].fraction_of_limit, response(scene).boundary.exact);
            INFO(scenes[n].name);
            const OrbitGuess guess = guess_for(scene);
            if (guess.directions.empty()) continue; // a mode that nothing damps
            const OrbitInBalls proved = proved_orbit(in_bits(scene), guess, 256, {}, false);
            CHECK(proved.stops.empty());
            const Truth closed(scene_source(scene));
            REQUIRE(closed.slides);
            for (std::size_t k = 0; k < closed.masses.size(); ++k) {
                const Ball& X = closed.masses[k].amplitude;
                CHECK(apart(proved.masses[k].size, X) == 0);
                CHECK(apart(proved.masses[k].phase.value(), closed.masses[k].phase, 2 * pi<Ball>()) == 0);
                CHECK(proved.masses[k].size.radius() < 1e-45 * X.high());
                CHECK(proved.masses[k].phase->radius() < 1e-45);
            }
            ++compared;
        }
    }
    CHECK(compared >= 40);
}

TEST_CASE("a motion without damping is proved", "[reference][orbit]") {
    const Scene<double> scene = scene_of(chain_of({1}, {1}, 0.0), 0.25, 0.5);
    const OrbitInBalls proved = proved_orbit(in_bits(scene), guess_for(scene), bits);
    CHECK(proved.stops.size() == 2);
    CHECK(proved.stable);
}

TEST_CASE("a motion to which no start leads is proved, and that it is unstable", "[reference][orbit]") {
    // Where the contact mirrors itself with more friction, the motion that does so is still there with less, beside another.
    const System<double> one = chain_of({1}, {1}, 0.0);
    const OrbitGuess guess = guess_for(scene_of(one, 0.4375, 0.3125, 1.5));
    REQUIRE(guess.mirrored);
    const OrbitInBalls proved = proved_orbit(in_bits(scene_of(one, 0.4375, 0.25, 1.5)), guess, bits);
    CHECK(proved.unstable);
    CHECK(!proved.stable);
    CHECK(proved.multipliers.front() > Ball(1));
}

TEST_CASE("a motion that only just stops is proved, whatever double precision sees of the stop", "[reference][orbit]") {
    const System<double> one = chain_of({1}, {1}, 0.125);
    const double limit = boundary(scene_of(one, 0.75, 0)).exact.value;
    for (const double above : {1e-6, 1e-10, 1e-13, 0x1p-53}) {
        const Scene<double> scene = scene_of(one, 0.75, limit * (1 + 2 * above));
        const OrbitGuess guess = guess_for(scene);
        REQUIRE(!guess.directions.empty());
        std::vector<OrbitGuess> all{guess};
        for (const OrbitGuess& other : with_other_stops(guess)) all.push_back(other);
        int found = 0;
        for (const OrbitGuess& each : all) try {
                (void)proved_orbit(in_bits(scene), each, bits);
                ++found;
            } catch (const Unproved&) {
            }
        CHECK(found == 1);
    }
}

TEST_CASE("a wrong guess is refused", "[reference][orbit]") {
    const Scene<double> scene = scene_of(two_masses(), 0.3125, 0.25);
    const OrbitGuess guess = guess_for(scene);
    REQUIRE(guess.directions.size() > 1);
    REQUIRE_NOTHROW(proved_orbit(in_bits(scene), guess, 128));
    SECTION("where the contact slides the other way") {
        OrbitGuess wrong = guess;
        for (int& direction : wrong.directions) direction = -direction;
        CHECK_THROWS_AS(proved_orbit(in_bits(scene), wrong, 128), Unproved);
    }
    SECTION("where a stop is missing") {
        bool tried = false;
        for (const OrbitGuess& other : with_other_stops(guess)) {
            if (other.directions.size() >= guess.directions.size()) continue;
            tried = true;
            CHECK_THROWS_AS(proved_orbit(in_bits(scene), other, 128), Unproved);
        }
        CHECK(tried);
    }
    SECTION("where there is a stop too much") {
        for (std::size_t n = 1; n < guess.directions.size(); ++n) {
            if (guess.directions[n] == 0) continue;
            OrbitGuess wrong = guess;
            const double from = guess.events[n - 1],
                         to = n < guess.events.size() ? guess.events[n] : guess.events[0] + pi<double>();
            wrong.slow = {from + (to - from) / 2};
            bool tried = false;
            for (const OrbitGuess& other : with_other_stops(wrong)) {
                if (other.directions.size() != guess.directions.size() + 2) continue;
                tried = true;
                CHECK_THROWS_AS(proved_orbit(in_bits(scene), other, 128), Unproved);
            }
            CHECK(tried);
        }
    }
    SECTION("where it is said to mirror itself and does not") {
        const Scene<double> lopsided = scene_of(chain_of({1}, {1}, 0.03125), 0.125, 0.1875, 1.5);
        OrbitGuess wrong = guess_for(lopsided);
        REQUIRE(!wrong.mirrored);
        REQUIRE_NOTHROW(proved_orbit(in_bits(lopsided), wrong, 128));
        wrong.mirrored = true;
        CHECK_THROWS_AS(proved_orbit(in_bits(lopsided), wrong, 128), Disproved); // it ends as it began
        std::size_t n = 1;
        while (wrong.directions[n] != -wrong.directions[0]) ++n;
        wrong.directions.resize(n + 1);
        wrong.events.resize(n);
        CHECK_THROWS_AS(proved_orbit(in_bits(lopsided), wrong, 128), Unproved);
    }
    SECTION("where it mirrors itself and half of it is taken for the whole") {
        OrbitGuess wrong = guess;
        REQUIRE(wrong.mirrored);
        wrong.mirrored = false;
        CHECK_THROWS_AS(proved_orbit(in_bits(scene), wrong, 128), Unproved);
    }
    SECTION("where the events are shifted") {
        OrbitGuess wrong = guess;
        for (double& event : wrong.events) event += 1.25;
        try { // Newton's method may find the way back, but to no other motion
            const OrbitInBalls found = proved_orbit(in_bits(scene), wrong, 128), right = proved_orbit(in_bits(scene), guess, 128);
            CHECK((found.masses[0].size - right.masses[0].size).may_vanish());
        } catch (const Unproved&) {
            SUCCEED();
        }
    }
    SECTION("where friction is another") {
        const Scene<double> stuck = scene_of(two_masses(), 0.3125, 4), sliding = scene_of(two_masses(), 0.3125, 0.015625);
        CHECK_THROWS_AS(proved_orbit(in_bits(stuck), guess, 128), Unproved);
        CHECK_THROWS_AS(proved_orbit(in_bits(sliding), guess, 128), Unproved);
    }
}

TEST_CASE("an order of phases that no contact has is disproved", "[reference][orbit]") {
    const Scene<double> scene = scene_of(two_masses(), 0.3125, 0.25);
    const OrbitGuess guess = guess_for(scene);
    for (int n = 0; n < 4; ++n) {
        OrbitGuess wrong = guess;
        if (n == 0) wrong.directions.front() += 1;
        if (n == 1) wrong.directions.back() = wrong.directions[wrong.directions.size() - 2];
        if (n == 2) wrong.events.pop_back();
        if (n == 3) wrong.x.push_back(0);
        CHECK_THROWS_AS(proved_orbit(in_bits(scene), wrong, 128), Disproved);
    }
}

TEST_CASE("a mass that no force reaches has no phase", "[reference][orbit]") {
    System<double> s = chain_of({1, 1}, {1, 1}, 0.0);
    s.stiffness_ratios.clear();
    s.damping_ratios.clear();
    s.stiffness_matrix = Matrix<double>::Identity(2, 2);
    s.damping_matrix = Matrix<double>::Identity(2, 2) / 16;
    s.stiffness_matrix(1, 1) = 3;
    const Scene<double> scene = scene_of(s, 0.5, 0.5);
    OrbitGuess guess = guess_for(scene_of(chain_of({1}, {1}, 0.03125), 0.5, 0.5));
    guess.x.push_back(0);
    guess.x_prime.push_back(0);
    const OrbitInBalls proved = proved_orbit(in_bits(scene), guess, 128);
    CHECK(proved.masses[1].size.is_zero());
    CHECK(!proved.masses[1].phase);
    CHECK(proved.masses[0].phase);
}

TEST_CASE("where a mass is as far out at several instants its phase may be that of any", "[reference][orbit]") {
    const Scene<double> scene = scene_of(chain_of({1, 1}, {1, 1}, {0, 0}, 2, 2), 0.1, 0.9);
    const OrbitInBalls proved = proved_orbit(in_bits(scene), guess_for(scene), bits);
    CHECK(proved.masses[0].size.radius() < 1e-15);
    REQUIRE(proved.masses[0].phase);
    CHECK(proved.masses[0].phase->radius() > 1); // mass 1 swings freely while the contact rests, and twice comes as far
    REQUIRE(proved.masses[1].phase);
    CHECK(proved.masses[1].phase->radius() < 1e-15);
}

TEST_CASE("only the masses asked for are given", "[reference][orbit]") {
    const Scene<double> scene = scene_of(two_masses(), 0.3125, 0.25);
    const OrbitInBalls proved = proved_orbit(in_bits(scene), guess_for(scene), 128, {0}, false);
    CHECK(proved.masses[0].phase);
    CHECK(!proved.masses[1].phase);
    CHECK(proved.masses[2].phase);
    CHECK(proved.multipliers.empty());
}

TEST_CASE("a proof ends with the budget of its question", "[reference][orbit]") {
    const Scene<double> scene = scene_of(two_masses(), 0.3125, 0.25);
    const OrbitGuess guess = guess_for(scene);
    QuestionEffort question(2, 1000);
    const auto paid = [&] {
        reference::SceneInBalls s = in_bits(scene)();
        s.effort = &question;
        return s;
    };
    CHECK_THROWS_AS(proved_orbit(paid, guess, 128), PrecisionError);
}

} // namespace
} // namespace denhartog::tests

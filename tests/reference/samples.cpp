/// @file
/// @brief Samples of a proved motion: those of double, within the amplitudes that are proved, in every regime.
#include <algorithm>
#include <cmath>
#include <string>

#include "denhartog/answer/reference.hpp"
#include "denhartog/c/denhartog.h"
#include "denhartog/evaluation/even_samples.hpp"
#include "denhartog/reference/sliding.hpp"
#include "denhartog/solve/sampled_solution.hpp"
#include "orbit_cases.hpp"
#include "proofs.hpp"
#include "tests/catch.hpp"
#include "tests/support/split_mix.hpp"
#include "tests/unit/program_runs.hpp"

namespace denhartog::tests {
namespace {

constexpr std::size_t instants = 256;

Solution answer(const SceneSource& source, bool proved) {
    Question question;
    question.proved = proved;
    return solve(source, question);
}

System<double> five_masses() { return chain_of({1, 2, 0.5, 1.5, 0.75}, {1, 0.75, 2, 1, 1.5}, 0.03125, 3, 1); }

// Where two motions differ most: displacements beside the amplitude of the mass, velocities beside the fastest.
double apart(const SampledSolution& a, const SampledSolution& b, const Solution& of) {
    double most = a.tau.size() == b.tau.size() ? 0 : 1;
    for (std::size_t k = 0; k < of.masses.size() && most == 0; ++k) {
        const double size = of.masses[k].amplitude.value;
        double fastest = size;
        for (const State& state : a.states()) fastest = std::max(fastest, std::abs(state.x_prime[k]));
        for (std::size_t n = 0; n < a.tau.size(); ++n) {
            const double x = std::abs(a.at(n).x[k] - b.at(n).x[k]), v = std::abs(a.at(n).x_prime[k] - b.at(n).x_prime[k]);
            most = std::max({most, x == 0 ? 0 : x / size, v == 0 ? 0 : v / fastest});
        }
    }
    return most;
}

// The samples of a proved answer, after they were held against its amplitudes and its start.
SampledSolution checked_samples(const SceneSource& source, const Solution& s) {
    REQUIRE(s.method.proved);
    SampledSolution motion = sampled_solution(source, s, instants);
    REQUIRE(motion.tau.size() == instants);
    for (std::size_t k = 0; k < s.masses.size(); ++k) {
        INFO("mass " << k + 1);
        const Certified& amplitude = s.masses[k].amplitude;
        double largest = 0;
        for (const State& state : motion.states()) largest = std::max(largest, std::abs(state.x[k]));
        CHECK(largest <= amplitude.value + amplitude.error);
        CHECK(largest >= amplitude.value * (1 - 1e-3));
        if (!s.start) continue;
        CHECK(std::abs(motion.at(0).x[k] - s.start->x[k].value) <= 2 * s.start->x[k].error);
        CHECK(std::abs(motion.at(0).x_prime[k] - s.start->x_prime[k].value) <= 2 * s.start->x_prime[k].error);
    }
    return motion;
}

void check_against_double(const Scene<double>& scene, Regime regime, int periods = 1, bool symmetric = true) {
    const SceneSource source = scene_source(scene);
    const Solution proved = answer(source, true), in_double = answer(source, false);
    REQUIRE(proved.regime.regime == regime);
    REQUIRE(in_double.method.precision == "double");
    CHECK(proved.periods == periods);
    CHECK(proved.symmetric == symmetric);
    const SampledSolution motion = checked_samples(source, proved);
    CHECK(apart(motion, sampled_solution(source, in_double, instants), proved) < 1e-9);
    if (!symmetric) return;
    for (std::size_t n = 0; n < instants; ++n) // (25)
        for (std::size_t k = 0; k < proved.masses.size(); ++k)
            REQUIRE(std::abs(motion.at(n).x[k] + motion.at((n + instants / 2) % instants).x[k]) <=
                    1e-14 * proved.masses[k].amplitude.value + 1e-300);
}

TEST_CASE("samples of a proved motion with stops are those of double, within its amplitudes", "[reference][samples]") {
    const auto check = [](const System<double>& s, double r, double beta, double mu = 1) {
        check_against_double(scene_of(s, r, beta, mu), Regime::stick_slip);
    };
    check(chain_of({1}, {1}, 0.01), 0.125, 0.25);
    check(two_masses(), 0.3125, 0.25);
    check(two_masses(), 0.375, 0.3125, 1.4);
    check(five_masses(), 0.4375, 0.3125);
    check(five_masses(), 0.4375, 0.25, 1.4);
    check(coupled_masses(), 0.375, 0.75);
    check(rubbing_masses(), 0.4375, 0.25);
}

TEST_CASE("samples of a proved motion that does not mirror itself, or takes two periods, are those of double",
          "[reference][samples][eq:25]") {
    check_against_double(scene_of(chain_of({1}, {1}, 0.03125), 0.125, 0.1875, 1.5), Regime::stick_slip, 1, false);
    check_against_double(scene_of(chain_of({1, 1}, {1, 1}, 0.03125, 2, 1), 1.125, 0.859375, 1.5), Regime::stick_slip, 2, false);
}

TEST_CASE("samples of a proved sliding motion are those of double", "[reference][samples][eq:41]") {
    for (const double beta : {0.0, 0.03125}) {
        check_against_double(scene_of(two_masses(), 1.25, beta), Regime::continuous);
        check_against_double(scene_of(five_masses(), 1.25, beta / 16), Regime::continuous);
        check_against_double(scene_of(coupled_masses(), 1.25, beta / 4), Regime::continuous);
        check_against_double(scene_of(rubbing_masses(), 1.25, beta / 4), Regime::continuous);
    }
}

TEST_CASE("samples of a proved motion at rest are those of double", "[reference][samples][eq:88]") {
    check_against_double(scene_of(two_masses(), 0.75, 8), Regime::permanent_sticking);
    check_against_double(scene_of(rubbing_masses(), 0.4375, 8), Regime::permanent_sticking);
}

TEST_CASE("an instant of an event or a turn is on both sides of it", "[reference][samples]") {
    const Scene<double> scene = scene_of(two_masses(), 0.3125, 0.25);
    const Bits all(192);
    const reference::OrbitInPhases motion = reference::orbit_in_phases(in_bits(scene), guess_for(scene), ball_bits);
    for (slong i = 0; i <= motion.orbit.at.m(); ++i)
        for (const int periods : {-2, 0, 3}) {
            const Ball event = motion.orbit.at.instant(i) + Ball(2 * periods) * PiOf<Ball>::value();
            const BallMatrix there = motion.at(event), before = motion.at(event - Ball(0x1p-40)),
                             after = motion.at(event + Ball(0x1p-40));
            for (slong k = 0; k < there.rows(); ++k) {
                CHECK(there(k).radius() < 1e-30);
                CHECK(abs(there(k) - before(k)).high() < 1e-10);
                CHECK(abs(there(k) - after(k)).high() < 1e-10);
            }
        }
}

TEST_CASE("samples of another motion are noticed, and an answer that is not the motion's is refused", "[reference][samples]") {
    const Scene<double> scene = scene_of(two_masses(), 0.3125, 0.25);
    Scene<double> twin = scene;
    twin.beta = *scene.beta * (1 + 1e-6);
    const SceneSource source = scene_source(scene), of_twin = scene_source(twin);
    const Solution s = answer(source, true), other = answer(of_twin, true);
    const SampledSolution motion = checked_samples(source, s);
    CHECK(apart(motion, sampled_solution(of_twin, other, instants), s) > 1e-9);
    Solution moved = s;
    moved.start->x[1].value += 1e-5;
    CHECK_THROWS_WITH(sampled_solution(source, moved, 8), Catch::Contains("is not that of the answer"));
    Solution longer = s;
    longer.periods = 2;
    CHECK_THROWS_WITH(sampled_solution(source, longer, 8), Catch::Contains("has another period"));
    Solution small = s; // what no bits can give
    small.masses[0].amplitude = {0, 0, {}};
    CHECK_THROWS_AS(sampled_solution(source, small, 8), PrecisionError);
}

TEST_CASE("the C interface hands out the samples of a proved motion, of a contact between two masses too",
          "[reference][samples]") {
    const std::string text = text_of_scene(R"(of every kind {"mass_ratios": [1, 2, 1], "stiffness_ratios": [1, 1, "0.5"],
        "damping_ratios": "0.03", "contact": [1, 3], "load": [1, 0, "-0.5"], "r": null, "beta": null})");
    dh_system* system = nullptr;
    REQUIRE(dh_system_from_json(text.data(), text.size(), &system) == DH_OK);
    for (const double beta : {0.0, 0.0625, 0.25, 8.0}) {
        const SceneSource source = denhartog::at_point(scene_source(SceneText{text}), 0.4375, beta);
        const Solution s = answer(source, true);
        const SampledSolution expected = checked_samples(source, s);
        dh_solution* solution = nullptr;
        REQUIRE(dh_solve_proved(system, 0.4375, beta, 1, 0, &solution) == DH_OK);
        std::vector<double> x(3 * instants), v(3 * instants);
        CHECK(dh_solution_motion(solution, instants, x.size(), x.data(), v.data()) == DH_OK);
        for (std::size_t n = 0; n < instants; ++n)
            for (std::size_t k = 0; k < 3; ++k) {
                CHECK(x[3 * n + k] == expected.at(n).x[k]);
                CHECK(v[3 * n + k] == expected.at(n).x_prime[k]);
            }
        dh_solution_destroy(solution);
    }
    dh_system_destroy(system);
}

TEST_CASE("the program prints the samples of a proved motion", "[reference][samples][program]") {
    const auto with = [](const std::string& beta) {
        return text_of_scene(R"(two {"damping_ratios": [0.02, 0.01], "r": "0.3125", "beta": )" + beta + "}");
    };
    for (const std::string beta : {"0.25", "0", "8"}) {
        const std::string scene = with(beta);
        const SceneSource source = scene_source(SceneText{scene});
        const SampledSolution expected = sampled_solution(source, answer(source, true), 64);
        const Run run = run_program("solve --samples 64 --proved", scene);
        CHECK(run.status == 0);
        CHECK(run.error.empty());
        const std::vector<std::string> lines = lines_of(run.output);
        REQUIRE(lines.size() == 65);
        CHECK(lines[0] == "tau,x_1,x_2,v_1,v_2");
        for (std::size_t n = 0; n < 64; ++n) {
            const std::vector<double> row = numbers_of(lines[n + 1]);
            const State& state = expected.at(n);
            CHECK(row == std::vector<double>{expected.tau[n], state.x[0], state.x[1], state.x_prime[0], state.x_prime[1]});
        }
        CHECK(nlohmann::json::parse(run_program("solve --proved --json", scene).output)["method"]["proved"] == true);
    }
    CHECK(run_program("solve --samples 4 --proved --ask phase", with("8")).status == 2);
}

// A seeded system of 1 to 5 masses: damped, with a mode beyond critical damping, without damping, or rubbing between two masses.
System<double> seeded_system(SplitMix64& random, int scene) {
    const int N = 1 + scene % 5, kind = scene % 4;
    std::vector<double> gamma{1}, kappa{1}, zeta;
    for (int k = 1; k < N; ++k) {
        gamma.push_back(random.over_octaves(-1, 0));
        kappa.push_back(random.over_octaves(-1, 1));
    }
    for (int k = 0; k < N; ++k) zeta.push_back(kind == 0 ? 0 : random.over_octaves(-7, -4));
    if (kind == 1) zeta.back() = random.over_octaves(0, 1);
    const int contact = random.integer(1, N), load = random.integer(1, N);
    System<double> s = chain_of(gamma, kappa, zeta, static_cast<std::size_t>(contact), static_cast<std::size_t>(load));
    if (kind == 3 && N > 1) s.contact_with = Mass{static_cast<std::size_t>(contact % N)};
    return s;
}

TEST_CASE("samples of a recurrence are those of the reference", "[reference][samples][eq:41]") {
    SplitMix64 random(607);
    int slides = 0, stops = 0;
    for (int scene = 0; scene < 60; ++scene) {
        Scene<double> at = scene_of(seeded_system(random, scene), random.over_octaves(-2, 0), 0);
        INFO("scene " << scene << " at r = " << *at.r);
        const double limit = solve(scene_source(at), {Asked::regime, {}}).limits->exact.value;
        at.beta = limit * (scene % 3 == 0 && scene % 4 != 0 ? 1.25 : 0.5);
        at.mu = scene % 2 == 0 ? 1 : 1.25;
        const SceneSource source = scene_source(at);
        const Solution s = solve(source, {});
        if (s.rest_interval || s.method.precision != "double") continue;
        ++(s.start ? stops : slides);
        const long steps = precision_steps();
        const SampledSolution fast = sampled_solution(source, s, 90 + static_cast<std::size_t>(scene % 2));
        CHECK(precision_steps() == steps);
        std::optional<PeriodicOrbit> followed;
        const auto guesses = [&] { return guesses_at(PreparedSystem{source}, source, followed); };
        CHECK(apart(fast, {fast.tau, samples_by_reference(source, s, fast.tau, 1e-9, guesses).required()}, s) <
              (s.start ? 1e-8 : 1e-10));
    }
    CHECK(slides >= 40);
    CHECK(stops >= 10);
}

TEST_CASE("no sample of a recurrence is off by more than its bound, and some are by a tenth of it", "[samples][accuracy]") {
    using Wide = long double;
    using namespace evaluation;
    SplitMix64 random(21);
    double most = 0;
    for (int scene = 0; scene < 600; ++scene) {
        const double zeta = scene % 3 == 0 ? 0 : scene % 3 == 1 ? random.over_octaves(-8, -1) : random.over_octaves(0, 2);
        const double R = random.over_octaves(-4, 4), rest = random.over_octaves(-3, 1), s_0 = random.over_octaves(-3, 1);
        const double s_prime = random.over_octaves(-3, 1) / R;
        const EvenInstants at{0.5, random.integer(1, 64) * 0x1p-12, 512}; // runs of 64 steps
        const LinearSum motion{0.25, {{R, zeta, w_if_oscillating(zeta), rest, s_0, s_prime}}, {1}, {0}, {0}, {0}, {0}};
        std::vector<double> x(at.count), v(at.count);
        even_samples(motion, at, x.data(), v.data());
        const ErrorOfSamples bound = loss_of_samples(motion, at).at(0);
        for (std::size_t n = 0; n < at.count; ++n) {
            const Wide t = 0.25 + at.step * static_cast<double>(n), w = w_if_oscillating<Wide>(zeta);
            const FreeMotion<Wide> free = free_motion<Wide>(t, R, zeta, w);
            const Wide exact = rest * one_minus_d<Wide>(t / R, zeta, w, free.q) + s_0 * free.d + s_prime * (R * free.q);
            const Wide exact_prime = (s_0 - Wide(rest)) * free.d_prime + s_prime * (R * free.q_prime);
            const Wide of_x = std::abs(exact - x[n]) / bound.x, of_v = std::abs(exact_prime - v[n]) / bound.x_prime;
            most = std::max({most, static_cast<double>(of_x), static_cast<double>(of_v)});
        }
    }
    CHECK(most <= 1);
    CHECK(most > 0.1);
}

TEST_CASE("where a recurrence would lose too much its instants are taken one by one", "[samples]") {
    const Scene<double> scene = scene_of(two_masses(), 0.3125, 0.25);
    FollowedMotion followed(scene);
    const ExactMotion& motion = followed.solver.run(followed.orbit.start, 0, 2 * pi<double>());
    std::vector<double> x(8), v(8), x_fast(8), v_fast(8);
    for (std::size_t n = 0; n < motion.phases.size(); ++n) {
        const Phase& phase = motion.phases[n];
        const evaluation::EvenInstants at{phase.start, (phase.end - phase.start) / 4, 4};
        followed.solver.sample(n, at, {0, 0}, x.data(), v.data());
        followed.solver.sample(n, at, {1e-12, 1e-12}, x_fast.data(), v_fast.data());
        for (std::size_t m = 0; m < 4; ++m) {
            const State state = followed.solver.state_at(n, at.first + at.step * static_cast<double>(m));
            for (std::size_t k = 0; k < 2; ++k) {
                CHECK(x[2 * m + k] == state.x[k]);
                CHECK(v[2 * m + k] == state.x_prime[k]);
                CHECK(std::abs(x_fast[2 * m + k] - state.x[k]) < 1e-12);
                CHECK(std::abs(v_fast[2 * m + k] - state.x_prime[k]) < 1e-12);
            }
        }
    }
    CHECK(x != x_fast);
}

} // namespace
} // namespace denhartog::tests

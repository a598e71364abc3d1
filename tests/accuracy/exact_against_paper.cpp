#include <cmath>

#include "denhartog/orbit/periodic_orbit.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"
#include "tests/accuracy/witness_survey.hpp"
#include "tests/speed_accuracy/surveys.hpp"
#include "tests/support/paper_systems.hpp"

using namespace denhartog::tests;
using namespace denhartog;

// The exact solver against the paper's algorithm at tolerance 1e-12 in stick-slip.
// Two comparisons, neither of which needs a motion to be steady. From rest both follow the same motion over ten periods. On the
// periodic orbit that the exact solver found, the paper's algorithm must stay. An amplitude can be tiny where the contact
// nearly rests for ever; as tolerances are, its error is gated over 1 plus the amplitude.

namespace {

void print(const std::string& what, const StickSlipSurvey& s) {
    std::printf("%s: %d amplitudes within %.1e, over 1 + X %.1e; %d stops, at most %d a period, times within %.1e; states %.1e\n",
                what.c_str(), s.amplitude.count, s.amplitude.error, s.mixed.error, s.stops, s.most_stops, s.event.error,
                s.state.error);
}

std::string list(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

} // namespace

TEST_CASE("in stick-slip the exact solver and the paper's algorithm at 1e-12 go through the same motion from rest",
          "[eq:6][eq:74][eq:75][exact-solver][paper-algorithm]") {
    const std::vector<StickSlipScene> scenes = stick_slip_scenes(200, 21);
    const StickSlipSurvey loose = from_rest(scenes, 10, 1e-10), tight = from_rest(scenes, 10, 1e-12);
    print("from rest, 1e-10", loose);
    print("from rest, 1e-12", tight);
    INFO(list(tight.differently) << tight.mixed.where << "\n" << tight.event.where);
    CHECK(tight.differently.empty());
    CHECK(tight.stops >= 300);
    CHECK(tight.most_stops >= 6);
    CHECK(tight.mixed.error <= 1e-9);
    CHECK(tight.event.error <= 1e-8);
    // The error that is left is that of the tolerance: a tolerance a hundred times smaller leaves at least thirty times less.
    CHECK(tight.mixed.error <= loose.mixed.error / 30);
    CHECK(tight.event.error <= loose.event.error / 30);
}

TEST_CASE("in stick-slip the paper's algorithm at 1e-12 stays on the orbits of the exact solver",
          "[eq:6][eq:74][eq:75][exact-solver][paper-algorithm]") {
    const std::vector<StickSlipScene> scenes = stick_slip_scenes(200, 22);
    const StickSlipSurvey loose = on_orbits(scenes, 1e-10), tight = on_orbits(scenes, 1e-12);
    print("on orbits, 1e-10", loose);
    print("on orbits, 1e-12", tight);
    INFO(list(tight.differently) << tight.mixed.where << "\n" << tight.event.where);
    CHECK(tight.differently.empty());
    CHECK(tight.stops >= 300);
    CHECK(tight.mixed.error <= 1e-10);
    CHECK(tight.event.error <= 1e-8);
    CHECK(tight.mixed.error <= loose.mixed.error / 30);
    CHECK(tight.event.error <= loose.event.error / 30);
}

// The exact solver against the closed form in the sliding regime: shooting on the motion from event to event on one side, the
// superposition of Section 2 on the other. Both use the modes; nothing else is common.
// Errors of amplitudes and of displacements at a maximum of the force are relative to the amplitude of the mass; phases are in
// radians. The declared set is that of `second_witness.cpp`: condition number of the superposition below 30 000.

namespace {

constexpr double declared_condition = 30000;

struct Survey {
    Record amplitude, phase, state; ///< in the declared set
    Record hard;                    ///< amplitude or state outside it
    Record over_bound;              ///< error of the displacements over the orbit's error bound, every scene
    int from_rest = 0;              ///< scenes started from rest
    int beside = 0;                 ///< scenes started from the closed form, 1/1024 too large
    int newton_steps = 0;
};

/// Whether the steady velocities are the only ones, so that any start leads to them.
bool any_start_will_do(const Scene<double>& scene, const ContactSystem& system) {
    bool damped = scene.mu == 1;
    for (const double zeta : system.basis.zeta) damped = damped && zeta > 0;
    return damped;
}

State too_large(State z) {
    for (std::vector<double>* each : {&z.x, &z.x_prime})
        for (double& value : *each) value += value / 1024;
    return z;
}

void compare_scene(const NamedScene<double>& named, Survey& survey) {
    const auto error = [](double a, double b, double size) { return std::abs(a - b) / size; };
    const Scene<double>& scene = named.scene;
    INFO(named.name << ", mu = " << scene.mu << ", beta = " << hexadecimal(*scene.beta));
    const Response<double> closed = response(scene);
    REQUIRE(closed.steady_state);
    const SteadyState<double>& steady = *closed.steady_state;
    const ContactSystem system = contact_system(scene.system);
    const ModeSums<double> sums = mode_sums(system.basis, system.contact, system.load, *scene.r);
    const State at_zero = at_maximum_of_force(sums, steady);
    const std::size_t N = at_zero.x.size();
    const bool rest = any_start_will_do(scene, system);
    (rest ? survey.from_rest : survey.beside) += 1;
    OrbitSearch search;
    search.follow_start = false;
    ExactSolver solver(system, {*scene.r, *scene.beta, scene.mu});
    const PeriodicOrbit orbit = periodic_orbit(solver, rest ? at_rest(N) : too_large(at_zero), search);
    INFO(in_words(orbit.reason));
    REQUIRE(orbit.status == OrbitStatus::periodic);
    REQUIRE(orbit.masses.size() == N);
    CHECK(orbit.symmetric);
    CHECK(orbit.periods == 1);
    CHECK(orbit.stops.empty());
    survey.newton_steps += orbit.newton_steps;
    const bool declared = condition(sums, steady, scene.system.stiffness_matrix.size() == 0) < declared_condition;
    for (std::size_t k = 0; k < N; ++k) {
        const double X = steady.masses[k].amplitude;
        const double of_amplitude = error(orbit.masses[k].amplitude, X, X);
        const double of_phase = std::abs(wrapped(orbit.masses[k].phase - steady.masses[k].phase));
        const double of_state = error(orbit.start.x[k], at_zero.x[k], X);
        survey.over_bound.note(error(orbit.start.x[k], at_zero.x[k], orbit.error_bound), named.name);
        if (declared) {
            survey.amplitude.note(of_amplitude, named.name);
            survey.phase.note(of_phase, named.name);
            survey.state.note(of_state, named.name);
        } else {
            survey.hard.note(std::max(of_amplitude, of_state), named.name);
        }
    }
}

std::vector<NamedScene<double>> scenes_with_mu_1(std::uint64_t seed) {
    std::vector<NamedScene<double>> scenes = random_sliding_scenes<double>(seed);
    const std::vector<RandomScene<double>> random = random_scenes<double>(seed);
    for (std::size_t n = 0; n < scenes.size(); ++n) {
        Scene<double> scene = random[n].scene;
        scene.mu = 1;
        scenes[n].scene.mu = 1;
        scenes[n].scene.beta = friction_ratio_at(random[n].fraction_of_limit, response(scene).boundary.exact);
    }
    return scenes;
}

void print_and_check(const std::string& what, const Survey& survey, double gate) {
    std::printf("%s: %d scenes from rest, %d from beside the closed form, %d Newton steps\n", what.c_str(), survey.from_rest,
                survey.beside, survey.newton_steps);
    print("amplitudes, condition number below 30 000", survey.amplitude);
    print("phases, radians", survey.phase);
    print("displacements at a maximum of the force", survey.state);
    print("from 30 000 on", survey.hard);
    print("displacements over the orbit's error bound", survey.over_bound);
    INFO("worst scenes: " << survey.amplitude.scene << "; " << survey.phase.scene << "; " << survey.state.scene << "; "
                          << survey.over_bound.scene);
    CHECK(survey.amplitude.error <= gate);
    CHECK(survey.phase.error <= gate);
    CHECK(survey.state.error <= gate);
    CHECK(survey.over_bound.error <= 1);
}

} // namespace

TEST_CASE("where the contact slides the exact solver agrees with the closed form to 1e-12 in double",
          "[eq:38][eq:39][eq:41][eq:44][eq:45][eq:47][exact-solver]") {
    Survey survey;
    for (const NamedScene<double>& named : scenes_with_mu_1(11)) compare_scene(named, survey);
    for (const NamedScene<double>& named : random_sliding_scenes<double>(12)) compare_scene(named, survey);
    print_and_check("random scenes, double", survey, 1e-12);
    CHECK(survey.from_rest >= 400);
    CHECK(survey.beside >= 400);
}

// 200 cycles against the periodic orbit: a sample of the survey `speed-accuracy cycles`.

TEST_CASE("near a resonance with zeta = 0.001 the amplitude after 200 cycles is far from that of the steady state",
          "[exact-solver][cycles]") {
    const std::vector<double> r = {0.5, 0.9, 1.0, 1.1, 2.0};
    for (const double zeta : {0.001, 0.01, 0.1}) {
        const CyclesSurvey survey = survey_cycles("SDOF", single_mass(zeta), zeta, 0.2, r, 200);
        REQUIRE(survey.errors.size() == r.size());
        const CyclesError& largest = worst(survey);
        std::printf("SDOF zeta = %g: largest error %.3e at r = %g\n", zeta, largest.contact, largest.r);
        // At resonance friction takes the same share of the load in every cycle: what is missing decays with the free motion.
        const double missing = std::exp(-400 * pi<double>() * zeta);
        if (zeta < 0.1) {
            CHECK(largest.r == 1.0);
            CHECK(largest.contact == Approx(missing).epsilon(0.02));
        } else {
            CHECK(largest.contact <= 1e-12);
        }
    }
    for (const NamedSystem<double>& s : paper_systems(0.001)) {
        const CyclesSurvey survey = survey_cycles(s.name, s.system, 0.001, 0.2, {0.6, 1.0, 1.3, 1.61}, 200);
        std::printf("%s zeta = 0.001: largest error %.3e at r = %g\n", s.name.c_str(), worst(survey).contact, worst(survey).r);
        CHECK(survey.unanswered == 0);
        CHECK(worst(survey).contact > 0.01);
    }
}

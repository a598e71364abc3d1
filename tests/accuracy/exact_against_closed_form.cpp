// The exact solver against the closed form in the sliding regime: shooting on the motion from event to event on one side, the
// superposition of Section 2 on the other. Both use the modes; nothing else is common.
//
// Errors of amplitudes and of displacements at a maximum of the force are relative to the amplitude of the mass; phases are in
// radians. The declared set is that of `second_witness.cpp`: condition number of the superposition below 30 000.
#include "tests/accuracy/witness_survey.hpp"

#include "denhartog/orbit/periodic_orbit.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"
#include "tests/support/plain_response.hpp"

using namespace denhartog;
using namespace denhartog::tests;

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

// The exact solver against the closed form in the sliding regime: shooting on the motion from event to event on one side, the
// superposition of Section 2 on the other. Both use the modes; nothing else is common.
//
// Errors of amplitudes and of displacements at a maximum of the force are relative to the amplitude of the mass; phases are in
// radians. The declared set is that of `second_witness.cpp`: condition number of the superposition below 30 000.
#include "tests/accuracy/witness_survey.hpp"

#include "denhartog/orbit/periodic_orbit.hpp"
#include "denhartog/stick_slip/at_maximum_of_force.hpp"
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
template <class T>
bool any_start_will_do(const Scene<T>& scene, const ContactSystem<T>& system) {
    bool damped = scene.mu == 1;
    for (const T& zeta : system.basis.zeta) damped = damped && zeta > 0;
    return damped;
}

template <class T>
State<T> too_large(State<T> z) {
    for (std::vector<T>* each : {&z.x, &z.x_prime})
        for (T& value : *each) value += value / 1024;
    return z;
}

template <class T>
void compare_scene(const NamedScene<T>& named, Survey& survey) {
    const auto error = [](const T& a, const T& b, const T& size) {
        return static_cast<double>(a < b ? T((b - a) / size) : T((a - b) / size));
    };
    const Scene<T>& scene = named.scene;
    INFO(named.name << ", mu = " << static_cast<double>(scene.mu)
                    << ", beta = " << hexadecimal(static_cast<double>(*scene.beta)));
    const Response<T> closed = response(scene);
    REQUIRE(closed.steady_state);
    const SteadyState<T>& steady = *closed.steady_state;
    const ContactSystem<T> system = contact_system(scene.system);
    const ModeSums<T> sums = mode_sums(system.basis, system.contact, system.load, *scene.r);
    const State<T> at_zero = at_maximum_of_force(sums, steady);
    const std::size_t N = at_zero.x.size();
    const bool rest = any_start_will_do(scene, system);
    (rest ? survey.from_rest : survey.beside) += 1;
    OrbitSearch<T> search;
    search.follow_start = false;
    ExactSolver<T> solver(system, {*scene.r, *scene.beta, scene.mu});
    const PeriodicOrbit<T> orbit = periodic_orbit(solver, rest ? at_rest<T>(N) : too_large(at_zero), search);
    INFO(orbit.reason);
    REQUIRE(orbit.status == OrbitStatus::periodic);
    REQUIRE(orbit.masses.size() == N);
    CHECK(orbit.symmetric);
    CHECK(orbit.periods == 1);
    CHECK(orbit.stops.empty());
    survey.newton_steps += orbit.newton_steps;
    const bool declared = condition(sums, steady, scene.system.stiffness_matrix.size() == 0) < declared_condition;
    for (std::size_t k = 0; k < N; ++k) {
        const T& X = steady.masses[k].amplitude;
        const double of_amplitude = error(orbit.masses[k].amplitude, X, X);
        const double of_phase = error(wrapped(T(orbit.masses[k].phase - steady.masses[k].phase)), T(0), T(1));
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

template <class T>
std::vector<NamedScene<T>> scenes_with_mu_1(std::uint64_t seed) {
    std::vector<NamedScene<T>> scenes = random_sliding_scenes<T>(seed);
    const std::vector<RandomScene<double>> random = random_scenes<double>(seed);
    for (std::size_t n = 0; n < scenes.size(); ++n) {
        Scene<double> scene = random[n].scene;
        scene.mu = 1;
        scenes[n].scene.mu = T(1);
        scenes[n].scene.beta = T(friction_ratio_at(random[n].fraction_of_limit, response(scene).boundary.exact));
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
    for (const NamedScene<double>& named : scenes_with_mu_1<double>(11)) compare_scene(named, survey);
    for (const NamedScene<double>& named : random_sliding_scenes<double>(12)) compare_scene(named, survey);
    print_and_check("random scenes, double", survey, 1e-12);
    CHECK(survey.from_rest >= 400);
    CHECK(survey.beside >= 400);
}

TEST_CASE("where the contact slides the exact solver agrees with the closed form to 1e-45 in 50 digits",
          "[eq:38][eq:39][eq:41][eq:44][eq:45][eq:47][exact-solver]") {
    Survey survey;
    for (const int seed : {13, 14}) {
        const std::vector<NamedScene<Real50>> scenes =
            seed == 13 ? scenes_with_mu_1<Real50>(13) : random_sliding_scenes<Real50>(14);
        for (std::size_t n = 0; n < scenes.size(); n += 17) compare_scene(scenes[n], survey);
    }
    print_and_check("random scenes, 50 digits", survey, 1e-45);
    CHECK(survey.from_rest >= 20);
    CHECK(survey.beside >= 20);
}

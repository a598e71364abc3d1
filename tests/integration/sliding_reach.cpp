// The distance from the sliding motion within which a motion slides for ever, and the search that this saves.
#include <cmath>
#include <memory>
#include <random>

#include "denhartog/sliding/instants_of_maxima.hpp"
#include "tests/integration/orbit_scenes.hpp"
#include "tests/support/kinds_of_scenes.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

/// A sliding motion at its turning point.
struct Turning {
    State z;
    double tau;
    double reach;
};

std::optional<Turning> turning_of(const PreparedMotion& p, ExactSolver& solver) {
    const PeriodicOrbit orbit = orbit_of(p);
    if (orbit.status != OrbitStatus::periodic || !orbit.stops.empty() || orbit.periods != 1) return std::nullopt;
    const ExactMotion& motion = solver.run(orbit.start, 0, pi<double>());
    if (motion.phases.size() != 2) return std::nullopt;
    const std::size_t N = orbit.start.x.size();
    const auto at = motion.states.begin() + static_cast<std::ptrdiff_t>(2 * N);
    Turning turning{{{at, at + static_cast<std::ptrdiff_t>(N)}, {at + static_cast<std::ptrdiff_t>(N), motion.states.end()}},
                    motion.phases[1].start,
                    0};
    turning.reach = solver.sliding_reach(1);
    return turning;
}

/// The state that is a distance away in modal displacements times frequencies and modal velocities.
State moved(const PreparedMotion& p, State z, const std::vector<double>& direction, double distance) {
    const std::size_t N = z.x.size();
    double size = 0;
    for (const double each : direction) size = std::hypot(size, each);
    for (std::size_t k = 0; k < N; ++k)
        for (std::size_t i = 0; i < N; ++i) {
            const double phi = p.system.basis.phi(k, i) * distance / size;
            z.x[k] += phi * direction[i] * p.excitation.r / p.system.basis.r_n[i];
            z.x_prime[k] += phi * direction[N + i];
        }
    return z;
}

bool sticks(const ExactMotion& motion) {
    return std::ranges::any_of(motion.phases, [](const Phase& phase) { return phase.direction == 0; });
}

} // namespace

TEST_CASE("a motion within the reach of the sliding one never stops, and one some reaches away may", "[eq:3][exact-solver]") {
    std::mt19937_64 generator(11);
    const auto uniform = [&] { return static_cast<double>(generator() >> 11) * 0x1p-52 - 1; };
    int tight = 0, tried = 0;
    const auto check = [&](const RandomScene<double>& each) {
        Scene<double> scene = each.scene;
        scene.mu = tried++ % 2 == 0 ? 1 + std::exp(4 * (uniform() - 1)) : 1.5 + uniform() / 2; // near 1, and not
        try {
            const ModeSums<Bounded<double>> sums =
                bounded_sums(scene.system, *modes_with_errors(scene.system), as_input(*scene.r));
            const double limit = regime_boundary(sums, as_input(scene.mu)).exact.x;
            scene.beta = friction_ratio_at(63.0 / 64, limit * std::sqrt(each.fraction_of_limit));
        } catch (const DomainError&) {
            return false; // at a pole of a mode without damping
        }
        const PreparedMotion p{each.name, contact_system(scene.system), {*scene.r, *scene.beta, scene.mu}};
        if (!(*scene.beta > 0) || !every_motion_is_damped(p.system.basis)) return false;
        ExactSolver solver(p.system, p.excitation);
        const std::optional<Turning> turning = turning_of(p, solver);
        if (!turning || !(turning->reach > 0)) return false;
        INFO(p.name << ", reach " << turning->reach);
        const OrbitMap map(solver);
        const std::size_t N = p.system.basis.r_n.size();
        double nearest = 1e9; // in reaches, of those that stop
        const auto try_state = [&](const State& z, double tau, double factor) {
            const ExactMotion& motion = solver.run(z, tau, tau + 40 * pi<double>());
            if (sticks(motion)) nearest = std::min(nearest, factor);
            if (factor > 1) return;
            CHECK_FALSE(sticks(motion));
            const State end = motion.end;
            CHECK(map.norm(difference(end, solver.run(turning->z, turning->tau, tau + 40 * pi<double>()).end)) <= turning->reach);
        };
        const std::vector<double> factors{0.999, 2.0, 4.0, 8.0};
        for (int n = 0; n < 4; ++n) {
            std::vector<double> direction(2 * N);
            for (double& y : direction) y = uniform();
            for (const double factor : factors)
                try_state(moved(p, turning->z, direction, factor * turning->reach), turning->tau, factor);
        }
        // The worst that can be done: next to a turning point the velocity is made zero, and what is left takes from the load.
        const Contact& contact = p.system.stuck.contact;
        double of_velocity = 0, of_load = 0;
        std::vector<double> velocity(2 * N), load(2 * N);
        for (std::size_t i = 0; i < N; ++i) {
            velocity[N + i] = p.system.contact_shape(static_cast<Eigen::Index>(i));
            load[i] = p.system.contact_shape(static_cast<Eigen::Index>(i)) * p.system.basis.r_n[i];
            of_velocity = std::hypot(of_velocity, velocity[N + i]);
            of_load = std::hypot(of_load, load[i]);
        }
        for (const double part : {0.0, 0.2, 0.4, 0.6, 0.8, 0.95, 1.0})
            for (const double factor : factors)
                for (const int before : {0, 1})
                    for (const int side : {1, -1}) {
                        const double distance = factor * turning->reach, speed = part * distance * of_velocity;
                        solver.run(turning->z, turning->tau, turning->tau + pi<double>());
                        double from = 0, to = pi<double>() / 2; // where the contact is as fast as that, by bisection
                        const auto time = [&](double t) { return before == 1 ? pi<double>() - t : t; };
                        const auto state = [&](double t) { return solver.state_at(0, turning->tau + time(t)); };
                        if (std::abs(contact.of(state(to).x_prime)) < speed) continue;
                        for (int n = 0; n < 40; ++n) {
                            const double middle = from + (to - from) / 2;
                            (std::abs(contact.of(state(middle).x_prime)) < speed ? from : to) = middle;
                        }
                        State z = state(from);
                        const double v = contact.of(z.x_prime);
                        z = moved(p, z, velocity, -v / of_velocity);
                        contact.hold(z.x_prime.data());
                        z = moved(p, z, load, side * distance * std::sqrt(1 - part * part));
                        try_state(z, turning->tau + time(from), factor);
                    }
        tight += nearest < 1e9;
        return true;
    };
    int scenes = 0;
    for (const std::vector<RandomScene<double>>& list : {random_coupled_scenes(2202), random_scenes<double>(2202)}) {
        int of_list = 0;
        for (const RandomScene<double>& each : list)
            if (of_list < 30 && number_of_masses(each.scene.system) <= 6) of_list += check(each);
        scenes += of_list;
    }
    CHECK(scenes == 60);
    INFO(tight << " of " << scenes << " scenes stop where no more than 8 reaches away");
    CHECK(tight >= 45); // a reach of nearly nothing would pass the rest
}

TEST_CASE("with mu above 1 a guess spares work and decides nothing", "[eq:3][eq:74][exact-solver][shooting][counter]") {
    // From rest the contact stays at rest; the guess is the sliding motion, which attracts as well.
    const PreparedMotion two_motions = prepared_oscillator(0.05, 1, 0.55, 2);
    OrbitSearch search;
    const State slides = orbit_from(two_motions, {{5}, {0}}).start;
    search.guess = &slides;
    CHECK(orbit_of(two_motions, search).status == OrbitStatus::permanently_stuck);
    // From rest the motion comes to one that needs two periods to repeat itself; the symmetric one is there and does not attract.
    const PreparedMotion asymmetric = prepared_oscillator(0.03125, 0.5, 0.1875, 2);
    OrbitSearch any;
    any.follow_start = false;
    const State symmetric = orbit_of(asymmetric, any).start;
    const PeriodicOrbit from_rest = orbit_of(asymmetric);
    search.guess = &symmetric;
    const PeriodicOrbit guided = orbit_of(asymmetric, search);
    REQUIRE(guided.status == OrbitStatus::periodic);
    CHECK(guided.symmetric == from_rest.symmetric);
    CHECK(guided.periods == from_rest.periods);
    CHECK(std::abs(guided.contact.amplitude - from_rest.contact.amplitude) <= guided.error_bound + from_rest.error_bound);
    // Where the motion from rest slides in the end, the closed form as a guess ends the search once the motion is near.
    const PreparedMotion sliding = prepared_chain({1, 1}, {1, 1}, {0.02, 0.05}, 2, 1, 0.5, 0.2, 1.2);
    const PeriodicOrbit slowly = orbit_of(sliding);
    search.guess = &slowly.start;
    const PeriodicOrbit quickly = orbit_of(sliding, search);
    REQUIRE(quickly.status == OrbitStatus::periodic);
    CHECK(quickly.periods_propagated < slowly.periods_propagated);
    CHECK(quickly.newton_steps < slowly.newton_steps);
    CHECK(quickly.periods_propagated <= 8); // counted when this was written
}

TEST_CASE("a motion that comes to a subharmonic one slowly is seen to do so, where the contact rests for whole half-periods",
          "[eq:3][exact-solver][shooting]") {
    const PreparedMotion p = prepared_chain({1, 1}, {1, 1}, {0.02, 0.05}, 2, 1, 0.47085427135678387, 0.46937875751503005, 1.2);
    const PeriodicOrbit orbit = orbit_of(p);
    INFO(in_words(orbit.reason));
    REQUIRE(orbit.status == OrbitStatus::periodic);
    CHECK(orbit.periods == 3);
    CHECK(orbit.stops.size() == 4);
}

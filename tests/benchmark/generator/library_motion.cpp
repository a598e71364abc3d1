#include <algorithm>
#include <cmath>

#include "denhartog/answer/reference_point.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/reference/orbit.hpp"
#include "denhartog/reference/sliding.hpp"
#include "denhartog/solve/solve.hpp"
#include "tests/benchmark/generator/motion.hpp"

namespace denhartog::benchmark {
namespace {

using namespace reference;

constexpr slong bits = 256;
constexpr double most_radius = 1e-30; // far below the digits that are written

Real50 number(const Ball& x) {
    if (!(x.radius() < most_radius)) throw DomainError("a number of the motion is not known well enough");
    Real50 rounded;
    arf_get_mpfr(rounded.backend().data(), arb_midref(x.a), MPFR_RNDN);
    return rounded;
}

Real50 lag(const Real50& instant, const Real50& x) {
    const Real50 turned = instant + (x < 0 ? pi<Real50>() : Real50(0));
    return atan2(Real50(sin(turned)), Real50(cos(turned)));
}

template <class At>
void set_samples(Motion& motion, std::size_t N, std::size_t j, const At& at) {
    std::size_t next = 0; // event
    int direction = motion.at_start;
    for (int n = 0; n < instants; ++n) {
        const Ball tau = 2 * n * pi<Ball>() / instants;
        for (; next < motion.events.size() && motion.events[next].tau < number(tau); ++next)
            direction = motion.events[next].after;
        const BallMatrix z = at(tau);
        Sample sample;
        for (std::size_t k = 0; k < N; ++k) {
            sample.x.push_back(number(z(static_cast<slong>(k))));
            sample.x_prime.push_back(direction == 0 && k == j ? Real50(0) : number(z(static_cast<slong>(N + k))));
        }
        motion.samples.push_back(std::move(sample));
    }
}

// The contact rests at zero for ever, and the others move as they do with it held.
Motion held_motion(const SceneSource& source, std::size_t N, std::size_t j) {
    const std::optional<StuckInBalls> stuck = stuck_in_balls(damped_scene_in_balls(source));
    if (!stuck) throw DomainError("the system may resonate with the contact held");
    Motion motion;
    motion.rests = true;
    set_samples(motion, N, j, [&](const Ball& tau) { return harmonic_in_balls(stuck->X, static_cast<slong>(N), tau); });
    for (std::size_t k = 0; k < N; ++k) {
        const Complex<Ball>& X = stuck->X[k];
        const bool still = k == j || number(root_of_positive(squared_modulus(X))) < no_motion;
        motion.amplitude.push_back(still ? Real50(0) : number(root_of_positive(squared_modulus(X))));
        motion.phase.push_back(still ? std::nullopt : std::optional(number(wrapped_in_balls(-argument(X)))));
    }
    return motion;
}

// The events of the stretch that a motion was proved on, then those of its mirror image, by their place in the period.
void set_events(Motion& motion, const OrbitInPhases& proved, std::size_t j) {
    const OrbitUnknowns& at = proved.orbit.at;
    const Real50 period = 2 * pi<Real50>();
    for (int part = 0; part < (at.mirrored ? 2 : 1); ++part)
        for (slong i = 0; i < at.m(); ++i) {
            const int sign = part == 0 ? 1 : -1;
            Real50 tau = number(at.instant(i) + Ball(part) * at.T());
            tau -= period * floor(Real50(tau / period));
            const Real50 x = number(proved.orbit.Z[static_cast<std::size_t>(i)](static_cast<slong>(j)));
            motion.events.push_back({tau, sign * at.direction(i), sign * at.direction(i + 1), Real50(sign * x)});
        }
    std::ranges::sort(motion.events, {}, &Event::tau);
    motion.at_start = motion.events.back().after;
    if (motion.events.front().before != motion.at_start) throw DomainError("a phase starts at the maximum of the force");
}

// A motion next to the boundary of sliding may have a stop more or less than double sees.
OrbitInPhases proved_near_guess(const std::function<SceneInBalls()>& in_balls, OrbitGuess& guess) {
    std::vector<OrbitGuess> all = with_other_stops(guess);
    all.insert(all.begin(), guess);
    for (const OrbitGuess& each : all) try {
            guess = each;
            return orbit_in_phases(in_balls, each, bits);
        } catch (const Unproved&) {
        }
    throw DomainError("the motion is not proved");
}

} // namespace

Motion library_motion(const Scene<double>& scene) {
    using std::abs;
    const std::size_t N = scene.system.mass_ratios.size(), j = scene.system.contact.index;
    const ContactSystem system = contact_system(scene.system);
    ExactSolver solver(system, {*scene.r, *scene.beta, scene.mu});
    const PeriodicOrbit orbit = periodic_orbit(solver, at_rest(N), {.contact_only = true, .with_stability = false});
    if (!is_from_start(orbit) || orbit.periods != 1 || orbit.touching > 0)
        throw DomainError("no motion of one period from rest: " + in_words(orbit.reason));
    const SceneSource source = scene_source(scene);
    if (orbit.status == OrbitStatus::permanently_stuck) {
        if (abs(orbit.start.x[j]) > orbit.error_bound) throw DomainError("the contact does not come to rest at zero");
        const Bits enough(bits);
        return held_motion(source, N, j);
    }
    const auto in_balls = [&] { return damped_scene_in_balls(source); };
    OrbitGuess guess = guess_of(solver, orbit);
    const OrbitInPhases proved = proved_near_guess(in_balls, guess);
    const OrbitInBalls numbers = proved_orbit(in_balls, guess, bits, {}, false);
    const Bits enough(bits);
    Motion motion;
    set_events(motion, proved, j);
    set_samples(motion, N, j, [&](const Ball& tau) { return proved.at(tau); });
    for (std::size_t k = 0; k < N; ++k) {
        motion.amplitude.push_back(number(numbers.masses[k].size));
        motion.phase.emplace_back();
        if (numbers.masses[k].phase) motion.phase.back() = number(*numbers.masses[k].phase);
    }
    Event furthest{Real50(0), 0, 0, Real50(0)}; // where the contact turns or comes to rest; of equal ones the first
    for (const Event& e : motion.events)
        if (e.before != 0 && abs(e.x) > abs(furthest.x) * (1 + Real50(1) / 1000000000)) furthest = e;
    motion.phase[j] = lag(furthest.tau, furthest.x);
    return motion;
}

} // namespace denhartog::benchmark

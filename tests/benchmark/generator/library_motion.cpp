#include <algorithm>
#include <cmath>

#include "denhartog/number/errors.hpp"
#include "denhartog/orbit/periodic_orbit.hpp"
#include "tests/benchmark/generator/motion.hpp"

namespace denhartog::benchmark {
namespace {

constexpr int most_periods = 20000;
constexpr double most_error = 1e-25; // bound of displacements: far below the digits that are written

Real50 lag(const Real50& instant, const Real50& x) {
    const Real50 turned = instant + (x < 0 ? pi<Real50>() : Real50(0));
    return atan2(Real50(sin(turned)), Real50(cos(turned)));
}

} // namespace

Motion library_motion(const Scene<double>& in_double) {
    using std::abs;
    const Scene<Real50> scene = converted<Real50>(in_double);
    const ContactSystem<Real50> system = contact_system(scene.system);
    ExactSolver<Real50> solver(system, {*scene.r, *scene.beta, scene.mu});
    const std::size_t N = in_double.system.mass_ratios.size(), j = scene.system.contact.index;
    OrbitSearch<Real50> search;
    search.most_periods = most_periods;
    search.with_stability = false;
    search.contact_only = true;
    const PeriodicOrbit<Real50> orbit = periodic_orbit(solver, at_rest<Real50>(N), search);
    if (orbit.status == OrbitStatus::not_converged || orbit.periods != 1 || orbit.touching > 0)
        throw DomainError("no motion of one period from rest: " + orbit.reason);
    if (!(orbit.error_bound < most_error)) throw DomainError("the motion is not known well enough: " + orbit.reason);
    Motion motion;
    motion.rests = orbit.status == OrbitStatus::permanently_stuck;
    if (motion.rests && abs(orbit.start.x[j]) > no_motion) throw DomainError("the contact does not come to rest at zero");
    const Real50 period = 2 * pi<Real50>();
    const ExactMotion<Real50> run = solver.run(orbit.start, Real50(0), period);
    motion.at_start = run.phases.front().direction;
    if (run.status != MotionStatus::complete || run.phases.back().direction != motion.at_start)
        throw DomainError("a phase starts at the maximum of the force");
    for (std::size_t n = 1; n < run.phases.size(); ++n)
        motion.events.push_back(
            {run.phases[n].start, run.phases[n - 1].direction, run.phases[n].direction, run.states[2 * N * n + j]});
    std::size_t phase = 0;
    for (int n = 0; n < instants; ++n) {
        const Real50 tau = period * n / instants;
        while (phase + 1 < run.phases.size() && run.phases[phase].end < tau) ++phase;
        motion.samples.push_back(solver.state_at(phase, tau));
    }
    const std::vector<Extremum<Real50>> largest = solver.largest_displacements();
    for (std::size_t k = 0; k < N; ++k) {
        Extremum<Real50> furthest = largest[k];
        if (k == j) { // where it turns or comes to rest; of equal ones the first
            furthest = {motion.rests ? orbit.start.x[j] : Real50(0), Real50(0)};
            for (const Event& e : motion.events)
                if (e.before != 0 && abs(e.x) > abs(furthest.x) * (1 + Real50(1) / 1000000000)) furthest = {e.x, e.tau};
        }
        motion.amplitude.push_back(abs(furthest.x));
        const bool still = motion.amplitude.back() < no_motion;
        motion.phase.push_back(still ? std::nullopt : std::optional(lag(furthest.instant, furthest.x)));
    }
    return motion;
}

std::vector<int> periods_to_settle(const Scene<Real50>& scene, const Motion& settled, const std::vector<double>& tolerances) {
    const ContactSystem<Real50> system = contact_system(scene.system);
    ExactSolver<Real50> solver(system, {*scene.r, *scene.beta, scene.mu});
    const std::size_t N = scene.system.mass_ratios.size();
    const State<Real50>& end = settled.samples.front();
    State<Real50> state = at_rest<Real50>(N);
    Real50 largest(0);
    for (std::size_t k = 0; k < N; ++k) largest = std::max({largest, Real50(abs(end.x[k])), Real50(abs(end.x_prime[k]))});
    if (largest == 0) largest = 1;
    std::vector<int> periods(tolerances.size(), 0);
    std::size_t next = 0;
    for (int n = 1; n <= most_periods && next < tolerances.size(); ++n) {
        state = solver.run(state, Real50(0), 2 * pi<Real50>()).end;
        Real50 apart(0);
        for (std::size_t k = 0; k < N; ++k)
            apart = std::max({apart, Real50(abs(state.x[k] - end.x[k])), Real50(abs(state.x_prime[k] - end.x_prime[k]))});
        while (next < tolerances.size() && apart <= tolerances[next] * largest) periods[next++] = n;
    }
    return periods;
}

} // namespace denhartog::benchmark

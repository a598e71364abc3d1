#include <cmath>

#include "denhartog/orbit/periodic_orbit.hpp"
#include "denhartog/sliding/bounded_modes.hpp"
#include "tests/conformance/generator/route.hpp"

namespace denhartog::conformance::generator {
namespace {

// To 24 bits: what libm does to the last digits is gone.
double cut(double x) {
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);
    return std::ldexp(std::nearbyint(std::ldexp(mantissa, 24)), exponent - 24);
}

State cut(State z) {
    for (double& x : z.x) x = cut(x);
    for (double& v : z.x_prime) v = cut(v);
    return z;
}

} // namespace

OrbitSeen orbit_seen(const ProtocolQuestion& q) {
    const Scene<double> scene = scene_of(q);
    const ContactSystem system = contact_system(with_load_at(scene.system, q.r));
    ExactSolver solver(system, {q.r, q.beta, q.mu});
    OrbitSearch search;
    search.most_periods = 2000;
    const std::size_t N = masses_of(q);
    const PeriodicOrbit orbit = periodic_orbit(solver, at_rest(N), search);
    if (orbit.status != OrbitStatus::periodic || !orbit.stable || orbit.touching > 0)
        throw DomainError("no stable motion from rest: " + in_words(orbit.reason));
    OrbitSeen seen;
    const double half = std::acos(-1.0);
    seen.halves = orbit.symmetric ? orbit.periods : 2 * orbit.periods;
    const ExactMotion& motion = solver.run(orbit.start, 0, (2 * seen.halves + 2) * half);
    std::size_t first = 1; // what is there at the start began before it
    while (first < motion.phases.size() && motion.phases[first].direction != 0) ++first;
    if (first >= motion.phases.size()) throw DomainError("the contact does not stop");
    const double end = motion.phases[first].start + seen.halves * half;
    for (std::size_t n = first; n < motion.phases.size() && motion.phases[n].start < end - 1e-6; ++n) {
        const Phase& p = motion.phases[n];
        if (p.end - p.start < 1e-3) throw DomainError("a phase is so short that it may be none");
        seen.phases.push_back({p.direction, cut(p.start), cut(p.end)});
    }
    if (std::abs(seen.phases.back().end - end) > 1e-6) throw DomainError("the phases do not repeat");
    const double* z = &motion.states[2 * N * first];
    seen.at_rest = cut({{z, z + N}, {z + N, z + 2 * N}});
    system.stuck.contact.hold(seen.at_rest.x_prime.data());
    return seen;
}

} // namespace denhartog::conformance::generator

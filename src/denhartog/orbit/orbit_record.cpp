// The record of an orbit that was found: `orbit_of` reads stops, amplitudes, phases and multipliers off it, and `rest_of` does so
// for a contact at rest. Their bounds come from `bounds_of_orbit.cpp`.
#include "denhartog/orbit/periodic_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/sliding/steady_state.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {
namespace {

// A displacement of its largest size as amplitude and phase.
MassMotion motion_with(double x, double tau, double spread = 0.0) {
    if (x < 0) return {-x, wrapped(tau + pi<double>()), spread};
    return {x, wrapped(tau), spread};
}

// Stops within the period, those across the section and the mirror point in one piece; starts ascending in [0, period).
std::vector<Stop> stops_of(const OrbitMap& map) {
    const ExactMotion& motion = map.motion();
    const auto N = static_cast<std::size_t>(map.N);
    const Contact& contact = map.solver().system().stuck.contact;
    const bool mirrored = map.half_periods() % 2 != 0;
    const double stretch = map.half_periods() * pi<double>(), period = mirrored ? 2 * stretch : stretch;
    std::vector<Stop> stops;
    bool resting = false; // at the end of what was looked at
    for (int part = 0; part < (mirrored ? 2 : 1); ++part)
        for (std::size_t n = 0; n < motion.phases.size(); ++n) {
            const Phase& p = motion.phases[n];
            if (!(p.end > p.start)) continue;
            const double end = p.end + part * stretch, x_j = contact.of(&motion.states[2 * N * n]);
            if (p.direction == 0 && resting)
                stops.back().end = end;
            else if (p.direction == 0)
                stops.push_back({p.start + part * stretch, end, part == 0 ? x_j : -x_j});
            resting = p.direction == 0;
        }
    if (resting && stops.size() > 1 && stops.front().start == 0) {
        stops.back().end = stops.front().end + period;
        stops.erase(stops.begin());
    }
    return stops;
}

// Amplitude and phase of the mass in contact, which is farthest out where it turns back or comes to rest. Another such place may
// be the farthest as well, if the displacements there differ by no more than their error.
MassMotion contact_motion(const OrbitMap& map, double error) {
    const ExactMotion& motion = map.motion();
    const auto N = static_cast<std::size_t>(map.N);
    const auto x_at = [&](std::size_t n) { return map.solver().system().stuck.contact.of(&motion.states[2 * N * n]); };
    // A rest counts from its start: neither where it ends, nor, of one across the start of the stretch, what the stretch has of
    // it first. Elsewhere the start of the stretch comes last and has to be larger by more than rounding.
    const bool rests_across =
        motion.phases.size() > 1 && motion.phases.front().direction == 0 && motion.phases.back().direction == 0;
    double x = rests_across ? 0.0 : x_at(0) * (1 - 16 * double_epsilon), tau = 0;
    for (std::size_t n = 1; n < motion.phases.size(); ++n) {
        if (motion.phases[n - 1].direction == 0) continue;
        const double x_j = x_at(n);
        if (std::abs(x_j) > std::abs(x)) {
            x = x_j;
            tau = motion.phases[n].start;
        }
    }
    MassMotion contact = motion_with(x, tau);
    for (std::size_t n = 1; n < motion.phases.size(); ++n) {
        const double x_j = x_at(n);
        if (motion.phases[n - 1].direction == 0 || std::abs(x_j) < contact.amplitude - 2 * error) continue;
        const double apart = wrapped(motion_with(x_j, motion.phases[n].start).phase - contact.phase);
        contact.spread = std::max(contact.spread, std::abs(apart));
    }
    return contact;
}

} // namespace

std::optional<PeriodicOrbit> orbit_of(const OrbitMap& map, const State& z, const OrbitSearch& search) {
    const std::optional<ErrorsOfOrbit> errors = errors_of(map);
    if (!errors) return std::nullopt;
    PeriodicOrbit orbit;
    const double bound = errors->settled;
    orbit.contact = contact_motion(map, bound);
    if (!map.slides_throughout() && !(bound < orbit.contact.amplitude)) return std::nullopt; // no sure slip
    double largest = orbit.contact.amplitude, unsure = 0;
    for (const double x : z.x) largest = std::max(largest, x < 0 ? -x : x);
    if (!search.contact_only) {
        for (const Extremum& extremum : map.solver().largest_displacements(bound)) {
            orbit.masses.push_back(motion_with(extremum.x, extremum.instant, extremum.spread));
            unsure = std::max(unsure, extremum.unsure);
        }
        orbit.masses[map.solver().system().contact.index] = orbit.contact;
    }
    for (const MassMotion& mass : orbit.masses) largest = std::max(largest, mass.amplitude);
    orbit.error_bound = bound + unsure;
    if (!std::isfinite(largest) || !(100 * orbit.error_bound < largest)) return std::nullopt; // as at a resonance without damping
    orbit.error_bound = errors->displacement + unsure;
    orbit.velocity_errors = errors->velocity;
    const int h = map.half_periods();
    orbit.status = OrbitStatus::periodic;
    orbit.start = z;
    orbit.symmetric = h % 2 != 0;
    orbit.periods = orbit.symmetric ? h : h / 2;
    orbit.stops = stops_of(map);
    orbit.touching = map.motion().touching;
    if (search.with_stability) {
        orbit.multipliers = multipliers_of_orbit(map, *errors);
        // With mu = 1, or without stops, no deviation grows, wherever the events are; if every motion is damped it falls.
        const bool shrinks = map.solver().excitation().mu == 1 || (map.slides_throughout() && orbit.touching == 0);
        orbit.stable = are_inside(orbit.multipliers) ||
                       (shrinks && (every_motion_is_damped(map.solver().system().basis) ||
                                    (map.solver().excitation().mu == 1 && are_inside(multipliers_next_to(map)))));
        if (orbit.symmetric) orbit.multipliers = squared(std::move(orbit.multipliers));
    }
    if (orbit.touching > 0) orbit.reason = Why::grazes;
    return orbit;
}

std::optional<PeriodicOrbit> rest_of(OrbitMap& map, const LastingRest& rest, double x_j, const OrbitSearch& search) {
    PeriodicOrbit orbit;
    orbit.start = rest.steady_state(x_j);
    if (!map.apply(orbit.start, 2, true) || !map.held()) return std::nullopt;
    orbit.status = OrbitStatus::permanently_stuck;
    orbit.symmetric = x_j == 0;
    orbit.stops = {{0, 2 * pi<double>(), x_j}};
    for (std::size_t k = 0; k < orbit.start.x.size(); ++k) orbit.masses.push_back(rest.motion(k, x_j));
    orbit.contact = motion_with(x_j, 0);
    if (map.solver().system().stuck.contact.has_own_row()) orbit.masses.push_back(orbit.contact);
    if (search.contact_only) orbit.masses.clear();
    orbit.error_bound = map.rounding(true).maxCoeff() + map.difference().cwiseAbs().maxCoeff();
    if (search.with_stability) {
        orbit.multipliers = multipliers_of_rest(map);
        orbit.stable = every_motion_is_damped(map.solver().system().basis) || map.N == 1 || are_inside(orbit.multipliers);
    }
    return orbit;
}

} // namespace denhartog

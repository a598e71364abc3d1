#include "denhartog/reference/orbit.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/reference/orbit_multipliers.hpp"
#include "denhartog/reference/orbit_states.hpp"

namespace denhartog::reference {
namespace {

constexpr slong bits_of_multipliers[] = {64, 192}; // the next, with slopes of its own, where the slopes of the proof do not tell
constexpr double narrow_multiplier = 1e-9;

Ball displacement_of_contact(const ContactMechanics& s, const BallMatrix& Z) {
    Ball x(0);
    for (slong k = 0; k < s.N; ++k) x += s.w(k) * Z(k);
    return x;
}

// An instant moved by whole periods to [0, period), by its midpoint; the other by as many.
void bring_into_period(Ball& start, Ball& end, const Ball& period) {
    const Ball shift = Ball(std::floor(static_cast<double>(start) / static_cast<double>(period))) * period;
    start -= shift;
    end -= shift;
}

std::vector<StopInBalls> stops_of(const ProvedOrbit& orbit) {
    const Ball period = Ball(2 * orbit.at.periods) * PiOf<Ball>::value();
    std::vector<StopInBalls> stops;
    for (slong i = 1; i <= orbit.at.m(); ++i) {
        if (orbit.at.direction(i) != 0) continue;
        StopInBalls stop{orbit.at.instant(i - 1), orbit.at.instant(i),
                         displacement_of_contact(orbit.s, orbit.Z[static_cast<std::size_t>(i - 1)])};
        StopInBalls mirrored{stop.start + orbit.at.T(), stop.end + orbit.at.T(), -stop.x};
        bring_into_period(stop.start, stop.end, period);
        bring_into_period(mirrored.start, mirrored.end, period);
        stops.push_back(std::move(stop));
        if (orbit.at.mirrored) stops.push_back(std::move(mirrored));
    }
    std::ranges::sort(stops, {}, [](const StopInBalls& stop) { return static_cast<double>(stop.start); });
    return stops;
}

void set_stability(const ProvedOrbit& orbit, OrbitInBalls& r) {
    for (const slong bits : bits_of_multipliers) {
        const Bits enough(bits + 4 * orbit.at.m());
        const MapOfDeviations map =
            map_of_deviations(orbit, bits == bits_of_multipliers[0] ? orbit.along : linearised(orbit.s, orbit.at));
        r.multipliers = multipliers_over_period(map, orbit.at.mirrored);
        r.stable = r.multipliers.front() < Ball(1) || dies_out(map.A);
        r.unstable = !r.stable && r.multipliers.front() > Ball(1);
        const double widest = std::ranges::max(r.multipliers, {}, &Ball::radius).radius();
        if ((r.stable || r.unstable) && widest < narrow_multiplier * std::max(1.0, r.multipliers.front().high())) return;
    }
}

} // namespace

OrbitInBalls proved_orbit(const std::function<SceneInBalls()>& scene, const OrbitGuess& guess, slong bits,
                          const std::vector<std::size_t>& masses, bool with_multipliers) {
    const OrbitInPhases motion = orbit_in_phases(scene, guess, bits);
    const ProvedOrbit& orbit = motion.orbit;
    const ContactMechanics& s = orbit.s;
    const Bits all(bits);
    OrbitInBalls r;
    r.mirrored = orbit.at.mirrored;
    r.periods = orbit.at.periods;
    r.amplitude.resize(static_cast<std::size_t>(s.N) + 1);
    r.phase.resize(r.amplitude.size());
    const auto set = [&](std::size_t k, const PeakInBalls& peak) {
        r.amplitude[k] = peak.size;
        r.phase[k] = peak.phase;
    };
    const PeakInBalls contact = peak_of_contact(orbit);
    set(static_cast<std::size_t>(s.N), contact);
    for (std::size_t k = 0; k < static_cast<std::size_t>(s.N); ++k) {
        if (!masses.empty() && std::ranges::find(masses, k) == masses.end()) continue;
        const auto mass = static_cast<slong>(k);
        set(k, s.on_a_wall && mass == s.lead ? contact : peak_of_mass(orbit, motion.phases, mass));
    }
    r.stops = stops_of(orbit);
    const BallMatrix start = motion.at(Ball(0));
    for (slong k = 0; k < s.N; ++k) {
        r.x.push_back(start(k));
        r.x_prime.push_back(start(s.N + k));
    }
    if (!with_multipliers) return r;
    set_stability(orbit, r);
    return r;
}

} // namespace denhartog::reference

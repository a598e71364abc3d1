// What is a proved motion with stops? Read `proved_orbit` first: it takes a guess from double, proves the motion
// (orbit_newton.cpp), the law of friction (orbit_proof.cpp), amplitudes (orbit_peaks.cpp) and multipliers
// (orbit_multipliers.cpp).
#include "denhartog/reference/orbit.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/number/effort.hpp"

namespace denhartog::reference {
namespace {

constexpr slong bits_of_multipliers[] = {64, 192}; // the next, with slopes of its own, if the slopes of the proof do not decide

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
                         (orbit.s.place() * orbit.Z[static_cast<std::size_t>(i - 1)])(0)};
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
        r.multipliers = multipliers_over_period(map, orbit.at.mirrored, orbit.s.effort);
        r.stable = r.multipliers.front() < Ball(1) || dies_out(map.A, orbit.s.effort);
        r.unstable = !r.stable && r.multipliers.front() > Ball(1);
        if ((r.stable || r.unstable) && are_narrow(r.multipliers)) return;
    }
}

} // namespace

BallMatrix OrbitInPhases::at(const Ball& tau) const {
    const OrbitUnknowns& o = orbit.at;
    const slong N = orbit.s.N;
    const Ball T = o.T();
    const double first = std::ceil(static_cast<double>(o.instant(0) - tau) / static_cast<double>(T));
    pay(orbit.s.effort, cost_of_ball_products(static_cast<double>(N * ball_bits) / 16));
    BallMatrix state(2 * N, 1);
    bool found = false;
    for (const double stretches : {first - 1, first, first + 1}) {
        const Ball there = tau + Ball(stretches) * T;
        const Ball sign(o.mirrored && std::fmod(stretches, 2) != 0 ? -1 : 1);
        for (slong i = 1; i <= o.m(); ++i) {
            const Ball start = o.instant(i - 1), end = o.instant(i);
            if (there < start || there > end) continue;
            BallMatrix Z = phases[static_cast<std::size_t>(i - 1)].state((there - start) / (end - start));
            if (orbit.s.on_a_wall && o.direction(i) == 0) Z(N + orbit.s.lead) = Ball(0); // it sticks
            for (slong k = 0; k < 2 * N; ++k) {                                          // an event may be on either side
                const Ball value = sign * (k < N ? Z(k) : Z(k) * orbit.s.sigma);
                state(k) = found ? either(state(k), value) : value;
            }
            found = true;
        }
    }
    if (!found) throw Unproved("an instant is in none of the phases");
    return state;
}

OrbitInPhases orbit_in_phases(const std::function<SceneInBalls()>& scene, const OrbitGuess& guess, slong bits) {
    OrbitInPhases motion{proved_near(scene, guess, bits)};
    const Bits all(bits);
    for (slong few = 64;; few *= 2) try { // what friction demands, with as many bits as it takes
            motion.phases = in_stretches(motion.orbit, few);
            const Bits some(few);
            require_friction(motion.orbit, motion.phases);
            return motion;
        } catch (const Disproved&) {
            throw;
        } catch (const Unproved&) {
            if (few >= bits) throw;
        }
}

OrbitInBalls proved_orbit(const std::function<SceneInBalls()>& scene, const OrbitGuess& guess, slong bits,
                          const std::vector<std::size_t>& masses, bool with_multipliers, const std::optional<Ball>& frame) {
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
    for (slong k = 0; frame && k < s.N; ++k) r.from_ground.push_back(peak_of_mass(orbit, motion.phases, k, *frame));
    r.stops = stops_of(orbit);
    const BallMatrix start = motion.at(Ball(0));
    for (slong k = 0; k < s.N; ++k) {
        r.x.push_back(start(k));
        r.x_prime.push_back(start(s.N + k));
    }
    if (with_multipliers) set_stability(orbit, r);
    return r;
}

} // namespace denhartog::reference

#include "denhartog/reference/orbit_states.hpp"

#include <cmath>

#include "denhartog/number/effort.hpp"

namespace denhartog::reference {

BallMatrix OrbitInPhases::at(const Ball& tau) const {
    const OrbitUnknowns& o = orbit.at;
    const slong N = orbit.s.N;
    const Ball T = o.T();
    const double first = std::ceil(static_cast<double>(o.instant(0) - tau) / static_cast<double>(T));
    QuestionEffort::pay(cost_of_ball_products(static_cast<double>(N * ball_bits) / 16));
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
            for (slong k = 0; k < 2 * N; ++k) { // an event may be on either side
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

} // namespace denhartog::reference

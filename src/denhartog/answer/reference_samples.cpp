#if DENHARTOG_REFERENCE
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "denhartog/answer/reference.hpp"
#include "denhartog/answer/reference_attempts.hpp"
#include "denhartog/answer/reference_point.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/reference/orbit.hpp"
#include "denhartog/reference/sliding.hpp"

namespace denhartog {
namespace {

using namespace reference;

// All displacements at an instant, then all velocities.
using MotionInBalls = std::function<BallMatrix(const Ball& tau)>;

constexpr double rounding = 1e-15; // more than that to a double

// The number as it is handed out: zero where it may be zero, as the velocity of a contact at rest. It is off by twice the radius of
// the ball at most, and by the rounding.
double in_double(const Ball& x) { return x.may_vanish() ? 0 : static_cast<double>(x); }

// Whether a state is that of the answer at tau = 0.
void require_start(const BallMatrix& state, const Solution& solution, double tolerance) {
    const std::size_t N = solution.masses.size();
    const auto require = [&](const Ball& proved, const Certified& answered, double size) {
        if (abs(proved - Ball(answered.value)) > Ball(answered.error) + Ball(tolerance * size))
            throw Disproved({Why::other_motion, 0});
    };
    for (std::size_t k = 0; k < N; ++k) {
        const double amplitude = solution.masses[k].amplitude.value;
        const Certified &x = solution.start->x[k], &v = solution.start->x_prime[k];
        require(state(static_cast<slong>(k)), x, amplitude);
        require(state(static_cast<slong>(N + k)), v, std::max(amplitude, std::abs(v.value)));
    }
}

MotionInBalls motion_with_stops(const SceneSource& source, const Solution& solution, double tolerance, slong bits,
                                OrbitGuesses& guesses) {
    const auto scene = [&] { return damped_scene_in_balls(source); };
    return guesses.first_proved(source->effort, [&](const OrbitGuess& guess) -> MotionInBalls {
        const auto orbit = std::make_shared<const OrbitInPhases>(orbit_in_phases(scene, guess, bits));
        if (orbit->orbit.at.periods != solution.periods) throw Disproved({Why::other_motion, 1});
        const auto motion = [orbit, bits](const Ball& tau) {
            const Bits all(bits);
            return orbit->at(tau);
        };
        require_start(motion(Ball(0)), solution, tolerance);
        return motion;
    });
}

MotionInBalls motion_at_rest(const PointInBalls& p) {
    return [X = required_stuck(p).X](const Ball& tau) { return harmonic_in_balls(X, static_cast<slong>(X.size()), tau); };
}

MotionInBalls sliding_motion(const PointInBalls& p) {
    require_sliding(p);
    const auto motion = std::make_shared<const SlidingMotionInBalls>(*p.responses, *p.scene.beta);
    return [motion](const Ball& tau) { return motion->at(tau); };
}

// The samples; none where a number is not certain enough. A mass without a phase does not move.
std::optional<std::vector<State>> samples_of(const MotionInBalls& motion, const Solution& solution,
                                             const std::vector<double>& tau, double tolerance) {
    const std::size_t N = solution.masses.size();
    std::vector<State> states;
    std::vector<double> unsure(N, 0), fastest(N, 0);
    for (const double instant : tau) {
        const BallMatrix Z = motion(Ball(instant));
        State& state = states.emplace_back(at_rest(N));
        for (std::size_t k = 0; k < N; ++k) {
            const SolvedMass& mass = solution.masses[k];
            if (!mass.phase) continue;
            const Ball &x = Z(static_cast<slong>(k)), &v = Z(static_cast<slong>(N + k));
            const double allowed = mass.amplitude.error + (tolerance - rounding) * mass.amplitude.value;
            if (!(2 * x.radius() <= allowed && v.finite())) return std::nullopt;
            state.x[k] = in_double(x);
            state.x_prime[k] = in_double(v);
            unsure[k] = std::max(unsure[k], 2 * v.radius());
            fastest[k] = std::max(fastest[k], std::abs(state.x_prime[k]));
        }
    }
    for (std::size_t k = 0; k < N; ++k) {
        const Certified& amplitude = solution.masses[k].amplitude;
        if (unsure[k] > amplitude.error + (tolerance - rounding) * std::max(fastest[k], amplitude.value)) return std::nullopt;
    }
    return states;
}

} // namespace

std::vector<State> samples_by_reference(const SceneSource& source, const Solution& solution, const std::vector<double>& tau,
                                        double tolerance, const std::function<std::vector<OrbitGuess>()>& made) {
    OrbitGuesses guesses(made);
    std::optional<std::vector<State>> states;
    with_enough_bits(source, 128, 1024, [&](const SceneSource& paid, slong bits, bool) {
        const auto motion = [&] {
            if (solution.start) return motion_with_stops(paid, solution, tolerance, bits, guesses);
            const PointInBalls p = point_in_balls(paid, !solution.rest_interval);
            return solution.rest_interval ? motion_at_rest(p) : sliding_motion(p);
        };
        states = samples_of(motion(), solution, tau, tolerance);
        return states.has_value();
    });
    return *states;
}

} // namespace denhartog
#endif

// Further questions about the motion of an answer, proved: samples of it, what it dissipates, and the invariant points of a
// system. Each begins with the point of the answer in enough bits, see `reference_point.cpp`.
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "denhartog/answer/certify.hpp"
#include "denhartog/answer/reference.hpp"
#include "denhartog/answer/reference_point.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/reference/energy.hpp"
#include "denhartog/reference/invariant_points.hpp"
#include "denhartog/reference/orbit.hpp"
#include "denhartog/reference/sliding.hpp"

namespace denhartog {
namespace {

using namespace reference;

// All displacements at an instant, then all velocities.
using MotionInBalls = std::function<BallMatrix(const Ball& tau)>;

constexpr double rounding = 1e-15; // more than that to a double

// The number as it is handed out: zero where it may be zero, as the velocity of a contact at rest. It is off by twice the radius
// of the ball at most, and by the rounding.
double sample_of(const Ball& x) { return x.may_vanish() ? 0 : static_cast<double>(x); }

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
    return [r = *p.responses, motion = sliding_motion_in_balls(*p.responses, *p.scene.beta)](const Ball& tau) {
        return state_in_balls(r, motion, tau);
    };
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
            state.x[k] = sample_of(x);
            state.x_prime[k] = sample_of(v);
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

// Whether an orbit is that of the answer: its period, its stops, and the amplitude of its contact.
void require_same_motion(const OrbitInPhases& motion, const EnergiesInBalls& e, const Solution& solution) {
    const OrbitUnknowns& at = motion.orbit.at;
    slong stops = 0;
    for (slong i = 1; i <= at.m(); ++i) stops += at.direction(i) == 0 ? (at.mirrored ? 2 : 1) : 0;
    if (at.periods != solution.periods || stops != static_cast<slong>(solution.stops.size()))
        throw Disproved({Why::other_motion, 1});
    const Certified& X = (solution.between ? *solution.between : mass_of(solution, solution.contact)).amplitude;
    if (abs(e.amplitude - Ball(X.value)) > Ball(X.error) + Ball(1e-6 * X.value)) throw Disproved({Why::other_motion, 0});
}

EnergiesInBalls energies_in_balls(const SceneSource& source, const Solution& solution, slong bits, OrbitGuesses& guesses) {
    const Ball d = motion_of_base_in_frame(source->in_double().system.base_motion);
    if (solution.start)
        return guesses.first_proved(source->effort, [&](const OrbitGuess& guess) {
            const auto scene = [&] { return damped_scene_in_balls(source); };
            const OrbitInPhases motion = orbit_in_phases(scene, guess, bits);
            const Bits all(bits);
            EnergiesInBalls e = energies_of_orbit(scene(), motion, d);
            require_same_motion(motion, e, solution);
            return e;
        });
    const PointInBalls p = point_in_balls(source, !solution.rest_interval);
    if (solution.rest_interval) return energies_of_rest(p.scene, required_stuck(p), d);
    require_sliding(p);
    return energies_of_sliding(p.scene, *p.responses, d);
}

// Zero, within what the number may be, where it may vanish.
Ball about_zero(const Ball& x) { return x.may_vanish() && x.finite() ? widened(Ball(0), upper_bound_of(abs(x))) : x; }

// Numbers that may vanish have their digits beside the unit that they are in.
Certified written(const Ball& x, WrittenNumbers& w) { return x.may_vanish() ? w.absolute(about_zero(x)) : w.relative(x); }

EquivalentDamping equivalent_damping(const EnergiesInBalls& e, const Ball& r, const Ball& beta, WrittenNumbers& w) {
    const Ball c = e.contact / (pi<Ball>() * r * e.amplitude * e.amplitude), textbook = 4 * beta * e.amplitude;
    EquivalentDamping all{written(c, w), written(Ball(c / 2), w), written(textbook, w), {}, {}, {}};
    all.textbook_energy_error = beta.is_zero() ? w.shown(Ball(0)) : w.absolute(about_zero((textbook - e.contact) / e.contact));
    if (!e.by_textbooks) return all;
    all.textbook_amplitude = w.relative(*e.by_textbooks);
    all.textbook_amplitude_error = w.absolute(about_zero((*e.by_textbooks - e.amplitude) / e.amplitude));
    return all;
}

Ball end_of_range(const std::string& text) {
    Ball value;
    if (number_from_text(text, value) != NumberFault::none) throw InputError("the range of r", "must be two numbers", text);
    return value;
}

// The points as they are written, and whether each has its digits.
std::vector<InvariantPointsOfMass<Certified>> written(const std::vector<InvariantPointsOfMass<Ball>>& found, WrittenNumbers& w) {
    std::vector<InvariantPointsOfMass<Certified>> masses;
    for (const InvariantPointsOfMass<Ball>& mass : found) {
        masses.push_back({mass.mass, {}, {}});
        for (const InvariantPoint<Ball>& p : mass.points) {
            const Certified r = w.relative(p.r);
            masses.back().points.push_back({r, w.mass(p.amplitude, std::nullopt, false, Ball(1)).amplitude, p.kind});
        }
        for (const UndecidedStretch<Ball>& u : mass.undecided)
            masses.back().undecided.push_back({w.shown(u.from), w.shown(u.to)});
    }
    return masses;
}

std::size_t stretches(const std::vector<InvariantPointsOfMass<Certified>>& masses) {
    std::size_t count = 0;
    for (const InvariantPointsOfMass<Certified>& mass : masses) count += mass.undecided.size();
    return count;
}

} // namespace

Tried<std::vector<State>> samples_by_reference(const SceneSource& source, const Solution& solution,
                                               const std::vector<double>& tau, double tolerance,
                                               const std::function<std::vector<OrbitGuess>()>& made) {
    OrbitGuesses guesses(made);
    return with_more_bits(source, first_bits, most_bits, [&](const SceneSource& paid, slong bits, bool) {
        const auto motion = [&] {
            if (solution.start) return motion_with_stops(paid, solution, tolerance, bits, guesses);
            const PointInBalls p = point_in_balls(paid, !solution.rest_interval);
            return solution.rest_interval ? motion_at_rest(p) : sliding_motion(p);
        };
        return samples_of(motion(), solution, tau, tolerance);
    });
}

Energies energies_by_reference(const SceneSource& source, const Solution& solution, int digits,
                               const std::function<std::vector<OrbitGuess>()>& made) {
    OrbitGuesses guesses(made);
    Energies all;
    const slong first = bits_for(digits);
    require(
        with_enough_bits(source, first, std::max<slong>(8192, 4 * first), [&](const SceneSource& paid, slong bits, bool last) {
            WrittenNumbers w(digits, last);
            const EnergiesInBalls e = energies_in_balls(paid, solution, bits, guesses);
            const auto energy = [&](const Ball& W) {
                w.beside(W, e.at_most.may_vanish() ? Ball(1) : e.at_most);
                return w.shown(about_zero(W));
            };
            const SceneInBalls s = scene_as_given(paid);
            all = {energy(e.contact), energy(e.dampers), written(e.friction, w), written(e.on_base, w), {}};
            if (!e.amplitude.may_vanish()) all.equivalent = equivalent_damping(e, s.r, s.beta.value(), w);
            return w.enough();
        }));
    return all;
}

std::vector<InvariantPointsOfMass<Certified>> invariant_points(const SceneSource& source, const RangeInText& range,
                                                               std::optional<int> asked_for) {
    const System<double>& system = source->in_double().system;
    if (system.base_motion == BaseMotion::wall)
        throw InputError(
            "base_motion",
            "must not be \"wall\" for invariant points: (87) is for one load at all frequencies, and in the frame of "
            "the wall the inertia of the masses loads them, in proportion to r^2",
            "wall");
    if (!system.load_phases.empty() &&
        system.base_motion == BaseMotion::none) // of a base alone damping, left out here, makes them
        throw InputError("load_phases", "must not be given for invariant points: (87) is for forces in phase", "");
    const int digits = aim_of(asked_for).digits;
    const slong first = bits_for(digits);
    const slong most = asked_for ? std::max<slong>(1024, 4 * first) : 2 * first;
    std::size_t undecided_before = 0;
    std::vector<InvariantPointsOfMass<Certified>> masses;
    require(with_enough_bits(source, first, most, [&](const SceneSource& paid, slong, bool last) {
        WrittenNumbers w(digits, last);
        masses = written(invariant_points_in_balls(scene_as_given(paid), end_of_range(range.from), end_of_range(range.to)), w);
        // A stretch that twice the bits leave undecided will stay so.
        const std::size_t undecided = stretches(masses), before = std::exchange(undecided_before, undecided);
        return w.enough() && (undecided == 0 || undecided == before || last || is_exhausted(paid->effort));
    }));
    return masses;
}

} // namespace denhartog

#if DENHARTOG_REFERENCE
#include <algorithm>

#include "denhartog/answer/printed.hpp"
#include "denhartog/answer/reference.hpp"
#include "denhartog/answer/reference_attempts.hpp"
#include "denhartog/answer/reference_point.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/reference/energy.hpp"

namespace denhartog {
namespace {

using namespace reference;

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

} // namespace

Energies energies_by_reference(const SceneSource& source, const Solution& solution, int digits,
                               const std::function<std::vector<OrbitGuess>()>& made) {
    OrbitGuesses guesses(made);
    Energies all;
    const slong first = bits_for(digits);
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
    });
    return all;
}

} // namespace denhartog
#endif

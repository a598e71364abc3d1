#include "denhartog/answer/sliding_solution.hpp"
#include "denhartog/scene/point_rules.hpp"

#include <algorithm>
#include <utility>

namespace denhartog {
namespace {

using Number = Bounded<double>;

SolvedMass solved_mass(const MassResponse<Number>& m, bool with_motion) {
    SolvedMass mass{certified(m.amplitude), std::nullopt, std::nullopt};
    if (m.amplitude.x > m.amplitude.e) mass.phase = certified(m.phase);
    const Number instant(m.instant.x, mass.phase ? m.instant.e : pi<double>()); // a mass that does not move has none
    if (with_motion)
        mass.sliding = SlidingOfMass{certified(m.x0), certified(m.v0), certified(instant), certified(m.amplitude_monoharmonic),
                                     certified(m.phase_monoharmonic)};
    return mass;
}

// Writes a point into an answer: regime, limits and masses.
void write_point(const Scene<double>& scene, SlidingPoint& point, Asked asked, Solution& s) {
    const Boundary<Number>& b = point.boundary;
    s.limits = Limits{certified(b.exact), certified(b.paper), certified(b.approximate), std::nullopt, b.binding};
    if (b.sticking) s.limits->sticking = certified(*b.sticking);
    if (!point.regime) return;
    s.regime = std::move(*point.regime);
    RegimeBoundary<Number> by_56 = b;
    by_56.exact = b.paper;
    const Number beta(*scene.beta);
    const Regime other = regime_of(by_56, beta);
    if (other != regime_of(static_cast<const RegimeBoundary<Number>&>(b), beta)) s.regime_by_56 = other;
    if (!point.state) return;
    s.masses.reserve(point.state->masses.size());
    for (const MassResponse<Number>& m : point.state->masses) s.masses.push_back(solved_mass(m, asked == Asked::motion));
}

} // namespace

Solution sliding_solution(const SceneSource& source, const SlidingQuestion& question) {
    const Aim aim = aim_of(question.digits);
    const Scene<double>& scene = source->in_double();
    if (!question.modes) check(scene);
    (void)frequency_ratio_of(scene);
    const auto modes = question.modes ? question.modes : modes_with_errors(scene.system);
    // Where mu > 1 the motion from rest may be the sliding one.
    const bool motion = question.asked != Asked::regime || scene.mu > 1;
    const bool limits = question.asked == Asked::motion || question.asked == Asked::regime;
    SlidingPoint point = sliding_point(scene, *modes, {motion, limits, question.only});
    Solution s;
    s.asked = question.asked;
    s.contact = scene.system.contact;
    s.r = exactly(*scene.r);
    s.mu = exactly(scene.mu);
    if (scene.beta) s.beta = exactly(*scene.beta);
    write_point(scene, point, question.asked, s);
    s.method = {point.state ? "closed form" : "boundary of the sliding regime", "double", verdict(point.attempted, aim)};
    s.relative_error = point.attempted.relative;
    s.digits_reached = s.relative_error <= aim.tolerance;
    return s;
}

} // namespace denhartog

#include "denhartog/answer/sliding_solution.hpp"
#include "denhartog/scene/point_rules.hpp"

#include <algorithm>
#include <utility>

namespace denhartog {
namespace {

template <class T>
SolvedMass solved_mass(const MassResponse<Bounded<T>>& m, int digits, bool with_motion) {
    const auto number = [digits](const Bounded<T>& x) { return certified(x, digits); };
    SolvedMass mass{number(m.amplitude), std::nullopt, std::nullopt};
    if (m.amplitude.x > m.amplitude.e) mass.phase = number(m.phase);
    const Bounded<T> instant(m.instant.x, mass.phase ? m.instant.e : pi<T>()); // a mass that does not move has none
    if (with_motion)
        mass.sliding = SlidingOfMass{number(m.x0), number(m.v0), number(instant), number(m.amplitude_monoharmonic),
                                     number(m.phase_monoharmonic)};
    return mass;
}

} // namespace

template <class T>
void write_point(const Scene<T>& scene, SlidingPoint<T>& point, int digits, Asked asked, Solution& s) {
    const auto number = [digits](const Bounded<T>& x) { return certified(x, digits); };
    const Boundary<Bounded<T>>& b = point.boundary;
    s.limits = Limits{number(b.exact), number(b.paper), number(b.approximate), std::nullopt, b.binding};
    if (b.sticking) s.limits->sticking = number(*b.sticking);
    if (!point.regime) return;
    s.regime = std::move(*point.regime);
    RegimeBoundary<Bounded<T>> by_56 = b;
    by_56.exact = b.paper;
    const Bounded<T> beta(*scene.beta);
    const Regime other = regime_of(by_56, beta);
    s.regime_by_56 =
        other != regime_of(static_cast<const RegimeBoundary<Bounded<T>>&>(b), beta) ? std::optional(other) : std::nullopt;
    s.masses.clear();
    if (!point.state) return;
    s.masses.reserve(point.state->masses.size());
    for (const MassResponse<Bounded<T>>& m : point.state->masses)
        s.masses.push_back(solved_mass(m, digits, asked == Asked::motion));
}

Solution sliding_solution(const SceneSource& source, const SlidingQuestion& question) {
    const Aim aim = aim_of(question.digits);
    const Scene<double>& scene = source->in_double();
    if (question.modes == nullptr) check(scene);
    (void)frequency_ratio_of(scene);
    const QuestionEffort effort(number_of_masses(scene.system));
    Solution s;
    s.asked = question.asked;
    s.contact = scene.system.contact;
    const auto attempt = [&]<class T>(std::type_identity<T>) {
        SceneIn<T> in;
        const Scene<T>* place = &in.scene;
        std::optional<BoundedModes<T>> own;
        BoundedModes<T>* modes = nullptr;
        if constexpr (std::same_as<T, double>)
            if (question.modes != nullptr) {
                place = &scene;
                modes = question.modes;
            }
        if (modes == nullptr) {
            in = scene_with_modes<T>(source);
            modes = &own.emplace(in.basis, as_input(*in.scene.r));
        }
        // Where mu > 1 the motion from rest may be the sliding one.
        const bool motion = question.asked != Asked::regime || scene.mu > 1;
        const bool limits = question.asked == Asked::motion || question.asked == Asked::regime;
        std::optional<Boundary<Bounded<T>>> without_coupling;
        if constexpr (!std::same_as<T, double>) without_coupling = boundary_without_coupling(source, in, aim.digits);
        SlidingPoint<T> point = sliding_point(*place, *modes, {motion, limits, question.only, aim.digits}, without_coupling);
        const auto write = [&](Solution& to) {
            to.r = exactly(*place->r, aim.digits);
            to.mu = exactly(place->mu, aim.digits);
            if (place->beta) to.beta = exactly(*place->beta, aim.digits);
            write_point(*place, point, aim.digits, question.asked, to);
            to.method.model = point.state ? "closed form" : "boundary of the sliding regime";
        };
        if constexpr (std::same_as<T, double>) {
            write(s);
        } else {
            Solution to = s; // what double answered stays where a number is refused
            write(to);
            s = std::move(to);
        }
        return point.attempted;
    };
    Certainty found = certify(aim, attempt, highest_precision(aim, number_of_masses(scene.system)));
    s.method.precision = name(found.precision);
    s.method.why = std::move(found.why);
    s.relative_error = found.relative;
    s.digits_reached = found.relative <= aim.tolerance;
    return s;
}

template void write_point(const Scene<double>&, SlidingPoint<double>&, int, Asked, Solution&);
template void write_point(const Scene<Real50>&, SlidingPoint<Real50>&, int, Asked, Solution&);
template void write_point(const Scene<Real100>&, SlidingPoint<Real100>&, int, Asked, Solution&);

} // namespace denhartog

#if DENHARTOG_REFERENCE
#include "denhartog/answer/reference.hpp"

#include <algorithm>

#include "denhartog/answer/certify.hpp"
#include "denhartog/answer/printed.hpp"
#include "denhartog/answer/reference_attempts.hpp"
#include "denhartog/answer/reference_point.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/reference/invariant_points.hpp"

namespace denhartog {
namespace {

using namespace reference;

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
            const bool rests = w.does_not_move(p.amplitude, Ball(1));
            masses.back().points.push_back(
                {w.relative(p.r), rests ? w.unmoved(p.amplitude).amplitude : w.relative(p.amplitude), p.kind});
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
    with_enough_bits(source, first, most, [&](const SceneSource& paid, slong, bool last) {
        WrittenNumbers w(digits, last);
        masses = written(invariant_points_in_balls(scene_as_given(paid), end_of_range(range.from), end_of_range(range.to)), w);
        // What twice the bits leave undecided as before will stay so.
        const std::size_t undecided = stretches(masses), before = std::exchange(undecided_before, undecided);
        return w.enough() && (undecided == 0 || undecided == before || last || is_exhausted(paid->effort));
    });
    return masses;
}

} // namespace denhartog
#endif

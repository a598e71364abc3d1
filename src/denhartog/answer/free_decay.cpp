#if DENHARTOG_REFERENCE
#include "denhartog/answer/from_a_start.hpp"

#include <cmath>
#include <string>

#include "denhartog/answer/printed.hpp"
#include "denhartog/answer/reference_point.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/reference/free_decay.hpp"
#include "denhartog/scene/point_rules.hpp"

namespace denhartog {
namespace {

using namespace reference;

constexpr slong first_bits_of_motion = 128, most_bits_of_motion = 1024;
constexpr double enough_of_largest = 1e-17; // error of a number before it is rounded, beside the largest of its kind

// K^-1 s, zero without a constant load.
BallMatrix static_displacements(const SceneSource& source, const BallMatrix& K) {
    Scene<Ball> scene;
    source->in_balls(scene);
    BallMatrix s(K.rows(), 1), x(K.rows(), 1);
    if (scene.static_load.empty()) return x;
    for (slong k = 0; k < K.rows(); ++k) s(k) = scene.static_load[static_cast<std::size_t>(k)];
    if (!solved(K, s, x)) throw Unproved("the stiffness matrix is not proved regular");
    return x;
}

Certified as_number(const Ball& x) { return printed(x, most_digits_of_a_double); }

// Whether numbers have their digits beside the largest of them.
bool are_certain(const std::vector<Ball>& x) {
    Ball largest(0), error(0);
    for (const Ball& each : x) {
        largest = larger(largest, abs(each));
        error = larger(error, radius_of(each));
    }
    return error.is_zero() || error < largest * Ball(enough_of_largest);
}

bool is_certain(const FreeDecayInBalls& motion) {
    std::vector<Ball> instants, displacements{motion.rest_at};
    for (const TurnInBalls& turn : motion.turns) {
        instants.push_back(turn.tau);
        displacements.push_back(turn.x);
    }
    for (const StopInBalls& stop : motion.stops) instants.push_back(stop.end);
    displacements.insert(displacements.end(), motion.x.begin(), motion.x.end());
    return are_certain(instants) && are_certain(displacements);
}

} // namespace

std::vector<Certified> place_of_rest(const SceneSource& source) {
    const Scene<double>& scene = source->in_double();
    std::vector<Certified> places;
    if (scene.static_load.empty()) return places;
    with_enough_bits(source, first_bits_of_motion, most_bits_of_motion, [&](const SceneSource& paid, slong, bool last) {
        const BallMatrix x = static_displacements(paid, scene_as_given(paid).K);
        std::vector<Ball> all;
        for (slong k = 0; k < x.rows(); ++k) all.push_back(x(k));
        places.clear();
        for (const Ball& each : all) places.push_back(as_number(each));
        return last || are_certain(all);
    });
    return places;
}

FreeDecay free_decay(const SceneSource& source, const State& start, const std::optional<double>& until) {
    const Scene<double>& scene = source->in_double();
    (void)frequency_ratio_of(scene);
    if (!(friction_ratio_of(scene) > 0))
        throw InputError("friction", "must be positive: without it the free motion does not end", number_to_text(*scene.beta));
    const std::size_t N = number_of_masses(scene.system);
    for (const std::vector<double>* each : {&start.x, &start.x_prime}) {
        if (each->size() != N)
            throw InputError("start", "must have " + std::to_string(N) + " displacements and velocities",
                             std::to_string(each->size()));
        for (const double x : *each)
            if (!std::isfinite(x)) throw InputError("start", "must be finite", number_to_text(x));
    }
    FreeDecay out;
    with_enough_bits(source, first_bits_of_motion, most_bits_of_motion, [&](const SceneSource& paid, slong, bool last) {
        const SceneInBalls s = damped_scene_in_balls(paid);
        const BallMatrix at_rest = static_displacements(paid, s.K);
        BallMatrix y(s.N(), 1), y_prime(s.N(), 1);
        for (slong k = 0; k < s.N(); ++k) {
            y(k) = Ball(start.x[static_cast<std::size_t>(k)]) - at_rest(k);
            y_prime(k) = Ball(start.x_prime[static_cast<std::size_t>(k)]);
        }
        FreeDecayInBalls motion = free_decay_in_balls(s, y, y_prime, until ? std::optional(Ball(*until)) : std::nullopt, last);
        const Ball shift = (transposed(s.w) * at_rest)(0);
        motion.rest_at += shift;
        for (TurnInBalls& turn : motion.turns) turn.x += shift;
        for (StopInBalls& stop : motion.stops) stop.x += shift;
        for (slong k = 0; motion.at_rest && k < s.N(); ++k) motion.x[static_cast<std::size_t>(k)] += at_rest(k);
        if (!last && !is_certain(motion)) return false;
        out = {motion.at_rest, {}, {}, as_number(motion.rest_from), as_number(motion.rest_at), {}, motion.others_come_to_rest,
               motion.on_limit};
        for (const TurnInBalls& turn : motion.turns) out.turns.push_back({as_number(turn.tau), as_number(turn.x)});
        for (const StopInBalls& stop : motion.stops)
            out.stops.push_back({as_number(stop.start), as_number(stop.end), as_number(stop.x)});
        for (const Ball& x : motion.x) out.masses.push_back(as_number(x));
        return true;
    });
    return out;
}

} // namespace denhartog
#endif

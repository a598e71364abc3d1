// How near must a motion be to one that slides throughout, to slide for ever itself? With mu > 1 friction can drive two motions
// apart at a stop. `slides_within` decides for one distance, `sliding_reach` looks for the largest one.
//
// Let a motion be at the distance d, in the norm of the energy, from one that slides throughout. As long as it does not stick
// either, friction and damping oppose the difference of both velocities, and d does not grow. The velocities of the two contacts
// then differ by at most |e_j| d, so that this contact can stop only near a turning point of the other one; and the loads on them
// differ by at most c d. If the load on the other exceeds mu beta by more than that near its turning points, this never sticks.
#include <algorithm>

#include "denhartog/stick_slip/contact_phases.hpp"

namespace denhartog {
namespace {

// Largest change of the load on the contact at a turning point, for a unit of distance, in units of P.
double load_of_distance(const ContactPhases& c) {
    const auto n = static_cast<Eigen::Index>(c.N);
    const Column& phi_j = c.system->contact_shape;
    Column weights(2 * n);
    weights.head(n) = phi_j.cwiseProduct(column(c.sliding.omega_0));
    if (c.sliding.coupled())
        weights.tail(n) = c.sliding.D.transpose() * phi_j;
    else
        weights.tail(n) = 2 * phi_j.cwiseProduct(column(c.sliding.decay));
    return c.inertia * weights.norm();
}

// Whether bounds prove that no motion within a distance of the sliding one ever sticks, over the half-period from a turning point,
// where its velocity is `start`; with a load beyond `needed` the contact cannot stick, within the distance.
bool slides_within(ContactPhases& c, int direction, const Jet& start, double needed, double distance) {
    const double speed = c.system->contact_shape.norm() * distance;
    const double half = pi<double>();
    // The load that drives the contact on, after the turning point, and before that at the end, which is its mirror image.
    const auto load = [&](const Jet& jet, int end) { return end * (c.e.beta + c.inertia * jet.f[1]); };
    const auto rate = [&](const Jet& jet, double length) { return c.inertia * (jet.second + jet.growth * length); };
    const double margin = load(start, 1) - needed;
    if (!(margin > 0)) return false;
    const double room = margin / c.inertia;
    double t = std::min(half / 8, room / (start.second + sqrt(start.second * start.second + 4 * start.growth * room)));
    Jet before = c.velocity(direction, half - t);
    if (!(rate(before, t) * t < margin)) return false;
    Jet after = c.velocity(direction, t);
    while (!(after.f[0] > speed && before.f[0] > speed)) { // the contact may be at rest there: the load has to last longer
        if (t > half / 8) return false;
        const Jet later = c.velocity(direction, 2 * t), earlier = c.velocity(direction, half - 2 * t);
        if (!(load(after, 1) + load(later, 1) - rate(after, t) * t > 2 * needed)) return false;
        if (!(load(before, -1) + load(earlier, -1) - rate(earlier, t) * t > 2 * needed)) return false;
        after = later;
        before = earlier;
        t = 2 * t;
    }
    auto above = [&](double at) {
        Jet jet = c.velocity(direction, at);
        jet.f[0] -= speed;
        return jet;
    };
    double step = half / 4;
    return !first_crossing(above, t, half - t, 0, step, *c.effort);
}

} // namespace

double ExactSolver::sliding_reach(std::size_t phase) {
    constexpr int most_halvings = 10;
    work_->stand_at(phase);
    ContactPhases& c = *work_;
    const int direction = work_->motion.phases[phase].direction;
    const Jet start = c.velocity(direction, 0);
    const double holds = c.e.mu * c.e.beta, unit = load_of_distance(c);
    double distance = (c.e.beta + c.inertia * start.f[1] - holds) / unit;
    for (int n = 0; n < most_halvings; ++n) {
        distance = distance / 2;
        if (slides_within(c, direction, start, holds + unit * distance, distance)) return distance;
    }
    return 0;
}

} // namespace denhartog

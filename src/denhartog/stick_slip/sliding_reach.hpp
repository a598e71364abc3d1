/// @file
/// @brief How near a motion has to be to one that slides without a stop so that it slides for ever too, whatever mu is.
///
/// While neither of two motions sticks, friction opposes the difference of their velocities, whether or not their contacts move to
/// the same side, and damping does too: their distance in the norm of the energy, d, never grows. Then the contact of the one is
/// slower than \f$ |e_j|\,d \f$ only where the other's is near its turning point too, and the load on it there differs by
/// \f$ c\,d \f$ at most. Where that load is beyond \f$ \mu\beta \f$ for all of these instants, the contact cannot stick.
#pragma once

#include "denhartog/stick_slip/contact_phases.hpp"

namespace denhartog {

/// @brief Largest change of the load on the contact at a turning point, for a unit of distance.
/// @param c  the phases of the system
/// @return   the change, units of P
template <class T>
[[nodiscard]] T load_of_distance(const ContactPhases<T>& c) {
    const auto n = static_cast<Eigen::Index>(c.N);
    const Column<T> phi_j = c.system->basis.phi.row(static_cast<Eigen::Index>(c.system->contact.index)).transpose();
    Column<T> weights(2 * n);
    weights.head(n) = phi_j.cwiseProduct(column(c.sliding.omega_0));
    if (c.sliding.coupled())
        weights.tail(n) = c.sliding.D.transpose() * phi_j;
    else
        weights.tail(n) = T(2) * phi_j.cwiseProduct(column(c.sliding.decay));
    return c.inertia * weights.norm();
}

/// @brief Whether no motion within a distance of the sliding motion ever sticks, over the half-period from a turning point.
/// @param c          the phases, at the start of the one that lasts half a period and leads to the mirrored turning point
/// @param direction  1 or -1, that of the phase
/// @param start      velocity at the start of the phase
/// @param needed     load beyond which the contact cannot stick, within the distance
/// @param distance   in the norm of the energy
/// @return           true where bounds prove it
template <class T>
[[nodiscard]] bool slides_within(ContactPhases<T>& c, int direction, const Jet<T>& start, const T& needed, const T& distance) {
    using std::sqrt;
    const T speed = c.system->basis.phi.row(static_cast<Eigen::Index>(c.system->contact.index)).norm() * distance;
    const T half = pi<T>();
    // The load that drives the contact on, after the turning point, and before that at the end, which is its mirror image.
    const auto load = [&](const Jet<T>& jet, int end) { return end * (c.e.beta + c.inertia * jet.f[1]); };
    const auto rate = [&](const Jet<T>& jet, const T& length) { return c.inertia * (jet.second + jet.growth * length); };
    const T margin = load(start, 1) - needed;
    if (!(margin > 0)) return false;
    const T room = margin / c.inertia;
    T t = std::min(T(half / 8), T(room / (start.second + sqrt(T(start.second * start.second + 4 * start.growth * room)))));
    Jet<T> before = c.velocity(direction, T(half - t));
    if (!(rate(before, t) * t < margin)) return false;
    Jet<T> after = c.velocity(direction, t);
    while (!(after.f[0] > speed && before.f[0] > speed)) { // the contact may be at rest there: the load has to last longer
        if (t > half / 8) return false;
        const Jet<T> later = c.velocity(direction, T(2 * t)), earlier = c.velocity(direction, T(half - 2 * t));
        if (!(load(after, 1) + load(later, 1) - rate(after, t) * t > 2 * needed)) return false;
        if (!(load(before, -1) + load(earlier, -1) - rate(earlier, t) * t > 2 * needed)) return false;
        after = later;
        before = earlier;
        t = 2 * t;
    }
    auto above = [&](const T& at) {
        Jet<T> jet = c.velocity(direction, at);
        jet.f[0] -= speed;
        return jet;
    };
    T step = half / 4;
    return !first_crossing(above, t, T(half - t), 0, step, *c.effort);
}

/// @brief A distance within which no motion ever sticks. @param c the phases @param direction as above
/// @return the distance, in the norm of the energy, no less than half the largest that bounds prove; 0 where that is small
template <class T>
[[nodiscard]] T sliding_reach(ContactPhases<T>& c, int direction) {
    constexpr int most_halvings = 10;
    const Jet<T> start = c.velocity(direction, T(0));
    const T holds = c.e.mu * c.e.beta, unit = load_of_distance(c);
    T distance = (c.e.beta + c.inertia * start.f[1] - holds) / unit;
    for (int n = 0; n < most_halvings; ++n) {
        distance = distance / 2;
        if (slides_within(c, direction, start, T(holds + unit * distance), distance)) return distance;
    }
    return T(0);
}

} // namespace denhartog

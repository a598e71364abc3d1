/// @file
/// @brief A motion with stops that double found, in 50 digits. Included by sources only.
#pragma once

#include <algorithm>

#include "denhartog/answer/sliding_point.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/orbit/periodic_orbit.hpp"

namespace denhartog {

/// @brief Whether the orbit found in 50 digits is the one that double had: both start at one place within the bound of double. The
/// stops are not compared, since some may be too short for double.
/// @param orbit  what was found
/// @param near   the orbit of double
/// @return       whether it is
[[nodiscard]] inline bool same_motion(const PeriodicOrbit<Real50>& orbit, const PeriodicOrbit<double>& near) {
    if (orbit.status != OrbitStatus::periodic || orbit.periods != near.periods || orbit.symmetric != near.symmetric) return false;
    return std::ranges::equal(orbit.start.x, near.start.x,
                              [&](const Real50& x, double there) { return abs(Real50(x - there)) <= near.error_bound; });
}

/// @brief The same orbit in 50 digits, for whoever takes it with its solver.
/// @param source  the scene
/// @param near    the orbit of double: its start, periods, symmetry and bound
/// @param how     what is asked of the orbit; how it is searched for is set here
/// @param take    called with the solver and the orbit
/// @throws        PrecisionError where 50 digits do not find it
template <class Take>
void find_in_50_digits(const SceneSource& source, const PeriodicOrbit<double>& near, OrbitSearch<Real50> how, const Take& take) {
    const SceneIn<Real50> in = scene_with_modes<Real50>(source);
    const ContactSystem<Real50> system = contact_system(in.scene.system);
    ExactSolver<Real50> solver(system, {*in.scene.r, *in.scene.beta, in.scene.mu});
    State<Real50> start;
    start.x.assign(near.start.x.begin(), near.start.x.end());
    start.x_prime.assign(near.start.x_prime.begin(), near.start.x_prime.end());
    how.periods_before = near.periods;
    how.follow_start = false;
    const PeriodicOrbit<Real50> orbit = periodic_orbit(solver, start, how);
    if (!same_motion(orbit, near))
        throw PrecisionError("the search in 50 digits does not find the motion that double precision found" +
                             (orbit.status == OrbitStatus::not_converged ? ": " + orbit.reason : ""));
    take(solver, orbit);
}

} // namespace denhartog

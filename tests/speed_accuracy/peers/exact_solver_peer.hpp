/// @file
/// @brief The exact solver on the chart in any number type.
#pragma once

#include <memory>

#include "denhartog/orbit/periodic_orbit.hpp"
#include "tests/speed_accuracy/peers/peer.hpp"

namespace denhartog::tests {

/// @brief A peer of the periodic orbit from rest, amplitude of the contact alone.
/// @param setting  name of the number type
/// @param convert  gives the system in T
/// @return         the peer
template <class T, class Convert>
[[nodiscard]] Peer exact_solver_peer(const std::string& setting, const Convert& convert) {
    return {"exact solver", setting, 0, [convert](const System<double>& system) {
                const auto prepared = std::make_shared<const ContactSystem<T>>(contact_system<T>(convert(system)));
                const auto solver = std::make_shared<ExactSolver<T>>(*prepared, Excitation<T>{T(1), T(0), T(1)});
                return [prepared, solver](const ChartPoint& point) {
                    using std::abs;
                    solver->set({T(point.r), T(point.beta), T(1)});
                    OrbitSearch<T> search;
                    search.contact_only = true;
                    search.with_stability = false;
                    const long before = phases_propagated();
                    const PeriodicOrbit<T> orbit = periodic_orbit(*solver, at_rest<T>(prepared->basis.r_n.size()), search);
                    PeerAnswer answer;
                    answer.evaluations = phases_propagated() - before;
                    answer.sticks = orbit.status == OrbitStatus::permanently_stuck || !orbit.stops.empty();
                    if (orbit.status == OrbitStatus::not_converged)
                        answer.ending = Ending::did_not_finish;
                    else if (orbit.status == OrbitStatus::periodic)
                        set_amplitude(answer, orbit.contact.amplitude);
                    else
                        set_amplitude(answer, T(abs(orbit.start.x[prepared->contact.index])));
                    return answer;
                };
            }};
}

} // namespace denhartog::tests

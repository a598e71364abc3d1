// Steady motions in 50 and 100 digits.
#include "tests/support/multiprecision.hpp" // first: what follows takes its functions

#include "denhartog/orbit/map_rounding.cpp"
#include "denhartog/orbit/orbit_record.cpp"
#include "denhartog/orbit/periodic_orbit.cpp"
#include "denhartog/orbit/stability.cpp"

namespace denhartog {

template MapRounding<Real50> rounding_of_map(const ExactSolver<Real50>&, const ExactMotion<Real50>&, const Real50&);
template Real50 rounding_of_jacobian(const ExactSolver<Real50>&, const ExactMotion<Real50>&, const Real50&);
template Real50 displacement_of_energy(const OrbitMap<Real50>&);
template std::optional<ErrorsOfOrbit<Real50>> errors_of(const OrbitMap<Real50>&);
template std::optional<PeriodicOrbit<Real50>> orbit_of(const OrbitMap<Real50>&, const State<Real50>&, const OrbitSearch<Real50>&);
template std::optional<PeriodicOrbit<Real50>> rest_of(OrbitMap<Real50>&, const LastingRest<Real50>&, const Real50&,
                                                      const OrbitSearch<Real50>&);
template PeriodicOrbit<Real50> periodic_orbit(ExactSolver<Real50>&, const State<Real50>&, const OrbitSearch<Real50>&);
template bool attracts(const OrbitMap<Real50>&);
template std::vector<Multiplier> multipliers_of_orbit(const OrbitMap<Real50>&, const ErrorsOfOrbit<Real50>&);
template StabilityOfRest stability_of_rest(const OrbitMap<Real50>&);

} // namespace denhartog

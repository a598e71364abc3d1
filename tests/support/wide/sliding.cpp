// The sliding motion in 50 and 100 digits.
#include "tests/support/multiprecision.hpp" // first: what follows takes its functions

#include "denhartog/search/largest_in_double.cpp"
#include "denhartog/sliding/boundary.cpp"
#include "denhartog/sliding/largest_demand.cpp"
#include "denhartog/sliding/instants_of_maxima.cpp"
#include "denhartog/sliding/regime.cpp"
#include "denhartog/sliding/steady_state.cpp"

namespace denhartog {

template Real50 sliding_demand(const ModeSums<Real50>&, const Real50&);
template Real100 sliding_demand(const ModeSums<Real100>&, const Real100&);
template Real50 instant_of_largest_demand(const ModeSums<Real50>&);
template Real100 instant_of_largest_demand(const ModeSums<Real100>&);
template std::vector<Real50> instants_of_demands(FrictionMotions<Real50>&);
template std::vector<Real100> instants_of_demands(FrictionMotions<Real100>&);
template Boundary<Real50> boundary(const ModeSums<Real50>&, const Real50&);
template Boundary<Real100> boundary(const ModeSums<Real100>&, const Real100&);
template InstantsOfMaxima<Real50> instants_of_maxima(FrictionMotions<Real50>&, const Real50&, std::optional<Mass>,
                                                     const std::vector<Real50>&);
template InstantsOfMaxima<Real100> instants_of_maxima(FrictionMotions<Real100>&, const Real100&, std::optional<Mass>,
                                                      const std::vector<Real100>&);
template Maximum<Real50> global_maximum(const Curve<Real50>&, const Real50&, const Real50&, const Real50&, Effort*, const Real50&,
                                        const Real50&);
template Maximum<Real100> global_maximum(const Curve<Real100>&, const Real100&, const Real100&, const Real100&, Effort*,
                                         const Real100&, const Real100&);
template std::vector<Place<Real50>> joined(std::vector<Place<Real50>>);
template std::vector<Place<Real50>> rivals(const std::vector<Place<Real50>>&, const Real50&, const Real50&, const Real50&);
template std::vector<Place<Real100>> joined(std::vector<Place<Real100>>);
template std::vector<Place<Real100>> rivals(const std::vector<Place<Real100>>&, const Real100&, const Real100&, const Real100&);
template Regime regime_of(const RegimeBoundary<Real50>&, const Real50&);
template bool on_boundary(const RegimeBoundary<Real50>&, const Real50&, const BoundaryError<Real50>&);
template bool on_boundary(const RegimeBoundary<Real100>&, const Real100&, const BoundaryError<Real100>&);
template RegimeAtPoint regime_at(const Boundary<Real50>&, const Real50&, const BoundaryError<Real50>&);
template RegimeAtPoint regime_at(const Boundary<Real100>&, const Real100&, const BoundaryError<Real100>&);
template Real50 wrapped(const Real50&);
template SteadyState<Real50> steady_state(const ModeSums<Real50>&, const RegimeBoundary<Real50>&, const Real50&,
                                          std::optional<Mass>);
template std::vector<Motion<Real50>> motions(const ModeSums<Real50>&, const SteadyState<Real50>&, std::span<const Real50>);
template Motion<Real50> motion(const ModeSums<Real50>&, const SteadyState<Real50>&, const Real50&);
template Real100 wrapped(const Real100&);
template SteadyState<Real100> steady_state(const ModeSums<Real100>&, const RegimeBoundary<Real100>&, const Real100&,
                                           std::optional<Mass>);
template std::vector<Motion<Real100>> motions(const ModeSums<Real100>&, const SteadyState<Real100>&, std::span<const Real100>);
template Motion<Real100> motion(const ModeSums<Real100>&, const SteadyState<Real100>&, const Real100&);
template SteadyState<Real100> with_maxima(const ModeSums<Real100>&, SteadyState<Real100>, const std::vector<Real100>&,
                                          std::optional<Mass>);
template SteadyState<Real50> with_maxima(const ModeSums<Real50>&, SteadyState<Real50>, const std::vector<Real50>&,
                                         std::optional<Mass>);
template SteadyState<Real50> steady_state_without_maxima(const ModeSums<Real50>&, const Real50&);
template SteadyState<Real100> steady_state_without_maxima(const ModeSums<Real100>&, const Real100&);

} // namespace denhartog

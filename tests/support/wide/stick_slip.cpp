// Motions with stops in 50 and 100 digits.
#include "tests/support/multiprecision.hpp" // first: what follows takes its functions

#include "denhartog/stick_slip/contact_system.cpp"
#include "denhartog/stick_slip/exact_motion.cpp"
#include "denhartog/stick_slip/lasting_rest.cpp"
#include "denhartog/stick_slip/stuck_response.cpp"

namespace denhartog {

template ContactSystem<Real50> contact_system(const System<Real50>&);
template ContactSystem<Real100> contact_system(const System<Real100>&);
template ContactSystem<Real50> contact_system(const System<Real50>&, const ModalBasis<Bounded<Real50>>&,
                                              const RoundedModes<Real50>*);
template class ExactSolver<Real50>;
template class ExactSolver<Real100>;
template class LastingRest<Real50>;
template StuckMass<Real50> motion_of(const Complex<Real50>&);
template StuckMass<Real100> motion_of(const Complex<Real100>&);
template StuckResponse<Real50> stuck_response(const StuckConfiguration<Real50>&, Mass, Mass, const Real50&);
template StuckResponse<Real100> stuck_response(const StuckConfiguration<Real100>&, Mass, Mass, const Real100&);
template std::optional<StuckChain<Real50>> stuck_chain(const System<Real50>&, const StuckConfiguration<Real50>&);
template StickingBoundary<Real50> sticking_boundary(const StuckResponse<Real50>&, const std::optional<StuckChain<Real50>>&,
                                                    const Real50&);
template std::optional<Real50> rest_interval(const StuckConfiguration<Real50>&, const StuckResponse<Real50>&, const Real50&,
                                             const Real50&);
template std::optional<Real100> rest_interval(const StuckConfiguration<Real100>&, const StuckResponse<Real100>&, const Real100&,
                                              const Real100&);

} // namespace denhartog

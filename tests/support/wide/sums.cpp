// Sums over modes in 50 and 100 digits.
#include "tests/support/multiprecision.hpp" // first: what follows takes its functions

#include "denhartog/sums/coupled_friction.cpp"
#include "denhartog/sums/coupled_sums.cpp"
#include "denhartog/sums/friction_motion.cpp"
#include "denhartog/sums/mode_sums.cpp"

namespace denhartog {

template class CoupledFriction<Real50>;
template class CoupledFriction<Real100>;
template ModeSums<Bounded<Real50>> coupled_sums(const System<Real50>&, const Bounded<Real50>&);
template class FrictionMotions<Real50>;
template class FrictionMotions<Real100>;
template std::vector<evaluation::FrictionMotion<Real50>> friction_motions(const ModeSums<Real50>&, const Real50&);
template std::vector<evaluation::FrictionMotion<Real100>> friction_motions(const ModeSums<Real100>&, const Real100&);
template ModeSums<Real50> mode_sums(const ModalBasis<Real50>&, Mass, Mass, const Real50&);
template ModeSums<Real100> mode_sums(const ModalBasis<Real100>&, Mass, Mass, const Real100&);
template bool contact_is_unmoved(const ModeSums<Real50>&);
template bool contact_is_unmoved(const ModeSums<Real100>&);
template bool stuck_system_resonates(const ModeSums<Real50>&);
template bool stuck_system_resonates(const ModeSums<Real100>&);

} // namespace denhartog

#include "denhartog/answer/coupled_damping.hpp"

#include <cmath>
#include <utility>

#include "denhartog/answer/modes_by_reference.hpp"
#include "denhartog/answer/modes_in_double.hpp"
#include "denhartog/model/modal_damping.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/sums/bounded_modes.hpp"

namespace denhartog {
namespace {

// The modes with the damping matrix as it is.
ModalBasis<double> modes_as_given(const SceneSource& source) {
    try {
        System<double> system = source->in_double().system;
        system.damping_tolerance = 0;
        return modal_basis(system);
    } catch (const PrecisionError&) {
        ModalBasis<Bounded<double>> basis = modes_by_reference(with_damping_tolerance(source, 0), true);
        if (!certainly_couples(basis)) leave_out_coupling(basis);
        return values_of(basis);
    }
}

} // namespace

std::optional<CoupledDamping> coupled_damping(const SceneSource& source) {
    const System<double>& system = source->in_double().system;
    if (system.damping_matrix.size() == 0) return std::nullopt;
    ModalBasis<double> basis = modes_as_given(source);
    if (!basis.coupled()) return std::nullopt;
    return CoupledDamping{basis.distance_from_classical > system.damping_tolerance, basis.distance_from_classical,
                          largest_coupling(basis.D), std::move(basis.zeta)};
}

} // namespace denhartog

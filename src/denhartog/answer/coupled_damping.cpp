#include "denhartog/answer/coupled_damping.hpp"

#include <utility>

#include "denhartog/answer/certify.hpp"
#include "denhartog/model/modal_damping.hpp"
#include "denhartog/scene/converted.hpp"

namespace denhartog {
namespace {

template <class T>
std::optional<CoupledDamping> in_number_type(const SceneSource& source) {
    System<T> system = scene_in<T>(source).system;
    const double tolerance = std::exchange(system.damping_tolerance, 0.0);
    const ModalBasis<T> basis = modal_basis(system);
    if (!basis.coupled()) return std::nullopt;
    const T rounding = rounding_of_modes<T>(basis.r_n.size()) * basis.D.cwiseAbs().maxCoeff();
    return CoupledDamping{basis.distance_from_classical > tolerance, static_cast<double>(basis.distance_from_classical),
                          static_cast<double>(largest_coupling(basis.D, rounding)), in_type<double>(basis.zeta)};
}

} // namespace

std::optional<CoupledDamping> coupled_damping(const SceneSource& source) {
    if (source->in_double().system.damping_matrix.size() == 0) return std::nullopt;
    std::optional<CoupledDamping> found;
    const auto attempt = [&]<class T>(std::type_identity<T>) {
        found = in_number_type<T>(source);
        return Attempted{0};
    };
    certify(aim_of({}), attempt, Precision::in_50_digits);
    return found;
}

} // namespace denhartog

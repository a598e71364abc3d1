/// @file
/// @brief What of a system whose damping couples the modes has the place of the sums over its modes.
#pragma once

#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/sums/bounded_modes.hpp"
#include "denhartog/sums/coupled_friction.hpp"

namespace denhartog {

/// @brief V, U, G, Y_jj, H_j of a system whose damping couples the modes; it has no modes, and their lists are empty.
/// @eq{33,34,35,64,65}
template <class T>
[[nodiscard]] ModeSums<Bounded<T>> coupled_sums(const System<T>& system, const Bounded<T>& r);

/// @brief The sums over modes with bounds of their errors, or what has their place where damping couples the modes. DomainError
/// at a pole of a mode without damping. @eq{33,34,35,64,65}
[[nodiscard]] inline ModeSums<Bounded<double>> bounded_sums(const System<double>& system,
                                                            const ModalBasis<Bounded<double>>& basis, const Bounded<double>& r) {
    return basis.coupled() ? coupled_sums(system, r) : mode_sums(basis, contact_row(system), load_row(system), r);
}

} // namespace denhartog

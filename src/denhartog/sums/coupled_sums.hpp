/// @file
/// @brief What of a system whose damping couples the modes has the place of the sums over its modes.
#pragma once

#include "denhartog/sums/coupled_friction.hpp"

namespace denhartog {

/// @brief V, U, G, Y_jj, H_j of a system whose damping couples the modes; it has no modes, and their lists are empty.
/// @eq{33,34,35,64,65}
/// @param system  the system, in the paper's form
/// @param r       frequency ratio with its error
/// @return        the sums, with bounds
/// @throws        as `CoupledFriction`
template <class T>
[[nodiscard]] ModeSums<Bounded<T>> coupled_sums(const System<T>& system, const Bounded<T>& r);

} // namespace denhartog

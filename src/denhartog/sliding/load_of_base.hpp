/// @file
/// @brief The load of a base or a wall that moves alone, at one frequency ratio.
///
/// With the absolute displacements \f$ \mathbf x \f$ of the masses and a base that moves by \f$ X\cos\tau \f$ springs and dampers
/// are strained by \f$ \mathbf x - \mathbf 1X\cos\tau \f$: the base loads the masses by
/// \f$ (\mathbf K + \mathrm ir\mathbf C)\mathbf 1 \f$ in units of \f$ P = k_1X \f$. In the frame of a wall that moves by
/// \f$ X\cos\tau \f$ the contact rubs against a wall at rest, the base moves by \f$ -X\cos\tau \f$, and inertia adds
/// \f$ r^2\mathbf M\mathbf 1 \f$.
#pragma once

#include "denhartog/scene/scene.hpp"

namespace denhartog {

/// @brief The system with a force and a phase of each mass, the load that its base or wall makes at a frequency ratio, with bounds
/// of what rounding and the modes make of it; the same system if the load does not depend on the frequency. InputError if `check`
/// throws; DomainError if the load vanishes; PrecisionError as `modal_basis`. @eq{6,7,19}
[[nodiscard]] System<double> with_load_at(const System<double>& system, double r);

} // namespace denhartog

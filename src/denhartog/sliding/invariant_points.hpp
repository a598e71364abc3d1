/// @file
/// @brief Invariant points of the displacement transmissibilities: frequency ratios at which friction does not matter, (87).
#pragma once

#include <vector>

#include "denhartog/scene/scene.hpp"

namespace denhartog {

/// @brief Why the amplitude of a mass does not depend on the friction ratio.
enum class InvariantPointKind {
    two_effects_cancel,      ///< (87): what friction does to the mass directly and by way of the contact's phase cancel
    friction_leaves_it_alone ///< U_k = 0: a factor that (87) divides out
};

/// @brief An invariant point of a mass.
template <class T>
struct InvariantPoint {
    T r;                     ///< frequency ratio, Eq. (10)
    T amplitude;             ///< |V_k| there: the monoharmonic amplitude (52) at every friction ratio, without damping
    InvariantPointKind kind; ///< which factor vanishes
};

/// @brief A stretch of frequency ratios in which it is not known whether there is an invariant point.
template <class T>
struct UndecidedStretch {
    T from; ///< its lower end
    T to;   ///< its upper end
};

/// @brief The invariant points of a mass within a range of frequency ratios.
template <class T>
struct InvariantPointsOfMass {
    Mass mass;                                  ///< the mass, k
    std::vector<InvariantPoint<T>> points;      ///< ascending
    std::vector<UndecidedStretch<T>> undecided; ///< ascending; empty unless rounding hides the points, or the effort was spent
};

} // namespace denhartog

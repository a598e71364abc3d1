/// @file
/// @brief What an answer says of a damping matrix that couples the modes.
#pragma once

#include <optional>
#include <vector>

#include "denhartog/answer/scene_source.hpp"

namespace denhartog {

/// @brief A damping matrix that couples the modes.
struct CoupledDamping {
    bool taken_in;                      ///< whether the coupling counts, or is left out as `damping_tolerance` allows
    double distance_from_classical;     ///< as that measures it
    double largest_coupling;            ///< of an entry between two modes, over the geometric mean of theirs
    std::vector<double> damping_ratios; ///< those nearest to the matrix, mode by mode
};

/// @brief Whether the damping matrix of a scene couples the modes, and how much. Double tells; the reference where it fails. None
/// where damping was given by ratios, or by a matrix that does not couple the modes. @eq{18}
[[nodiscard]] std::optional<CoupledDamping> coupled_damping(const SceneSource& source);

} // namespace denhartog

/// @file
/// @brief Where the masses are farthest out while the contact slides.
#pragma once

#include <optional>
#include <vector>

#include "denhartog/scene/scene.hpp"
#include "denhartog/sums/mode_sums.hpp"

namespace denhartog {

/// @brief Where the displacements of the masses are largest.
template <class T>
struct InstantsOfMaxima {
    std::vector<T> instants; ///< N, in [0, pi]; 0 for the contact and for masses not asked for
    /// N, radians: how far the phase of another instant is from that of this one, where the displacement there may be the largest
    /// as well; else 0
    std::vector<T> spreads;
};

/// @brief Where the displacements of the masses are largest, guaranteed by `global_maximum`.
/// @eq{46}
/// @param sums    modes at a frequency ratio
/// @param beta    friction ratio, Eq. (11), in the sliding regime
/// @param only    the one mass whose maximum is wanted besides that of the contact; none for all
/// @param errors  bounds of the errors that the sums make of the displacements, N; empty for none
/// @return        the instants
template <class T>
[[nodiscard]] InstantsOfMaxima<T> instants_of_maxima(const ModeSums<T>& sums, const T& beta,
                                                     std::optional<Mass> only = std::nullopt, const std::vector<T>& errors = {});

} // namespace denhartog

/// @file
/// @brief Amplitudes and phases in the sliding regime from the modes that matter, with a bound of what is left out.
///
/// A mode far above the frequency of the force counts by `static_mode_functions`, with the bounds of what that leaves out, in the
/// same sums as a mode that is evaluated. The motion of the contact needs no more: see `contact_modes.hpp`. The others move by
/// the first harmonic of load and friction up to the higher harmonics of friction, \f$ 4\beta/(n\pi) \f$ for odd n from 3 on,
/// each times the response of every mode to it.
#pragma once

#include "denhartog/answer/solution.hpp"
#include "denhartog/sums/bounded_modes.hpp"

namespace denhartog {

/// @brief What the modes that matter give.
struct TruncatedModesSolution {
    std::vector<SolvedMass> masses; ///< N; zero where not asked about
    double slides_below;            ///< the boundary (69) is not below it
    std::size_t modes;              ///< how many modes were evaluated
    double relative;                ///< largest error, relative to amplitudes and, where asked for, of phases
};

/// @brief Amplitudes and phases from as few modes as have the digits, for mu = 1.
/// @eq{38,39,69}
/// @param scene    the scene, with r and beta
/// @param modes    its modes
/// @param digits   significant digits wanted
/// @param phases   whether the phases must have them too
/// @param only     the one mass that must have them, and whose numbers are wanted; none for all
/// @return         the solution; none where sliding is not certain, or the digits are out of reach this way
[[nodiscard]] std::optional<TruncatedModesSolution> truncated_modes_solution(const Scene<double>& scene,
                                                                             BoundedModes<double>& modes, int digits, bool phases,
                                                                             std::optional<Mass> only = std::nullopt);

} // namespace denhartog

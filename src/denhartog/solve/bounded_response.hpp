/// @file
/// @brief The response in double with bounds of its errors known beforehand: no second computation in more digits.
///
/// The formulas are evaluated on `Bounded` numbers, from the errors of the modes and of the inputs, see `bounded_modes.hpp`.
#pragma once

#include <optional>

#include "denhartog/sliding/bounded_modes.hpp"
#include "denhartog/solve/response.hpp"

namespace denhartog {

/// @brief A response with bounds of its errors.
struct BoundedResponse {
    Response<double> response;       ///< the response; error bounds of the masses and the regime with its boundary's error set
    double relative = 0;             ///< largest error, relative to amplitudes and friction ratios, absolute for phases
    std::vector<double> phase_error; ///< absolute errors of the phases, N values; empty where nothing slides
};

/// @brief The response at the point of a scene with bounds of its errors.
/// @eq{38,39,44,45,47,52,53,69}
/// @param scene        the scene, with r and beta
/// @param modes        its modes
/// @param with_motion  whether the steady state is wanted too, or boundary and regime alone
/// @param only         the one mass that is asked about: no other has a maximum or counts among the errors; none for all
/// @return             the response
/// @throws             DomainError at a pole of a mode without damping; PrecisionError where a maximum is not settled
[[nodiscard]] BoundedResponse bounded_response(const Scene<double>& scene, BoundedModes& modes, bool with_motion = true,
                                               std::optional<Mass> only = std::nullopt);

} // namespace denhartog

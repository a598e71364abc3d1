/// @file
/// @brief The closed form at evenly spaced instants of a period.
#pragma once

#include "denhartog/solve/quantities.hpp"
#include "denhartog/solve/sampled_solution.hpp"

namespace denhartog {

/// @brief The closed form over a period.
struct SampledClosedForm {
    SampledSolution motion; ///< none outside the sliding regime
    QuantitiesAnswer found; ///< the numbers of the point, as far as they were needed, and how they were computed
};

/// @brief Samples the closed form, of which x_j has its maximum at tau = phi_j, to digits as `quantities` has them.
///
/// In double the instants are a recurrence over the half-period, mirrored in the other, with one bound for all of a mass. Where
/// that does not have the digits, and where damping couples the modes, each instant is one of `quantities`. The boundary is not
/// asked for where beta is known to be below.
/// @eq{38,39,41,46}
[[nodiscard]] SampledClosedForm sampled_closed_form(const SceneSource& source, double phi_j, std::size_t samples, int digits,
                                                    bool known_to_slide);

} // namespace denhartog

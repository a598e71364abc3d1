/// @file
/// @brief Invariant points, proved: the zeros of (87) without damping, and those of a factor that (87) divides out.
#pragma once

#include <vector>

#include "denhartog/reference/modes.hpp"
#include "denhartog/sliding/invariant_points.hpp"

namespace denhartog::reference {

/// @brief All invariant points of every mass within a range of frequency ratios, damping left out.
///
/// Over x = 1/r, \f$ V_jU_k - 2V_kU_j \f$ and \f$ U_k \f$ are analytic once their poles are multiplied out. A stretch of x is
/// divided until the Taylor polynomial about its middle, with the last coefficient over the whole stretch, proves that the
/// function does not vanish there, or that it is monotone, so that its signs at the ends decide whether it vanishes once.
/// Newton's method then proves the place in all current bits. If V_j vanishes too, the point is no root of (87) if the response
/// of some mass is a factor of V_j and of V_k, and (87) does not vanish without that factor. Undecided are a zero that may be a
/// pole, one at which (87) may divide by zero, and what is left when the effort is spent.
/// Points that may lie on an end of the range are among those that are found. The scene's r is not used.
/// @eq{33,34,87}
/// @throws InputError if r_a is not positive, r_b not above it, or there are more than 100000 poles above r_a; Unproved if
///         the modes are not proved; PrecisionError if the budget of work is spent before the modes are known
[[nodiscard]] std::vector<InvariantPointsOfMass<Ball>> invariant_points_in_balls(const SceneInBalls& scene, const Ball& r_a,
                                                                                 const Ball& r_b);

} // namespace denhartog::reference

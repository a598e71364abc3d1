/// @file
/// @brief Invariant points, proved: (87) without damping, where it vanishes and where a factor does that it divides out.
#pragma once

#include <vector>

#include "denhartog/reference/scene_in_balls.hpp"
#include "denhartog/sliding/invariant_points.hpp"

namespace denhartog::reference {

/// @brief All invariant points of every mass within a range of frequency ratios, damping left out.
///
/// Over x = 1/r, \f$ V_jU_k - 2V_kU_j \f$ and \f$ U_k \f$ are analytic once their poles are multiplied out. A stretch of x is
/// divided until the Taylor polynomial about its middle, with the last coefficient over the whole stretch, proves that the
/// function does not vanish there, or that it is monotone, so that its signs at the ends tell whether it vanishes once. Newton's
/// method then proves the place to all bits of the moment. Where V_j vanishes too, the point is no root of (87) if the response
/// of some mass is a factor of V_j and of V_k, and (87) does not vanish without that factor. Undecided are a zero that may be a
/// pole, one at which (87) may divide by zero, and what is left when the effort is spent.
/// @eq{33,34,87}
/// @param scene  the scene; its r and its damping are not used
/// @param r_a    least frequency ratio, positive
/// @param r_b    largest frequency ratio, above r_a
/// @return       the points of each mass, ascending; those that may lie on an end of the range are among them
/// @throws       InputError where r_a is not positive, r_b not above it, or there are more than 100000 poles above
///               r_a; Unproved where the modes are not proved; PrecisionError where the budget of work is spent before the modes are known
[[nodiscard]] std::vector<InvariantPointsOfMass<Ball>> invariant_points_in_balls(const SceneInBalls& scene, const Ball& r_a,
                                                                                 const Ball& r_b);

} // namespace denhartog::reference

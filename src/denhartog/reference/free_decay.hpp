/// @file
/// @brief The motion without a load, from a start until the contact rests for good, every number of it proved.
///
/// Friction and damping take energy out of the motion. Each stretch of sliding ends where the velocity of the contact is zero. There
/// (74) decides: the contact stops, or its load turns it round. Events are enclosed one after the other, and between them
/// interval arithmetic excludes that one was missed.
#pragma once

#include <optional>
#include <vector>

#include "denhartog/reference/orbit.hpp"

namespace denhartog::reference {

/// @brief Follows the motion without a load until the contact rests for good.
///
/// While the contact rests, the others move freely about their places of rest, with an energy E that never grows, as damping takes
/// energy out of every motion. With
/// \f[ \mathbf P_K = \mathbf K^{-1}-
///     \frac{\mathbf K^{-1}\mathbf w\mathbf w^T\mathbf K^{-1}}{\mathbf w^T\mathbf K^{-1}\mathbf w} \f]
/// and \f$ \mathbf P_M \f$ alike, what they add to the load on the contact,
/// \f$ \mathbf a^T\bar{\mathbf x}+\mathbf b^T\bar{\mathbf x}' \f$, is at most
/// \f[ \sqrt{2E\,(\mathbf a^T\mathbf P_K\mathbf a+\mathbf b^T\mathbf P_M\mathbf b)} \f]
/// (Cauchy and Schwarz). If this and the load of the springs at rest are less than static friction, the rest lasts.
/// @eq{6,74,75}
/// The scene has its damping matrix, and its load counts for nothing. The motion is followed up to `until`, or until the contact rests
/// for good, which it may never do where nothing damps the other masses. If no more bits will be tried, at `last`, a single mass whose
/// springs pull with static friction to all bits rests, see `on_limit`.
/// @throws Unproved if more bits may help; PrecisionError if the work allowed is spent before the motion has come to its end
[[nodiscard]] FreeDecayOf<Ball> free_decay_in_balls(const SceneInBalls& scene, const BallMatrix& x, const BallMatrix& x_prime,
                                                    const std::optional<Ball>& until, bool last);

} // namespace denhartog::reference

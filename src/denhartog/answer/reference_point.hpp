/// @file
/// @brief A point of a scene as the reference sees it. Included by sources only.
#pragma once

#include <optional>

#include "denhartog/answer/scene_source.hpp"
#include "denhartog/reference/series.hpp"
#include "denhartog/reference/sliding.hpp"

namespace denhartog {

/// @brief What is known of a point in the bits of the moment.
struct PointInBalls {
    reference::SceneInBalls scene{};                        ///< the scene, with its damping matrix
    std::optional<reference::ResponsesInBalls> responses{}; ///< its response functions; none at a pole
    std::optional<reference::BoundaryInBalls> boundary{};   ///< the boundary of the sliding regime; none at a pole
    std::optional<reference::StuckInBalls> stuck{};         ///< the response with the contact held; none where that may resonate
    std::optional<Ball> sticking{};                         ///< the friction ratio from which the contact can rest for ever
};

/// @brief A scene as it is given, without r at r = 1.
/// @throws  InputError where it breaks a rule that double is too coarse to see broken
[[nodiscard]] reference::SceneInBalls scene_as_given(const SceneSource& source);

/// @brief A scene with the damping that counts: ratios, or a matrix; the ratios nearest to that where it is within
/// `damping_tolerance` of having them.
[[nodiscard]] reference::SceneInBalls scene_in_balls(const SceneSource& source);

/// @brief The same at r = 1, where psi of (17) is phi, under the load that it has at its own r.
[[nodiscard]] reference::SceneInBalls scene_at_one(const SceneSource& source);

/// @brief The damping matrix in the modes, \f$ \boldsymbol\Psi^T\mathbf{C}\boldsymbol\Psi \f$, whose diagonal has the damping of
/// each by itself.
/// @eq{18}
[[nodiscard]] BallMatrix damping_of_modes(const reference::SceneInBalls& scene, const reference::ModesInBalls& modes);

/// @brief A scene with its damping matrix, (19) where damping is given by ratios.
[[nodiscard]] reference::SceneInBalls damped_scene_in_balls(const SceneSource& source);

/// @brief A point of a scene, which may be of no use without its boundary.
[[nodiscard]] PointInBalls point_in_balls(const SceneSource& source, bool needs_boundary);

/// @brief The stuck response at a point.
/// @throws  Unproved where the system with its contact held may resonate
[[nodiscard]] const reference::StuckInBalls& required_stuck(const PointInBalls& p);

/// @brief Requires that a point with its boundary lies below (69).
/// @throws  Disproved, Unproved
void require_sliding(const PointInBalls& p);

} // namespace denhartog

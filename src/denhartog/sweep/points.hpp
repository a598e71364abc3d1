/// @file
/// @brief The points of a chunk: each system's columns by `regime_map`, phases by `solve`.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

#include "denhartog/sweep/plan.hpp"
#include "denhartog/sweep/scene_at.hpp"

namespace denhartog::sweep {

/// @brief What became of a point: the statuses of a map, and one for samples whose numbers make no scene.
inline constexpr std::array statuses{"answered", "on_boundary", "not_converged", "at_a_pole", "failed", "no_scene"};

/// @brief What a chunk found, point after point in the order of the grid.
struct Points {
    std::vector<std::int8_t> status;             ///< place among `statuses`
    std::vector<std::int8_t> regime;             ///< 0 continuous, 1 stick_slip, 2 permanent_sticking, -1 none
    std::vector<std::int32_t> stops;             ///< stops in a period of the motion, -1 where there are no numbers
    std::vector<std::int32_t> periods;           ///< that period, -1 where there are no numbers
    std::vector<std::vector<double>> amplitudes; ///< a list a mass asked for; NaN where there are no numbers
    std::vector<std::vector<double>> phases;     ///< the same; empty unless the study needs them; NaN also where nothing moves
    bool complete = false;                       ///< false where it was stopped
};

/// @brief Computes the points of a chunk.
/// @param plan   the plan
/// @param scenes its scenes
/// @param box    the chunk
/// @param stop   set to stop early
/// @return       the points
[[nodiscard]] Points points_of(const Plan& plan, const SceneAt& scenes, const Box& box, const std::atomic<bool>& stop);

} // namespace denhartog::sweep

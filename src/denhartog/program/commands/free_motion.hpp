// The motion of a scene without a load, `"force": 0`, as `denhartog integrate` answers it.
#pragma once

#include <optional>
#include <string>

#include "denhartog/answer/from_a_start.hpp"
#include "denhartog/program/json/number_json.hpp"

namespace denhartog::program {

// A dimensional scene whose force is 0, as one with a force: P / k_1 is one unit of length, and omega a power of two, so that
// no number is rounded by its units. Neither counts for the motion.
struct UnloadedScene {
    std::string text; // of that scene
    double omega;     // its frequency, in radians per unit of time
    double
        period; // what counts as a period, in radians of it: of the scene's frequency, else of the first mass on the first spring
};

// The scene, where its force is 0; none of any other, nor where the text is no scene. Throws InputError where a base moves.
[[nodiscard]] std::optional<UnloadedScene> unloaded_scene(const SceneText& part);

// Its way to rest, or its motion over some periods, and its history if there is one, in the units of the scene; as JSON, and as a
// table.
[[nodiscard]] Json free_motion_json(const UnloadedScene& unloaded, const SceneSource& source, const State& start,
                                    const std::optional<int>& periods, const std::optional<MotionHistory>& history);
[[nodiscard]] std::string free_motion_table(const Json& answer);

// Over how many of its periods the contact comes to rest for good, and one more.
[[nodiscard]] int periods_to_rest(const UnloadedScene& unloaded, const SceneSource& source, const State& start);

// The stops of a history; numbers of time and displacement are multiplied by the factors.
[[nodiscard]] Json history_json(const MotionHistory& history, double time, double length);
[[nodiscard]] std::string history_table(const Json& history);

} // namespace denhartog::program

/// @file
/// @brief What an answer makes of a damping matrix that couples the modes.
#pragma once

#include <optional>

#include "denhartog/answer/scene_source.hpp"
#include "denhartog/program/json/number_json.hpp"

namespace denhartog::program {

/// @brief Whether the coupling of the modes was taken in or left out, how large it is, and the damping ratios without it.
/// @param source  a scene
/// @return        the object; none where damping was given by ratios, or by a matrix that does not couple the modes
[[nodiscard]] std::optional<Json> damping_json(const SceneSource& source);

/// @brief The same for reading. @param damping the object @return a line of text
[[nodiscard]] std::string damping_table(const Json& damping);

} // namespace denhartog::program

/// @file
/// @brief The keys of a scene: which there are, and which may stand together.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string_view>

namespace denhartog {

/// @brief The keys that a scene may have.
/// @return  the keys, in the order of the documentation
[[nodiscard]] std::span<const std::string_view> scene_keys();

/// @brief Checks the keys of a scene. One that is none is told the nearest, all there are, and what a scene does not hold.
/// @param object  the value
/// @throws        InputError where it is no object, has a key that is none, or keys of both kinds of scenes
void check_keys(const nlohmann::json& object);

/// @brief Whether a scene is dimensional. @param object an object with the keys of a scene @return true where it has such a key
[[nodiscard]] bool is_dimensional(const nlohmann::json& object);

} // namespace denhartog

/// @file
/// @brief The keys of a scene in JSON: which exist, and which may be given together.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string_view>

namespace denhartog {

/// @brief The keys that a scene may have.
/// @return  the keys, in the order of the documentation
[[nodiscard]] std::span<const std::string_view> scene_keys();

/// @brief Checks the keys of a scene. The error for an unknown key names the nearest key and lists them all.
/// @param object  the value
/// @throws        InputError if it is not an object, has an unknown key, or has keys of both ratios and physical units
void check_keys(const nlohmann::json& object);

/// @brief Whether a scene is in physical units.
/// @param object  an object with the keys of a scene
/// @return        true if it has a key of physical units
[[nodiscard]] bool is_dimensional(const nlohmann::json& object);

} // namespace denhartog

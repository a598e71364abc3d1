/// @file
/// @brief A scene with one of its numbers changed, and its amplitudes.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "denhartog/number/certified.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/scene/scene.hpp"

namespace denhartog {

/// @brief The place of a number in the JSON of a scene: of a key, or of a list's key with the place, counted from 1, behind a slash.
/// InputError where there is no such number.
[[nodiscard]] nlohmann::json::json_pointer place_of(const std::string& key, const nlohmann::json& scene);

/// @brief The amplitudes at the point of a scene.
struct AmplitudesOfScene {
    std::vector<Certified>
        amplitudes{};  ///< of the masses asked for, in the scene's unit of length, else of P / k_1; none if refused
    Reasons refused{}; ///< why there is no answer
};

/// @brief Solves a scene for the amplitude of a mass, or of all, paid from a budget, if there is one. InputError where it breaks a rule.
[[nodiscard]] AmplitudesOfScene amplitudes_of(const nlohmann::json& scene, std::optional<Mass> mass, double damping_tolerance,
                                              Effort* effort);

} // namespace denhartog

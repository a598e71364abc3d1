/// @file
/// @brief Scenes as JSON: the one place where masses counted from 1 become masses counted from 0.
///
/// Keys, units and conventions stand in docs/scene.schema.json. A number is a JSON number, which means the double, or a text
/// that is written like a JSON number and is rounded once to the number type.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "denhartog/number/errors.hpp"
#include "denhartog/scene/scene.hpp"
#include "denhartog/scene/scene_keys.hpp"

namespace denhartog {

/// @brief A scene from a JSON value.
/// @param object  the value
/// @return        the scene, checked; dimensional quantities divided by k_1, m_1 and P, Eqs. (7)-(11), (73)
/// @throws        InputError with quantity, rule, value and JSON pointer
template <class T>
[[nodiscard]] Scene<T> scene_from_json(const nlohmann::json& object);

/// @brief A scene from JSON text.
/// @param text  the text of one scene
/// @return      the scene, checked
/// @throws      InputError with quantity, rule, value and JSON pointer, or line and column where the text is no JSON
template <class T>
[[nodiscard]] Scene<T> read_scene(std::string_view text);

/// @brief The text of one scene among many.
struct SceneText {
    std::string_view text; ///< part of the whole text
    std::size_t line = 1;  ///< the line on which it starts
    bool alone = true;     ///< it is the only one; else places are given with their line
};

/// @brief Divides a text into scenes: one object over any number of lines, or JSON Lines, one object a line.
/// @param text  the text; outlives the result
/// @return      one part a scene, in order, at least one; blank lines between scenes are passed over
[[nodiscard]] std::vector<SceneText> split_scenes(std::string_view text);

/// @brief A scene or the reason why there is none.
template <class T>
struct SceneOrError {
    std::size_t line = 1;            ///< the line on which the scene starts
    std::optional<Scene<T>> scene;   ///< the scene, checked
    std::optional<InputError> error; ///< the error where there is no scene
};

/// @brief One scene of a text that may hold many.
/// @param part  the part, from `split_scenes`
/// @return      the scene or its error
template <class T>
[[nodiscard]] SceneOrError<T> read_scene(const SceneText& part);

/// @brief All scenes of a text, each with its own error.
/// @param text  one object, or JSON Lines
/// @return      one entry a scene, in order, at least one
template <class T>
[[nodiscard]] std::vector<SceneOrError<T>> read_scenes(std::string_view text);

/// @brief A scene as a JSON object from which the same scene can be read again, to the last bit.
/// @param scene  the scene; checked
/// @return       non-dimensional keys; numbers that no double holds are text
/// @throws       InputError where the scene breaks a rule
template <class T>
[[nodiscard]] nlohmann::ordered_json write_scene(const Scene<T>& scene);

} // namespace denhartog

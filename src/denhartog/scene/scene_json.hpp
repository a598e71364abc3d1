/// @file
/// @brief Reads and writes scenes as JSON. Masses are counted from 1 in JSON and from 0 in C++.
///
/// docs/scene.schema.json lists the keys with their units and conventions. A number is either a JSON number, which stands for the
/// nearest double, or a text written like a JSON number, which is rounded once to the number type: "0.1" in balls is one
/// tenth to all their digits.
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

namespace denhartog {

/// @brief The keys that a scene may have.
/// @return  the keys, in the order of the documentation
[[nodiscard]] std::span<const std::string_view> scene_keys();

/// @brief Reads a scene from a JSON value.
/// @param object  the value
/// @return        the scene, checked; physical quantities are divided by k_1, m_1 and P, Eqs. (7)-(11), (73)
/// @throws        InputError that names quantity, rule, value and JSON pointer
template <class T>
[[nodiscard]] Scene<T> scene_from_json(const nlohmann::json& object);

/// @brief Reads a scene from JSON text.
/// @param text  the text of one scene
/// @return      the scene, checked
/// @throws      InputError that names quantity, rule, value and JSON pointer; line and column if the text is not JSON
template <class T>
[[nodiscard]] Scene<T> read_scene(std::string_view text);

/// @brief The text of one scene among many.
struct SceneText {
    std::string_view text; ///< part of the whole text
    std::size_t line = 1;  ///< the line on which it starts
    bool alone = true;     ///< whether it is the only scene; if not, messages name its line
};

/// @brief Divides a text into scenes: one object over any number of lines, or JSON Lines with one object on each line.
/// @param text  the text; it must outlive the result
/// @return      one part for each scene, in order, at least one; blank lines between scenes are skipped
[[nodiscard]] std::vector<SceneText> split_scenes(std::string_view text);

/// @brief A scene, or the error if there is none.
template <class T>
struct SceneOrError {
    std::size_t line = 1;            ///< the line on which the scene starts
    std::optional<Scene<T>> scene;   ///< the scene, checked
    std::optional<InputError> error; ///< the error, if there is no scene
};

/// @brief Reads one scene of a text that may hold many.
/// @param part  the part, from `split_scenes`
/// @return      the scene or its error
template <class T>
[[nodiscard]] SceneOrError<T> read_scene(const SceneText& part);

/// @brief Reads all scenes of a text. An error in one does not affect the others.
/// @param text  one object, or JSON Lines
/// @return      one entry for each scene, in order, at least one
template <class T>
[[nodiscard]] std::vector<SceneOrError<T>> read_scenes(std::string_view text);

/// @brief Writes a scene as a JSON object from which the same scene can be read again, to the last bit.
/// @param scene  the scene; it is checked
/// @return       the object, with non-dimensional keys
/// @throws       InputError if the scene breaks a rule
[[nodiscard]] nlohmann::ordered_json write_scene(const Scene<double>& scene);

} // namespace denhartog

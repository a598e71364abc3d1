/// @file
/// @brief Scenes by their names in tests/named_scenes.jsonl, where it says why each is there.
///
/// A scene is asked for by its name and a merge patch that changes it: `two {"r": 2, "beta": null}`.
#pragma once

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "denhartog/answer/scene_source.hpp"
#include "denhartog/scene/scene_json.hpp"

namespace denhartog::tests {

/// @brief A file of the sources. @param path from the top @return its name
inline std::string source_file(const std::string& path) {
    const char* top = std::getenv("DENHARTOG_SOURCE_DIR");
    if (top == nullptr) throw std::runtime_error("DENHARTOG_SOURCE_DIR must name the sources: run the tests by ctest");
    return std::string(top) + "/" + path;
}

/// @brief The text of a scene. @param scene its name, and a merge patch @return JSON
inline std::string text_of_scene(const std::string& scene) {
    const std::size_t patch = std::min(scene.find('{'), scene.size());
    const std::string name = scene.substr(0, scene.find_last_not_of(' ', patch == 0 ? 0 : patch - 1) + 1);
    std::ifstream file(source_file("tests/named_scenes.jsonl"));
    for (std::string line; std::getline(file, line);)
        if (nlohmann::ordered_json found = nlohmann::ordered_json::parse(line); found.at("name") == name) {
            found.erase("name");
            found.erase("why");
            if (patch < scene.size()) found.merge_patch(nlohmann::ordered_json::parse(scene.substr(patch)));
            return found.dump();
        }
    throw std::logic_error("no scene has the name " + name);
}

/// @brief A scene. @param scene its name, and a merge patch @return it in a number type
template <class T = double>
[[nodiscard]] Scene<T> named_scene(const std::string& scene) {
    return read_scene<T>(text_of_scene(scene));
}

/// @brief A scene whose numbers are read anew in every precision. @param scene its name, and a merge patch @return its source
[[nodiscard]] inline SceneSource named_source(const std::string& scene) { return scene_source(SceneText{text_of_scene(scene)}); }

} // namespace denhartog::tests

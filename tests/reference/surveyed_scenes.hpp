/// @file
/// @brief The scenes of tests/scenes.jsonl, and all that the library tells of them in double, beside proofs.
#pragma once

#include <nlohmann/json.hpp>

#include "tests/reference/survey_of_bounds.hpp"
#include "tests/reference/truth.hpp"

namespace denhartog::tests {

/// @brief A scene of the file.
struct SurveyedScene {
    std::string text{};         ///< its line
    nlohmann::json json{};      ///< the same, read
    SceneSource source{};       ///< the same as a source
    bool couples_modes = false; ///< whether a damping matrix couples the modes
    bool of_doubles = true;     ///< whether a double for each number says the same; no decimals as text, no units
};

/// @brief The scenes. @return them, in the order of the file
[[nodiscard]] const std::vector<SurveyedScene>& surveyed_scenes();

/// @brief The answer of the reference, to 25 digits. @param source the scene @return the answer
[[nodiscard]] Solution proved_answer(const SceneSource& source);

/// @brief Surveys an answer. @param kind what was asked @param told the answer @param proved the proved one @param survey gets it
void survey_answer(const std::string& kind, const Solution& told, const Solution& proved, SurveyOfBounds& survey);

/// @brief Surveys what `dh_system_from_json` and the functions of its handle give. @param scene the scene @param truth its numbers
void survey_c_functions(const SurveyedScene& scene, const Truth& truth, SurveyOfBounds& survey);

/// @brief Surveys `dh_solve`, `dh_map` and `dh_quantity`. @param scene the scene @param proved the proved answer @param truth its
/// numbers @param survey gets them
void survey_c_answers(const SurveyedScene& scene, const Solution& proved, const Truth& truth, SurveyOfBounds& survey);

} // namespace denhartog::tests

/// @file
/// @brief Scenes of the surveys, and comparisons of numbers with their bounds and what is proved.
#pragma once

#include <algorithm>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/catch.hpp"
#include "tests/reference/proofs.hpp"
#include "tests/reference/truth.hpp"

namespace denhartog::tests {

/// @brief A number beside its proof.
struct NumberHeld {
    double off = 0;      ///< by how much it is off at least
    double bound = 0;    ///< what it may be off by
    std::string where{}; ///< what was asked, with the number in hexadecimal
};

/// @brief Numbers by kind, beside their proofs.
struct SurveyOfBounds {
    std::map<std::string, std::vector<NumberHeld>> kinds{}; ///< by kind
    std::map<std::string, long> without_bound{};            ///< numbers whose bound is infinite, by kind
    std::vector<std::string> differences{};                 ///< regimes, counts and words that are not those proved
    std::vector<std::string> refusals{};                    ///< what a part of the library says it has no digits for
    std::string scene{};                                    ///< the scene that is being surveyed

    /// @brief Takes a number. @param kind its kind @param value the number @param bound of its error @param proved what it is
    void take(const std::string& kind, double value, double bound, const Ball& proved, const Ball& period = Ball(0)) {
        if (!proved.finite()) return;
        if (!(bound < std::numeric_limits<double>::max())) {
            ++without_bound[kind];
            return;
        }
        const Ball x(value);
        kinds[kind].push_back({period.is_zero() ? apart(x, proved) : apart(x, proved, period), bound,
                               hexadecimal(value) + " +- " + hexadecimal(bound) + ", proved " + in_words(proved) + ", " + scene});
    }
    /// @brief Takes what has to be the same. @param what in words @param told of the answer @param proved of the proof
    template <class T>
    void same(const std::string& what, const T& told, const T& proved) {
        if (!(told == proved)) differences.push_back(what + ", " + scene);
    }
    /// @brief Numbers that are off by more than a part of their bound. @param kind a kind @param part of the bound @return them
    [[nodiscard]] std::vector<NumberHeld> beyond(const std::string& kind, double part) const {
        std::vector<NumberHeld> all;
        std::ranges::copy_if(kinds.at(kind), std::back_inserter(all),
                             [part](const NumberHeld& n) { return n.off > part * n.bound; });
        return all;
    }
};

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

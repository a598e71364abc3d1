/// @file
/// @brief Numbers that vague words of the text are taken to be, and the numbers at which a verdict turns. Header only.
///
/// The text says "very good", "slightly", "nearly": an observation has to put a number in its place. Which number is our choice,
/// and the verdict depends on it. Plain text on purpose: the ledger is joined and tested without GiNaC.
#pragma once

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace denhartog::derivation {

/// @brief A number taken for a vague word.
struct Threshold {
    std::string what = {};            ///< what is compared with it
    double taken = 0;                 ///< the number taken
    double turns = 0;                 ///< the number from which on the statement is no longer refuted, as far as was searched
    std::optional<double> empty = {}; ///< the number at which the statement says nothing any more; none where there is no such
};

/// @brief Whether some other number than the one taken turns the verdict and leaves the statement a meaning.
/// @param threshold  a threshold
/// @return           false where the statement is refuted at every number that leaves it one
[[nodiscard]] inline bool decides(const Threshold& threshold) {
    if (!threshold.empty) return true;
    return threshold.taken < *threshold.empty ? threshold.turns < *threshold.empty : threshold.turns > *threshold.empty;
}

/// @brief Whether a refuted statement is refuted whatever numbers its vague words are taken to be.
/// @param thresholds  the thresholds of the statement, each turned with the others held
/// @return            true where no threshold decides
[[nodiscard]] inline bool refuted_whatever_the_threshold(const std::vector<Threshold>& thresholds) {
    return std::ranges::none_of(thresholds, decides);
}

/// @brief A number in a sentence on thresholds. @param x a number @return three digits
[[nodiscard]] inline std::string in_three_digits(double x) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.3g", x);
    return buffer;
}

/// @brief A threshold in words, e.g. `relative error: 0.01 taken, turns at 0.29`. @param threshold a threshold @return the words
[[nodiscard]] inline std::string sentence(const Threshold& threshold) {
    return threshold.what + ": " + in_three_digits(threshold.taken) + " taken, turns at " + in_three_digits(threshold.turns);
}

/// @brief Thresholds as the ledger has them. @param thresholds the thresholds
/// @return  an array, an object each: what, taken, turns, empty (a number or null), decides
[[nodiscard]] inline nlohmann::json thresholds_to_json(const std::vector<Threshold>& thresholds) {
    nlohmann::json list = nlohmann::json::array();
    for (const Threshold& t : thresholds)
        list.push_back({{"what", t.what},
                        {"taken", t.taken},
                        {"turns", t.turns},
                        {"empty", t.empty ? nlohmann::json(*t.empty) : nlohmann::json()},
                        {"decides", decides(t)}});
    return list;
}

/// @brief The other way round. @param list what `thresholds_to_json` made @return the thresholds
[[nodiscard]] inline std::vector<Threshold> thresholds_from_json(const nlohmann::json& list) {
    std::vector<Threshold> thresholds;
    for (const nlohmann::json& t : list) {
        Threshold made{t.at("what"), t.at("taken"), t.at("turns")};
        if (!t.at("empty").is_null()) made.empty = t.at("empty").get<double>();
        thresholds.push_back(std::move(made));
    }
    return thresholds;
}

} // namespace denhartog::derivation

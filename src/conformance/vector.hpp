/// @file
/// @brief A certified vector: a question, its value by two unrelated routes, and how an answer to it is judged.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "conformance/question.hpp"

namespace denhartog::conformance {

/// @brief Version of the format of the vector files.
inline constexpr int format_version = 2;

/// @brief Largest errors that a verdict allows, relative to the vector's scale.
struct Tolerance {
    double pass = 0;       ///< up to here `pass`
    double loose = 0;      ///< up to here `pass-loose`
    double inaccurate = 0; ///< up to here `inaccurate`, beyond it `wrong`
};

/// @brief A certified vector.
struct Vector {
    ProtocolQuestion question; ///< what is asked
    std::string group;         ///< what the vector is about: the name of its file without its end
    std::string equation;      ///< number of the equation in the paper; empty if there is none
    std::string tier;          ///< `must`, `should` or `stress`
    std::vector<std::string>
        value;          ///< 40 significant digits each; empty where the question has to be rejected or its answer is a word
    std::string word;   ///< the regime, where that is the answer
    std::string reject; ///< the rule that the question breaks; empty where it breaks none
    std::vector<double> nearest; ///< the doubles nearest to `value`; in files as hexadecimal floats
    double scale = 0; ///< what errors are divided by: the largest size among the values; 1 for angles and where all are zero
    /// Condition number of the value with respect to each input: |change of value| / scale over relative change of the input.
    /// Inputs: r, beta, mu, tau, mass_ratios, stiffness_ratios, damping_ratios (of a list the largest over its entries); one of
    /// no influence is left out.
    std::vector<std::pair<std::string, double>> condition;
    std::string regime; ///< `continuous`, `stick_slip` or `permanent_sticking` at the scene; empty for a rejected question
    std::optional<double> margin;   ///< |beta / nearest boundary of a regime - 1|; none where the quantity does not depend on it
    Tolerance tolerance;            ///< how errors are judged
    std::vector<std::string> flags; ///< what the scene has, e.g. `unequal`, `mu`, `undamped`, `near-resonance`
    std::vector<std::string> catches;  ///< names of the mistakes whose answer to it is judged `wrong`, ascending
    std::array<std::string, 2> routes; ///< the two unrelated routes
    std::array<int, 2> digits{};       ///< digits on which the routes agree: computed in 50 and in 100 digits
};

/// @brief The true answer of a vector. @param v the vector @return the doubles nearest to it, or the regime
[[nodiscard]] inline Value truth_of(const Vector& v) { return {v.nearest, v.word}; }

/// @brief A number as a hexadecimal float. @param x a number @return its text
[[nodiscard]] std::string hexadecimal_float(double x);

/// @brief A vector as a line of a vector file. @param v the vector @return the object, keys in the order of the format
[[nodiscard]] nlohmann::ordered_json vector_json(const Vector& v);

/// @brief A vector from an object of a vector file. @param object the object @return the vector
/// @throws InputError that names quantity and rule, if the object is not a vector
[[nodiscard]] Vector vector_from_json(const nlohmann::json& object);

/// @brief Whether a vector is about a system beyond the paper. Such vectors are asked only if chosen. @param v the vector
/// @return whether its group is one of those that start with `systems-`
[[nodiscard]] bool is_of_systems(const Vector& v);

/// @brief Vectors as a table with a heading; lists are numbers separated by spaces, matrices such lists row by row. If a vector
/// is about a system beyond the paper, there are five columns more. @param vectors the vectors @return the lines
[[nodiscard]] std::string vectors_csv(const std::vector<const Vector*>& vectors);

/// @brief All vectors of a folder: its files *.jsonl in the order of their names. @param folder the folder @return the vectors
/// @throws InputError if a file cannot be read, a line is not a vector, or an id is given twice
[[nodiscard]] std::vector<Vector> read_vectors(const std::filesystem::path& folder);

} // namespace denhartog::conformance

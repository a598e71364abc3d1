/// @file
/// @brief Known mistakes, each as the answers that an implementation gives that makes it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/question.hpp"

namespace denhartog::conformance {

/// @brief How near an answer is to that of a mistake that explains it, in units of its distance from the truth.
inline constexpr double nearer_than_truth = 0.1;

/// @brief A known mistake.
struct Mistake {
    std::string name;     ///< stable name, e.g. `46-as-printed`, `mu-ignored`
    std::string equation; ///< equation of the paper that it is about; empty where it is about none
    bool as_printed;      ///< whether it is the paper's print
    std::string told;     ///< what it is, a sentence with the equation
    std::string look_at;  ///< what to look at in the code that makes it
    /// How near, relative to its size, answers of implementations that make it come to `answer_with_mistake`: rounding where it
    /// is one formula for another, the steps in time or the harmonics of a solver where the mistake is a solver's.
    double agreement = 1e-6;
    /// The quantities of its own equation, where it need not reach the others that it says something of: a program that has
    /// (44) as printed may take the motion from (46). Empty where it reaches all.
    std::vector<std::string> core = {};
};

/// @brief All known mistakes, by name. @return the mistakes
[[nodiscard]] std::span<const Mistake> mistakes();

/// @brief What an implementation that makes a mistake answers, in double.
///
/// Whatever of the answer the mistake does not touch is right to the accuracy of the plain closed form in double.
/// @param name  name of the mistake
/// @param q     the question; its scene keeps the rules
/// @return      the answer; none where the mistake says nothing about the quantity, or its answer cannot be computed
/// @throws      InputError for a name that is none
[[nodiscard]] std::optional<Value> answer_with_mistake(std::string_view name, const Question& q);

} // namespace denhartog::conformance

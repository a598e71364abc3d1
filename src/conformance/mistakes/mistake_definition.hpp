/// @file
/// @brief A known mistake with the function that gives its answers, and the parts of the list of all mistakes.
#pragma once

#include <functional>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "conformance/mistakes/mistake.hpp"
#include "conformance/plain/closed_form.hpp"

namespace denhartog::conformance {

/// @brief Agreement of the mistakes that time-stepping solvers make.
inline constexpr double of_steps_in_time = 3e-2;

/// @brief A mistake with its answers.
struct MistakeDefinition {
    Mistake mistake;                                             ///< the description for reports
    std::function<std::optional<Value>(const ProtocolQuestion&)> answer; ///< its answer; none if it does not affect the quantity
};

/// @brief Defines a mistake in the formulas: the plain closed form with other choices.
/// @param mistake  the description for reports
/// @param touched  the quantities that it affects; all if empty
/// @param choose   makes the choices
/// @return         the definition
[[nodiscard]] MistakeDefinition by_formulas(Mistake mistake, std::vector<std::string_view> touched,
                                            std::function<void(Choices&)> choose);

/// @brief Mistakes in reading a question: every answer is the right answer to another question. @return the mistakes
[[nodiscard]] std::vector<MistakeDefinition> mistakes_of_input();
/// @brief Formulas as the paper prints them, if the derivation refutes them. @return the mistakes
[[nodiscard]] std::vector<MistakeDefinition> mistakes_of_print();
/// @brief Mistakes in the closed form that the paper does not print. @return the mistakes
[[nodiscard]] std::vector<MistakeDefinition> mistakes_of_form();
/// @brief Mistakes in the convention of an answer, such as its unit or sign. @return the mistakes
[[nodiscard]] std::vector<MistakeDefinition> mistakes_of_output();
/// @brief Mistakes that solvers of the motion make. @return the mistakes
[[nodiscard]] std::vector<MistakeDefinition> mistakes_of_integrators();

/// @brief Mistakes that only systems beyond the paper can show. @return the mistakes
[[nodiscard]] std::vector<MistakeDefinition> mistakes_of_systems();

/// @brief Whether a question asks for one of several quantities.
/// @param q      the question
/// @param names  the quantities
/// @return       true if it does
[[nodiscard]] bool asks_for(const ProtocolQuestion& q, std::initializer_list<std::string_view> names);

} // namespace denhartog::conformance

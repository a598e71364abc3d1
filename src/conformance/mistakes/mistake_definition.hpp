/// @file
/// @brief A known mistake with the function that answers as it does; the parts of the list of all mistakes.
#pragma once

#include <functional>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "conformance/mistakes/mistake.hpp"
#include "conformance/plain/closed_form.hpp"

namespace denhartog::conformance {

/// @brief Agreement of mistakes that solvers make which go in steps through time.
inline constexpr double of_steps_in_time = 3e-2;

/// @brief A mistake and what it answers.
struct MistakeDefinition {
    Mistake mistake;                                             ///< what is told of it
    std::function<std::optional<Value>(const Question&)> answer; ///< what it answers; none where it says nothing
};

/// @brief A mistake in the formulas: the plain closed form with other choices.
/// @param mistake  what is told of it
/// @param touched  the quantities of which it says something; all where empty
/// @param choose   makes the choices
/// @return         the definition
[[nodiscard]] MistakeDefinition by_formulas(Mistake mistake, std::vector<std::string_view> touched,
                                            std::function<void(Choices&)> choose);

/// @brief Mistakes in what is read from a question: every answer is that to another question. @return the mistakes
[[nodiscard]] std::vector<MistakeDefinition> mistakes_of_input();
/// @brief Formulas as the paper prints them where the derivation refutes them. @return the mistakes
[[nodiscard]] std::vector<MistakeDefinition> mistakes_of_print();
/// @brief Mistakes in the closed form that are not the paper's print. @return the mistakes
[[nodiscard]] std::vector<MistakeDefinition> mistakes_of_form();
/// @brief Mistakes in the convention by which an answer is given. @return the mistakes
[[nodiscard]] std::vector<MistakeDefinition> mistakes_of_output();
/// @brief Mistakes that solvers of the motion make. @return the mistakes
[[nodiscard]] std::vector<MistakeDefinition> mistakes_of_integrators();

/// @brief Mistakes in what only systems beyond the paper have. @return the mistakes
[[nodiscard]] std::vector<MistakeDefinition> mistakes_of_systems();

/// @brief Whether a question asks for one of some quantities.
/// @param q      the question
/// @param names  the quantities
/// @return       whether it does
[[nodiscard]] bool asks_for(const Question& q, std::initializer_list<std::string_view> names);

} // namespace denhartog::conformance

/// @file
/// @brief A known mistake with the function that answers as it does; the parts of the list of all mistakes.
#pragma once

#include <functional>
#include <vector>

#include "denhartog/conformance/mistake.hpp"
#include "denhartog/conformance/plain_closed_form.hpp"

namespace denhartog::conformance {

/// @brief A mistake and what it answers.
struct MistakeDefinition {
    Mistake mistake;                                            ///< what is told of it
    std::function<std::vector<Value>(const Question&)> answers; ///< its answers; none where it says nothing about the question
};

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

/// @brief Whether a quantity is one of some. @param q the question @param names names of quantities @return whether it is
[[nodiscard]] bool asks_for(const Question& q, std::initializer_list<std::string_view> names);

/// @brief An answer as a list of one or none. @param value the answer @return the list
[[nodiscard]] std::vector<Value> listed(const std::optional<Value>& value);

} // namespace denhartog::conformance

// A known mistake with the function that gives its answers, and the parts of the list of all mistakes.
#pragma once

#include <functional>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "conformance/mistakes/mistake.hpp"
#include "conformance/plain/closed_form.hpp"

namespace denhartog::conformance {

// Agreement of the mistakes that time-stepping solvers make.
inline constexpr double of_steps_in_time = 3e-2;

// A mistake with its answers.
struct MistakeDefinition {
    Mistake mistake;                                                     // the description for reports
    std::function<std::optional<Value>(const ProtocolQuestion&)> answer; // its answer; none if it does not affect the quantity
};

// Defines a mistake in the formulas: the plain closed form with other choices. It affects the
// quantities `touched`; all if there are none.
[[nodiscard]] MistakeDefinition by_formulas(Mistake mistake, std::vector<std::string_view> touched,
                                            std::function<void(Choices&)> choose);

// Mistakes in reading a question: every answer is the right answer to another question.
[[nodiscard]] std::vector<MistakeDefinition> mistakes_of_input();
// Formulas as the paper prints them, if the derivation refutes them.
[[nodiscard]] std::vector<MistakeDefinition> mistakes_of_print();
// Mistakes in the closed form that the paper does not print.
[[nodiscard]] std::vector<MistakeDefinition> mistakes_of_form();
// Mistakes in the convention of an answer, such as its unit or sign.
[[nodiscard]] std::vector<MistakeDefinition> mistakes_of_output();
// Mistakes that solvers of the motion make.
[[nodiscard]] std::vector<MistakeDefinition> mistakes_of_integrators();

// Mistakes that only systems beyond the paper can show.
[[nodiscard]] std::vector<MistakeDefinition> mistakes_of_systems();

// Whether a question asks for one of several quantities.
[[nodiscard]] bool asks_for(const ProtocolQuestion& q, std::initializer_list<std::string_view> names);

} // namespace denhartog::conformance

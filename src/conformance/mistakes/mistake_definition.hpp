// Makers of the answers of known mistakes, and the parts of the list of all of them.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "conformance/mistakes/mistake.hpp"
#include "conformance/plain/closed_form.hpp"

namespace denhartog::conformance {

// Agreement of the mistakes that time-stepping solvers make.
inline constexpr double of_steps_in_time = 3e-2;

using Names = std::vector<std::string_view>;

// The quantities that (67) decides, those that the condition of (69) decides, and those that depend on a maximum over tau.
inline const Names of_load{"beta_lim_approximate", "beta_lim_exact", "beta_lim_paper", "regime"},
    of_boundary{"beta_lim_exact", "beta_lim_paper", "regime"}, of_maximum{"S_j", "beta_lim_exact", "beta_lim_paper", "regime"};

// The plain closed form with other choices. It affects the quantities `touched`; all if there are none.
[[nodiscard]] Answering by_formulas_of(Names touched, std::function<void(Choices&, const ProtocolQuestion&)> choose);
[[nodiscard]] Answering by_formulas(Names touched, std::function<void(Choices&)> choose);
[[nodiscard]] Answering by_formulas(Names touched, bool Choices::*choice);

// The answers of a program that makes a mistake, which is not made together with others.
[[nodiscard]] inline Answering by_itself(std::function<std::optional<Value>(const ProtocolQuestion&)> answer) {
    return {std::move(answer)};
}

// A mistake that is made only if no mode is overdamped.
[[nodiscard]] Answering where_modes_vibrate(Answering mistake);

// The right answer to some quantities, changed; or each of its numbers.
[[nodiscard]] Answering changed(Names touched, std::function<void(Value& value, const ProtocolQuestion& q)> change);
[[nodiscard]] Answering each_changed(Names touched, std::function<double(double x, const ProtocolQuestion& q)> change);
[[nodiscard]] Answering each_changed(Names touched, std::function<double(double x)> change);

// The right answer to another question; none if the change leaves the question as it is.
[[nodiscard]] Answering reading(std::function<void(ProtocolQuestion&)> change);

// Mistakes in reading a question, and in what only systems beyond the paper have.
[[nodiscard]] std::vector<Mistake> mistakes_of_input();
// Formulas as the paper prints them, if the derivation refutes them, and others in the closed form.
[[nodiscard]] std::vector<Mistake> mistakes_of_formulas();
// Mistakes in the convention of an answer, such as its unit or sign, and those that solvers of the motion make.
[[nodiscard]] std::vector<Mistake> mistakes_of_output();

} // namespace denhartog::conformance

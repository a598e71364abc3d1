// Makers of the answers of known mistakes, and the parts of the list of all of them.
#pragma once

#include <algorithm>
#include <functional>
#include <string_view>
#include <type_traits>
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

// Whether a question is about one of some quantities; about any if there are none.
[[nodiscard]] inline std::function<bool(const ProtocolQuestion&)> about(Names touched) {
    return [touched = std::move(touched)](const ProtocolQuestion& q) {
        return touched.empty() || std::ranges::find(touched, q.quantity) != touched.end();
    };
}

// The plain closed form with other choices: `&Choices::x` makes the choice x; a function of (Choices&), or of (Choices&,
// question), changes them.
template <class Choose>
[[nodiscard]] Answering by_formulas(Names touched, Choose choose) {
    return {.touches = about(std::move(touched)), .choose = [choose](Choices& c, const ProtocolQuestion& q) {
                if constexpr (std::is_same_v<Choose, bool Choices::*>)
                    c.*choose = true;
                else if constexpr (std::is_invocable_v<Choose, Choices&>)
                    choose(c);
                else
                    choose(c, q);
            }};
}

// The answers of a program that makes a mistake. It is never combined with other mistakes.
[[nodiscard]] inline Answering by_itself(std::function<std::optional<Value>(const ProtocolQuestion&)> answer) {
    return {std::move(answer)};
}

// A mistake that is made only if no mode is overdamped; not one that is `by_itself`.
[[nodiscard]] inline Answering where_modes_vibrate(Answering mistake) {
    mistake.touches = [touches = std::move(mistake.touches)](const ProtocolQuestion& q) {
        return !is_overdamped(q) && touches(q);
    };
    return mistake;
}

// The right answer to some quantities, changed; or each of its numbers.
[[nodiscard]] inline Answering changed(Names touched, std::function<void(Value& value, const ProtocolQuestion& q)> change) {
    return {.touches = about(std::move(touched)), .change = std::move(change)};
}
template <class Change>
[[nodiscard]] Answering each_changed(Names touched, Change change) {
    return changed(std::move(touched), [change](Value& value, const ProtocolQuestion& q) {
        for (double& x : value.numbers)
            if constexpr (std::is_invocable_v<Change, double>)
                x = change(x);
            else
                x = change(x, q);
    });
}

// The right answer to another question; none if the change leaves the question as it is.
[[nodiscard]] inline Answering reading(std::function<void(ProtocolQuestion&)> change) {
    const auto touches = [change](const ProtocolQuestion& q) {
        ProtocolQuestion other = q;
        change(other);
        return other != q;
    };
    return {.touches = touches, .read = std::move(change)};
}

// The answer that is read off in a period of the force, counted from rest.
[[nodiscard]] Answering read_off_in(int period);

// Mistakes in reading a question, and in what only systems beyond the paper have.
[[nodiscard]] std::vector<Mistake> mistakes_of_input();
// Formulas as the paper prints them, if the derivation refutes them, and others in the closed form.
[[nodiscard]] std::vector<Mistake> mistakes_of_formulas();
// Mistakes in the convention of an answer, such as its unit or sign, and those that solvers of the motion make.
[[nodiscard]] std::vector<Mistake> mistakes_of_output();

} // namespace denhartog::conformance

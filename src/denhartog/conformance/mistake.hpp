/// @file
/// @brief Known mistakes, each as the answers that an implementation gives that makes it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "denhartog/conformance/question.hpp"

namespace denhartog::conformance {

/// @brief A known mistake.
struct Mistake {
    std::string name;     ///< stable name, e.g. `46-as-printed`, `mu-ignored`
    std::string equation; ///< equation of the paper that it is about; empty where it is about none
    bool as_printed;      ///< whether it is the paper's print
    std::string told;     ///< what it is, a sentence with the equation
    std::string look_at;  ///< what to look at in the code that makes it
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

/// @brief What implementations answer that make a mistake which has more than one form: the number of periods integrated, of
/// harmonics kept, of instants tried; one answer a form, always in the same order.
///
/// A diagnosis compares an answer with all of them and takes the nearest. Where it wants one form to explain every answer, it
/// compares by position in the list; positions are the same for all questions of a quantity where no answer is left out.
/// @param name  name of the mistake
/// @param q     the question; its scene keeps the rules
/// @return      the answers, the first of them that of `answer_with_mistake`; none where that has none
/// @throws      InputError for a name that is none
[[nodiscard]] std::vector<Value> answers_with_mistake(std::string_view name, const Question& q);

} // namespace denhartog::conformance

/// @file
/// @brief Known mistakes. Each is given by the answers of an implementation that makes it.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/question.hpp"

namespace denhartog::conformance {

/// @brief The largest distance from the answer of a mistake that explains it, in units of the distance from the truth.
inline constexpr double nearer_than_truth = 0.1;

struct Choices;

/// @brief A mistake: the answers of a program that makes it, or its change of a program that is right otherwise. Only
/// mistakes that are given by such changes can be made together.
struct Answering {
    /// The answer of a program that makes this mistake alone; empty: it follows from the changes.
    std::function<std::optional<Value>(const ProtocolQuestion&)> alone = {};
    std::function<bool(const ProtocolQuestion&)> touches =
        {}; ///< whether it changes an answer; empty: it is not made together with others
    std::function<void(ProtocolQuestion&)> read = {};                   ///< changes the question that is read
    std::function<void(Choices&, const ProtocolQuestion&)> choose = {}; ///< changes the formulas
    std::function<void(Value&, const ProtocolQuestion&)> change = {};   ///< changes the answer

    /// @brief The answer of a program that makes this mistake alone.
    /// @param q  the question
    /// @return   the answer; none if the mistake does not touch the question, or if its answer cannot be computed
    [[nodiscard]] std::optional<Value> operator()(const ProtocolQuestion& q) const;
};

/// @brief The answer of a program that makes several mistakes.
/// @param several  what the mistakes change; those that cannot be made together with others are left out
/// @param q        the question
/// @return         the answer; none if no mistake touches the question, or if the answer cannot be computed
[[nodiscard]] std::optional<Value> answer_with_several(std::span<const Answering* const> several, const ProtocolQuestion& q);

/// @brief A known mistake.
struct Mistake {
    std::string name;     ///< stable name, e.g. `46-as-printed`, `mu-ignored`
    std::string equation; ///< equation of the paper that it concerns; empty if it concerns none
    std::string told;     ///< a sentence that says what the mistake is, with the equation
    std::string look_at;  ///< the place to look at in code that makes it; completes "Look at ..."
    Answering answer;     ///< see `answer_with_mistake`
    /// The quantities of its own equation, by which alone the mistake is weighed: a program that has (44) as printed may take the
    /// motion from (46), or have that as printed as well. Empty if it is weighed by all quantities that it affects.
    std::vector<std::string> core = {};
    /// The relative distance from its answer within which implementations that make the mistake answer. Rounding decides it if
    /// one formula stands for another; the steps in time or the harmonics decide it if the mistake is a solver's.
    double agreement = 1e-6;
    bool as_printed = false;               ///< whether the code follows the equation as the paper prints it
    std::string number = {};               ///< the number of its own that answers show, in words; empty if they show none
    std::vector<std::string> besides = {}; ///< names of other mistakes that the answers show as well
};

/// @brief All known mistakes, sorted by name. @return the mistakes
[[nodiscard]] std::span<const Mistake> mistakes();

/// @brief The answer of an implementation that makes a mistake, in double.
///
/// The parts of the answer that the mistake does not affect are as accurate as the plain closed form in double.
/// @param name  name of the mistake
/// @param q     the question; its scene obeys the rules
/// @return      the answer; none if the mistake does not affect the quantity, or if its answer cannot be computed
/// @throws      InputError if no mistake has this name
[[nodiscard]] std::optional<Value> answer_with_mistake(std::string_view name, const ProtocolQuestion& q);

} // namespace denhartog::conformance

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

/// @brief A known mistake.
struct Mistake {
    std::string name;     ///< stable name, e.g. `46-as-printed`, `mu-ignored`
    std::string equation; ///< equation of the paper that it concerns; empty if it concerns none
    std::string told;     ///< a sentence that says what the mistake is, with the equation
    std::string look_at;  ///< the place to look at in code that makes it; completes "Look at ..."
    std::function<std::optional<Value>(const ProtocolQuestion&)> answer; ///< see `answer_with_mistake`
    /// The relative distance from its answer within which implementations that make the mistake answer. Rounding decides it if
    /// one formula stands for another; the steps in time or the harmonics decide it if the mistake is a solver's.
    double agreement = 1e-6;
    /// The quantities of its own equation, if the mistake need not affect the other quantities that it can affect: a program
    /// that has (44) as printed may take the motion from (46). Empty if it affects all of them.
    std::vector<std::string> core = {};
    bool as_printed = false; ///< whether the code follows the equation as the paper prints it
    std::string number = {}; ///< the number of its own that answers show, in words; empty if they show none
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

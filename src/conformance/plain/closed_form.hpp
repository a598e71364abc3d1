/// @file
/// @brief The answers of the plain closed form to every quantity of the protocol, with its points of variation.
#pragma once

#include <optional>
#include <string_view>

#include "conformance/plain/modes.hpp"

namespace denhartog::conformance {

/// @brief The boundaries of the regimes as the plain closed form has them.
struct PlainLimits {
    double S = 0;           ///< what (69) takes for the largest demand: the maximum of the sum over modes
    double exact = 0;       ///< (69) with it
    double paper = 0;       ///< (69) with (56)
    double approximate = 0; ///< (67)
    double sticking = 0;    ///< the smallest beta at which the contact never moves
};

/// @brief Which boundaries are computed; searches for a maximum cost most.
struct Needed {
    bool S = true;        ///< S and `exact`
    bool paper = true;    ///< `paper`
    bool sticking = true; ///< `sticking`
};

/// @brief The boundaries that a quantity needs. @param quantity its name @return what is needed
[[nodiscard]] Needed needed_for(std::string_view quantity);

/// @brief The boundaries at a question's frequency ratio.
/// @param q  the question
/// @param m  its modes
/// @param c  the points of variation
/// @param needed  which of them
/// @return   the boundaries; 0 where one is not needed
[[nodiscard]] PlainLimits plain_limits(const Question& q, const PlainModes& m, const Choices& c, const Needed& needed = {});

/// @brief The answer of the plain closed form to a question; beyond the sliding regime that of the exact solver in double.
/// @param q  the question, of a scene of the paper; where it breaks a rule that friction has, the formulas answer as they stand
/// @param c  the points of variation
/// @return   the answer; none where it is not finite, or the question has none
[[nodiscard]] std::optional<Value> plain_answer(const Question& q, const Choices& c);

/// @brief The same without variation, and of any system: one beyond the paper is answered by `answer_of_system`.
/// @param q  the question
/// @return   the answer; none where it is not finite, or the question has none
[[nodiscard]] std::optional<Value> plain_answer(const Question& q);

/// @brief An angle as the protocol has it. @param angle radians @return the same direction in (-pi, pi]
[[nodiscard]] double wrapped_angle(double angle);

} // namespace denhartog::conformance

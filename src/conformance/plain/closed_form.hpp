/// @file
/// @brief The answers of the plain closed form to every quantity of the protocol, with its points of variation.
#pragma once

#include <optional>

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

/// @brief The boundaries at a question's frequency ratio.
/// @param q  the question
/// @param m  its modes
/// @param c  the points of variation
/// @return   the boundaries
[[nodiscard]] PlainLimits plain_limits(const Question& q, const PlainModes& m, const Choices& c);

/// @brief The answer of the plain closed form to a question; beyond the sliding regime that of the exact solver in double.
/// @param q  the question; it may break the rules that friction has, and is then answered by the formulas as they stand
/// @param c  the points of variation
/// @return   the answer; none where it is not finite, or the question has none
[[nodiscard]] std::optional<Value> plain_answer(const Question& q, const Choices& c = {});

/// @brief An angle as the protocol has it. @param angle radians @return the same direction in (-pi, pi]
[[nodiscard]] double wrapped_angle(double angle);

} // namespace denhartog::conformance

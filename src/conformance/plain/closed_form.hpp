/// @file
/// @brief The answers of the plain closed form to every quantity of the protocol, with its points of variation.
#pragma once

#include <optional>
#include <string_view>

#include "conformance/plain/modes.hpp"

namespace denhartog::conformance {

/// @brief The boundaries of the regimes by the plain closed form.
struct PlainLimits {
    double S = 0;           ///< the largest demand in (69): the maximum of the sum over modes
    double exact = 0;       ///< (69) with S
    double S_paper = 0;     ///< that of (56): the sum of the maxima of the modes
    double paper = 0;       ///< (69) with (56)
    double approximate = 0; ///< (67)
    double sticking = 0;    ///< the smallest beta at which the contact never moves
};

/// @brief Says which boundaries to compute. The searches for a maximum cost most of the time.
struct Needed {
    bool S = true;        ///< S and `exact`
    bool paper = true;    ///< `paper`
    bool sticking = true; ///< `sticking`
};

/// @brief The boundaries that a quantity needs. @param quantity its name @return which boundaries to compute
[[nodiscard]] Needed needed_for(std::string_view quantity);

/// @brief The boundaries at a question's frequency ratio.
/// @param q  the question
/// @param m  its modes
/// @param c  the points of variation
/// @param needed  which of them to compute
/// @return   the boundaries; 0 for one that is not needed
[[nodiscard]] PlainLimits plain_limits(const ProtocolQuestion& q, const PlainModes& m, const Choices& c,
                                       const Needed& needed = {});

/// @brief The answer of the plain closed form to a question; beyond the sliding regime the exact solver answers in double.
/// @param q  the question, of a scene of the paper; the formulas are used as they stand even if it breaks a rule of friction
/// @param c  the points of variation
/// @return   the answer; none if it is not finite, or if the question has no answer
[[nodiscard]] std::optional<Value> plain_answer(const ProtocolQuestion& q, const Choices& c);

/// @brief The same without variation, for any system: `answer_of_system` answers for systems beyond the paper.
/// @param q  the question
/// @return   the answer; none if it is not finite, or if the question has no answer
[[nodiscard]] std::optional<Value> plain_answer(const ProtocolQuestion& q);

/// @brief An angle as the protocol gives it. @param angle radians @return the same direction in (-pi, pi]
[[nodiscard]] double wrapped_angle(double angle);

} // namespace denhartog::conformance

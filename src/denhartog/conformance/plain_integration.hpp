/// @file
/// @brief What an integrator answers beyond the sliding regime, and on the way to the steady motion: by the exact solver in double.
#pragma once

#include <optional>

#include "denhartog/conformance/question.hpp"

namespace denhartog::conformance {

/// @brief The answer where the contact rests for a part of every period, or for ever.
/// @param q  the question, of a quantity of the motion
/// @return   the answer; none where no steady motion of one period is found
[[nodiscard]] std::optional<Value> answer_of_steady_motion(const Question& q);

/// @brief The answer read off the last of some periods from rest.
/// @param q        the question, of a quantity of the motion
/// @param periods  number of periods of the force, at least 1
/// @return         the answer; none where the quantity is none of a motion
[[nodiscard]] std::optional<Value> answer_of_transient(const Question& q, int periods);

} // namespace denhartog::conformance

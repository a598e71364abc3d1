/// @file
/// @brief The answers of integrators beyond the sliding regime and before the motion is steady, by the exact solver in double.
#pragma once

#include <optional>
#include <vector>

#include "conformance/question.hpp"

namespace denhartog::conformance {

/// @brief The answer for a contact that rests during a part of every period, or permanently.
/// @param q  the question, of a quantity of the motion
/// @return   the answer; none if no steady motion of one period is found
[[nodiscard]] std::optional<Value> answer_of_steady_motion(const ProtocolQuestion& q);

/// @brief The answers that are read off some of the periods between rest and the steady motion.
/// @param q      the question, of a quantity of the motion
/// @param first  the first of these periods of the force, at least 1
/// @param last   the last of them
/// @return       one answer for each period; none if the quantity does not belong to a motion, or the scene not to the paper
[[nodiscard]] std::vector<std::optional<Value>> answers_of_transient(const ProtocolQuestion& q, int first, int last);

/// @brief The answer of a solver that replaces sgn by a hyperbolic tangent: a contact that should rest permanently creeps.
///
/// \f[ \bar{x}_j' = -\varepsilon\,\mathrm{artanh}\frac{|\lambda|\cos(\tau+\angle\lambda)}{\beta} \f] with the load
/// \f$ \lambda \f$ of (88) on the held contact; this is of first order in the width.
/// @param q      the question, of amplitude or motion
/// @param width  velocity over which friction changes its sign, in the unit of d x / d tau
/// @return       the answer; none if another mass is asked about, the contact moves, or only static friction holds it
[[nodiscard]] std::optional<Value> answer_of_creep(const ProtocolQuestion& q, double width);

} // namespace denhartog::conformance

/// @file
/// @brief What integrators answer beyond the sliding regime and on the way to the steady motion, by the exact solver in double.
#pragma once

#include <optional>
#include <vector>

#include "conformance/question.hpp"

namespace denhartog::conformance {

/// @brief The answer where the contact rests for a part of every period, or for ever.
/// @param q  the question, of a quantity of the motion
/// @return   the answer; none where no steady motion of one period is found
[[nodiscard]] std::optional<Value> answer_of_steady_motion(const Question& q);

/// @brief The answers read off some periods on the way from rest to the steady motion.
/// @param q      the question, of a quantity of the motion
/// @param first  the first period of the force that is read off, at least 1
/// @param last   the last
/// @return       the answers, a period each; none where the quantity is none of a motion, or the scene none of the paper
[[nodiscard]] std::vector<std::optional<Value>> answers_of_transient(const Question& q, int first, int last);

/// @brief The answer of a solver that replaces sgn by a hyperbolic tangent, where the contact should rest for ever: it creeps.
///
/// \f[ \bar{x}_j' = -\varepsilon\,\mathrm{artanh}\frac{|\lambda|\cos(\tau+\angle\lambda)}{\beta} \f] with the load
/// \f$ \lambda \f$ of (88) on the held contact, to first order in the width.
/// @param q      the question, of amplitude or motion
/// @param width  velocity over which friction changes its sign, in the unit of d x / d tau
/// @return       the answer; none where the contact is not asked about, moves, or is held by static friction alone
[[nodiscard]] std::optional<Value> answer_of_creep(const Question& q, double width);

} // namespace denhartog::conformance

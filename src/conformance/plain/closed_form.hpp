// The answers of the plain closed form to every quantity of the protocol. It shares nothing with the library
// but the elementary functions.
#pragma once

#include "conformance/plain/modes.hpp"

namespace denhartog::conformance {

// The largest demand in (69): the maximum over tau of the sum over modes, or (56), the sum of the maxima of the modes.
[[nodiscard]] double plain_demand(const PlainModes& m, const Choices& c, bool of_paper);

// (69) with a demand and the load condition (67); with the demand alone; (67).
[[nodiscard]] double plain_limit(const PlainModes& m, const Choices& c, double S);
[[nodiscard]] double plain_limit_by(const PlainModes& m, double S);
[[nodiscard]] double plain_approximate_limit(const PlainModes& m, const Choices& c);

// The smallest beta at which the contact never moves; the same by (88) as printed, no number where that has none, and without the
// damping forces on the contact; and by (88) from sub-matrices of M, C and K, as its text has it.
[[nodiscard]] double plain_sticking_limit(const ProtocolQuestion& q, const PlainModes& m, const Choices& c);
[[nodiscard]] double plain_sticking_limit_by_88(const ProtocolQuestion& q);
[[nodiscard]] double plain_sticking_limit_without_damping(const ProtocolQuestion& q);
[[nodiscard]] double plain_sticking_limit_by_sub_matrices(const ProtocolQuestion& q);

// The answer of the plain closed form to a question, and of the motion from event to event beyond the sliding regime. The formulas
// are used as they stand even if the scene breaks a rule of friction. None if the answer is not finite, or if the question has none.
[[nodiscard]] std::optional<Value> plain_answer(const ProtocolQuestion& q);

// The answer under a variation, for scenes of the paper.
[[nodiscard]] std::optional<Value> plain_answer(const ProtocolQuestion& q, const Choices& c);

// The answer to a question of an absolute motion, where the motion of the frame is added so many times: once is right, and not at
// all gives the relative motion.
[[nodiscard]] std::optional<Value> plain_answer_in_frame(const ProtocolQuestion& q, double times_frame);

// An answer; none where it has a number that is not finite, or where NoPlainAnswer is thrown.
[[nodiscard]] std::optional<Value> where_finite(const std::function<std::optional<Value>()>& answer);

// The values of a function at the instants of a question, equally spaced over a period from 0 on.
[[nodiscard]] Value sampled(const ProtocolQuestion& q, const std::function<double(double tau)>& f);

// An angle as the protocol gives it, in (-pi, pi].
[[nodiscard]] double wrapped_angle(double angle);

// The answers that are read off some of the periods between rest and the steady motion, one for each period of the force from
// the first, at least 1, to the last. Throws NoPlainAnswer.
[[nodiscard]] std::vector<std::optional<Value>> answers_of_transient(const ProtocolQuestion& q, int first, int last);

// The answer of a solver that replaces sgn by a hyperbolic tangent, to a question of amplitude or motion: a contact that should
// rest permanently creeps with x_j' = -width artanh(|load| cos(tau + arg load) / beta), with the load of (88) on the held
// contact; this is of first order in the width, a velocity in the unit of d x / d tau. None if another mass is asked about, the
// contact moves, or only static friction holds it.
[[nodiscard]] std::optional<Value> answer_of_creep(const ProtocolQuestion& q, double width);

} // namespace denhartog::conformance

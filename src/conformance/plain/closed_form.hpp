// The answers of the plain closed form, and of the exact solver in double beyond it, to every quantity of the protocol, with its points of variation.
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "conformance/plain/modes.hpp"

namespace denhartog::conformance {

// The boundaries of the regimes by the plain closed form.
struct PlainLimits {
    double S = 0;           // the largest demand in (69): the maximum of the sum over modes
    double exact = 0;       // (69) with S
    double S_paper = 0;     // that of (56): the sum of the maxima of the modes
    double paper = 0;       // (69) with (56)
    double approximate = 0; // (67)
    double sticking = 0;    // the smallest beta at which the contact never moves
};

// Says which boundaries to compute. The searches for a maximum cost most of the time.
struct Needed {
    bool S = true;        // S and `exact`
    bool paper = true;    // `paper`
    bool sticking = true; // `sticking`
};

// The boundaries that a quantity needs.
[[nodiscard]] Needed needed_for(std::string_view quantity);

// The boundaries at a question's frequency ratio. 0 for one that is not needed.
[[nodiscard]] PlainLimits plain_limits(const ProtocolQuestion& q, const PlainModes& m, const Choices& c,
                                       const Needed& needed = {});

// The answer of the plain closed form to a question; beyond the sliding regime the exact solver answers in double. The
// scene is of the paper; the formulas are used as they stand even if it breaks a rule of friction. None if the answer is not
// finite, or if the question has none.
[[nodiscard]] std::optional<Value> plain_answer(const ProtocolQuestion& q, const Choices& c);

// The same without variation, for any system: `answer_of_system` answers for systems beyond the paper.
[[nodiscard]] std::optional<Value> plain_answer(const ProtocolQuestion& q);

// An answer; none where it has a number that is not finite, or no answer but an InputError, a DomainError or a PrecisionError.
[[nodiscard]] std::optional<Value> where_finite(const std::function<std::optional<Value>()>& answer);

// An angle as the protocol gives it, in (-pi, pi].
[[nodiscard]] double wrapped_angle(double angle);

// The answer for a contact that rests during a part of every period, or permanently. None if no steady motion
// of one period is found.
[[nodiscard]] std::optional<Value> answer_of_steady_motion(const ProtocolQuestion& q);

// The answers that are read off some of the periods between rest and the steady motion. One answer for
// each period of the force from the first, at least 1, to the last; none if the quantity does not belong to a motion, or the scene
// not to the paper.
[[nodiscard]] std::vector<std::optional<Value>> answers_of_transient(const ProtocolQuestion& q, int first, int last);

/// @brief The answer of a solver that replaces sgn by a hyperbolic tangent: a contact that should rest permanently creeps.
///
/// \f[ \bar{x}_j' = -\varepsilon\,\mathrm{artanh}\frac{|\lambda|\cos(\tau+\angle\lambda)}{\beta} \f] with the load
/// \f$ \lambda \f$ of (88) on the held contact; this is of first order in the width.
/// @param q      the question, of amplitude or motion
/// @param width  velocity over which friction changes its sign, in the unit of d x / d tau
/// @return       the answer; none if another mass is asked about, the contact moves, or only static friction holds it
[[nodiscard]] std::optional<Value> answer_of_creep(const ProtocolQuestion& q, double width);

// The answer about a system beyond the paper (a contact between two masses, several loads, a moving base, matrices), by the library in double. None if only a chain has
// the quantity, or if the motion takes more than one period to repeat. Throws InputError if the question breaks a rule;
// DomainError and PrecisionError if the library has no answer.
[[nodiscard]] std::optional<Value> answer_of_system(const ProtocolQuestion& q);

} // namespace denhartog::conformance

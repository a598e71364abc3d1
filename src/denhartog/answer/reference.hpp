/// @file
/// @brief Answers by the reference: the paper's own formulas on balls, to any number of digits, every number proved.
#pragma once

#include <functional>
#include <vector>

#include "denhartog/answer/scene_source.hpp"
#include "denhartog/answer/solution.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/tried.hpp"
#include "denhartog/sliding/invariant_points.hpp"
#include "denhartog/stick_slip/motion_record.hpp"

namespace denhartog {

/// @brief A question to the reference: the digits, or those by default, are all certain in the answer, and every number is
/// proved.
struct ReferenceQuestion : Question {
    std::optional<Regime> met{};    ///< the regime of the motion that is meant, where the friction ratio does not tell it
    bool with_boundary = false;     ///< whether the boundaries must be there where `met` does not need them
    bool closed_form_alone = false; ///< whether only boundary and regime are wanted outside the sliding regime
};

/// @brief The answer of the reference, or what it proves of the regime.
struct AnswerByReference : Tried<Solution> {
    /// Without an answer: true where it is proved that the contact sticks and slips, false where there certainly is no motion of
    /// the regime that was to be proved, empty where neither is proved
    std::optional<bool> regime_holds{};
};

/// @brief The answer of the reference; without beta the boundaries alone. Bits are doubled until every number asked for has its
/// digits. `guesses` gives motions with stops near the one that is meant, as double sees them, the likeliest first; it is called
/// once at most. InputError where the scene breaks a rule that double is too coarse to see broken.
[[nodiscard]] AnswerByReference solution_by_reference(const SceneSource& source, const ReferenceQuestion& question,
                                                      const std::function<std::vector<OrbitGuess>()>& guesses);

/// @brief The motion of an answer to `Asked::motion` at instants from a maximum of the force; a contact that never moves rests at
/// zero. A displacement may be off by `tolerance` of the amplitude of its mass, beside the error of that amplitude, and a
/// velocity of the largest of its mass or of the amplitude, whichever is more. None where it is not proved to be the answer's
/// motion.
[[nodiscard]] Tried<std::vector<State>> samples_by_reference(const SceneSource& source, const Solution& solution,
                                                             const std::vector<double>& tau, double tolerance,
                                                             const std::function<std::vector<OrbitGuess>()>& guesses);

/// @brief The energies of the motion of an answer to `Asked::motion`; PrecisionError where they are not proved.
[[nodiscard]] Energies energies_by_reference(const SceneSource& source, const Solution& solution, int digits,
                                             const std::function<std::vector<OrbitGuess>()>& guesses);

/// @brief The ends of a range of frequency ratios as text, which every number type reads to its own digits.
struct RangeInText {
    std::string from; ///< positive
    std::string to;   ///< above it
};

/// @brief The invariant points of every mass in a range, damping left out, and the stretches that stay undecided. Bits are
/// doubled until every point has its digits, once at most where none are asked for. InputError where the range breaks a rule,
/// PrecisionError where something cannot be proved. @eq{87}
[[nodiscard]] std::vector<InvariantPointsOfMass<Certified>> invariant_points(const SceneSource& source, const RangeInText& range,
                                                                             std::optional<int> digits = {});

} // namespace denhartog

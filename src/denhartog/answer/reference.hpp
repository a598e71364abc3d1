/// @file
/// @brief Answers by the reference: the paper's own formulas on balls, to any number of digits, every number proved.
#pragma once

#include <functional>
#include <vector>

#include "denhartog/answer/energy.hpp"
#include "denhartog/answer/scene_source.hpp"
#include "denhartog/answer/solution.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/reference/orbit_guess_data.hpp"
#include "denhartog/sliding/invariant_points.hpp"

namespace denhartog {

/// @brief Whether the library was built with the reference. @return false of one built with `DENHARTOG_REFERENCE=OFF`
[[nodiscard]] bool has_reference();

/// @brief A question to the reference: the digits, or those by default, are all certain in the answer, and every number is proved.
struct ReferenceQuestion : Question {
    std::optional<Regime> met{};    ///< the regime of the motion that is meant, where the friction ratio does not tell it
    bool closed_form_alone = false; ///< whether only boundary and regime are wanted outside the sliding regime
};

/// @brief The answer of the reference. Bits are doubled until every number asked for has its digits.
/// @param source    the scene, with r; without beta the boundaries alone are computed
/// @param question  the question
/// @param guesses   motions with stops near the one that is meant, as double sees them, the likeliest first; called once at most
/// @return          the answer, whose numbers are proved; or none, where something cannot be proved, the budget of work is spent,
///                  or the library was built without the reference
/// @throws          InputError where the scene breaks a rule that double is too coarse to see broken
[[nodiscard]] AnswerOrNone solution_by_reference(const SceneSource& source, const ReferenceQuestion& question,
                                                 const std::function<std::vector<OrbitGuess>()>& guesses);

/// @brief The motion of an answer at given instants, proved.
/// @param source     the scene, with r and beta
/// @param solution   its answer to `Asked::motion`, which says what motion it is; a contact that never moves rests at zero
/// @param tau        instants, from a maximum of the force
/// @param tolerance  what a displacement may be off by of the amplitude of its mass, beside the error of that amplitude, and a
///                   velocity of the largest of its mass or of the amplitude, whichever is more
/// @param guesses    motions with stops near that of the answer, as double sees them; called once at most
/// @return           displacements and velocities of all masses
/// @throws           PrecisionError where something cannot be proved, as with `solution_by_reference`, and where the motion
///                   that is proved is not that of the answer
[[nodiscard]] std::vector<State> samples_by_reference(const SceneSource& source, const Solution& solution,
                                                      const std::vector<double>& tau, double tolerance,
                                                      const std::function<std::vector<OrbitGuess>()>& guesses);

/// @brief What the motion of an answer dissipates, proved in every regime.
/// @param source    the scene, with r and beta
/// @param solution  its answer to `Asked::motion`, which says what motion it is
/// @param digits    significant digits
/// @param guesses   as of `samples_by_reference`
/// @return          energies and forces
/// @throws          PrecisionError as `samples_by_reference`
[[nodiscard]] Energies energies_by_reference(const SceneSource& source, const Solution& solution, int digits,
                                             const std::function<std::vector<OrbitGuess>()>& guesses);

/// @brief The ends of a range of frequency ratios as text, which every number type reads to its own digits.
struct RangeInText {
    std::string from; ///< positive
    std::string to;   ///< above it
};

/// @brief The invariant points of every mass, damping left out. Bits are doubled until every point has its digits.
/// @eq{87}
/// @param source   the scene
/// @param range    frequency ratios between which points are wanted
/// @param digits   significant digits, all certain in the answer; where none are asked for the aim is 6, and bits are doubled once
///                 at most
/// @return         the points of each mass, in their order; every number is proved. Stretches that stay undecided are listed
/// @throws         InputError where the range breaks a rule, see `invariant_points_in_balls`; PrecisionError where something
///                 cannot be proved, the budget of work is spent, or the library was built without the reference
[[nodiscard]] std::vector<InvariantPointsOfMass<Certified>> invariant_points(const SceneSource& source, const RangeInText& range,
                                                                             std::optional<int> digits = {});

} // namespace denhartog

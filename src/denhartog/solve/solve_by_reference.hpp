/// @file
/// @brief Questions that the reference answers: those for a proof, and those of which double does not have the digits.
#pragma once

#include <functional>

#include "denhartog/reference/orbit_guess_data.hpp"
#include "denhartog/solve/solve_task.hpp"

namespace denhartog {

/// @brief Motions near the one from rest, as double sees them: what a proof starts from.
/// @param p       the system; what it has prepared is used
/// @param source  the scene, with r and beta
/// @return        the motions, the likeliest first
[[nodiscard]] std::vector<OrbitGuess> guesses_at(const PreparedSystem& p, const SceneSource& source);

/// @brief An answer in double.
struct AnswerInDouble {
    Solution solution{};   ///< the answer
    bool open = false;     ///< whether double does not tell what the contact does
    bool is_answer = true; ///< whether the regime is certain nevertheless, so that it answers where the reference does not

    /// @brief Whether it needs nothing more. @return true where it has its digits, and the regime is certain
    [[nodiscard]] bool is_settled() const { return solution.digits_reached && !open && !solution.regime.on_boundary; }
};

/// @brief How double answers a question.
using InDouble = std::function<AnswerInDouble(const Question&)>;

/// @brief An answer in double, or else by the reference.
/// @param p         the system, prepared
/// @param at        the point
/// @param question  the question, its mass in the order of the masses
/// @param fast      answers a question in double
/// @return          the answer, masses in their order
/// @throws          what double throws, where the reference cannot help; PrecisionError where the digits asked for are not reached
[[nodiscard]] Solution answer_or_reference(const PreparedSystem& p, const SolvePoint& at, const Question& question,
                                           const InDouble& fast);

/// @brief Boundary, regime and sliding motion of a scene, with its masses in their order.
/// @param source    the scene, with r; without beta the boundary alone
/// @param question  what is asked
/// @param proved    whether every number must be proved
/// @return          the answer, of the one mass alone if that is asked about; no masses outside the sliding regime; `digits_reached`
///                  where its digits are there
/// @throws          as `sliding_solution`
[[nodiscard]] Solution sliding_answer(const SceneSource& source, const SlidingQuestion& question, bool proved = false);

/// @brief The same for every mass.
/// @param source  the scene, with r; without beta the boundary alone
/// @param digits  significant digits; none for 6 that are aimed at
/// @param proved  whether every number must be proved
/// @return        the answer; no masses outside the sliding regime
/// @throws        as `sliding_solution`; PrecisionError where the digits asked for are not reached
[[nodiscard]] Solution sliding_answer(const SceneSource& source, std::optional<int> digits, bool proved);

} // namespace denhartog

/// @file
/// @brief Questions that the reference answers: those for a proof, and those of which double does not have the digits.
#pragma once

#include <functional>

#include "denhartog/reference/orbit_guess_data.hpp"
#include "denhartog/solve/solve_task.hpp"

namespace denhartog {

/// @brief Motions near the one from rest, as double sees them, the likeliest first: what a proof starts from. What the system has
/// prepared is used.
[[nodiscard]] std::vector<OrbitGuess> guesses_at(const PreparedSystem& p, const SceneSource& source);

/// @brief An answer in double.
struct AnswerInDouble {
    Solution solution{};   ///< the answer
    bool open = false;     ///< whether double does not tell what the contact does
    bool is_answer = true; ///< whether the regime is certain nevertheless, so that it answers where the reference does not

    /// @brief Whether it needs nothing more: it has its digits, and the regime is certain.
    [[nodiscard]] bool is_settled() const { return solution.digits_reached && !open && !solution.regime.on_boundary; }
};

/// @brief How double answers a question.
using InDouble = std::function<AnswerInDouble(const Question&)>;

/// @brief An answer in double, or else by the reference. The mass of the question and those of the answer are in the order of the
/// masses. What `fast` throws comes out where the reference cannot help; PrecisionError where the digits asked for are not
/// reached.
[[nodiscard]] Solution answer_or_reference(const PreparedSystem& p, const SolvePoint& at, const Question& question,
                                           const InDouble& fast);

/// @brief Boundary, regime and sliding motion of a scene, with its masses in their order, as `sliding_solution` has them; with
/// `proved` every number is proved. If one mass is asked about, it alone is listed.
[[nodiscard]] Solution sliding_answer(const SceneSource& source, const SlidingQuestion& question, bool proved = false);

/// @brief The same for every mass; without digits 6 are aimed at. PrecisionError where the digits asked for are not reached.
[[nodiscard]] Solution sliding_answer(const SceneSource& source, std::optional<int> digits, bool proved);

} // namespace denhartog

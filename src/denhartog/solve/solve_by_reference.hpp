/// @file
/// @brief Questions that the reference answers: those for a proof, and those of which double does not have the digits.
#pragma once

#include <functional>

#include "denhartog/reference/orbit_guess_data.hpp"
#include "denhartog/solve/solve_task.hpp"

namespace denhartog {

/// @brief What a proof of a motion that double found periodic starts from, in the masses of the scene. Stops and slips shorter
/// than `shortest`, in tau, are left out; zero leaves out those of no length only. There are no directions where the motion has
/// no phases that repeat.
[[nodiscard]] OrbitGuess guess_of(ExactSolver& solver, const PeriodicOrbit& orbit, double shortest = 0);

/// @brief Motions that differ from a guess by one stop of nearly no length, which rounding may have invented or hidden; the
/// likeliest first.
///
/// Where double precision sees the contact turn without a stop, or slide on at nearly no speed, a stop may hide; the shortest
/// stop or slip that it sees may be none. A motion that mirrors itself keeps doing so: the stretch of a guess holds one of each
/// pair.
[[nodiscard]] std::vector<OrbitGuess> with_other_stops(const OrbitGuess& guess);

/// @brief Motions near the one from rest, as double sees them, the likeliest first: what a proof starts from. What the system has
/// prepared is used.
[[nodiscard]] std::vector<OrbitGuess> guesses_at(const PreparedSystem& p, const SceneSource& source);

/// @brief An answer in double.
struct AnswerInDouble {
    Solution solution{};   ///< the answer
    bool open = false;     ///< whether double does not tell what the contact does
    bool is_answer = true; ///< whether the regime is certain nevertheless, so that it answers where the reference does not
    bool vague = false;    ///< whether double does not tell if the motion is stable

    /// @brief Whether it needs nothing more: it has its digits, and regime and stability are certain.
    [[nodiscard]] bool is_settled() const { return solution.digits_reached && !open && !vague && !solution.regime.on_boundary; }
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

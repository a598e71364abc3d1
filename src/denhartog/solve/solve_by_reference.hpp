/// @file
/// @brief Questions that the reference answers: those for a proof, and those whose digits double and more digits do not have.
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

/// @brief An answer on the fast floor, or else by the reference.
/// @param p         the system, prepared
/// @param at        the point
/// @param question  the question, its mass in the order of the masses
/// @param fast      answers a question on the fast floor
/// @return          the answer, masses in their order
/// @throws          what the fast floor throws, where digits are not asked for, the reference cannot help, or has no proof
[[nodiscard]] Solution answer_or_reference(const PreparedSystem& p, const SolvePoint& at, const Question& question,
                                           const std::function<Solution(const Question&)>& fast);

/// @brief Boundary, regime and sliding motion of a scene, with its masses in their order.
/// @param source  the scene, with r; without beta the boundary alone
/// @param digits  significant digits; none for 6 that are aimed at
/// @param proved  whether every number must be proved
/// @return        the answer; no masses outside the sliding regime
/// @throws        as `sliding_solution`; PrecisionError where the digits asked for are not reached
[[nodiscard]] Solution sliding_answer(const SceneSource& source, std::optional<int> digits, bool proved);

} // namespace denhartog

/// @file
/// @brief `solve`: the answer in every regime by the cheapest model that is certain to have the digits asked for.
///
/// The models, cheapest first:
///  1. amplitude or phase of the mass in contact alone, mu = 1: (38), (39) below a lower bound of (69), see `contact_alone.hpp`;
///  2. boundary, regime and closed form of all masses, or of the one that is asked about, see `sliding_solution`;
///  3. for a contact that rests the stuck response, see `held_solution`;
///  4. the exact solver's periodic orbit.
/// Each is in double, with the bounds of its numbers. Where these do not leave the digits, or the regime is open, the reference
/// answers, see `decision.hpp`.
/// The boundaries tell the regime where mu = 1. Where mu > 1 more than one motion may exist: the exact solver then follows the
/// start from rest, and where that leads into the closed form or the stuck response these give the numbers.
#pragma once

#include "denhartog/solve/prepared_system.hpp"

namespace denhartog {

/// @brief The steady motion at the point of a scene, in every regime. A bad scene or question is an InputError, a pole of a mode
/// without damping a DomainError; PrecisionError where no model reaches the digits asked for or no steady motion is found.
[[nodiscard]] Solution solve(const SceneSource& source, const Question& question);

/// @brief The same at any point of a system that is prepared: `solve` of a scene is nothing but both. Another question than was
/// prepared for is answered as well. The work of the answer is that of this point, paid from a budget, if there is one.
[[nodiscard]] Solution solve(const PreparedSystem& system, double r, double beta, const Question& question,
                             Effort* effort = nullptr);

} // namespace denhartog

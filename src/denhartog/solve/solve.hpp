/// @file
/// @brief `solve`: the answer in every regime by the cheapest model that is certain to have the digits asked for.
///
/// The models, cheapest first. Where amplitude or phase of the contact alone is asked about, another stands before them: its
/// closed form in double with bounds at the cost of the modes, see `contact_modes.hpp`, then with the modes of long double, then
/// with errors measured in 50 and 100 digits. Of any other one mass the same models answer; no other mass must have the digits.
///  1. the closed form in double with error bounds known beforehand, on the modes that matter where amplitudes or phases alone
///     are asked for: the others by their static displacement, motions but that of the contact by their first harmonic, all of it
///     with bounds of what is left out;
///  2. the closed form in double on all modes with error bounds known beforehand, first with the modes of double, then with those
///     of long double; V and U of a chain without damping without a sum over modes where that is sharper;
///  3. the closed form in double, 50 and 100 digits with measured errors, see `answer`;
///  4. for a contact that rests the stuck response, in double with the bound that its residual gives, else measured;
///  5. the exact solver's periodic orbit, in double, then in 50 digits.
/// The boundaries tell the regime where mu = 1. Where mu > 1 more than one motion may exist: the exact solver then follows the
/// start from rest, and where that leads into the closed form or the stuck response these give the numbers.
#pragma once

#include "denhartog/solve/prepared_system.hpp"

namespace denhartog {

/// @brief The steady motion at the point of a scene, in every regime.
/// @param source    the scene, with r and beta
/// @param question  what is asked
/// @return          the answer
/// @throws          InputError for a bad scene or question; DomainError at a pole of a mode without damping; PrecisionError where
///                  no model reaches the digits asked for or no steady motion is found
[[nodiscard]] Solution solve(const SceneSource& source, const Question& question);

/// @brief The same at any point of a system that is prepared: `solve` of a scene is nothing but both.
/// @param system    the system, from `prepare`
/// @param r         frequency ratio, Eq. (10)
/// @param beta      friction ratio, Eq. (11)
/// @param question  what is asked; another one than was prepared for is answered as well
/// @return          the answer; its work is that of this point
/// @throws          as above
[[nodiscard]] Solution solve(const PreparedSystem& system, double r, double beta, const Question& question);

} // namespace denhartog

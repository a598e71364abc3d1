/// @file
/// @brief From a periodic motion in double precision to what a proof of it starts from.
#pragma once

#include <vector>

#include "denhartog/orbit/periodic_orbit.hpp"
#include "denhartog/reference/orbit_guess_data.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {

/// @brief What a proof of a periodic motion starts from.
/// @param solver    system, frequency and friction of the motion
/// @param orbit     the motion, with status `periodic`
/// @param shortest  stops and slips that are shorter, in tau, are left out; zero leaves out those of no length only
/// @return          the guess, in the masses of the scene; without directions where the motion has no phases that repeat
[[nodiscard]] OrbitGuess guess_of(ExactSolver& solver, const PeriodicOrbit& orbit, double shortest = 0);

/// @brief Motions that differ from a guess by one stop of nearly no length, which rounding may have invented or hidden.
///
/// Where double precision sees the contact turn without a stop, or slide on at nearly no speed, a stop may hide; the shortest
/// stop or slip that it sees may be none. A motion that mirrors itself keeps doing so: the stretch of a guess holds one of each pair.
/// @param guess  a guess
/// @return       the others, the likeliest first
[[nodiscard]] std::vector<OrbitGuess> with_other_stops(const OrbitGuess& guess);

} // namespace denhartog

/// @file
/// @brief From a periodic motion in double precision to what a proof of it starts from.
#pragma once

#include <vector>

#include "denhartog/orbit/periodic_orbit.hpp"
#include "denhartog/reference/orbit_guess_data.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {

/// @brief What a proof of a motion that double found periodic starts from, in the masses of the scene. Stops and slips shorter
/// than `shortest`, in tau, are left out; zero leaves out those of no length only. There are no directions where the motion has
/// no phases that repeat.
[[nodiscard]] OrbitGuess guess_of(ExactSolver<double>& solver, const PeriodicOrbit<double>& orbit, double shortest = 0);

/// @brief Motions that differ from a guess by one stop of nearly no length, which rounding may have invented or hidden; the
/// likeliest first.
///
/// Where double precision sees the contact turn without a stop, or slide on at nearly no speed, a stop may hide; the shortest
/// stop or slip that it sees may be none. A motion that mirrors itself keeps doing so: the stretch of a guess holds one of each
/// pair.
[[nodiscard]] std::vector<OrbitGuess> with_other_stops(const OrbitGuess& guess);

} // namespace denhartog

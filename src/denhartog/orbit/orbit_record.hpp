/// @file
/// @brief What is read off a periodic orbit once it is found: stops, amplitudes and phases, the bound of its error.
#pragma once

#include <optional>

#include "denhartog/orbit/orbit_map.hpp"
#include "denhartog/orbit/periodic_orbit.hpp"
#include "denhartog/stick_slip/lasting_rest.hpp"

namespace denhartog {

/// @brief The largest displacement of any mass that a unit of the map's energy norm can make.
/// @param map  the map
/// @return     the displacement, units of P / k_1
[[nodiscard]] double displacement_of_energy(const OrbitMap& map);

/// @brief Bounds of the errors over an orbit.
struct ErrorsOfOrbit {
    double settled;               ///< of every displacement, as far as Newton's method can settle it; in units of P / k_1
    double displacement;          ///< the same with what turned modes make of it, as a bound that is handed out needs
    std::vector<double> velocity; ///< of the velocity of each coordinate, then of each mass that is none; likewise
};

/// @brief Bounds of the errors over an orbit.
///
/// In modal displacements times frequencies and modal velocities the distance of the start from the fixed point is bounded by
/// \f$ |(1 - DP)^{-1}| \f$ times the difference of the two ends and the rounding of the map. Along the orbit it is bounded by its
/// energy norm, which friction with mu = 1 does not let grow; for mu > 1 the largest growth that the Jacobian shows is allowed for.
/// @param map  the map, applied last to the orbit with its Jacobian, its rounding measured
/// @return     the bounds; none where the matrix is singular to rounding
[[nodiscard]] std::optional<ErrorsOfOrbit> errors_of(const OrbitMap& map);

/// @brief Reads the orbit off the map that was applied to it last, with its Jacobian, its rounding measured.
/// @param map     the map: all of the orbit, or half of it where the number h of its half-periods is odd
/// @param z       the state at tau = 0
/// @param search  what is asked of the orbit
/// @return        the orbit; none where its error is too large for a number, or the contact does not surely slip
[[nodiscard]] std::optional<PeriodicOrbit> orbit_of(const OrbitMap& map, const State& z, const OrbitSearch& search);

/// @brief The steady motion with the contact at rest, and what it leaves over as an orbit of the map.
/// @param map     the map, which is applied to it
/// @param rest    rest at the system, frequency and friction of the map
/// @param x_j     where the contact rests
/// @param search  what is asked of the orbit
/// @return        the motion; none where the contact does not stay
[[nodiscard]] std::optional<PeriodicOrbit> rest_of(OrbitMap& map, const LastingRest& rest, double x_j, const OrbitSearch& search);

} // namespace denhartog

/// @file
/// @brief The results that are read off a periodic orbit: stops, amplitudes and phases, the bound of its error, its
/// stability.
#pragma once

#include <optional>

#include "denhartog/orbit/orbit_map.hpp"
#include "denhartog/orbit/periodic_orbit.hpp"
#include "denhartog/stick_slip/lasting_rest.hpp"

namespace denhartog {

/// @brief The largest displacement of any mass that a unit of the map's energy norm can make.
[[nodiscard]] double displacement_of_energy(const OrbitMap& map);

/// @brief Bounds of the errors over an orbit.
struct ErrorsOfOrbit {
    double settled;               ///< of every displacement, as far as Newton's method can settle it; in units of P / k_1
    double displacement;          ///< the same with what turned modes make of it, as a bound that is handed out needs
    std::vector<double> velocity; ///< of the velocity of each coordinate, then of each mass that is none; likewise
};

/// @brief Bounds of the errors over the orbit to which the map was applied last, with its Jacobian; none if the matrix is
/// singular to rounding.
///
/// In modal displacements times frequencies and modal velocities the distance of the start from the fixed point is bounded by
/// \f$ |(1 - DP)^{-1}| \f$ times the difference of the two ends and the rounding of the map. Along the orbit it is bounded by its
/// energy norm, which friction with mu = 1 does not let grow; for mu > 1 the largest growth that the Jacobian shows is allowed for.
[[nodiscard]] std::optional<ErrorsOfOrbit> errors_of(const OrbitMap& map);

/// @brief Reads the orbit with the state z at tau = 0 off the map that was applied to it last, with its Jacobian: all of the
/// orbit, or half of it if the number h of its half-periods is odd. None if its error is too large for a number, or the
/// contact does not surely slip.
[[nodiscard]] std::optional<PeriodicOrbit> orbit_of(const OrbitMap& map, const State& z, const OrbitSearch& search);

/// @brief The steady motion with the contact at rest in x_j, as an orbit of the map, which is applied to it; none if the
/// contact does not stay.
[[nodiscard]] std::optional<PeriodicOrbit> rest_of(OrbitMap& map, const LastingRest& rest, double x_j, const OrbitSearch& search);

/// @brief Multipliers of the map that was applied last, for motions next to it: with the error of its rounding alone, as if the
/// instants of events were known. With mu = 1 no deviation grows, wherever they are.
[[nodiscard]] std::vector<Multiplier> multipliers_next_to(const OrbitMap& map);

/// @brief Floquet multipliers of the orbit to which the map was applied last, over its stretch.
///
/// The Jacobian is as far off as rounding makes it and as the instants of events are off: a phase that is longer by \f$ \delta
/// \f$ turns it by \f$ \delta \f$ times the rate of the fastest mode, and what an event makes of deviations depends on the
/// acceleration, or the rate of the load, at its instant. In the norm of the energy neither a phase nor, with mu = 1, an event
/// lets deviations grow, so that the errors add up; for mu > 1 the product of the growths is allowed for.
[[nodiscard]] std::vector<Multiplier> multipliers_of_orbit(const OrbitMap& map, const ErrorsOfOrbit& errors);

/// @brief Multipliers of the others, over the stretch of the map that was applied to a motion whose contact rested throughout.
[[nodiscard]] std::vector<Multiplier> multipliers_of_rest(const OrbitMap& map);

} // namespace denhartog

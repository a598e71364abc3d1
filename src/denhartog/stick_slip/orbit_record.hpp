/// @file
/// @brief What is read off a periodic orbit once it is found: stops, amplitudes and phases, the bound of its error.
#pragma once

#include <optional>

#include "denhartog/stick_slip/orbit_map.hpp"
#include "denhartog/stick_slip/periodic_orbit.hpp"

namespace denhartog {

/// @brief Stops within the period of an orbit, those across the section and the mirror point in one piece.
/// @param map  the map, applied last to the orbit over its h half-periods: all of it, or half of it where h is odd
/// @return     the stops, starts ascending in [0, period)
template <class T>
[[nodiscard]] std::vector<Stop<T>> stops_of(const OrbitMap<T>& map);

/// @brief Amplitude and phase of the mass in contact, which is farthest out where it turns back or comes to rest.
/// @param map  the map, applied last to the orbit
/// @return     its motion
template <class T>
[[nodiscard]] MassMotion<T> contact_motion(const OrbitMap<T>& map);

/// @brief Amplitude and phase of every mass.
/// @param map  the map, applied last to the orbit
/// @return     their motions
template <class T>
[[nodiscard]] std::vector<MassMotion<T>> motions_of(const OrbitMap<T>& map);

/// @brief Error of the map's Jacobian: some units in the last place for every phase and every period of the modes.
/// @param map       the map, applied last
/// @param jacobian  its Jacobian in some coordinates
/// @return          bound of the error, in the largest sum of a row
template <class T>
[[nodiscard]] double jacobian_error(const OrbitMap<T>& map, const Matrix<double>& jacobian);

/// @brief Whether the map certainly contracts next to the orbit.
/// @param map  the map, applied last to the orbit with its Jacobian
/// @return     true where all its eigenvalues are inside the unit circle by more than their error
template <class T>
[[nodiscard]] bool attracts(const OrbitMap<T>& map);

/// @brief Jacobian of the map for the other masses while the contact is held.
/// @param map  the map, applied last to a motion with the contact held
/// @return     2 (N - 1) x 2 (N - 1), in double
template <class T>
[[nodiscard]] Matrix<double> jacobian_of_others(const OrbitMap<T>& map);

/// @brief The largest displacement of any mass that a unit of the map's energy norm can make.
/// @param map  the map
/// @return     the displacement, units of P / k_1
template <class T>
[[nodiscard]] T displacement_of_energy(const OrbitMap<T>& map);

/// @brief Bound of the error of the displacements over an orbit.
///
/// The distance of the start from the fixed point is bounded by \f$ |(1 - DP)^{-1}| \f$ times the difference of the two ends and
/// the rounding of the map. Along the orbit it is bounded by its energy norm, which friction with mu = 1 does not let grow; for
/// mu > 1 the largest growth that the Jacobian shows is allowed for.
/// @param map        the map, applied last to the orbit with its Jacobian, its rounding measured
/// @return           the bound, in units of P / k_1; none where the matrix is singular to rounding
template <class T>
[[nodiscard]] std::optional<T> error_bound_of(const OrbitMap<T>& map);

} // namespace denhartog

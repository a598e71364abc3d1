/// @file
/// @brief Stability of a periodic orbit: what is known of the eigenvalues of the map over its period.
#pragma once

#include <vector>

#include "denhartog/orbit/floquet.hpp"
#include "denhartog/orbit/orbit_map.hpp"
#include "denhartog/orbit/orbit_record.hpp"

namespace denhartog {

/// @brief Whether the map certainly contracts next to the orbit.
/// @param map  the map, applied last to the orbit with its Jacobian
/// @return     true where all its eigenvalues are inside the unit circle by more than their error
[[nodiscard]] bool attracts(const OrbitMap& map);

/// @brief Floquet multipliers of an orbit.
///
/// The Jacobian is as far off as rounding makes it and as the instants of events are off: a phase that is longer by \f$ \delta
/// \f$ turns it by \f$ \delta \f$ times the rate of the fastest mode, and what an event makes of deviations depends on the
/// acceleration, or the rate of the load, at its instant. In the norm of the energy neither a phase nor, with mu = 1, an event
/// lets deviations grow, so that the errors add up; for mu > 1 the product of the growths is allowed for.
/// @param map     the map, applied last to the orbit with its Jacobian
/// @param errors  bounds of the errors over the orbit
/// @return        the multipliers over the stretch of the map, by descending size
[[nodiscard]] std::vector<Multiplier> multipliers_of_orbit(const OrbitMap& map, const ErrorsOfOrbit& errors);

/// @brief Stability of a motion at rest of the contact.
struct StabilityOfRest {
    bool stable;                         ///< whether the others certainly tend to their motion
    std::vector<Multiplier> multipliers; ///< theirs over the stretch of the map, by descending size
};

/// @brief Stability of the others while the contact is held.
/// @param map  the map, applied last to a motion whose contact rested throughout, with its Jacobian
/// @return     the stability
[[nodiscard]] StabilityOfRest stability_of_rest(const OrbitMap& map);

} // namespace denhartog

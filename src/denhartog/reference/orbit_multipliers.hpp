/// @file
/// @brief Floquet multipliers of a proved motion, and whether it is stable.
///
/// A deviation at one instant is carried by exp(A h) over a phase. At an event that comes later by dt the two phases differ in
/// their rates, so that it jumps by \f$ (\mathbf A_{before} - \mathbf A_{after})\mathbf Z\,dt \f$, with dt such that what
/// ends the phase still vanishes. The product over a stretch is the map whose eigenvalues are the multipliers over the stretch.
#pragma once

#include <vector>

#include "denhartog/reference/orbit_newton.hpp"

namespace denhartog::reference {

/// @brief What becomes of deviations over a stretch.
struct MapOfDeviations {
    /// It starts and ends within a stop where there is one: there a deviation does not move the contact and has 2N - 1 numbers
    /// only. Else it has 2N.
    BallMatrix A{};
    bool from_a_stop = false; ///< whether it starts within a stop; a further multiplier is then zero
};

/// @brief The map of deviations of a motion.
/// @param orbit  the motion
/// @param along  what its phases make of deviations, in a box next to it
/// @return       the map
/// @throws       Unproved where an event may be tangential
[[nodiscard]] MapOfDeviations map_of_deviations(const ProvedOrbit& orbit, const Linearised& along);

/// @brief Whether all deviations certainly die out: a power of the map has a norm below 1. @param map the map @return true if so
[[nodiscard]] bool dies_out(const BallMatrix& map);

/// @brief Sizes of the multipliers over the whole period.
///
/// Arb encloses the eigenvalues, from approximate ones: by the method of van der Hoeven and Mourrain if they are simple, else by
/// those of Miyajima and Rump. If that fails, norms of powers of the matrix bound them.
/// @param map       the map over a stretch
/// @param mirrored  whether the period has two stretches
/// @return          2N sizes, descending; wide where the eigenvectors hardly differ
[[nodiscard]] std::vector<Ball> multipliers_over_period(const MapOfDeviations& map, bool mirrored);

} // namespace denhartog::reference

/// @file
/// @brief A proved motion with stops at any instant.
#pragma once

#include <functional>
#include <vector>

#include "denhartog/reference/orbit_proof.hpp"

namespace denhartog::reference {

/// @brief A motion that obeys its equations and all that friction demands.
struct OrbitInPhases {
    ProvedOrbit orbit;                      ///< the motion
    std::vector<PhaseInStretches> phases{}; ///< phases 1 to m, at [0 .. m-1]

    /// @brief The state at an instant. The motion is followed over one stretch; before and after, that stretch repeats itself or
    /// its mirror image.
    /// @param tau  from a maximum of the force, an instant or a ball that holds it
    /// @return     N displacements, then N velocities with respect to tau, 2 N x 1, in the bits of the moment
    /// @throws     Unproved where the ball is too wide
    [[nodiscard]] BallMatrix at(const Ball& tau) const;
};

/// @brief Proves that there is a periodic motion near a guess, and that friction allows it.
/// @param scene   makes the scene in the bits of the moment; C and beta must be filled
/// @param guess   the motion as double precision sees it
/// @param bits    bits that it is computed with, and that what is taken from it should be computed with
/// @return        the motion
/// @throws        Disproved, Unproved as `proved_orbit`
[[nodiscard]] OrbitInPhases orbit_in_phases(const std::function<SceneInBalls()>& scene, const OrbitGuess& guess, slong bits);

} // namespace denhartog::reference

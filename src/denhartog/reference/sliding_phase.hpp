/// @file
/// @brief A phase of sliding by its modes, Eq. (20): if damping leaves these by themselves, no exponential of a matrix is needed.
#pragma once

#include <optional>

#include "denhartog/reference/modes.hpp"

namespace denhartog::reference {

/// @brief All phases in which the contact of a scene slides. A state is that of `ContactMechanics`.
class SlidingPhases {
public:
    /// @brief Of the modes of a scene, each below critical damping and distinct from the others; sigma is the unit of velocities.
    SlidingPhases(const SceneInBalls& scene, ModesInBalls modes, const Ball& sigma);

    /// @brief States at the end of a phase, a column each, from those at its start.
    /// @param Z          states at the start
    /// @param length     length of the phase, in tau
    /// @param direction  1 or -1: friction pushes the other way
    [[nodiscard]] BallMatrix after(const BallMatrix& Z, const Ball& length, int direction) const;

private:
    ModesInBalls m_;
    BallMatrix shapes_;     // psi_ki
    BallMatrix from_state_; // its inverse, by (17)
    Ball sigma_, beta_;
};

/// @brief The phases of a scene whose damping is given by damping ratios; none if its modes are not proved distinct, or one is
/// damped critically or beyond.
[[nodiscard]] std::optional<SlidingPhases> sliding_phases(const SceneInBalls& scene, const Ball& sigma);

} // namespace denhartog::reference

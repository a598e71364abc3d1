/// @file
/// @brief A steady motion with stops, every number of it proved.
///
/// A guess from double precision says in which order the contact slides and sticks. The reference then proves that there is one
/// motion of that order near the guess, that it obeys (2), (3) and (74) at every instant, and bounds its numbers.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "denhartog/reference/orbit_proof.hpp"

namespace denhartog::reference {

/// @brief A stop of the contact, proved.
struct StopInBalls {
    Ball start{}; ///< tau where the contact comes to rest, counted from a maximum of the force
    Ball end{};   ///< tau where it breaks away again
    Ball x{};     ///< the displacement w^T x at which it rests, units of P / k_1
};

/// @brief A periodic motion with stops, or with turns without a stop, proved.
struct OrbitInBalls {
    bool mirrored = false; ///< whether it mirrors itself after half its period, Eq. (25)
    int periods = 1;       ///< its period in periods of the force
    /// N + 1 values: largest |x_k| of each mass, then of the contact, |w^T x|; units of P / k_1. Zero if it was not asked for.
    std::vector<Ball> amplitude{};
    /// N + 1 values: lag behind the force in (-pi, pi], as in `MassMotion`; empty for a mass that no force reaches, and where it
    /// was not asked for
    std::vector<std::optional<Ball>> phase{};
    std::vector<PeakInBalls> from_ground{}; ///< N values, of the masses as they are seen from the ground; empty if not asked for
    std::vector<StopInBalls> stops{};       ///< within the period, starts ascending in [0, 2 pi periods)
    std::vector<Ball> x{};                  ///< displacements of the masses at tau = 0, where the force is largest
    std::vector<Ball> x_prime{};            ///< their velocities there
    bool stable = false;                    ///< proved: every deviation from it dies out
    bool unstable = false;                  ///< proved: a multiplier is outside the unit circle
    /// 2N values: sizes of the Floquet multipliers over the period, descending; empty if they were not asked for. A multiplier
    /// that a stop makes zero is exactly zero.
    std::vector<Ball> multipliers{};
};

/// @brief Proves that there is a periodic motion near a guess, and bounds its numbers.
///
/// A guess may be wrong in the order of its phases. That is found out, but only what is certainly wrong is `Disproved`.
/// Somewhat fewer bits are certain than it computes with. No `masses` are all; the contact's amplitude is always given. `frame` is
/// by how much the frame of the displacements moves, if the masses are wanted as they are seen from the ground.
/// @throws Disproved        if the motion near the guess is certainly not what the guess says
/// @throws Unproved         if more bits, or another guess, may help
/// @throws PrecisionError   if the work allowed is spent, see `SceneInBalls::effort`
[[nodiscard]] OrbitInBalls proved_orbit(const std::function<SceneInBalls()>& scene, const OrbitGuess& guess, slong bits,
                                        const std::vector<std::size_t>& masses = {}, bool with_multipliers = true,
                                        const std::optional<Ball>& frame = std::nullopt);

/// @brief A motion that obeys its equations and all that friction demands.
struct OrbitInPhases {
    ProvedOrbit orbit;                      ///< the motion
    std::vector<PhaseInStretches> phases{}; ///< phases 1 to m, at [0 .. m-1]

    /// @brief The state at an instant. The motion is followed over one stretch; before and after, that stretch repeats itself or
    /// its mirror image.
    /// tau counts from a maximum of the force, and may be a ball that holds the instant. The state is that of `harmonic_in_balls`.
    /// @throws Unproved if the ball is too wide
    [[nodiscard]] BallMatrix at(const Ball& tau) const;
};

/// @brief Proves that there is a periodic motion near a guess, and that friction allows it.
/// Compute with as many bits whatever you derive from it.
/// @throws Disproved, Unproved as `proved_orbit`
[[nodiscard]] OrbitInPhases orbit_in_phases(const std::function<SceneInBalls()>& scene, const OrbitGuess& guess, slong bits);

} // namespace denhartog::reference

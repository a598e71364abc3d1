/// @file
/// @brief A steady motion with stops, every number of it proved.
///
/// A guess from double precision says in which order the contact slides and sticks. The reference then proves that there is one
/// motion of that order near the guess, that it obeys (2), (3) and (74) at every instant, and bounds its numbers.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "denhartog/reference/orbit_guess_data.hpp"
#include "denhartog/reference/scene_in_balls.hpp"

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
    /// N + 1 values: largest |x_k| of each mass, then of the contact, |w^T x|; units of P / k_1. Zero where it was not asked for.
    std::vector<Ball> amplitude{};
    /// N + 1 values: lag behind the force in (-pi, pi], as in `MassMotion`; empty for a mass that no force reaches, and where it
    /// was not asked for
    std::vector<std::optional<Ball>> phase{};
    std::vector<StopInBalls> stops{}; ///< within the period, starts ascending in [0, 2 pi periods)
    std::vector<Ball> x{};            ///< displacements of the masses at tau = 0, where the force is largest
    std::vector<Ball> x_prime{};      ///< their velocities there
    bool stable = false;              ///< proved: every deviation from it dies out
    bool unstable = false;            ///< proved: a multiplier is outside the unit circle
    /// 2N values: sizes of the Floquet multipliers over the period, descending; empty where they were not asked for. A multiplier
    /// that a stop makes zero is exactly zero.
    std::vector<Ball> multipliers{};
};

/// @brief Proves that there is a periodic motion near a guess, and bounds its numbers.
///
/// A guess may be wrong in the order of its phases. That is found out, but only what is certainly wrong is `Disproved`.
/// @param scene             makes the scene in the bits of the moment; C and beta must be filled
/// @param guess             the motion as double precision sees it
/// @param bits              bits of the numbers that the result is computed with; somewhat fewer are certain
/// @param masses            the masses whose amplitudes are wanted; empty for all. The contact's is always given
/// @param with_multipliers  whether stability and multipliers are wanted
/// @return                  the motion
/// @throws Disproved        where the motion near the guess is certainly not what the guess says
/// @throws Unproved         where more bits, or another guess, may help
/// @throws PrecisionError   where the budget of the question is spent, see `QuestionEffort`
[[nodiscard]] OrbitInBalls proved_orbit(const std::function<SceneInBalls()>& scene, const OrbitGuess& guess, slong bits,
                                        const std::vector<std::size_t>& masses = {}, bool with_multipliers = true);

} // namespace denhartog::reference

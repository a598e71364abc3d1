/// @file
/// @brief The proof that the equations of a periodic motion with stops have one solution near a guess.
#pragma once

#include <functional>
#include <vector>

#include "denhartog/reference/orbit_equations.hpp"

namespace denhartog::reference {

/// @brief Bits that a motion is computed with so that its numbers keep those asked for: a leap may widen a ball by
/// exp(longest_leap), and the equations may be ill-conditioned.
/// @param bits  bits asked for
/// @return      bits to compute with
[[nodiscard]] constexpr slong bits_of_orbit(slong bits) { return bits + 64; }

/// @brief A motion that is proved to obey the equations; whether it obeys the inequalities of friction is another matter.
struct ProvedOrbit {
    ContactMechanics s;             ///< the mechanics
    OrbitUnknowns at;               ///< the unknowns: the box holds one solution
    std::vector<BallMatrix> Z{};    ///< states at events 0 to m
    std::vector<slong> leaps{};     ///< leaps in which phases 1 to m are followed, at [0 .. m-1]
    std::vector<BallMatrix> leap{}; ///< exp(A length / leaps) of the same
    bool fast = false;              ///< whether they are followed by their free motions instead
};

/// @brief Proves that the equations have one solution near a guess.
///
/// With an approximate inverse \f$ \mathbf Y \f$ of the derivative J, Krawczyk's operator of a box U about u,
/// \f[ \mathbf u - \mathbf Y\mathbf F(\mathbf u) + (\mathbf 1 - \mathbf Y\mathbf J(U))(U - \mathbf u) \f]
/// holds every solution in U; if it is inside of U there is exactly one. Newton's method brings u near, with steps made shorter
/// until they bring it nearer. A product over many phases widens balls, so that J takes as many bits as it needs.
/// @param scene  makes the scene in the bits of the moment
/// @param guess  the guess
/// @param bits   bits of the result
/// @return       the motion
/// @throws       Disproved, Unproved
[[nodiscard]] ProvedOrbit proved_near(const std::function<SceneInBalls()>& scene, const OrbitGuess& guess, slong bits);

} // namespace denhartog::reference

/// @file
/// @brief The proof that the equations of a periodic motion with stops have one solution near a guess.
#pragma once

#include <functional>
#include <vector>

#include "denhartog/reference/orbit_equations.hpp"

namespace denhartog::reference {

/// @brief A motion that is proved to obey the equations; whether it obeys the inequalities of friction is another matter.
struct ProvedOrbit {
    ContactMechanics s;          ///< the mechanics
    OrbitUnknowns at;            ///< the unknowns: the box holds one solution
    std::vector<BallMatrix> Z{}; ///< states at events 0 to m
    Linearised along{};          ///< what the phases make of deviations, in few bits, over a larger box
};

/// @brief Proves that the equations have one solution near a guess.
///
/// With an approximate inverse \f$ \mathbf Y \f$ of the derivative J, Krawczyk's operator of a box U about u,
/// \f[ \mathbf u - \mathbf Y\mathbf F(\mathbf u) + (\mathbf 1 - \mathbf Y\mathbf J(U))(U - \mathbf u) \f]
/// holds every solution in U; if it is inside of U there is exactly one. Newton's method brings u near, with steps made shorter
/// until they bring it nearer. A product over many phases widens balls, so that J takes as many bits as it needs.
/// @param scene  makes the scene in the bits of the moment
/// @param guess  the guess
/// @param bits   bits that it is computed with; fewer are certain, as a leap may widen a ball by exp(longest_leap)
/// @return       the motion
/// @throws       Disproved, Unproved
[[nodiscard]] ProvedOrbit proved_near(const std::function<SceneInBalls()>& scene, const OrbitGuess& guess, slong bits);

} // namespace denhartog::reference

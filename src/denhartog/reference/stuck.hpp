/// @file
/// @brief The response with the contact held, and the friction ratio from which friction holds it for ever, (88).
#pragma once

#include <optional>
#include <vector>

#include "denhartog/formulas/complex.hpp"
#include "denhartog/reference/modes.hpp"

namespace denhartog::reference {

/// @brief The motion with the contact held.
struct StuckInBalls {
    std::vector<Complex<Ball>> X{}; ///< complex amplitudes of the masses: x_k = Re(X_k e^{i tau})
    Complex<Ball> load{};           ///< complex amplitude of the force that holds the contact
    Ball compliance{};              ///< static displacement of the contact by a unit force on it
};

/// @brief The response if a force on the contact holds it: \f$ \mathbf w^T\mathbf X = 0 \f$.
/// There is none if the system may resonate with the contact held.
/// @eq{88}
[[nodiscard]] std::optional<StuckInBalls> stuck_in_balls(const SceneInBalls& s);

/// @brief The friction ratio from which the contact can rest for ever: 1 / mu if the load acts on the contact alone. @eq{88}
[[nodiscard]] Ball sticking_limit_in_balls(const SceneInBalls& s, const StuckInBalls& stuck);

/// @brief (88) as printed, for a chain with one loaded mass and a contact on the wall.
/// @eq{88}
/// @throws Unproved as `modes_in_balls`
[[nodiscard]] Ball sticking_limit_by_88(const SceneInBalls& s, std::size_t load);

} // namespace denhartog::reference

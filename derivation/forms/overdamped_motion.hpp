/// @file
/// @brief The motion of a mode with zeta >= 1, from the equation of motion (20): two real rates, or one double rate.
///
/// Nothing of the derivation for zeta < 1 is used.
#pragma once

#include <ginac/ginac.h>
#include <utility>
#include <vector>

namespace denhartog::derivation {

/// @brief A damping ratio, and two motions that solve (20) without its right side.
struct FreeMotions {
    GiNaC::ex zeta;   ///< modal damping ratio
    GiNaC::ex first;  ///< a motion
    GiNaC::ex second; ///< another
};

/// @brief A damping ratio above 1. @return the symbol
[[nodiscard]] const GiNaC::ex& heavy();

/// @brief Two different real rates: half the sum, more or less the root of its square less the product. @return at `heavy()`
[[nodiscard]] FreeMotions derived_two_rates();

/// @brief A double rate at zeta = 1: the second motion has the factor tau. @return the motions
[[nodiscard]] FreeMotions derived_double_rate();

/// @brief The combination of the two motions with a displacement and a velocity at tau = 0.
/// @param f the motions @param displacement at tau = 0 @param velocity at tau = 0 @return the motion
[[nodiscard]] GiNaC::ex derived_start(const FreeMotions& f, const GiNaC::ex& displacement, const GiNaC::ex& velocity);

/// @brief v cos(phi_j) and v sin(phi_j) from the initial values and (A.4). @param f the motions @return the two
[[nodiscard]] std::pair<GiNaC::ex, GiNaC::ex> derived_phase(const FreeMotions& f);

/// @brief u and g: what friction alone adds to -v sin(phi_j) and v cos(phi_j), over psi_ji beta / psi_li. @param f the motions
/// @return  the two
[[nodiscard]] std::vector<GiNaC::ex> derived_damping_functions(const FreeMotions& f);

/// @brief The braces of (40): what is left of the motion over beta psi_ji R^2 once its harmonic part is taken off.
/// @param f  the motions @return the braces in u and g
[[nodiscard]] GiNaC::ex derived_braces(const FreeMotions& f);

/// @brief The derivative in tau. @param e an expression @return its rate
[[nodiscard]] GiNaC::ex rate(const GiNaC::ex& e);

/// @brief An expression with its first two rates in tau. @param e the expression @return the three
[[nodiscard]] std::vector<GiNaC::ex> with_two_rates(const GiNaC::ex& e);

/// @brief d and q of (A.8) with the rates d', q', q''. @param f the motions @return the five
[[nodiscard]] std::vector<GiNaC::ex> derived_free_motions(const FreeMotions& f);

} // namespace denhartog::derivation

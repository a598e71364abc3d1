/// @file
/// @brief The regimes of the steady motion, and the condition that ends the sliding regime.
#pragma once

#include <string>
#include <vector>

#include "denhartog/number/errors.hpp"

namespace denhartog {

/// @brief Regime of the steady motion of the contact.
enum class Regime {
    continuous,        ///< it slides all the time, except at the two turning points in each period
    stick_slip,        ///< it moves, and rests for a part of every period
    permanent_sticking ///< it never moves
};

/// @brief Name of a regime, as answers write it. @param regime a regime @return `continuous`, `stick_slip` or
/// `permanent_sticking`
[[nodiscard]] inline std::string name(Regime regime) {
    return regime == Regime::continuous ? "continuous" : regime == Regime::stick_slip ? "stick_slip" : "permanent_sticking";
}

/// @brief The regime at a point.
struct RegimeAtPoint {
    Regime regime;             ///< the regime; `continuous` if the closed form holds
    std::vector<Regime> other; ///< other regimes that exist at the same point, reached from other initial values
    bool on_boundary = false;  ///< beta equals a boundary to the accuracy of that boundary; the neighbouring regime is possible
    Reasons reason{};          ///< why it is this regime
};

/// @brief Takes the regime of a motion that was found. The sliding regime exists besides if the boundaries have that instead.
/// @param met    the regime of the motion
/// @param point  the regime by the boundaries; gets the other
inline void take_regime(Regime met, RegimeAtPoint& point) {
    if (point.regime == met) return;
    std::erase(point.other, met);
    if (point.regime == Regime::continuous) point.other.push_back(point.regime);
    point.regime = met;
}

/// @brief The condition of (54) that ends the sliding regime as beta grows.
enum class BindingCondition {
    velocity,        ///< (54)a: beyond it the contact would turn back within the half-period
    static_friction, ///< (54)b: beyond it static friction would hold the contact at the end of the half-period
    both             ///< as with mu = 1 and a sum over modes that is largest for tau -> 0; or the digits do not tell
};

} // namespace denhartog

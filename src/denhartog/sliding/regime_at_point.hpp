/// @file
/// @brief The regimes of the steady state, and what ends the sliding one.
#pragma once

#include <string>
#include <vector>

namespace denhartog {

/// @brief How the contact moves in the steady state.
enum class Regime {
    continuous,        ///< it slides throughout, but for its two turning points a period
    stick_slip,        ///< it moves, and rests for a part of every period
    permanent_sticking ///< it rests
};

/// @brief Name of a regime as answers have it. @param regime a regime @return `continuous`, `stick_slip` or `permanent_sticking`
[[nodiscard]] std::string name(Regime regime);

/// @brief The regime at a point.
struct RegimeAtPoint {
    Regime regime;             ///< the regime; `continuous` wherever the closed form holds
    std::vector<Regime> other; ///< regimes that exist at the same point, from other initial values
    bool on_boundary = false;  ///< beta equals a boundary to the accuracy of the boundary: the regime could be the neighbour
    std::string reason;        ///< why, in a sentence
};

/// @brief The condition that ends the sliding regime first.
enum class BindingCondition {
    velocity,        ///< (54)a: the contact would turn back within the half-period
    static_friction, ///< (54)b: static friction would hold it at the end of the half-period
    both             ///< the two coincide: mu = 1 and the sum over modes is largest for tau -> 0
};

} // namespace denhartog

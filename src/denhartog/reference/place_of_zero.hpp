/// @file
/// @brief The one zero of a function in a stretch, by Newton's method on balls.
#pragma once

#include <functional>

#include "denhartog/number/ball.hpp"

namespace denhartog::reference {

/// @brief A function and its slope, or two functions with the signs of these.
struct ValueAndSlope {
    Ball value{}; ///< the function
    Ball slope{}; ///< its slope
};

/// @brief The place of the one zero in a stretch.
///
/// A step of Newton's method that leads from a small stretch about the likely place into itself proves it. If it does not,
/// halving finds the place.
/// @param stretch  the stretch
/// @param f        a function that is positive before its one zero in the stretch and negative after it
/// @return         the place with all bits of the moment
[[nodiscard]] Ball place_of_zero(const Ball& stretch, const std::function<ValueAndSlope(const Ball&)>& f);

} // namespace denhartog::reference

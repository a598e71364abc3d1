// Balls if the library is built with them, and a name for the type in any case. Included by sources only.
#pragma once

#include <concepts>

#if DENHARTOG_REFERENCE
#include "denhartog/number/ball.hpp"
#endif

namespace denhartog {

class Ball;

// Whether a number type is that of the reference.
template <class T>
inline constexpr bool is_ball = std::same_as<T, Ball>;

} // namespace denhartog

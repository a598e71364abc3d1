/// @file
/// @brief The zero of a function between two instants where it has opposite signs.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace denhartog {

/// @brief A function at an instant, with its slope.
template <class T>
struct ValueAt {
    T t;     ///< the instant
    T f;     ///< the function
    T slope; ///< its derivative
};

/// @brief The zero between two instants: t as a polynomial of third degree in f, through the last two instants with their slopes,
/// shows where to look next, within what is known to hold the zero.
///
/// What is left after a step is a multiple of the squares of the distances of both instants from the zero. That multiple is the
/// one seen in the step before; or, if this is more, the one that leaves as much as the bracket is wide if both are that far. The
/// search starts at `now`; f has the opposite sign at `before`, or is zero at `now`. The zero is known to rounding; the function
/// is not evaluated there.
template <class T, class Function>
[[nodiscard]] T bracketed_zero(const Function& at, ValueAt<T> now, ValueAt<T> before) {
    using std::abs;
    constexpr int most_steps = 200;
    const bool rises = (now.t < before.t) == (now.f < 0);
    T a = std::min(now.t, before.t), b = std::max(now.t, before.t), whole = b - a, step_before = 2 * whole, far_before(0);
    for (int n = 0; n < most_steps && now.f != 0; ++n) {
        (rises == (now.f > 0) ? b : a) = now.t;
        const T span = before.f - now.f, part = -now.f / span, rest = 1 - part;
        const T zero = now.t + part * rest * rest * (span / now.slope) +
                       part * part * ((1 + 2 * rest) * (before.t - now.t) - rest * (span / before.slope));
        const bool falls_off = zero > a && zero < b && 2 * abs(T(zero - now.t)) < step_before;
        const T next = falls_off ? zero : T(a + (b - a) / 2), step = abs(T(next - now.t)),
                far = falls_off ? T(abs(T(next - before.t))) : T(0), tiny = std::numeric_limits<T>::epsilon() * abs(next);
        const bool falls_to_nothing = falls_off && step * step * step <= tiny * far_before * far_before &&
                                      step * step * far * far <= tiny * whole * whole * whole;
        if (step <= tiny || falls_to_nothing || !(a < next && next < b)) return next;
        step_before = falls_off ? step : T(b - a);
        far_before = far;
        before = std::exchange(now, at(next));
    }
    return now.t;
}

} // namespace denhartog

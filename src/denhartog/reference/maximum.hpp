/// @file
/// @brief The largest value of a function that is known by its series, proved.
#pragma once

#include <functional>
#include <optional>

#include "denhartog/reference/scene_in_balls.hpp"
#include "denhartog/reference/series.hpp"

namespace denhartog::reference {

/// @brief A function and its slope, or two functions with the signs of these.
struct ValueAndSlope {
    Ball value{}; ///< the function
    Ball slope{}; ///< its slope
};

/// @brief The place, in all current bits, of the one zero in a stretch of a function that falls through it.
///
/// A step of Newton's method that leads from a small stretch about the likely place into itself proves it. If it does not,
/// halving finds the place.
[[nodiscard]] Ball place_of_zero(const Ball& stretch, const std::function<ValueAndSlope(const Ball&)>& f);

/// @brief A largest value, and where it is taken.
struct LargestInBalls {
    Ball value{};   ///< the largest value
    Ball instant{}; ///< an instant at which it is taken; if several may be the largest, a ball that holds them all
};

/// @brief A function by its series about an instant or over a stretch.
using FunctionOfTime = std::function<Series(const Ball& tau)>;

/// @brief A function over a stretch, from its middle: the terms of low order there, and that of order 3 over the whole stretch.
/// Next to a resonance a function is a small difference of large terms, and its range by terms is wide.
[[nodiscard]] Series over_stretch(const FunctionOfTime& f, const Ball& X);

/// @brief Z = n'' + n over a stretch; and n with its rate there made narrower: from the middle n goes on as a sine and a cosine
/// do, and is driven by Z.
[[nodiscard]] Ball narrowed_by_drive(Series& n, const FunctionOfTime& n_of, const FunctionOfTime& Z_of, const Ball& X);

/// @brief The largest value of a function and the largest of its negative.
struct LargestBothWays {
    std::optional<LargestInBalls> up{};   ///< the largest value; none if it is certainly not the largest in size
    std::optional<LargestInBalls> down{}; ///< the largest of the negative; none likewise
};

/// @brief The largest size of a function on [0, pi], by a search with few bits and then by Newton's method with all bits of the
/// moment.
/// @throws Unproved if the search does not come to its end
[[nodiscard]] LargestBothWays largest_size_of(const FunctionOfTime& f);

/// @brief The largest value on [0, pi] of n / sin for a function n that is zero at both ends.
///
/// \f$ W = n'\sin - n\cos \f$ has the sign of the rate of the quotient, and \f$ W' = (n'' + n)\sin \f$. At the ends the quotient
/// is the rate of n over the cosine. Z is n'' + n with its slope and curvature, where that is a small difference of large terms.
/// @eq{54,56,57}
/// @throws Unproved if the search does not come to its end
[[nodiscard]] LargestInBalls largest_over_sine(const FunctionOfTime& n, const FunctionOfTime& Z = {});

} // namespace denhartog::reference

/// @file
/// @brief Proved numbers as they are handed out. Included by sources only.
#pragma once

#include <algorithm>

#include "denhartog/answer/solution.hpp"
#include "denhartog/number/ball.hpp"
#include "denhartog/number/bounded.hpp"

namespace denhartog {

/// @brief A number of an answer from a ball: rounded once, with a bound that holds the rounding, infinite where the ball is not
/// finite. Of more than 15 digits its decimals are written.
[[nodiscard]] Certified printed(const Ball& x, int digits);

/// @brief A ball rounded to double, with the rounding in its bound.
[[nodiscard]] inline Bounded<double> in_double(const Ball& x) {
    const Certified rounded = printed(x, most_digits_of_a_double);
    return {rounded.value, rounded.error};
}

/// @brief Bits of a decimal digit.
inline constexpr double bits_of_digit = 3.3219280948873626;

/// @brief Bits with which a proof of so many digits begins.
[[nodiscard]] inline slong bits_for(int digits) { return static_cast<slong>(std::max(128.0, bits_of_digit * digits + 64)); }

/// @brief Numbers of an answer as they are written, and whether those that are asked for have their digits.
class WrittenNumbers {
public:
    /// @brief Of an answer with so many digits; `last` where no more bits will be tried.
    WrittenNumbers(int digits, bool last) : digits_(digits), last_(last) {}

    /// @brief A number that need not have the digits. Unproved is thrown where it has no bound, PrecisionError where it is
    /// written as a double and is beyond the range of one.
    [[nodiscard]] Certified shown(const Ball& x) const;
    /// @brief A number that must have them, relative to its size, unless that is below all doubles and a double is asked for.
    [[nodiscard]] Certified relative(const Ball& x);
    /// @brief A number that must have them as it is, such as an angle.
    [[nodiscard]] Certified absolute(const Ball& x) {
        count(radius_of(x));
        return shown(x);
    }
    /// @brief A number that must have them beside the size of another.
    void beside(const Ball& x, const Ball& size) { count(radius_of(x) / abs(size)); }
    /// @brief A mass, whose phase need not have the digits where it is not `asked` for; at rest, within what its amplitude may
    /// be, where that is nothing beside the largest as far as all the bits can tell.
    [[nodiscard]] SolvedMass mass(const Ball& amplitude, const std::optional<Ball>& phase, bool asked, const Ball& largest);
    /// @brief Whether every number that must have the digits has them.
    [[nodiscard]] bool enough() const { return enough_; }
    /// @brief The largest error of those numbers, before they are rounded.
    [[nodiscard]] double largest_error() const { return largest_; }

private:
    void count(const Ball& error);

    int digits_;
    bool last_;
    bool enough_ = true;
    double largest_ = 0;
};

} // namespace denhartog

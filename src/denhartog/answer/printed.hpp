/// @file
/// @brief Proved numbers as they are handed out. Included by sources only.
#pragma once

#include "denhartog/answer/solution.hpp"
#include "denhartog/number/ball.hpp"
#include "denhartog/number/bounded.hpp"

namespace denhartog {

/// @brief A number of an answer from a ball: rounded once, with a bound that holds the rounding.
/// @param x       the number
/// @param digits  significant digits asked for: above 15 its decimals are written
/// @return        the number; its bound is infinite where the ball is not finite
[[nodiscard]] Certified printed(const Ball& x, int digits);

/// @brief A ball rounded to double. @param x the number @return the same, the rounding in its bound
[[nodiscard]] inline Bounded<double> in_double(const Ball& x) {
    const Certified rounded = printed(x, most_digits_of_a_double);
    return {rounded.value, rounded.error};
}

/// @brief Bits of a decimal digit.
inline constexpr double bits_of_digit = 3.3219280948873626;

/// @brief Numbers of an answer as they are written, and whether those that are asked for have their digits.
class WrittenNumbers {
public:
    /// @param digits  significant digits asked for
    /// @param last    whether no more bits will be tried
    WrittenNumbers(int digits, bool last) : digits_(digits), last_(last) {}

    /// @brief A number that need not have the digits. @param x the number @return it as it is handed out
    /// @throws Unproved where it has no bound; PrecisionError where it is written as a double and is beyond the range of one
    [[nodiscard]] Certified shown(const Ball& x) const;
    /// @brief A number that must have them, relative to its size, unless that is below all doubles and a double is asked for.
    /// @param x the number @return it as it is handed out
    [[nodiscard]] Certified relative(const Ball& x);
    /// @brief A number that must have them as it is, such as an angle. @param x the number @return it as it is handed out
    [[nodiscard]] Certified absolute(const Ball& x) {
        count(radius_of(x));
        return shown(x);
    }
    /// @brief A number that must have them beside the size of another. @param x the number @param size the other
    void beside(const Ball& x, const Ball& size) { count(radius_of(x) / abs(size)); }
    /// @brief Whether a mass does not move, as far as all the bits can tell.
    /// @param amplitude  its amplitude @param largest that of all masses @return true where it does not
    [[nodiscard]] bool does_not_move(const Ball& amplitude, const Ball& largest) const;
    /// @brief Such a mass: at rest, within what its amplitude may be. @param amplitude its amplitude @return the mass
    [[nodiscard]] SolvedMass unmoved(const Ball& amplitude) const;
    /// @brief Whether every number that must have the digits has them. @return true where it is so
    [[nodiscard]] bool enough() const { return enough_; }
    /// @brief The largest error of those numbers, before they are rounded. @return it
    [[nodiscard]] double largest_error() const { return largest_; }

private:
    void count(const Ball& error);

    int digits_;
    bool last_;
    bool enough_ = true;
    double largest_ = 0;
};

} // namespace denhartog

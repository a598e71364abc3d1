/// @file
/// @brief A real number known to lie in a ball: the number type of the reference, by Arb.
///
/// Every function gives a ball that holds the result for every number in its arguments, rounding included. A comparison is true
/// only where it is true of all numbers in both balls. How many bits a midpoint has is a matter of the moment, see `Bits`.
#pragma once

#include <arb.h>

#include <concepts>
#include <string>

#include "denhartog/number/number.hpp"

namespace denhartog {

/// @brief Bits of all that this thread computes with balls.
inline thread_local slong ball_bits = 128;

/// @brief Everything until the end of the scope is computed with so many bits.
struct Bits {
    slong before = ball_bits; ///< what is restored
    /// @param bits  bits of a midpoint
    explicit Bits(slong bits) { ball_bits = bits; }
    /// @brief Restores the bits before.
    ~Bits() { ball_bits = before; }
    Bits(const Bits&) = delete;
    Bits& operator=(const Bits&) = delete;
};

/// @brief A ball: a midpoint and a radius.
class Ball {
public:
    arb_t a; ///< the ball as Arb has it

    /// @brief Zero.
    Ball() { arb_init(a); }
    /// @param n  a whole number, exact; a double that is not is no such number
    template <std::integral Whole>
    Ball(Whole n) : Ball() {
        arb_set_si(a, static_cast<slong>(n));
    }
    /// @param x  a double, exact
    explicit Ball(double x) : Ball() { arb_set_d(a, x); }
    /// @param b  a ball, copied to all its bits
    Ball(const Ball& b) : Ball() { arb_set(a, b.a); }
    /// @param b  a ball, whose number is taken
    Ball(Ball&& b) noexcept : Ball() { arb_swap(a, b.a); }
    /// @brief Copies a ball. @param b the ball @return this
    Ball& operator=(const Ball& b) {
        arb_set(a, b.a);
        return *this;
    }
    /// @brief Takes a ball. @param b the ball @return this
    Ball& operator=(Ball&& b) noexcept {
        arb_swap(a, b.a);
        return *this;
    }
    /// @brief Frees the number.
    ~Ball() { arb_clear(a); }
    /// @brief The midpoint, rounded. @return it
    explicit operator double() const { return arf_get_d(arb_midref(a), ARF_RND_NEAR); }
    /// @brief An interval. @param from its lower end @param to its upper end @return a ball that holds it
    [[nodiscard]] static Ball within(double from, double to);
    /// @brief What decimals stand for. @param text a decimal number @return a ball that holds it; NaN where it is no number
    [[nodiscard]] static Ball of_text(const std::string& text);

    /// @brief Sum. @param x a summand @param y a summand @return x + y
    friend Ball operator+(const Ball& x, const Ball& y) { return by(arb_add, x, y); }
    /// @brief Difference. @param x a number @param y what is taken from it @return x - y
    friend Ball operator-(const Ball& x, const Ball& y) { return by(arb_sub, x, y); }
    /// @brief Product. @param x a factor @param y a factor @return x y
    friend Ball operator*(const Ball& x, const Ball& y) { return by(arb_mul, x, y); }
    /// @brief Quotient. @param x a number @param y a number @return x / y; not finite where y may be zero
    friend Ball operator/(const Ball& x, const Ball& y) { return by(arb_div, x, y); }
    /// @brief Negative. @param x a number @return -x
    friend Ball operator-(const Ball& x) {
        Ball r;
        arb_neg(r.a, x.a);
        return r;
    }
    /// @brief Adds in place. @param y a summand @return this
    Ball& operator+=(const Ball& y) {
        arb_add(a, a, y.a, ball_bits);
        return *this;
    }
    /// @brief Subtracts in place. @param y what is taken @return this
    Ball& operator-=(const Ball& y) {
        arb_sub(a, a, y.a, ball_bits);
        return *this;
    }
    /// @brief Multiplies in place. @param y a factor @return this
    Ball& operator*=(const Ball& y) {
        arb_mul(a, a, y.a, ball_bits);
        return *this;
    }
    /// @brief Divides in place. @param y a number @return this
    Ball& operator/=(const Ball& y) {
        arb_div(a, a, y.a, ball_bits);
        return *this;
    }
    /// @brief Whether it is certainly less. @param x a number @param y a number @return true only where it is certain
    friend bool operator<(const Ball& x, const Ball& y) { return arb_lt(x.a, y.a) != 0; }
    /// @brief Whether it is certainly greater. @param x a number @param y a number @return true only where it is certain
    friend bool operator>(const Ball& x, const Ball& y) { return arb_gt(x.a, y.a) != 0; }
    /// @brief Whether it is certainly not greater. @param x a number @param y a number @return true only where it is certain
    friend bool operator<=(const Ball& x, const Ball& y) { return arb_le(x.a, y.a) != 0; }
    /// @brief Whether it is certainly not less. @param x a number @param y a number @return true only where it is certain
    friend bool operator>=(const Ball& x, const Ball& y) { return arb_ge(x.a, y.a) != 0; }
    /// @brief Whether both are one exact number. @param x a number @param y a number @return true only where it is certain
    friend bool operator==(const Ball& x, const Ball& y) { return arb_eq(x.a, y.a) != 0; }

    /// @brief A lower bound. @return a double not above any number of the ball
    [[nodiscard]] double low() const;
    /// @brief An upper bound. @return a double not below any number of the ball
    [[nodiscard]] double high() const;
    /// @brief Half the width. @return an upper bound of the radius
    [[nodiscard]] double radius() const { return mag_get_d(arb_radref(a)); }
    /// @brief Whether it is bounded. @return false of a quotient by zero and of what is no number
    [[nodiscard]] bool finite() const { return arb_is_finite(a) != 0; }
    /// @brief Whether zero is in it. @return true where it may be zero
    [[nodiscard]] bool may_vanish() const { return arb_contains_zero(a) != 0; }
    /// @brief Whether it is zero and nothing else. @return true of the exact zero
    [[nodiscard]] bool is_zero() const { return arb_is_zero(a) != 0; }
    /// @brief Accuracy. @return bits that are certain, relative to its size
    [[nodiscard]] slong certain_bits() const { return is_zero() ? ARF_PREC_EXACT : arb_rel_accuracy_bits(a); }

private:
    template <class Operation>
    static Ball by(Operation operation, const Ball& x, const Ball& y) {
        Ball r;
        operation(r.a, x.a, y.a, ball_bits);
        return r;
    }
};

/// @brief pi.
template <>
struct PiOf<Ball> {
    /// @return a ball that holds pi
    static Ball value();
};

/// @brief Square root. @param x a number @return its root; NaN where x may be negative
[[nodiscard]] Ball sqrt(const Ball& x);
/// @brief Square root of a number that is known not to be negative, though its ball may reach below zero.
/// @param x  the number @return its root
[[nodiscard]] Ball root_of_positive(const Ball& x);
/// @brief Exponential. @param x a number @return exp(x)
[[nodiscard]] Ball exp(const Ball& x);
/// @brief Sine. @param x radians @return sin(x)
[[nodiscard]] Ball sin(const Ball& x);
/// @brief Cosine. @param x radians @return cos(x)
[[nodiscard]] Ball cos(const Ball& x);
/// @brief Hyperbolic sine. @param x a number @return sinh(x)
[[nodiscard]] Ball sinh(const Ball& x);
/// @brief Hyperbolic cosine. @param x a number @return cosh(x)
[[nodiscard]] Ball cosh(const Ball& x);
/// @brief Angle of the point (x, y). @param y ordinate @param x abscissa @return radians in [-pi, pi]
[[nodiscard]] Ball atan2(const Ball& y, const Ball& x);
/// @brief An angle taken to (-pi, pi] by whole turns, by its midpoint. If it may be -pi exactly, as far as a narrow ball tells, it
/// is taken next to pi.
/// @param angle  radians @return the angle
[[nodiscard]] Ball wrapped_in_balls(const Ball& angle);
/// @brief Size. @param x a number @return |x|
[[nodiscard]] Ball abs(const Ball& x);
/// @brief The larger. @param x a number @param y a number @return the larger of the two
[[nodiscard]] Ball larger(const Ball& x, const Ball& y);
/// @brief Both. @param x a number @param y a number @return a ball that holds both
[[nodiscard]] Ball either(const Ball& x, const Ball& y);
/// @brief What both hold. @param x a number @param y the same number @return a ball that holds what is in both; x where rounding
/// leaves nothing
[[nodiscard]] Ball both_hold(const Ball& x, const Ball& y);
/// @brief A power of two. @param n the exponent @return 2^n, exact
[[nodiscard]] Ball power_of_two(slong n);
/// @brief The midpoint. @param x a number @return its midpoint, exact
[[nodiscard]] Ball middle(const Ball& x);
/// @brief The radius. @param x a number @return its radius, exact
[[nodiscard]] Ball radius_of(const Ball& x);
/// @brief An upper bound. @param x a number @return the upper end of the ball, exact
[[nodiscard]] Ball upper_bound_of(const Ball& x);
/// @brief A number with what it may be off by. @param x a number @param radius at least zero @return x plus or minus the radius
[[nodiscard]] Ball widened(Ball x, const Ball& radius);

} // namespace denhartog

// A real number known to lie in a ball: the number type of the reference, by Arb.
//
// Every function gives a ball that holds the result for every number in its arguments, rounding included. A comparison is true
// only if it is true of all numbers in both balls. The number of bits of a midpoint is a setting of the thread, see `Bits`.
#pragma once

#include <arb.h>

#include <concepts>
#include <string>

#include "denhartog/number/number.hpp"

namespace denhartog {

// Bits of all that this thread computes with balls: as an argument they would stand in every operation of a formula.
inline thread_local slong ball_bits = 128;

// Everything until the end of the scope is computed with so many bits.
struct Bits {
    slong before = ball_bits; // what is restored
    explicit Bits(slong bits) { ball_bits = bits; }
    ~Bits() { ball_bits = before; }
    Bits(const Bits&) = delete;
    Bits& operator=(const Bits&) = delete;
};

// A ball: a midpoint and a radius.
class Ball {
public:
    arb_t a; // the ball as Arb has it

    Ball() { arb_init(a); }
    // A whole number, exact; a double that is not is no such number.
    template <std::integral Whole>
    Ball(Whole n) : Ball() {
        arb_set_si(a, static_cast<slong>(n));
    }
    explicit Ball(double x) : Ball() { arb_set_d(a, x); }
    Ball(const Ball& b) : Ball() { arb_set(a, b.a); }
    Ball(Ball&& b) noexcept : Ball() { arb_swap(a, b.a); }
    Ball& operator=(const Ball& b) { // NOLINT(cert-oop54-cpp): arb_set of a number to itself does nothing
        arb_set(a, b.a);
        return *this;
    }
    Ball& operator=(Ball&& b) noexcept {
        arb_swap(a, b.a);
        return *this;
    }
    ~Ball() { arb_clear(a); }
    // The midpoint, rounded.
    explicit operator double() const { return arf_get_d(arb_midref(a), ARF_RND_NEAR); }
    // A ball that holds an interval.
    [[nodiscard]] static Ball within(double from, double to);
    // A ball that holds what decimals stand for; NaN if they are no number.
    [[nodiscard]] static Ball of_text(const std::string& text);

    // Arithmetic, and comparisons, which are true only if that is certain: `==` if both are one exact number.
    friend Ball operator+(const Ball& x, const Ball& y) { return by(arb_add, x, y); }
    friend Ball operator-(const Ball& x, const Ball& y) { return by(arb_sub, x, y); }
    friend Ball operator*(const Ball& x, const Ball& y) { return by(arb_mul, x, y); }
    // Quotient; not finite if the divisor may be zero.
    friend Ball operator/(const Ball& x, const Ball& y) { return by(arb_div, x, y); }
    friend Ball operator-(const Ball& x) {
        Ball r;
        arb_neg(r.a, x.a);
        return r;
    }
    Ball& operator+=(const Ball& y) { return changed_by(arb_add, y); }
    Ball& operator-=(const Ball& y) { return changed_by(arb_sub, y); }
    Ball& operator*=(const Ball& y) { return changed_by(arb_mul, y); }
    Ball& operator/=(const Ball& y) { return changed_by(arb_div, y); }
    friend bool operator<(const Ball& x, const Ball& y) { return arb_lt(x.a, y.a) != 0; }
    friend bool operator>(const Ball& x, const Ball& y) { return arb_gt(x.a, y.a) != 0; }
    friend bool operator<=(const Ball& x, const Ball& y) { return arb_le(x.a, y.a) != 0; }
    friend bool operator>=(const Ball& x, const Ball& y) { return arb_ge(x.a, y.a) != 0; }
    friend bool operator==(const Ball& x, const Ball& y) { return arb_eq(x.a, y.a) != 0; }

    // A double not above any number of the ball.
    [[nodiscard]] double low() const;
    // A double not below any number of the ball.
    [[nodiscard]] double high() const;
    // An upper bound of half the width.
    [[nodiscard]] double radius() const { return mag_get_d(arb_radref(a)); }
    // Whether it is bounded; false of a quotient by zero and of what is no number.
    [[nodiscard]] bool finite() const { return arb_is_finite(a) != 0; }
    // Whether zero is in it.
    [[nodiscard]] bool may_vanish() const { return arb_contains_zero(a) != 0; }
    // Whether it is zero and nothing else.
    [[nodiscard]] bool is_zero() const { return arb_is_zero(a) != 0; }
    // Bits that are certain, relative to its size.
    [[nodiscard]] slong certain_bits() const { return is_zero() ? ARF_PREC_EXACT : arb_rel_accuracy_bits(a); }

private:
    template <class Operation>
    static Ball by(Operation operation, const Ball& x, const Ball& y) {
        Ball r;
        operation(r.a, x.a, y.a, ball_bits);
        return r;
    }
    template <class Operation>
    Ball& changed_by(Operation operation, const Ball& y) {
        operation(a, a, y.a, ball_bits);
        return *this;
    }
};

template <>
struct PiOf<Ball> {
    static Ball value();
};

// Elementary functions: a root is NaN if the number may be negative. The angle of (x, y) is in [-pi, pi]; where it may be
// on either side of that, it is one about pi, so that its ball is no wider than it is uncertain.
[[nodiscard]] Ball sqrt(const Ball& x);
[[nodiscard]] Ball exp(const Ball& x);
[[nodiscard]] Ball sin(const Ball& x);
[[nodiscard]] Ball cos(const Ball& x);
[[nodiscard]] Ball sinh(const Ball& x);
[[nodiscard]] Ball cosh(const Ball& x);
[[nodiscard]] Ball atan2(const Ball& y, const Ball& x);
[[nodiscard]] Ball abs(const Ball& x);
[[nodiscard]] Ball larger(const Ball& x, const Ball& y);
// Square root of a number that is known not to be negative, though its ball may reach below zero.
[[nodiscard]] Ball root_of_positive(const Ball& x);
// An angle taken to (-pi, pi] by whole turns, by its midpoint. If it may be -pi exactly, as far as a narrow ball decides,
// it is taken next to pi.
[[nodiscard]] Ball wrapped_in_balls(const Ball& angle);
// A ball that holds both.
[[nodiscard]] Ball either(const Ball& x, const Ball& y);
// The narrower of two balls of one number.
[[nodiscard]] Ball narrower(const Ball& x, const Ball& y);
// A power of two, exact.
[[nodiscard]] Ball power_of_two(slong n);
// The midpoint, exact.
[[nodiscard]] Ball middle(const Ball& x);
// The radius, exact.
[[nodiscard]] Ball radius_of(const Ball& x);
// The upper end of the ball, exact.
[[nodiscard]] Ball upper_bound_of(const Ball& x);
// A number with what it may be off by: x plus or minus the radius.
[[nodiscard]] Ball widened(Ball x, const Ball& radius);

} // namespace denhartog

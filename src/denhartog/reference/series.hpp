/// @file
/// @brief A function of time by its first terms about an instant: a formula that is written once gives its derivatives too.
#pragma once

#include <array>

#include "denhartog/number/ball.hpp"

namespace denhartog::reference {

/// @brief Bits with which this thread searches for maxima. Newton's method then finds them with all bits of the moment. The
/// driver doubles both.
inline thread_local slong bits_of_search = 64;

/// @brief \f$ c_0 + c_1\theta + \dots + c_4\theta^4 \f$; the terms beyond are left out. c_n is the n-th derivative over n!.
///
/// If the instant is a ball, it is a stretch of time. Each c_n then holds the derivative over n! at every instant of the stretch.
struct Series {
    std::array<Ball, 5> c{}; ///< the coefficients

    /// @brief Zero.
    Series() = default;
    /// @param n  a whole number
    Series(int n) { c[0] = Ball(n); }
    /// @param x  a number that does not depend on time
    Series(const Ball& x) { c[0] = x; }
    /// @brief Time itself. @param instant where, an instant or a stretch @return instant + theta
    [[nodiscard]] static Series time(const Ball& instant) {
        Series t(instant);
        t.c[1] = Ball(1);
        return t;
    }
    /// @brief Whether it is time itself, or differs from it by a constant. @return true where it is
    [[nodiscard]] bool is_time() const { return arb_is_one(c[1].a) != 0 && c[2].is_zero() && c[3].is_zero() && c[4].is_zero(); }
    /// @brief The derivative. @return its series; the last coefficient is not known and is zero
    [[nodiscard]] Series derivative() const {
        Series d;
        for (int n = 0; n < 4; ++n) d.c[n] = (n + 1) * c[n + 1];
        return d;
    }
    /// @brief Value, slope and curvature. @param n 0, 1 or 2 @return the derivative of that order
    [[nodiscard]] Ball rate(int n) const { return n < 2 ? c[n] : 2 * c[2]; }

    /// @brief Sum. @param x a summand @param y a summand @return x + y
    friend Series operator+(const Series& x, const Series& y) {
        Series r;
        for (int n = 0; n < 5; ++n) r.c[n] = x.c[n] + y.c[n];
        return r;
    }
    /// @brief Difference. @param x a function @param y what is taken from it @return x - y
    friend Series operator-(const Series& x, const Series& y) {
        Series r;
        for (int n = 0; n < 5; ++n) r.c[n] = x.c[n] - y.c[n];
        return r;
    }
    /// @brief Negative. @param x a function @return -x
    friend Series operator-(const Series& x) { return Series() - x; }
    /// @brief Product. @param x a factor @param y a factor @return x y
    friend Series operator*(const Series& x, const Series& y) {
        Series r;
        for (int n = 0; n < 5; ++n)
            for (int k = 0; k <= n; ++k)
                if (!x.c[k].is_zero() && !y.c[n - k].is_zero()) r.c[n] += x.c[k] * y.c[n - k];
        return r;
    }
    /// @brief Quotient. @param x a function @param y a function @return x / y
    friend Series operator/(const Series& x, const Series& y) {
        Series r;
        for (int n = 0; n < 5; ++n) {
            Ball rest = x.c[n];
            for (int k = 1; k <= n; ++k)
                if (!y.c[k].is_zero()) rest -= y.c[k] * r.c[n - k];
            r.c[n] = rest.is_zero() ? rest : rest / y.c[0];
        }
        return r;
    }
};

/// @brief A function over a stretch from its series in the middle, where it differs from a constant by what decays and turns: its
/// derivative of order n is at most size times speed to the n.
/// @param at_middle  its series in the middle of the stretch
/// @param off        instants of the stretch less the middle
/// @param constant   what it differs from
/// @param size       by how much, at most, in the stretch
/// @param speed      the speed
/// @return           its series over the stretch
[[nodiscard]] Series over_stretch(const Series& at_middle, const Ball& off, const Ball& constant, const Ball& size,
                                  const Ball& speed);
/// @brief The same with a bound of each derivative.
/// @param at_middle  its series in the middle of the stretch
/// @param off        instants of the stretch less the middle
/// @param constant   what it differs from
/// @param most       bounds of its derivatives over n! in the stretch; of order 0 of the difference
/// @return           its series over the stretch
[[nodiscard]] Series over_stretch(const Series& at_middle, const Ball& off, const Ball& constant,
                                  const std::array<Ball, 6>& most);

/// @brief Sine and cosine of a function, each from the slope of the other.
struct SineCosineSeries {
    Series s{}; ///< sine
    Series c{}; ///< cosine
};

/// @brief Sine and cosine. @param x radians @return both
[[nodiscard]] SineCosineSeries sine_cosine_series(const Series& x);
/// @brief Sine. @param x radians @return sin(x)
[[nodiscard]] inline Series sin(const Series& x) { return sine_cosine_series(x).s; }
/// @brief Cosine. @param x radians @return cos(x)
[[nodiscard]] inline Series cos(const Series& x) { return sine_cosine_series(x).c; }
/// @brief Exponential. @param x a function @return exp(x)
[[nodiscard]] Series exp(const Series& x);
/// @brief Square root of a number that does not depend on time. @param x the number @return its root
[[nodiscard]] inline Series sqrt(const Series& x) { return Series(sqrt(x.c[0])); }

} // namespace denhartog::reference

/// @file
/// @brief A function of time by its first terms about an instant: a formula that is written once gives its derivatives too. A
/// memory of such functions, as searches for several masses look at the same stretches.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <utility>

#include "denhartog/number/ball.hpp"

namespace denhartog::reference {

/// @brief Cost of so many functions of time at an instant, as `Effort` counts: an exponential, a sine and a cosine each.
[[nodiscard]] inline long cost_of_evaluations(std::size_t count) { return static_cast<long>(20 * count) * (1 + ball_bits / 256); }

/// @brief Bits with which this thread searches for maxima. Newton's method then finds them with all current bits. The
/// driver doubles both.
inline thread_local slong bits_of_search = 64;

/// @brief \f$ c_0 + c_1\theta + \dots + c_4\theta^4 \f$; the terms beyond are left out. c_n is the n-th derivative over n!.
///
/// If the instant is a ball, it is a stretch of time. Each c_n then holds the derivative over n! at every instant of the stretch.
struct Series {
    std::array<Ball, 5> c{}; ///< the coefficients

    Series() = default;
    /// @brief A whole number.
    Series(int n) { c[0] = Ball(n); }
    /// @brief A number that does not depend on time.
    Series(const Ball& x) { c[0] = x; }
    /// @brief Time itself, from an instant or a stretch.
    [[nodiscard]] static Series time(const Ball& instant) {
        Series t(instant);
        t.c[1] = Ball(1);
        return t;
    }
    /// @brief Whether it is time itself, or differs from it by a constant.
    [[nodiscard]] bool is_time() const { return arb_is_one(c[1].a) != 0 && c[2].is_zero() && c[3].is_zero() && c[4].is_zero(); }
    /// @brief The derivative. Its last coefficient is not known and is zero.
    [[nodiscard]] Series derivative() const {
        Series d;
        for (int n = 0; n < 4; ++n) d.c[n] = (n + 1) * c[n + 1];
        return d;
    }
    /// @brief Value, slope and curvature: the derivative of order n.
    [[nodiscard]] Ball rate(int n) const { return n < 2 ? c[n] : 2 * c[2]; }

    /// @brief Sum.
    friend Series operator+(const Series& x, const Series& y) {
        Series r;
        for (int n = 0; n < 5; ++n) r.c[n] = x.c[n] + y.c[n];
        return r;
    }
    /// @brief Difference.
    friend Series operator-(const Series& x, const Series& y) {
        Series r;
        for (int n = 0; n < 5; ++n) r.c[n] = x.c[n] - y.c[n];
        return r;
    }
    /// @brief The negative.
    friend Series operator-(const Series& x) { return Series() - x; }
    /// @brief Product.
    friend Series operator*(const Series& x, const Series& y) {
        Series r;
        for (int n = 0; n < 5; ++n)
            for (int k = 0; k <= n; ++k)
                if (!x.c[k].is_zero() && !y.c[n - k].is_zero()) r.c[n] += x.c[k] * y.c[n - k];
        return r;
    }
};

/// @brief A function over a stretch from its series in the middle, where it differs from a constant by what decays and turns: its
/// derivative of order n is at most size times speed to the n.
/// `off` are the instants of the stretch less the middle.
[[nodiscard]] Series over_stretch(const Series& at_middle, const Ball& off, const Ball& constant, const Ball& size,
                                  const Ball& speed);
/// @brief A function over a stretch by its series in the middle, with a bound of each derivative of the difference over n!.
[[nodiscard]] Series over_stretch(const Series& at_middle, const Ball& off, const Ball& constant,
                                  const std::array<Ball, 6>& most);

/// @brief Sine and cosine of a function of time.
struct SineCosineSeries {
    Series s{}; ///< sine
    Series c{}; ///< cosine
};

/// @brief Both at once.
[[nodiscard]] SineCosineSeries sine_cosine_series(const Series& x);
/// @brief Sine.
[[nodiscard]] inline Series sin(const Series& x) { return sine_cosine_series(x).s; }
/// @brief Cosine.
[[nodiscard]] inline Series cos(const Series& x) { return sine_cosine_series(x).c; }
/// @brief Exponential.
[[nodiscard]] Series exp(const Series& x);
/// @brief A function of time with a memory of all that was asked with the few bits of a search, and of the last that was asked.
template <class Value>
class Remembered {
public:
    /// @brief The function at an instant, exact.
    using AtInstant = std::function<Value(const Ball& tau)>;
    /// @brief The function over a stretch from what it is in the middle.
    using OverStretch = std::function<Value(const Value& in_the_middle, const Ball& tau)>;

    /// @brief At an instant, and over a stretch.
    Remembered(AtInstant at, OverStretch over) : at_(std::move(at)), over_(std::move(over)) {}
    /// @brief Its value at an instant or over a stretch, which lasts until the next call.
    const Value& operator()(const Ball& tau) {
        // two balls may be so near that their ends are the same in double: each has a value of its own
        const auto is = [&](const Known& k) { return k.bits == ball_bits && arb_equal(k.tau.a, tau.a) != 0; };
        if (is(last_)) return last_.value;
        if (ball_bits > bits_of_search) {
            last_ = known(tau);
            return last_.value;
        }
        const std::pair stretch{tau.low(), tau.high()};
        const auto found = all_.find(stretch);
        if (found != all_.end() && is(found->second)) return found->second.value;
        Known now = known(tau);
        if (all_.size() >= most_remembered) all_.clear(); // a search next to a resonance looks at tens of thousands
        return all_.insert_or_assign(stretch, std::move(now)).first->second.value;
    }

private:
    struct Known {
        Ball tau{};
        slong bits = 0;
        Value value{};
    };

    static constexpr std::size_t most_remembered = 4096;

    Known known(const Ball& tau) {
        if (arb_is_exact(tau.a) != 0) return {tau, ball_bits, at_(tau)};
        return {tau, ball_bits, over_((*this)(middle(tau)), tau)};
    }

    AtInstant at_;
    OverStretch over_;
    Known last_{};
    std::map<std::pair<double, double>, Known> all_{};
};

} // namespace denhartog::reference

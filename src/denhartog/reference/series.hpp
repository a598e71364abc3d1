// A function of time by its first terms about an instant: a formula that is written once gives its derivatives too. A memory of such
// functions, as searches for several masses look at the same stretches; and their largest value, proved.
#pragma once

#include <arb_poly.h>

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "denhartog/number/ball.hpp"

namespace denhartog::reference {

// Cost of so many functions of time at an instant, as `Effort` counts: an exponential, a sine and a cosine each.
[[nodiscard]] inline long cost_of_evaluations(std::size_t count) { return static_cast<long>(20 * count) * (1 + ball_bits / 256); }

// Cost of products of balls in the current bits, as `Effort` counts.
[[nodiscard]] inline long cost_of_ball_products(double products) {
    return static_cast<long>(products * (0.25 + static_cast<double>(ball_bits) / 1024)) + 1;
}

// Bits with which this thread searches for maxima. Newton's method then finds them with all current bits. The driver doubles both.
inline thread_local slong bits_of_search = 64;

// c_0 + c_1 theta + c_2 theta^2 + ..., some first terms; those beyond are left out. c_n is the n-th derivative over n!. If the instant
// is a ball, it is a stretch of time, and c_n holds the derivative over n! at every instant of it.
template <int terms>
struct SeriesOf {
    std::array<Ball, terms> c{};

    SeriesOf() = default;
    SeriesOf(int n) { c[0] = Ball(n); }
    SeriesOf(const Ball& x) { c[0] = x; }
    // Time itself, from an instant or a stretch.
    [[nodiscard]] static SeriesOf time(const Ball& instant) {
        SeriesOf t(instant);
        if (terms > 1) t.c.at(1) = Ball(1);
        return t;
    }
    [[nodiscard]] arb_ptr a() { return reinterpret_cast<arb_ptr>(c.data()); } // as Arb has them
    [[nodiscard]] arb_srcptr a() const { return reinterpret_cast<arb_srcptr>(c.data()); }
    // Number of terms up to the last that is not zero.
    [[nodiscard]] slong length() const {
        slong n = terms;
        while (n > 1 && c[n - 1].is_zero()) --n;
        return n;
    }
    // The derivative. Its last coefficient is not known and is zero.
    [[nodiscard]] SeriesOf derivative() const {
        SeriesOf d;
        for (int n = 0; n + 1 < terms; ++n) d.c[n] = (n + 1) * c[n + 1];
        return d;
    }
    // The sum of the terms.
    [[nodiscard]] Ball at(const Ball& theta) const {
        Ball sum = c.back();
        for (int n = terms - 2; n >= 0; --n) sum = sum * theta + c[n];
        return sum;
    }
    // Value, slope and curvature: the derivative of order n.
    [[nodiscard]] Ball rate(int n) const { return n < 2 ? c[n] : 2 * c[2]; }

    friend SeriesOf operator+(SeriesOf x, const SeriesOf& y) {
        for (int n = 0; n < terms; ++n) x.c[n] += y.c[n];
        return x;
    }
    friend SeriesOf operator-(SeriesOf x, const SeriesOf& y) {
        for (int n = 0; n < terms; ++n) x.c[n] -= y.c[n];
        return x;
    }
    friend SeriesOf operator-(const SeriesOf& x) { return SeriesOf() - x; }
    friend SeriesOf operator*(const SeriesOf& x, const SeriesOf& y) {
        SeriesOf r;
        for (int n = 0; n < terms; ++n) arb_dot(r.c[n].a, nullptr, 0, x.a(), 1, y.a() + n, -1, n + 1, ball_bits);
        return r;
    }
    friend SeriesOf operator/(const SeriesOf& x, const SeriesOf& y) {
        SeriesOf r;
        _arb_poly_div_series(r.a(), x.a(), x.length(), y.a(), y.length(), terms, ball_bits);
        return r;
    }
    friend SineCosine<SeriesOf> sine_cosine(const SeriesOf& x) {
        SineCosine<SeriesOf> both;
        _arb_poly_sin_cos_series(both.s.a(), both.c.a(), x.a(), x.length(), terms, ball_bits);
        return both;
    }
    friend SeriesOf sin(const SeriesOf& x) { return sine_cosine(x).s; }
    friend SeriesOf cos(const SeriesOf& x) { return sine_cosine(x).c; }
    friend SeriesOf exp(const SeriesOf& x) {
        SeriesOf e;
        _arb_poly_exp_series(e.a(), x.a(), x.length(), terms, ball_bits);
        return e;
    }
};
using Series = SeriesOf<5>;

// The sum of numbers times functions of time; none of those whose number is zero.
template <int terms>
[[nodiscard]] SeriesOf<terms> weighted_sum(const std::vector<Ball>& weights, const std::vector<SeriesOf<terms>>& e,
                                           SeriesOf<terms> sum) {
    for (std::size_t i = 0; i < e.size(); ++i)
        for (std::size_t n = 0; n < terms && !weights[i].is_zero(); ++n)
            arb_addmul(sum.c[n].a, weights[i].a, e[i].c[n].a, ball_bits);
    return sum;
}

// A function of time with a memory of all that was asked with the few bits of a search, and of the last that was asked.
template <class Value>
class Remembered {
public:
    explicit Remembered(std::function<Value(const Ball& tau)> at) : at_(std::move(at)) {}
    // Its value at an instant or over a stretch, which lasts until the next call.
    const Value& operator()(const Ball& tau) {
        // two balls may be so near that their ends are the same in double: each has a value of its own
        const auto is = [&](const Known& k) { return k.bits == ball_bits && arb_equal(k.tau.a, tau.a) != 0; };
        if (is(last_)) return last_.value;
        if (ball_bits > bits_of_search) {
            last_ = {tau, ball_bits, at_(tau)};
            return last_.value;
        }
        const std::pair stretch{tau.low(), tau.high()};
        const auto found = all_.find(stretch);
        if (found != all_.end() && is(found->second)) return found->second.value;
        Known now{tau, ball_bits, at_(tau)};
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

    std::function<Value(const Ball& tau)> at_;
    Known last_{};
    std::map<std::pair<double, double>, Known> all_{};
};

// A function and its slope, or two functions with the signs of these.
struct ValueAndSlope {
    Ball value{}, slope{};
};

// The place, in all current bits, of the one zero in a stretch of a function that falls through it: a step of Newton's method that
// leads from a small stretch about the likely place into itself proves it, or halving finds it.
[[nodiscard]] Ball place_of_zero(const Ball& stretch, const std::function<ValueAndSlope(const Ball&)>& f);

// A largest value, and an instant at which it is taken; if several may be the largest, a ball that holds them all.
struct LargestInBalls {
    Ball value{}, instant{};
};

// A function by its series about an instant or over a stretch.
using FunctionOfTime = std::function<Series(const Ball& tau)>;

// A function over a stretch, from its middle: the terms of low order there, and that of order 3 over the whole stretch. Next to a
// resonance a function is a small difference of large terms, and its range by terms is wide.
[[nodiscard]] Series over_stretch(const FunctionOfTime& f, const Ball& X);

// Z = n'' + n over a stretch; and n with its rate there made narrower: from the middle n goes on as a sine and a cosine do, and is
// driven by Z.
[[nodiscard]] Ball narrowed_by_drive(Series& n, const FunctionOfTime& n_of, const FunctionOfTime& Z_of, const Ball& X);

// The largest value of a function and the largest of its negative; none that is certainly not the largest in size.
struct LargestBothWays {
    std::optional<LargestInBalls> up{}, down{};
};

// The largest size of a function on [0, pi], by a search with few bits and then by Newton's method with all. Throws Unproved if the
// search does not come to its end, as the next does.
[[nodiscard]] LargestBothWays largest_size_of(const FunctionOfTime& f);

// (57): the largest value on [0, pi] of n / sin for a function n that is zero at both ends, where the quotient is the rate of n over
// the cosine. W = n' sin - n cos has the sign of the rate of the quotient, and W' = (n'' + n) sin. Z is n'' + n with its slope and
// curvature, where that is a small difference of large terms.
[[nodiscard]] LargestInBalls largest_over_sine(const FunctionOfTime& n, const FunctionOfTime& Z = {});

} // namespace denhartog::reference

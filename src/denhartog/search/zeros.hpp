/// @file
/// @brief Zeros of a function: the one between two instants where it has opposite signs, the first one after a start, of several
/// functions too, and all of them on an interval. Nothing here knows of modes, masses or friction.
///
/// The first zero of a smooth function is found with none missed: steps are taken only as far as bounds allow. Over a step h the
/// Taylor polynomial is bounded from below by its Bernstein coefficients on [0, h]. If they exceed the remainder there is no zero
/// in the step; if the polynomial of the derivative stays negative by more than its remainder there is one at most, and the sign
/// at the end decides. The polynomial is that of fifth or that of third degree, whichever has the smaller remainder, and in
/// short steps a tangent is tried first: for fast modes that hardly move, rounding makes the bounds of higher derivatives
/// useless. Otherwise the step is shortened. The zero itself is that of the Taylor polynomial at an instant so near that the
/// remainder is below rounding.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "denhartog/number/effort.hpp"

namespace denhartog {

/// @brief A function at an instant, with its slope.
struct ValueAt {
    double t;     ///< the instant
    double f;     ///< the function
    double slope; ///< its derivative
};

/// @brief The zero between two instants, to rounding: f has opposite signs there, or is zero at `now`. The inverse function as a
/// cubic through the last two instants with their slopes shows where to look next, within what is known to hold the zero. A step
/// leaves an error of about a constant times the squares of the distances of both instants from the zero. The constant is taken
/// from the step before. It is at least the one that makes the error equal to the bracket if both are that far away.
template <class Function>
[[nodiscard]] double bracketed_zero(const Function& at, ValueAt now, ValueAt before) {
    using std::abs;
    constexpr int most_steps = 200;
    const bool rises = (now.t < before.t) == (now.f < 0);
    double a = std::min(now.t, before.t), b = std::max(now.t, before.t), whole = b - a, step_before = 2 * whole, far_before(0);
    for (int n = 0; n < most_steps && now.f != 0; ++n) {
        if (rises == (now.f > 0))
            b = now.t;
        else
            a = now.t;
        const double span = before.f - now.f, part = -now.f / span, rest = 1 - part;
        const double zero = now.t + part * rest * rest * (span / now.slope) +
                            part * part * ((1 + 2 * rest) * (before.t - now.t) - rest * (span / before.slope));
        const bool falls_off = zero > a && zero < b && 2 * abs(zero - now.t) < step_before;
        const double next = falls_off ? zero : a + (b - a) / 2, step = abs(next - now.t),
                     far = falls_off ? abs(next - before.t) : 0.0, tiny = std::numeric_limits<double>::epsilon() * abs(next);
        const bool falls_to_nothing = falls_off && step * step * step <= tiny * far_before * far_before &&
                                      step * step * far * far <= tiny * whole * whole * whole;
        if (step <= tiny || falls_to_nothing || !(a < next && next < b)) return next;
        step_before = falls_off ? step : b - a;
        far_before = far;
        before = std::exchange(now, at(next));
    }
    return now.t;
}

inline constexpr double tangent_up_to = 0x1p-10; ///< the longest step that a tangent is tried for

/// @brief A function at an instant with what bounds it ahead.
struct Jet {
    std::array<double, 6> f; ///< the function and five derivatives
    double bound;            ///< the sixth derivative is at most bound + growth h in size over [t, t + h]
    double growth;           ///< see `bound`
    double noise;            ///< rounding error of f
    /// The fourth derivative is at most this + growth h in size; rounding adds less to it than to `bound`.
    double fourth = std::numeric_limits<double>::infinity();
    double second = std::numeric_limits<double>::infinity(); ///< the same of the second derivative
};

/// @brief The first zero of one of the functions, or where the search had to end.
struct Crossing {
    double t;              ///< where it is
    bool touches;          ///< the function reaches zero there to rounding, but no step is short enough to see it cross
    std::size_t which = 0; ///< the function that is zero, if there are several
    /// no zero, and what comes after t is not known: the effort is spent, or no step of the number type is short enough
    bool open = false;
};

/// @brief True if bounds prove that f > 0 on (0, h]. The function and its derivatives below `order`, which is 0, 1 or 2, are zero
/// at the start.
[[nodiscard]] bool stays_positive(const Jet& jet, int order, double h);

/// @brief True if bounds prove that f' < 0 on [0, h].
[[nodiscard]] bool falls(const Jet& jet, double h);

/// @brief True if bounds prove that f(h) < 0.
[[nodiscard]] bool is_below(const Jet& jet, double h);

/// @brief The zero of a falling Taylor polynomial between two distances from its instant, with the slope there.
[[nodiscard]] ValueAt zero_of_taylor(const Jet& jet, double low, double high);

/// @brief The zero, to rounding, of a function that falls over [from, to]: it is positive at `from` and not at `to`. The jet is
/// that at t, which is one of them; `bound` is that of the sixth derivative over the whole. A polynomial formed far from its zero
/// has the rounding of all its terms there, so that none is trusted that was not formed again.
template <class Function>
[[nodiscard]] double zero_of_falling(const Function& at, double from, double to, double t, Jet jet, double bound) {
    constexpr int most_steps = 200;
    for (int n = 0; n < most_steps; ++n) {
        const ValueAt zero = zero_of_taylor(jet, from - t, to - t);
        const bool falls_off = from < t + zero.t && t + zero.t < to && n % 4 != 3;
        const double next = falls_off ? t + zero.t : from + (to - from) / 2, d_2 = zero.t * zero.t,
                     tiny = std::numeric_limits<double>::epsilon() * std::abs(next);
        if (std::abs(zero.t) <= tiny || !(from < next && next < to)) return t;
        if (n > 0 && falls_off && bound * d_2 * d_2 * d_2 / 720 <= tiny / 4 * std::abs(zero.slope)) return next;
        jet = at(t = next);
        (jet.f[0] > 0 ? from : to) = t;
    }
    return t;
}

/// @brief First zero of functions that are positive after the start; none up to the end.
///
/// A step is shortened until its bounds decide, no further than the digits of t go. The functions spend the effort, and the
/// search ends when it is spent. `order` is that of the zero at the start: 0 if f > 0 there, 1 if f' > 0, 2 if f'' > 0. On return
/// it is that at the start of the last step. `step` is the first step tried. On return it is the one to try next.
template <class Functions, std::size_t count>
[[nodiscard]] std::optional<Crossing> first_crossing(const Functions& at, double t, double t_end, std::array<int, count>& order,
                                                     double& step, const Effort& effort) {
    const double shortest = 4 * std::numeric_limits<double>::epsilon() * std::max(1.0, t_end);
    const double least((std::numeric_limits<double>::min)()); // a search that starts at 0 does not shorten its step below this
    std::array<Jet, count> jets = at(t);
    while (t < t_end) {
        for (std::size_t k = 0; k < count; ++k)
            if (order[k] == 0 && jets[k].f[0] <= 0) return Crossing{t, true, k};
        if (effort.exhausted()) return Crossing{t, false, 0, true};
        double h = std::min(step, t_end - t);
        for (;;) {
            const double next = t + h < t_end ? t + h : t_end;
            if (!(next > t) || h < least) return Crossing{t, false, 0, true};
            std::size_t undecided = 0, which = 0;
            for (std::size_t k = 0; k < count; ++k) {
                if (stays_positive(jets[k], order[k], h)) continue;
                ++undecided;
                which = k;
            }
            if (undecided == 0) {
                step = 2 * h;
                order.fill(0);
                t = next;
                if (t < t_end) jets = at(t);
                break;
            }
            const Jet& jet = jets[which];
            if (undecided == 1 && order[which] == 0 && falls(jet, h)) {
                const bool crosses = is_below(jet, h);
                std::array<Jet, count> ahead;
                if (!crosses) ahead = at(next);
                if (crosses || ahead[which].f[0] <= 0) {
                    const auto one = [&](double x) { return at(x)[which]; };
                    const double bound = jet.bound + jet.growth * h,
                                 zero = crosses ? zero_of_falling(one, t, next, t, jet, bound)
                                                : zero_of_falling(one, t, next, next, ahead[which], bound);
                    return Crossing{zero, false, which};
                }
                order.fill(0);
                t = next;
                jets = ahead;
                break;
            }
            h = h * 5 / 8;
            for (std::size_t k = 0; h <= shortest && k < count; ++k)
                if ((order[k] > 0 || jets[k].f[0] <= 8 * jets[k].noise) && !stays_positive(jets[k], order[k], h))
                    return Crossing{t, true, k};
        }
    }
    return std::nullopt;
}

/// @brief The same of one function.
template <class Function>
[[nodiscard]] std::optional<Crossing> first_crossing(Function& at, double t, double t_end, int order, double& step,
                                                     const Effort& effort) {
    std::array<int, 1> orders{order};
    return first_crossing([&](double x) { return std::array{at(x)}; }, t, t_end, orders, step, effort);
}

/// @brief Knowledge of a function's zeros in a stretch.
enum class ZerosInStretch : unsigned char {
    unknown, ///< nothing is certain: the stretch is divided
    none,    ///< it has none
    one,     ///< it has one, which lies inside
    hidden   ///< nothing is certain, and will not be in its parts
};

/// @brief A function on an interval, as a search for its zeros sees it.
struct FunctionWithZeros {
    std::function<ZerosInStretch(double from, double to)> look; ///< over a stretch
    std::function<bool(double x)> has_sign;                     ///< whether it is certainly not zero at x, and no pole
};

/// @brief A stretch of an interval.
struct StretchOfZeros {
    double from; ///< its lower end
    double to;   ///< its upper end
};

/// @brief Result of a search, in ascending order.
struct ZerosOnStretches {
    std::vector<StretchOfZeros> single;    ///< stretches with one zero each
    std::vector<StretchOfZeros> undecided; ///< stretches of which nothing is known; outside of all of these there is no zero
};

/// @brief The zeros of a function: an interval is divided until it is known of each part that it has none or one. The lower end
/// is not negative. A stretch is not divided further once it is as narrow as `narrow`, as a part of its upper end. `found` gets
/// the stretches behind those that it has.
inline void find_zeros(const FunctionWithZeros& f, double a, double b, double narrow, ZerosOnStretches& found) {
    const ZerosInStretch seen = f.look(a, b);
    if (seen == ZerosInStretch::none) return;
    if (seen == ZerosInStretch::one) {
        found.single.push_back({a, b});
    } else if (seen == ZerosInStretch::hidden || b - a <= narrow * b) {
        if (!found.undecided.empty() && found.undecided.back().to >= a)
            found.undecided.back().to = b;
        else
            found.undecided.push_back({a, b});
    } else {
        double at = a + (b - a) / 2; // a zero at the end of a part would be seen by neither
        for (const int sixteenths : {8, 7, 9, 6, 10}) {
            const double x = a + (b - a) * sixteenths / 16;
            if (!f.has_sign(x)) continue;
            at = x;
            break;
        }
        find_zeros(f, a, at, narrow, found);
        find_zeros(f, at, b, narrow, found);
    }
}

} // namespace denhartog

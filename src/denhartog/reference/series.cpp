// A smooth function of time over a stretch, and its largest value over the half-period. `over_stretch` bounds it by its series. A
// search in doubles narrows the place of the largest value down, and `refined` proves it in all bits;
// `largest_over_sine` is for (57), a quotient whose numerator and denominator vanish at both ends.
#include "denhartog/reference/series.hpp"

#include <algorithm>
#include <limits>

#include "denhartog/reference/modes.hpp"
#include "denhartog/search/largest.hpp"

namespace denhartog::reference {
namespace {

// A function with the sign of another one's rate, and the slope of the first.
using RateInTime = std::function<ValueAndSlope(const Ball&)>;

// The stretch halved, as often as the bits decide and no more often than is asked for.
Ball halved(Ball at, const RateInTime& f, slong most) {
    for (slong looks = 0; looks < most; ++looks) {
        const Ball m = middle(at), there = f(m).value, half = radius_of(at) / 2;
        if (there > Ball(0))
            at = widened(m + half, half);
        else if (there < Ball(0))
            at = widened(m - half, half);
        else
            break;
    }
    return at;
}

// The place that Newton's method finds from the middle of a stretch, without proof. More bits are taken as digits come.
Ball likely_place(const Ball& at, const RateInTime& f) {
    const slong full = ball_bits;
    Ball m = middle(at), last = radius_of(at);
    for (slong looks = 0, bits = std::min(bits_of_search, full); looks < 40; ++looks) {
        const Bits some(bits);
        const ValueAndSlope here = f(m);
        const Ball step = middle(here.value / here.slope);
        if (!step.finite()) break;
        m = middle(m - step);
        if (arb_overlaps(m.a, at.a) == 0) break;
        const bool goes_on = abs(step) < last / 4 && !here.value.may_vanish();
        last = abs(step);
        if (goes_on && !(last < power_of_two(4 - bits / 2))) continue; // a step as small leaves all bits right
        if (bits == full) break;
        bits = std::min(2 * bits, full);
    }
    return m;
}

constexpr double end = 3.141592653589793; // not above pi
constexpr double narrow = 0.1, flat = 1e-14;
constexpr int most_looks = 30'000;

// The interval of the search ends at the double next to pi; the last stretch goes on to pi itself.
Ball stretch(double from, double to) {
    if (to < end) return Ball::within(from, to);
    return from < end ? either(Ball(from), pi<Ball>()) : pi<Ball>();
}

// A function as a search in doubles sees it: over its size, as it may be beyond the range of double.
struct SeenBySearch {
    slong bits; // few, or all if the function is so small a difference of its terms that few show little of it
    Ball size;  // about its largest value, exact
};

SeenBySearch seen_by_search(const std::function<Ball(const Ball&)>& f) {
    Ball size;
    const auto shows = [&](slong bits, double part) { // radii are no more than a part of the largest value
        const Bits these(bits);
        Ball radius(0);
        size = Ball(0);
        for (const double tau : {0.0, 0.75, 1.5, 2.25, end}) {
            const Ball value = f(Ball(tau));
            size = larger(size, upper_bound_of(abs(value)));
            radius = larger(radius, radius_of(value));
        }
        return size.finite() && size > Ball(0) && radius <= Ball(part) * size;
    };
    if (shows(bits_of_search, 0x1p-8)) return {bits_of_search, size};
    if (shows(ball_bits, 0x1p-32)) return {ball_bits, size};
    throw Unproved("a sum is too small a difference of its terms");
}

// From stretches to the largest value in the current bits.
LargestInBalls refined(const LargestOnStretches& found, const std::function<Ball(const Ball&)>& value, const RateInTime& rate) {
    if (!found.settled || found.stretches.empty()) throw Unproved("a largest value is not settled");
    std::optional<LargestInBalls> best;
    for (const StretchOfLargest& s : found.stretches) {
        Ball at = stretch(s.from, s.to);
        if (s.trend == TrendOnStretch::one_maximum) at = place_of_zero(at, rate);
        // Next to its maximum a function changes by the square of the distance: the value in the middle, and what curvature adds.
        const Ball here = value(at);
        if (best && arb_overlaps(here.a, best->value.a) != 0) // either may be the largest
            best = {larger(here, best->value), either(at, best->instant)};
        else if (!best || here > best->value)
            best = {here, at};
    }
    return *best;
}

// The trend of a function from a to b, by a function with the sign of its rate and the slope of that function.
template <class Rate>
TrendOnStretch trend_by(const Ball& slope_of_rate, double a, double b, const Rate& rate) {
    const bool up = slope_of_rate.low() > 0;
    if (!up && !(slope_of_rate.high() < 0)) return TrendOnStretch::unknown;
    const Ball at_a = rate(a), at_b = rate(b);
    if ((up ? at_a : at_b).low() >= 0) return TrendOnStretch::rises;
    if ((up ? at_b : at_a).high() <= 0) return TrendOnStretch::falls;
    return at_a.low() > 0 && at_b.high() < 0 ? TrendOnStretch::one_maximum : TrendOnStretch::unknown;
}

// Stretches on which a smooth function may have its largest value, if that is `at_least` so large; searched for with some bits.
LargestOnStretches stretches_of(const FunctionOfTime& f, slong bits, double at_least) {
    SearchedFunction<Ball> searched;
    searched.value = [&](const Ball& t) { return f(static_cast<double>(t) < end ? t : pi<Ball>()).rate(0); };
    searched.stretch = [&](double a, double b) {
        const Series x = over_stretch(f, stretch(a, b));
        const Ball slope = x.rate(1);
        const TrendOnStretch trend = slope.low() >= 0 ? TrendOnStretch::rises
                                     : slope.high() <= 0
                                         ? TrendOnStretch::falls
                                         : trend_by(x.rate(2), a, b, [&](double t) { return f(stretch(t, t)).rate(1); });
        return SeenOverStretch<Ball>{x.rate(0), trend};
    };
    const Bits few(bits);
    return stretches_of_largest(searched, 0, end, narrow, flat, most_looks, at_least);
}

LargestInBalls refined_of(const FunctionOfTime& f, const LargestOnStretches& found) {
    const auto rate = [&](const Ball& t) {
        const Series at = f(t);
        return ValueAndSlope{at.rate(1), at.rate(2)};
    };
    return refined(
        found, [&](const Ball& at) { return over_stretch(f, at).rate(0); }, rate);
}

} // namespace

Series over_stretch(const FunctionOfTime& f, const Ball& X) {
    const Series wide = f(X);
    const Ball m = middle(X), d = X - m;
    if (d.is_zero()) return wide;
    const Series thin = f(m);
    Series r = wide;
    const Ball value = thin.c[0] + d * (thin.c[1] + d * (thin.c[2] + d * wide.c[3])),
               slope = thin.c[1] + d * (2 * thin.c[2] + 3 * d * wide.c[3]), curvature = thin.c[2] + 3 * d * wide.c[3];
    r.c[0] = narrower(wide.c[0], value);
    r.c[1] = narrower(wide.c[1], slope);
    r.c[2] = narrower(wide.c[2], curvature);
    return r;
}

Ball narrowed_by_drive(Series& n, const FunctionOfTime& n_of, const FunctionOfTime& Z_of, const Ball& X) {
    const Ball m = middle(X), d = X - m, s = sin(d), half = sin(d / 2);
    const Series Z_m = Z_of(m), Z_X = Z_of(X), n_m = n_of(m);
    const Ball Z = narrower(Z_X.c[0], Z_m.c[0] + d * (Z_m.c[1] + d * Z_X.c[2]));
    n.c[0] = narrower(n.c[0], n_m.c[0] * cos(d) + n_m.c[1] * s + Z * (2 * half * half));
    n.c[1] = narrower(n.c[1], n_m.c[1] * cos(d) - n_m.c[0] * s + Z * s);
    return Z;
}

Ball place_of_zero(const Ball& stretch, const RateInTime& f) {
    Ball at = stretch;
    for (int attempt = 0; attempt < 2; ++attempt) {
        const Ball m = likely_place(at, f);
        const Ball about = widened(m, power_of_two(-ball_bits / 2));
        if (arb_contains(at.a, about.a) != 0) {
            const Ball there = f(m).value, next = m - there / f(about).slope;
            if (next.finite() && arb_contains_interior(about.a, next.a) != 0) return next;
        }
        const Bits few(std::min(bits_of_search, ball_bits));
        at = halved(at, f, 32);
    }
    return halved(at, f, 64 + ball_bits);
}

LargestBothWays largest_size_of(const FunctionOfTime& f) {
    const SeenBySearch seen = seen_by_search([&f](const Ball& tau) { return f(tau).rate(0); });
    const Series per_size(1 / seen.size);
    const FunctionOfTime scaled = [&](const Ball& tau) { return f(tau) * per_size; };
    const FunctionOfTime negative = [&](const Ball& tau) { return -scaled(tau); };
    LargestOnStretches up = stretches_of(scaled, seen.bits, -std::numeric_limits<double>::infinity());
    const LargestOnStretches down = stretches_of(negative, seen.bits, up.lower);
    std::erase_if(up.stretches, [&](const StretchOfLargest& s) { return s.upper < down.lower; });
    const auto found = [&](const FunctionOfTime& function, const LargestOnStretches& where) {
        LargestInBalls largest = refined_of(function, where);
        largest.value = largest.value * seen.size;
        return largest;
    };
    LargestBothWays largest;
    if (!up.settled || !up.stretches.empty()) largest.up = found(scaled, up);
    if (!down.settled || !down.stretches.empty()) largest.down = found(negative, down);
    return largest;
}

LargestInBalls largest_over_sine(const FunctionOfTime& numerator, const FunctionOfTime& Z_in_time) {
    const auto at_end = [](double t) { return t <= 0 || t >= end; };
    const auto W_of = [](const Series& n, const Ball& t) { return n.rate(1) * sin(t) - n.rate(0) * cos(t); };
    // Cauchy's mean value theorem: n / sin is n' / cos at some instant between here and the end, if the cosine keeps its sign.
    const auto quotient = [](const Series& n, const Ball& t, bool by_slope) {
        return by_slope ? n.rate(1) / cos(t) : n.rate(0) / sin(t);
    };
    const auto value_at = [&](const FunctionOfTime& n, const Ball& t) {
        const auto at = static_cast<double>(t);
        const Ball here = at < end ? t : pi<Ball>();
        return quotient(n(here), here, at_end(at));
    };
    const SeenBySearch seen = seen_by_search([&](const Ball& t) { return value_at(numerator, t); });
    const Series per_size(1 / seen.size);
    const auto scaled = [&per_size](const FunctionOfTime& f) {
        return [&f, &per_size](const Ball& t) { return f(t) * per_size; };
    };
    const FunctionOfTime n_of = scaled(numerator), Z_of = scaled(Z_in_time);
    const auto W = [&](const Ball& t) { return W_of(n_of(t), t); };
    SearchedFunction<Ball> searched;
    searched.value = [&](const Ball& t) { return value_at(n_of, t); };
    searched.stretch = [&](double a, double b) {
        const Ball t = stretch(a, b);
        Series n = over_stretch(n_of, t);
        const Ball Z = Z_in_time ? narrowed_by_drive(n, n_of, Z_of, t) : n.rate(2) + n.rate(0);
        const auto trend_by_ends = [&] { return trend_by(Z, a, b, [&](double t) { return at_end(t) ? Ball(0) : W(Ball(t)); }); };
        if (at_end(a) || at_end(b)) return SeenOverStretch<Ball>{quotient(n, t, true), trend_by_ends()};
        // from the middle, W goes on by Z sin and the quotient by W over the square of the sine
        const Ball m = middle(t), d = t - m, s = sin(t);
        const Series thin = n_of(m);
        const Ball W_t = W_of(thin, m) + d * (Z * s);
        const TrendOnStretch trend = W_t.low() >= 0    ? TrendOnStretch::rises
                                     : W_t.high() <= 0 ? TrendOnStretch::falls
                                                       : trend_by_ends();
        return SeenOverStretch<Ball>{narrower(n.rate(0) / s, quotient(thin, m, false) + d * (W_t / (s * s))), trend};
    };
    const LargestOnStretches found = [&] {
        const Bits few(seen.bits);
        return stretches_of_largest(searched, 0, end, narrow, flat, most_looks);
    }();
    const auto value = [&](const Ball& at) {
        const Ball m = middle(at), d = at - m;
        const double from = at.low(), to = at.high();
        if (from <= 0 || to >= end) return quotient(over_stretch(n_of, at), at, true);
        const Ball here = quotient(n_of(m), m, false);
        if (d.is_zero()) return here;
        // the rate of the quotient is W over the square of the sine
        const Ball s = sin(at);
        return here + d * (W(at) / (s * s));
    };
    const auto rate = [&](const Ball& t) {
        const Series n = n_of(t);
        return ValueAndSlope{W_of(n, t), (n.rate(2) + n.rate(0)) * sin(t)};
    };
    LargestInBalls largest = refined(found, value, rate);
    largest.value = largest.value * seen.size;
    return largest;
}

} // namespace denhartog::reference

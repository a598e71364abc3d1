#include "denhartog/reference/maximum.hpp"

#include <algorithm>

#include "denhartog/search/largest.hpp"

namespace denhartog::reference {
namespace {

constexpr double end = 3.141592653589793; // not above pi
constexpr double narrow = 1e-3, flat = 1e-14;
constexpr int most_looks = 4000;

// The interval of the search ends at the double next to pi; the last stretch goes on to pi itself.
Ball stretch(double from, double to) {
    if (to < end) return Ball::within(from, to);
    return from < end ? either(Ball(from), pi<Ball>()) : pi<Ball>();
}

// A function over a stretch, from its middle: the terms of low order there, and that of order 3 over the whole stretch. Next to a
// resonance a function is a small difference of large terms, and its range by terms is wide.
Series over_stretch(const FunctionOfTime& f, const Ball& X) {
    const Series wide = f(X);
    const Ball m = middle(X), d = X - m;
    if (d.is_zero()) return wide;
    const Series thin = f(m);
    Series r = wide;
    const Ball value = thin.c[0] + d * (thin.c[1] + d * (thin.c[2] + d * wide.c[3])),
               slope = thin.c[1] + d * (2 * thin.c[2] + 3 * d * wide.c[3]), curvature = thin.c[2] + 3 * d * wide.c[3];
    const auto narrowed = [](Ball& by_terms, const Ball& from_middle) {
        Ball both;
        if (arb_intersection(both.a, by_terms.a, from_middle.a, ball_bits) != 0) by_terms = both;
    };
    narrowed(r.c[0], value);
    narrowed(r.c[1], slope);
    narrowed(r.c[2], curvature);
    return r;
}

// The one maximum in a stretch: by Newton's method, and by halves as long as that leads nowhere. `rate` is positive before it and
// negative after it.
Ball place_of_maximum(Ball at, const std::function<Ball(const Ball&)>& rate, const std::function<Ball(const Ball&)>& step) {
    for (slong looks = 0; looks < 64 + ball_bits / 8; ++looks) {
        const Ball next = step(at), before = radius_of(at);
        if (next.finite()) {
            Ball both;
            if (arb_intersection(both.a, next.a, at.a, ball_bits) == 0) throw Unproved("a maximum is not where it was seen");
            at = both;
        }
        if (radius_of(at) < before / 4) continue;
        const Ball m = middle(at), there = rate(m), half = radius_of(at) / 2;
        if (there > Ball(0))
            at = widened(m + half, half);
        else if (there < Ball(0))
            at = widened(m - half, half);
        else
            break; // as near as the bits can tell
    }
    return at;
}

// From stretches to the largest value in the bits of the moment. `step` is one of Newton's method from the middle of a stretch.
LargestInBalls refined(const LargestOnStretches& found, const std::function<Ball(const Ball&)>& value,
                       const std::function<Ball(const Ball&)>& rate, const std::function<Ball(const Ball&)>& step) {
    if (!found.settled || found.stretches.empty()) throw Unproved("a largest value is not settled");
    const slong full = ball_bits;
    LargestInBalls best;
    bool first = true;
    for (const StretchOfLargest& s : found.stretches) {
        Ball at = stretch(s.from, s.to);
        for (slong bits = bits_of_search; s.one_maximum; bits *= 2) { // the digits double
            const Bits some(std::min(bits, full));
            at = place_of_maximum(at, rate, step);
            if (bits >= full) break;
        }
        // Next to its maximum a function changes by the square of the distance: the value in the middle, and what curvature adds.
        const Ball here = value(at);
        if (first) {
            best = {here, at};
            first = false;
        } else if (arb_overlaps(here.a, best.value.a) != 0) { // either may be the largest
            best = {larger(here, best.value), either(at, best.instant)};
        } else if (here > best.value) {
            best = {here, at};
        }
    }
    return best;
}

FunctionOfTime negative_of(const FunctionOfTime& f) {
    return [&f](const Ball& tau) { return -f(tau); };
}

bool may_reach(const LargestOnStretches& found, double value) {
    return !found.settled || std::ranges::any_of(found.stretches, [&](const StretchOfLargest& s) { return s.upper >= value; });
}

// Where a smooth function may be largest.
LargestOnStretches stretches_of(const FunctionOfTime& f) {
    SearchedFunction<Ball> searched;
    searched.value = [&](const Ball& t) { return f(static_cast<double>(t) < end ? t : pi<Ball>()).rate(0); };
    searched.over = [&](double a, double b) { return over_stretch(f, stretch(a, b)).rate(0); };
    searched.trend = [&](double a, double b) {
        const Series x = over_stretch(f, stretch(a, b));
        const Ball slope = x.rate(1);
        if (slope.low() >= 0) return TrendOnStretch::rises;
        if (slope.high() <= 0) return TrendOnStretch::falls;
        const Ball curvature = x.rate(2);
        if (curvature.low() > 0 || curvature.high() < 0) {
            const Ball at_a = f(Ball(a)).rate(1), at_b = f(stretch(b, b)).rate(1);
            const bool up = curvature.low() > 0; // the slope grows
            if (up ? at_a.low() >= 0 : at_b.low() >= 0) return TrendOnStretch::rises;
            if (up ? at_b.high() <= 0 : at_a.high() <= 0) return TrendOnStretch::falls;
            if (!up && at_a.low() > 0 && at_b.high() < 0) return TrendOnStretch::one_maximum;
        }
        return TrendOnStretch::unknown;
    };
    const Bits few(bits_of_search);
    return stretches_of_largest(searched, 0, end, narrow, flat, most_looks);
}

LargestInBalls refined_of(const FunctionOfTime& f, const LargestOnStretches& found) {
    const auto step = [&](const Ball& at) {
        const Ball m = middle(at);
        return m - f(m).rate(1) / f(at).rate(2);
    };
    return refined(
        found, [&](const Ball& at) { return over_stretch(f, at).rate(0); }, [&](const Ball& t) { return f(t).rate(1); }, step);
}

} // namespace

LargestBothWays largest_size_of(const FunctionOfTime& f) {
    const LargestOnStretches up = stretches_of(f), down = stretches_of(negative_of(f));
    LargestBothWays largest;
    if (up.lower >= down.lower || may_reach(up, down.lower)) largest.up = refined_of(f, up);
    if (down.lower >= up.lower || may_reach(down, up.lower)) largest.down = refined_of(negative_of(f), down);
    return largest;
}

LargestInBalls largest_over_sine(const FunctionOfTime& numerator) {
    const auto at_end = [](double t) { return t <= 0 || t >= end; };
    const auto W = [&](const Ball& t) {
        const Series n = numerator(t);
        return n.rate(1) * sin(t) - n.rate(0) * cos(t);
    };
    // Cauchy's mean value theorem: n / sin is n' / cos at some instant between here and the end, if the cosine keeps its sign.
    const auto quotient = [&](const Ball& t, bool by_slope) {
        const Series n = over_stretch(numerator, t);
        return by_slope ? n.rate(1) / cos(t) : n.rate(0) / sin(t);
    };
    SearchedFunction<Ball> searched;
    searched.value = [&](const Ball& t) {
        const auto at = static_cast<double>(t);
        return quotient(at < end ? t : pi<Ball>(), at_end(at));
    };
    searched.over = [&](double a, double b) { return quotient(stretch(a, b), at_end(a) || at_end(b)); };
    searched.trend = [&](double a, double b) {
        const Series n = over_stretch(numerator, stretch(a, b));
        const Ball Z = n.rate(2) + n.rate(0);
        if (!(Z.high() < 0 || Z.low() > 0)) return TrendOnStretch::unknown;
        const Ball at_a = at_end(a) ? Ball(0) : W(Ball(a)), at_b = at_end(b) ? Ball(0) : W(Ball(b));
        if (Z.high() < 0) { // W falls
            if (at_a.high() <= 0) return TrendOnStretch::falls;
            if (at_b.low() >= 0) return TrendOnStretch::rises;
            return at_a.low() > 0 && at_b.high() < 0 ? TrendOnStretch::one_maximum : TrendOnStretch::unknown;
        }
        if (at_a.low() >= 0) return TrendOnStretch::rises;
        return at_b.high() <= 0 ? TrendOnStretch::falls : TrendOnStretch::unknown;
    };
    const LargestOnStretches found = [&] {
        const Bits few(bits_of_search);
        return stretches_of_largest(searched, 0, end, narrow, flat, most_looks);
    }();
    const auto value = [&](const Ball& at) {
        const Ball m = middle(at), d = at - m;
        const double from = at.low(), to = at.high();
        if (from <= 0 || to >= end) return quotient(at, true);
        if (d.is_zero()) return quotient(m, false);
        // the rate of the quotient is W over the square of the sine
        const Ball s = sin(at);
        return quotient(m, false) + d * (W(at) / (s * s));
    };
    const auto step = [&](const Ball& at) {
        const Ball m = middle(at);
        const Series n = numerator(at);
        return m - W(m) / ((n.rate(2) + n.rate(0)) * sin(at));
    };
    return refined(found, value, W, step);
}

} // namespace denhartog::reference

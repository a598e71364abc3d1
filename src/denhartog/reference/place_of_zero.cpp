#include "denhartog/reference/place_of_zero.hpp"

#include <algorithm>

#include "denhartog/reference/series.hpp"

namespace denhartog::reference {
namespace {

using FunctionWithSlope = std::function<ValueAndSlope(const Ball&)>;

// The stretch halved, as often as the bits can tell and no more often than is asked for.
Ball halved(Ball at, const FunctionWithSlope& f, slong most) {
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

// Where Newton's method leads from the middle of a stretch, without proof. More bits are taken as digits come.
Ball likely_place(const Ball& at, const FunctionWithSlope& f) {
    const slong full = ball_bits;
    Ball m = middle(at), last = radius_of(at);
    for (slong looks = 0, bits = std::min(bits_of_search, full); looks < 40; ++looks) {
        const Bits some(bits);
        const ValueAndSlope here = f(m);
        const Ball step = middle(here.value / here.slope);
        if (!step.finite()) break;
        m = middle(m - step);
        if (arb_overlaps(m.a, at.a) == 0) break;
        Ball half(16); // a step as small leaves all bits right
        arb_mul_2exp_si(half.a, half.a, -bits / 2);
        const bool goes_on = abs(step) < last / 4 && !here.value.may_vanish();
        last = abs(step);
        if (goes_on && !(last < half)) continue;
        if (bits == full) break;
        bits = std::min(2 * bits, full);
    }
    return m;
}

} // namespace

Ball place_of_zero(const Ball& stretch, const std::function<ValueAndSlope(const Ball&)>& f) {
    Ball at = stretch;
    for (int attempt = 0; attempt < 2; ++attempt) {
        const Ball m = likely_place(at, f);
        Ball about(1);
        arb_mul_2exp_si(about.a, about.a, -ball_bits / 2);
        about = widened(m, about);
        if (arb_contains(at.a, about.a) != 0) {
            const Ball there = f(m).value, next = m - there / f(about).slope;
            if (next.finite() && arb_contains_interior(about.a, next.a) != 0) return next;
        }
        const Bits few(std::min(bits_of_search, ball_bits));
        at = halved(at, f, 32);
    }
    return halved(at, f, 64 + ball_bits);
}

} // namespace denhartog::reference

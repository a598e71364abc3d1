// Does a proved orbit obey Coulomb's law (3) and (74) at every instant? `require_friction` asks of each phase that the contact
// slides one way or that static friction holds it; `require_positive` proves it of a curve that vanishes at the ends.
#include "denhartog/reference/orbit_proof.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/number/effort.hpp"
#include "denhartog/search/zeros.hpp"

namespace denhartog::reference {
namespace {

constexpr double longest_stretch = 3;      // norm of A times its length
constexpr int most_looks_at_phase = 20000; // at one curve
constexpr double narrowest_look = 0x1p-60; // at a part of a stretch

} // namespace

Ball derivative(const CurveInBalls& c, int order, const Ball& theta) {
    if (c.in_time) {
        Ball rate = c.in_time(theta * c.length).rate(order);
        for (int n = 0; n < order; ++n) rate *= c.length;
        return rate;
    }
    Ball sum(0), term;
    for (int k = static_cast<int>(c.powers.size()) - 1; k >= order; --k) {
        slong factor = 1;
        for (int q = 0; q < order; ++q) factor *= k - q;
        arb_mul(sum.a, sum.a, theta.a, ball_bits);
        arb_mul_si(term.a, c.powers[static_cast<std::size_t>(k)].a, factor, ball_bits);
        arb_add(sum.a, sum.a, term.a, ball_bits);
    }
    return sum;
}

Ball derivative_over(const CurveInBalls& c, int order, double a, double b) {
    const Ball X = Ball::within(a, b), m(a + (b - a) / 2), h = X - m;
    if (order == 2) return derivative(c, 2, X);
    if (order == 1) return derivative(c, 1, m) + derivative(c, 2, X) * h;
    return derivative(c, 0, m) + derivative(c, 1, m) * h + derivative(c, 2, X) * h * h / Ball(2);
}

void require_positive(const CurveInBalls& c, const EndsOfCurve& ends, const char* what) {
    for (const double end : {0.0, 1.0})
        if (derivative(c, 0, Ball(end)) < Ball(0)) throw Disproved(what);
    int looks = 0;
    const auto look = [&](double a, double b) {
        if (++looks > most_looks_at_phase || b - a < narrowest_look) throw Unproved(what);
        const int order = a == 0 ? ends.order : 0;
        if (!(ends.vanishes && b == 1)) {
            if (derivative_over(c, order, a, b) > Ball(0)) return ZerosInStretch::none;
        } else if (derivative_over(c, 1, a, b) < Ball(0)) {
            return ZerosInStretch::none;
        }
        if (derivative(c, 0, Ball(a + (b - a) / 2)) < Ball(0)) throw Disproved(what);
        return ZerosInStretch::unknown;
    };
    ZerosOnStretches found;
    find_zeros({look, [](double) { return true; }}, 0, 1, 0, found);
}

PhaseInStretches::PhaseInStretches(const ProvedOrbit& orbit, slong i, slong few) {
    const auto n = static_cast<std::size_t>(i - 1);
    const slong leaps = orbit.along.leaps[n];
    const int direction = orbit.at.direction(i);
    const BallMatrix& Z = orbit.Z[n];
    const Ball length = orbit.at.length(i);
    if (orbit.along.fast) {
        fast_ = orbit.s.by_free_motions(direction);
        Z_ = Z;
        length_ = length;
        return;
    }
    const BallMatrix A = orbit.s.phase(direction);
    (void)followed(A, Z, length, leaps, orbit.along.leap[n], orbit.s.effort, &leaps_);
    each_ =
        std::max<slong>(1, static_cast<slong>(std::ceil(norm(A) * length.high() / static_cast<double>(leaps) / longest_stretch)));
    count_ = each_ * leaps;
    const BallMatrix B = A * (length / Ball(static_cast<int>(count_)));
    for (slong k = 0; k < count_; ++k) {
        BallMatrix node;
        {
            const Bits more(few + 32); // a leap widens a ball by exp(longest_leap) at most
            node =
                leaps_[static_cast<std::size_t>(k / each_)].at(Ball(static_cast<int>(k % each_)) / Ball(static_cast<int>(each_)));
        }
        const Bits enough(few);
        stretches_.emplace_back(rounded(B), rounded(node), orbit.s.effort);
    }
}

CurveInBalls PhaseInStretches::curve(slong stretch, const BallMatrix& row) const {
    if (fast_) return {{}, fast_->number(row, Z_), length_};
    return {stretches_[static_cast<std::size_t>(stretch)].powers(row)};
}

Ball PhaseInStretches::number(slong stretch, const BallMatrix& row, const Ball& theta) const {
    if (fast_) return fast_->number(row, Z_)(theta * length_).rate(0);
    const Ball part = (Ball(static_cast<int>(stretch % each_)) + theta) / Ball(static_cast<int>(each_));
    return leaps_[static_cast<std::size_t>(stretch / each_)].at(row, part);
}

BallMatrix PhaseInStretches::state(const Ball& part) const {
    if (fast_) return fast_->state(Z_, part * length_);
    const auto leaps = static_cast<int>(count_ / each_);
    const Ball place = part * Ball(leaps);
    const slong leap = std::clamp<slong>(static_cast<slong>(std::floor(static_cast<double>(place))), 0, leaps - 1);
    return leaps_[static_cast<std::size_t>(leap)].at(place - Ball(static_cast<int>(leap)));
}

std::vector<PhaseInStretches> in_stretches(const ProvedOrbit& orbit, slong few) {
    std::vector<PhaseInStretches> phases;
    for (slong i = 1; i <= orbit.at.m(); ++i) {
        if (!(orbit.at.length(i) > Ball(0))) {
            if (orbit.at.length(i) < Ball(0)) throw Disproved("a phase ends before it starts");
            throw Unproved("a phase may have no length");
        }
        phases.emplace_back(orbit, i, few);
    }
    return phases;
}

void require_friction(const ProvedOrbit& orbit, const std::vector<PhaseInStretches>& phases) {
    const ContactMechanics& s = orbit.s;
    BallMatrix limit(1, s.n());
    limit(0, s.n() - 1) = s.holds;
    const auto require = [&](const PhaseInStretches& phase, const BallMatrix& row, const EndsOfCurve& ends, const char* what) {
        for (slong k = 0; k < phase.count(); ++k)
            require_positive(phase.curve(k, row), {k == 0 ? ends.order : 0, ends.vanishes && k == phase.count() - 1}, what);
    };
    for (slong i = 1; i <= orbit.at.m(); ++i) {
        const PhaseInStretches& phase = phases[static_cast<std::size_t>(i - 1)];
        const int before = orbit.at.direction(i - 1), here = orbit.at.direction(i), after = orbit.at.direction(i + 1);
        if (here == 0) {
            require(phase, limit - s.load * Ball(after), {0, true}, "it slips earlier");
            require(phase, limit + s.load * Ball(after), {0, false}, "it slips to the other side");
            continue;
        }
        if (before != 0) {
            const Ball beyond = (s.load * orbit.Z[static_cast<std::size_t>(i - 1)])(0) * Ball(here) - s.holds;
            if (beyond < Ball(0)) throw Disproved("it stops where it is said to turn");
            if (!(beyond > Ball(0))) throw Unproved("it may stop where it is said to turn");
        }
        // With mu = 1 it slips without a jump of its acceleration.
        require(phase, s.speed() * Ball(here), {before == 0 && s.equal ? 2 : 1, true}, "it turns or stops while it slides");
    }
}

} // namespace denhartog::reference

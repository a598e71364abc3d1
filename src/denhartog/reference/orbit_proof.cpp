// The proof that an orbit obeys Coulomb's law (3) and (74) at every instant, and the largest displacements. `require_friction` asks of each
// phase that the contact slides one way or that static friction holds it; `require_positive` proves it of a curve that vanishes at
// the ends. `peak_of_mass` searches all phases by branch and bound, so that no maximum is missed.
#include <algorithm>
#include <cmath>
#include <utility>

#include "denhartog/reference/orbit.hpp"
#include "denhartog/search/largest.hpp"
#include "denhartog/search/zeros.hpp"

namespace denhartog::reference {
namespace {

constexpr double longest_stretch = 3;      // norm of A times its length
constexpr int most_looks_at_phase = 20000; // at one curve
constexpr double narrowest_look = 0x1p-60; // at a part of a stretch

constexpr int most_looks_for_peak = 20000;
constexpr double narrow_peak = 1e-4;     // of a stretch, where Newton's method takes over if the velocity falls or rises
constexpr double narrowest_peak = 1e-12; // where it takes over in any case
constexpr int most_newton_steps = 20;    // each doubles the digits

// A displacement that may be the largest in size; it has a phase.
PeakInBalls candidate(const Ball& x, const Ball& instant) {
    const Ball pi = PiOf<Ball>::value();
    if (x.may_vanish()) return {abs(x), widened(Ball(0), pi)};
    return {abs(x), wrapped_in_balls(x < Ball(0) ? instant + pi : instant)};
}

// Of several that may be equal any may be the largest.
PeakInBalls largest_of(const std::vector<PeakInBalls>& all) {
    if (all.empty()) throw Unproved("no largest displacement was found");
    Ball largest = all.front().size;
    for (const PeakInBalls& each : all) largest = larger(largest, each.size);
    const Ball pi = PiOf<Ball>::value();
    std::optional<Ball> lag;
    Ball first;
    for (const PeakInBalls& each : all) {
        if (each.size < largest) continue;
        if (!lag) first = *each.phase;
        // The other's lag within half a turn of the first one's.
        const double turns = std::round(static_cast<double>(*each.phase - first) / (2 * static_cast<double>(pi)));
        const Ball beside = *each.phase - Ball(2) * Ball(turns) * pi;
        lag = lag ? either(*lag, beside) : beside;
    }
    return {largest, lag};
}

// Whether a force reaches a mass: through entries of the matrices that are not exactly zero.
bool is_reached(const ContactMechanics& s, slong mass) {
    const slong N = s.N;
    std::vector<char> reached(N, 0);
    for (slong rounds = 0; rounds <= N; ++rounds)
        for (slong i = 0; i < N; ++i) {
            bool now = !s.push(i).is_zero() || !s.free(N + i, 2 * N).is_zero() || !s.free(N + i, 2 * N + 1).is_zero();
            for (slong k = 0; k < N && !now; ++k)
                now = reached[k] != 0 && !(s.free(N + i, k).is_zero() && s.free(N + i, N + k).is_zero());
            if (now) reached[i] = 1;
        }
    return reached[mass] != 0;
}

// A part of a stretch where the largest displacement may be.
struct PlaceOfPeak {
    std::size_t phase, curve;
    double a, b, upper;

    friend bool operator<(const PlaceOfPeak& x, const PlaceOfPeak& y) { return x.upper < y.upper; }
};

// The search for the largest size of one number.
class PeakSearch {
public:
    // Of a row over Z, whose rate is taken in a unit of its own.
    PeakSearch(const ProvedOrbit& orbit, const std::vector<PhaseInStretches>& phases, BallMatrix row, Ball unit_of_rate)
        : orbit_(orbit), phases_(phases), row_(std::move(row)), unit_of_rate_(std::move(unit_of_rate)) {}

    // The candidates are places that the search does not see, as those where the rate jumps.
    PeakInBalls largest(std::vector<PeakInBalls> candidates = {}) {
        for (const PeakInBalls& each : candidates) best_ = std::max(best_, each.size.low());
        std::vector<PlaceOfPeak> places = narrowed();
        // Neighbours are one place; if they are too many the displacement hardly changes.
        std::erase_if(places, [&](const PlaceOfPeak& p) { return p.upper < best_; });
        for (const PlaceOfPeak& place : places)
            if (std::optional<PeakInBalls> found = at(place)) candidates.push_back(std::move(*found));
        return largest_of(candidates);
    }

private:
    std::vector<PlaceOfPeak> narrowed() {
        const Bits few(64);
        std::vector<PlaceOfPeak> open, kept;
        for (std::size_t i = 0; i < phases_.size(); ++i) {
            curves_.emplace_back();
            if (rests_in(i)) continue;
            for (slong n = 0; n < phases_[i].count(); ++n) {
                const CurveInBalls& c = curves_[i].emplace_back(phases_[i].curve(n, row_));
                open.push_back({i, static_cast<std::size_t>(n), 0, 1, abs(derivative(c, 0, Ball::within(0, 1))).high()});
            }
        }
        int looks = 0;
        const auto ends = [&](const PlaceOfPeak& p) {
            if (looks++ > most_looks_for_peak) throw Unproved("a displacement hardly changes, so that its largest is not found");
            return p.upper < best_;
        };
        branch_and_bound(open, ends, [&](const PlaceOfPeak& p) {
            const CurveInBalls& c = curves_[p.phase][p.curve];
            pay(orbit_.s.effort, cost_of_ball_products(3 * static_cast<double>(c.powers.size())));
            const Ball X = Ball::within(p.a, p.b), v = derivative(c, 1, X);
            const double half = p.a + (p.b - p.a) / 2;
            const Ball x = derivative(c, 0, Ball(half));
            best_ = std::max(best_, abs(x).low());
            const double upper = abs(widened(x, abs(v) * Ball((p.b - p.a) / 2))).high();
            if (upper < best_ || v > Ball(0) || v < Ball(0)) return;
            if (p.b - p.a < narrowest_peak || (p.b - p.a < narrow_peak && !derivative(c, 2, X).may_vanish())) {
                kept.push_back({p.phase, p.curve, p.a, p.b, upper});
            } else {
                open.push_back({p.phase, p.curve, p.a, half, upper});
                open.push_back({p.phase, p.curve, half, p.b, upper});
            }
        });
        return kept;
    }

    // Whether the number depends on the contact alone, and that sticks.
    [[nodiscard]] bool rests_in(std::size_t i) const {
        const ContactMechanics& s = orbit_.s;
        bool alone = s.on_a_wall && orbit_.at.direction(static_cast<slong>(i) + 1) == 0;
        for (slong k = 0; k < s.n() && alone; ++k) alone = k == s.lead || k == s.N + s.lead || row_(0, k).is_zero();
        return alone;
    }

    // The zero of the velocity in a place; none if there is none.
    std::optional<PeakInBalls> at(const PlaceOfPeak& p) const {
        const PhaseInStretches& phase = phases_[p.phase];
        const auto stretch = static_cast<slong>(p.curve);
        const CurveInBalls& c = curves_[p.phase][p.curve];
        const BallMatrix rate = row_ * orbit_.s.phase(orbit_.at.direction(static_cast<slong>(p.phase) + 1)) / unit_of_rate_;
        const CurveInBalls v = phase.curve(stretch, rate);
        Ball X = Ball::within(p.a, p.b);
        pay(orbit_.s.effort, cost_of_ball_products(500));
        for (int step = 0; step < most_newton_steps; ++step) {
            const Ball next = middle(X) - phase.number(stretch, rate, middle(X)) / derivative(v, 1, X);
            if (!next.finite()) break;
            const double width = X.radius();
            if (arb_intersection(X.a, X.a, next.a, ball_bits) == 0) return std::nullopt;
            if (step > 0 && !(X.radius() < width / 4)) break;
        }
        const auto i = static_cast<slong>(p.phase);
        const Ball part = (Ball(static_cast<int>(stretch)) + X) / Ball(static_cast<int>(phase.count()));
        // Next to the extremum the displacement hardly changes: that at a middle, and no more than the speed over the rest.
        const Ball x = phase.number(stretch, row_, middle(X));
        return candidate(widened(x, abs(derivative(c, 1, X)) * radius_of(X)),
                         orbit_.at.instant(i) + orbit_.at.length(i + 1) * part);
    }

    const ProvedOrbit& orbit_;
    const std::vector<PhaseInStretches>& phases_;
    BallMatrix row_;
    Ball unit_of_rate_;
    double best_ = 0; // a size that is certainly reached
    std::vector<std::vector<CurveInBalls>> curves_{};
};

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
        arb_mul_si(term.a, c.powers[k].a, factor, ball_bits);
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
            node = leaps_[k / each_].at(Ball(static_cast<int>(k % each_)) / Ball(static_cast<int>(each_)));
        }
        const Bits enough(few);
        stretches_.emplace_back(rounded(B), rounded(node), orbit.s.effort);
    }
}

CurveInBalls PhaseInStretches::curve(slong stretch, const BallMatrix& row) const {
    if (fast_) return {{}, fast_->number(row, Z_), length_};
    return {stretches_[stretch].powers(row)};
}

Ball PhaseInStretches::number(slong stretch, const BallMatrix& row, const Ball& theta) const {
    if (fast_) return fast_->number(row, Z_)(theta * length_).rate(0);
    const Ball part = (Ball(static_cast<int>(stretch % each_)) + theta) / Ball(static_cast<int>(each_));
    return leaps_[stretch / each_].at(row, part);
}

BallMatrix PhaseInStretches::state(const Ball& part) const {
    if (fast_) return fast_->state(Z_, part * length_);
    const auto leaps = static_cast<int>(count_ / each_);
    const Ball place = part * Ball(leaps);
    const slong leap = std::clamp<slong>(static_cast<slong>(std::floor(static_cast<double>(place))), 0, leaps - 1);
    return leaps_[leap].at(place - Ball(static_cast<int>(leap)));
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
    const auto require = [&](const PhaseInStretches& phase, const BallMatrix& row, const EndsOfCurve& ends, const char* what) {
        for (slong k = 0; k < phase.count(); ++k)
            require_positive(phase.curve(k, row), {k == 0 ? ends.order : 0, ends.vanishes && k == phase.count() - 1}, what);
    };
    for (slong i = 1; i <= orbit.at.m(); ++i) {
        const PhaseInStretches& phase = phases[i - 1];
        const int before = orbit.at.direction(i - 1), here = orbit.at.direction(i), after = orbit.at.direction(i + 1);
        if (here == 0) {
            require(phase, s.ending(0, after) * Ball(-after), {0, true}, "it slips earlier");
            require(phase, s.ending(0, -after) * Ball(after), {0, false}, "it slips to the other side");
            continue;
        }
        if (before != 0) {
            const Ball beyond = (s.load * orbit.Z[i - 1])(0) * Ball(here) - s.holds;
            if (beyond < Ball(0)) throw Disproved("it stops where it is said to turn");
            if (!(beyond > Ball(0))) throw Unproved("it may stop where it is said to turn");
        }
        // With mu = 1 it slips without a jump of its acceleration.
        require(phase, s.speed() * Ball(here), {before == 0 && s.equal ? 2 : 1, true}, "it turns or stops while it slides");
    }
}

PeakInBalls peak_of_contact(const ProvedOrbit& orbit) {
    const BallMatrix place = orbit.s.place();
    std::vector<PeakInBalls> candidates;
    for (slong i = 0; i < orbit.at.m(); ++i) {
        if (orbit.at.direction(i) == 0) continue;
        candidates.push_back(candidate((place * orbit.Z[i])(0), orbit.at.instant(i)));
    }
    return largest_of(candidates);
}

PeakInBalls peak_of_mass(const ProvedOrbit& orbit, const std::vector<PhaseInStretches>& phases, slong k, const Ball& frame) {
    if (frame.is_zero() && !is_reached(orbit.s, k)) return {Ball(0), std::nullopt};
    BallMatrix row(1, orbit.s.n());
    row(0, k) = Ball(1);
    row(0, 2 * orbit.s.N) = frame;
    return PeakSearch(orbit, phases, row, orbit.s.sigma).largest();
}

Ball largest_of_row(const ProvedOrbit& orbit, const std::vector<PhaseInStretches>& phases, const BallMatrix& row) {
    std::vector<PeakInBalls> at_events;
    for (slong i = 0; i < orbit.at.m(); ++i) at_events.push_back(candidate((row * orbit.Z[i])(0), orbit.at.instant(i)));
    return PeakSearch(orbit, phases, row, Ball(1)).largest(std::move(at_events)).size;
}

} // namespace denhartog::reference

// How far does each mass go in a motion with stops? Branch and bound over all phases, so that no maximum is missed: read
// `peak_of_mass` first, then `largest` and `narrowed`.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "denhartog/number/effort.hpp"
#include "denhartog/reference/orbit_proof.hpp"
#include "denhartog/search/largest.hpp"

namespace denhartog::reference {
namespace {

constexpr int most_looks_for_peak = 20000;
constexpr double narrow_peak = 1e-4;     // of a stretch, where Newton's method takes over if the velocity falls or rises
constexpr double narrowest_peak = 1e-12; // where it takes over in any case
constexpr int most_newton_steps = 20;    // each doubles the digits

// A displacement that may be the largest in size.
struct PeakCandidate {
    Ball size, lag;
};

PeakCandidate candidate(const Ball& x, const Ball& instant) {
    const Ball pi = PiOf<Ball>::value();
    if (x.may_vanish()) return {abs(x), widened(Ball(0), pi)};
    return {abs(x), wrapped_in_balls(x < Ball(0) ? instant + pi : instant)};
}

// Of several that may be equal any may be the largest.
PeakInBalls largest_of(const std::vector<PeakCandidate>& all) {
    if (all.empty()) throw Unproved("no largest displacement was found");
    Ball largest = all.front().size;
    for (const PeakCandidate& each : all) largest = larger(largest, each.size);
    const Ball pi = PiOf<Ball>::value();
    std::optional<Ball> lag;
    Ball first;
    for (const PeakCandidate& each : all) {
        if (each.size < largest) continue;
        if (!lag) first = each.lag;
        // The other's lag within half a turn of the first one's.
        const double turns = std::round(static_cast<double>(each.lag - first) / (2 * static_cast<double>(pi)));
        const Ball beside = each.lag - Ball(2) * Ball(turns) * pi;
        lag = lag ? either(*lag, beside) : beside;
    }
    return {largest, lag};
}

// Whether a force reaches a mass: through entries of the matrices that are not exactly zero.
bool is_reached(const ContactMechanics& s, slong mass) {
    const slong N = s.N;
    std::vector<char> reached(static_cast<std::size_t>(N), 0);
    for (slong rounds = 0; rounds <= N; ++rounds)
        for (slong i = 0; i < N; ++i) {
            bool now = !s.push(i).is_zero() || !s.free(N + i, 2 * N).is_zero() || !s.free(N + i, 2 * N + 1).is_zero();
            for (slong k = 0; k < N && !now; ++k)
                now =
                    reached[static_cast<std::size_t>(k)] != 0 && !(s.free(N + i, k).is_zero() && s.free(N + i, N + k).is_zero());
            if (now) reached[static_cast<std::size_t>(i)] = 1;
        }
    return reached[static_cast<std::size_t>(mass)] != 0;
}

// A part of a stretch where the largest displacement may be.
struct PlaceOfPeak {
    std::size_t phase, curve;
    double a, b, upper;

    friend bool operator<(const PlaceOfPeak& x, const PlaceOfPeak& y) { return x.upper < y.upper; }
};

// A number, a row over Z, and a row that vanishes with its rate in a phase of sliding back, of sticking, and of sliding forward.
struct RowWithRates {
    BallMatrix row;
    std::array<BallMatrix, 3> rates;
};

// A displacement, as it is seen from the ground where the frame moves.
RowWithRates displacement_row(const ContactMechanics& s, slong k, const Ball& frame) {
    BallMatrix row(1, s.n()), velocity(1, s.n());
    row(0, k) = Ball(1);
    velocity(0, s.N + k) = Ball(1);
    row(0, 2 * s.N) = frame;
    velocity(0, 2 * s.N + 1) = -(frame / s.sigma);
    return {row, {velocity, velocity, velocity}};
}

// The search for the largest size of one number.
class PeakSearch {
public:
    PeakSearch(const ProvedOrbit& orbit, const std::vector<PhaseInStretches>& phases, RowWithRates row, slong few)
        : orbit_(orbit), phases_(phases), row_(std::move(row.row)), rates_(std::move(row.rates)), few_(few) {}

    // The candidates are places that the search does not see, as those where the rate jumps.
    PeakInBalls largest(std::vector<PeakCandidate> candidates = {}) {
        for (const PeakCandidate& each : candidates) best_ = std::max(best_, each.size.low());
        std::vector<PlaceOfPeak> places = narrowed();
        // Neighbours are one place; if they are too many the displacement hardly changes.
        std::erase_if(places, [&](const PlaceOfPeak& p) { return p.upper < best_; });
        for (const PlaceOfPeak& place : places)
            if (std::optional<PeakCandidate> found = at(place)) candidates.push_back(std::move(*found));
        return largest_of(candidates);
    }

private:
    std::vector<PlaceOfPeak> narrowed() {
        const Bits few(few_);
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
    std::optional<PeakCandidate> at(const PlaceOfPeak& p) const {
        const PhaseInStretches& phase = phases_[p.phase];
        const auto stretch = static_cast<slong>(p.curve);
        const CurveInBalls& c = curves_[p.phase][p.curve];
        const BallMatrix& rate = rates_[static_cast<std::size_t>(orbit_.at.direction(static_cast<slong>(p.phase) + 1) + 1)];
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
        Ball apart;
        arf_set_mag(arb_midref(apart.a), arb_radref(X.a));
        return candidate(widened(x, abs(derivative(c, 1, X)) * apart), orbit_.at.instant(i) + orbit_.at.length(i + 1) * part);
    }

    const ProvedOrbit& orbit_;
    const std::vector<PhaseInStretches>& phases_;
    BallMatrix row_;
    std::array<BallMatrix, 3> rates_;
    slong few_;
    double best_ = 0; // a size that is certainly reached
    std::vector<std::vector<CurveInBalls>> curves_{};
};

} // namespace

PeakInBalls peak_of_contact(const ProvedOrbit& orbit) {
    const BallMatrix place = orbit.s.place();
    std::vector<PeakCandidate> candidates;
    for (slong i = 0; i < orbit.at.m(); ++i) {
        if (orbit.at.direction(i) == 0) continue;
        candidates.push_back(candidate((place * orbit.Z[static_cast<std::size_t>(i)])(0), orbit.at.instant(i)));
    }
    return largest_of(candidates);
}

PeakInBalls peak_of_mass(const ProvedOrbit& orbit, const std::vector<PhaseInStretches>& phases, slong k, const Ball& frame) {
    if (frame.is_zero() && !is_reached(orbit.s, k)) return {Ball(0), std::nullopt};
    return PeakSearch(orbit, phases, displacement_row(orbit.s, k, frame), 64).largest();
}

Ball largest_of_row(const ProvedOrbit& orbit, const std::vector<PhaseInStretches>& phases, const BallMatrix& row) {
    const ContactMechanics& s = orbit.s;
    std::vector<PeakCandidate> at_events;
    for (slong i = 0; i < orbit.at.m(); ++i)
        at_events.push_back(candidate((row * orbit.Z[static_cast<std::size_t>(i)])(0), orbit.at.instant(i)));
    return PeakSearch(orbit, phases, {row, {row * s.phase(-1), row * s.phase(0), row * s.phase(1)}}, 64)
        .largest(std::move(at_events))
        .size;
}

} // namespace denhartog::reference

// Is there a motion near a guess, and only one? Newton's method on the equations of orbit_equations.cpp, with few bits in the
// slopes, and Krawczyk's operator as the proof. Read `NewtonSearch::proved` first.
#include "denhartog/reference/orbit_equations.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "denhartog/number/effort.hpp"

namespace denhartog::reference {
namespace {

constexpr int most_rounds = 60; // of linearising anew, until Newton's method is near
constexpr int most_halvings = 12;
constexpr slong bits_a_phase = 5; // about what a phase widens balls by, and some more

// The binary logarithm of a midpoint's size, even if a double cannot hold it.
double size_in_bits(const Ball& x) {
    if (arf_is_zero(arb_midref(x.a))) return -1e9;
    const slong exponent = arf_abs_bound_lt_2exp_si(arb_midref(x.a));
    return binary_logarithm(std::abs(static_cast<double>(x * power_of_two(-exponent)))) + static_cast<double>(exponent);
}

// The equations at one point: states at the events, and what is not zero.
struct OrbitResidual {
    std::vector<BallMatrix> Z{};
    BallMatrix F{};
};

// The equations at a point of the box that was linearised, or near it while nothing is to be proved yet.
OrbitResidual residual_at(const ContactMechanics& s, const OrbitUnknowns& o, const Linearised& along) {
    const slong z = o.states(), m = o.m();
    OrbitResidual r{{o.start()}, BallMatrix(z + m, 1)};
    for (slong i = 0; i < m; ++i) {
        r.F(z + i) = (s.ending(o.direction(i), o.direction(i + 1)) * r.Z.back())(0);
        const auto k = static_cast<std::size_t>(i);
        const int kind = o.direction(i + 1);
        const Ball length = o.length(i + 1);
        r.Z.push_back(along.fast ? s.by_free_motions(kind)->state(r.Z.back(), length)
                      : kind != 0 && s.sliding
                          ? s.sliding->after(r.Z.back(), length, kind)
                          : followed(s.phase(kind), r.Z.back(), length, along.leaps[k], along.leap[k], s.effort));
    }
    for (slong i = 0; i < z; ++i) r.F(i) = o.u(i) - Ball(o.sign()) * r.Z.back()(i);
    return r;
}

// Newton's method, from a guess to a proof, with derivatives of few bits.
class NewtonSearch {
public:
    NewtonSearch(const ContactMechanics& s, OrbitUnknowns& o, slong bits_of_slopes)
        : s_(s), o_(o), bits_(bits_of_slopes), scale_(static_cast<std::size_t>(o.u.rows()), 1),
          box_(std::ldexp(1, -static_cast<int>(std::min<slong>(std::max<slong>(36, bits_of_slopes / 2 - 6), 900)))) {
        double largest = 1e-280;
        for (slong k = 0; k < o.states(); ++k) largest = std::max(largest, std::abs(static_cast<double>(o.u(k))));
        std::fill_n(scale_.begin(), o.states(), largest);
    }

    // The motion, once its box is proved to hold one.
    ProvedOrbit proved() {
        for (int round = 0; round < most_rounds; ++round) {
            const BallMatrix about = o_.u;
            linearise();
            if (!settled()) continue;
            double away = 0;
            for (slong k = 0; k < o_.u.rows(); ++k)
                away = std::max(away, std::abs(static_cast<double>(o_.u(k) - about(k))) / scale_[static_cast<std::size_t>(k)]);
            if (away > box_ / 2) continue;
            if (std::optional<ProvedOrbit> orbit = krawczyk()) return std::move(*orbit);
            throw Unproved("the slopes are too uncertain for a proof");
        }
        throw Unproved("Newton's method does not come near a motion");
    }

private:
    void linearise() {
        const Bits few(bits_);
        pay(s_.effort, cost_of_ball_products(3 * static_cast<double>(o_.u.rows() * o_.u.rows() * o_.u.rows())));
        OrbitUnknowns box = o_;
        for (slong k = 0; k < box.u.rows(); ++k) box.u(k) = widened(box.u(k), Ball(box_ * scale_[static_cast<std::size_t>(k)]));
        along_ = linearised(s_, box);
        box_of_slopes_ = std::move(box.u);
        Y_ = BallMatrix(o_.u.rows(), o_.u.rows());
        if (arb_mat_approx_inv(Y_.a, along_.J.a, bits_) == 0) throw Unproved("the slopes are singular");
        Y_ = middle(Y_);
    }

    BallMatrix step_at(const OrbitUnknowns& o) {
        residual_ = residual_at(s_, o, along_);
        return Y_ * residual_.F;
    }

    // The digits that are right once a step was taken, in bits: how small the step is, in units of the scales.
    double smallness_of(const BallMatrix& step) const {
        double least = 1e9;
        for (slong k = 0; k < step.rows(); ++k) {
            if (!step(k).finite()) throw Unproved("Newton's method leaves all bounds");
            least = std::min(least, binary_logarithm(scale_[static_cast<std::size_t>(k)]) - size_in_bits(step(k)));
        }
        return least;
    }

    // By how much a step may be taken so that every phase keeps a quarter of its length.
    double part_of(const BallMatrix& step) const {
        double part = 1;
        const slong z = o_.states(), m = o_.m();
        for (slong i = 1; i <= m; ++i) {
            const double length = static_cast<double>(o_.length(i)),
                         shrinks = static_cast<double>(step(z + i % m) - step(z + i - 1));
            if (shrinks > 0.75 * length) part = std::min(part, 0.75 * std::max(length, 1e-300) / shrinks);
        }
        return part;
    }

    OrbitUnknowns moved(const BallMatrix& step, double part) const {
        OrbitUnknowns to = o_;
        to.u = middle(o_.u - step * Ball(part));
        return to;
    }

    // Steps with the same slopes as long as they bring it nearer: true once rounding is all that is left.
    bool settled() {
        const slong all = ball_bits;
        at_hand_ = false;
        BallMatrix step = step_at(o_);
        double small = smallness_of(step), gained = 0; // bits
        const double at_first = small;
        for (int n = 0;; ++n) {
            const Bits enough(std::min(all, static_cast<slong>(std::max(small, 0.0)) + 64 + bits_));
            double part = part_of(step);
            bool nearer = false;
            for (int halvings = 0; halvings < (n == 0 ? most_halvings : 1) && !nearer; ++halvings) {
                if (halvings > 0) part /= 2;
                const OrbitUnknowns to = moved(step, part);
                BallMatrix next = step_at(to);
                const double then = smallness_of(next);
                nearer = then > small - binary_logarithm(1 - part / 4);
                if (!nearer) continue;
                gained = then - small;
                o_.u = to.u;
                step = std::move(next);
                small = then;
            }
            if (nearer && part < 1) return false;                               // the slopes there are others
            if (nearer && small + gained / 2 > static_cast<double>(all) - 56) { // the step at hand does the rest
                at_hand_ = ball_bits == all && small + gained / 2 > static_cast<double>(all) - 32;
                const Bits last(all);
                if (!at_hand_) o_.u = moved(step, 1).u; // else the proof takes it
                return true;
            }
            // Slopes taken here, so much nearer, give more digits a step.
            if (nearer && small > 3 * at_first && static_cast<double>(all) - small > 8 * gained) return false;
            if (nearer && (n == 0 || gained > 2)) continue;
            const bool again = std::abs(small - stalled_) < 16; // twice at one place is rounding
            stalled_ = small;
            return again;
        }
    }

    std::optional<ProvedOrbit> krawczyk() {
        const BallMatrix step = at_hand_ ? Y_ * residual_.F : step_at(o_);
        const auto left_open = [&] {
            const Bits few(bits_);
            return unit_matrix(step.rows()) - Y_ * along_.J;
        };
        const std::optional<BallMatrix> off = solution_from(o_.u, step, left_open(), box_of_slopes_);
        if (!off) return std::nullopt;
        ProvedOrbit orbit{s_, o_, {}, along_};
        orbit.at.u = o_.u + *off;
        for (std::size_t i = 0; i < residual_.Z.size(); ++i) orbit.Z.push_back(residual_.Z[i] + along_.D[i] * *off);
        return orbit;
    }

    const ContactMechanics& s_;
    OrbitUnknowns& o_;
    slong bits_; // of the slopes
    std::vector<double> scale_;
    double box_; // half the width of the box that the slopes are of, in units of the scales
    Linearised along_{};
    BallMatrix box_of_slopes_{};
    BallMatrix Y_{};
    OrbitResidual residual_{}; // where it was taken last
    bool at_hand_ = false;     // whether that is where the proof takes it, in all bits
    double stalled_ = -1;      // bits, where rounding may have stopped it
};

} // namespace

std::optional<BallMatrix> solution_from(const BallMatrix& u, const BallMatrix& step, const BallMatrix& open,
                                        const BallMatrix& box) {
    const slong count = u.rows();
    // In units of the widths of the box: how far the step leads, row sums of 1 - Y J, and how far u is from the middle.
    Ball moves(0), keeps(0), apart(0);
    for (slong k = 0; k < count; ++k) {
        const Ball unit = radius_of(box(k));
        Ball sum(0);
        for (slong c = 0; c < count; ++c) sum += abs(open(k, c)) * radius_of(box(c)) / unit;
        moves = larger(moves, abs(step(k)) / unit);
        keeps = larger(keeps, sum);
        apart = larger(apart, abs(u(k) - middle(box(k))) / unit);
    }
    // with keeps < 1/2 the image of this box is inside of it
    const Ball radius = upper_bound_of(larger(moves * Ball(2), power_of_two(-(ball_bits + 8))));
    if (!(keeps < Ball(0.5)) || !(apart + radius < Ball(1))) return std::nullopt;
    BallMatrix off(count, 1);
    for (slong k = 0; k < count; ++k) off(k) = widened(-step(k), upper_bound_of(keeps * radius * radius_of(box(k))));
    return off;
}

ProvedOrbit proved_near(const std::function<SceneInBalls()>& scene, const OrbitGuess& guess, slong bits) {
    const auto phases = static_cast<slong>(guess.events.size());
    for (slong of_slopes = std::max({slong(64), bits / 6, bits_a_phase * phases});; of_slopes *= 2) {
        // A long motion, or its events, widen the states as they widen the slopes.
        const Bits all(std::max(bits, of_slopes + 64));
        const ContactMechanics s(scene());
        OrbitUnknowns o = unknowns_of(s, guess);
        try {
            return NewtonSearch(s, o, of_slopes).proved();
        } catch (const Disproved&) {
            throw;
        } catch (const Unproved&) {
            if (of_slopes >= std::max({bits, slong(256), 2 * bits_a_phase * phases})) throw;
        }
    }
}

} // namespace denhartog::reference

// The equations of a motion with stops, and the proof that there is one near a guess, and only one. One equation for each phase, by (6),
// and one for each event, by (3) and (74). The unknowns are the states and the instants of the events; `linearised` gives the
// derivatives over a box of unknowns. Newton's method, with few bits in the slopes, comes near a motion, and Krawczyk's operator
// proves it: read `NewtonSearch::proved` first.
#include <algorithm>
#include <cmath>

#include "denhartog/reference/orbit.hpp"

namespace denhartog::reference {
namespace {

constexpr double longest_leap = 16; // norm of A times its length: a series summed at one go may widen a ball by its exponential
constexpr slong many_leaps = 24;    // of all phases, beyond which these are followed by their free motions, if these are known
constexpr slong most_leaps = 4096;  // beyond which series are too many
constexpr int most_rounds = 60;     // of linearising anew, until Newton's method is near
constexpr int most_halvings = 12;
constexpr slong bits_a_phase = 5; // about what a phase widens balls by, and some more

// The unknowns where a guess puts them, exact. Throws Disproved if no contact has such an order of phases.
OrbitUnknowns unknowns_of(const ContactMechanics& s, const OrbitGuess& guess) {
    OrbitUnknowns o{guess.directions, guess.mirrored, guess.periods, BallMatrix()};
    const slong m = o.m(), N = s.N;
    if (m < 1 || guess.events.size() != static_cast<std::size_t>(m) || guess.x.size() != static_cast<std::size_t>(N) ||
        guess.x_prime.size() != guess.x.size() || guess.periods < 1)
        throw Disproved("a guess needs a phase, an instant for each event and a state of every mass");
    if (o.direction(m) != o.sign() * o.direction(0)) throw Disproved("the last phase of the stretch is not its first one again");
    for (slong i = 0; i <= m; ++i)
        if (o.direction(i) == o.direction(i + 1)) throw Disproved("a phase follows one of its own kind");
    o.u = BallMatrix(2 * N + m, 1);
    for (slong k = 0; k < N; ++k) {
        o.u(k) = Ball(guess.x[k]);
        o.u(N + k) = Ball(guess.x_prime[k]) / s.sigma;
    }
    for (slong i = 0; i < m; ++i) o.u(2 * N + i) = Ball(guess.events[i]);
    return o;
}

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
        const int kind = o.direction(i + 1);
        const Ball length = o.length(i + 1);
        r.Z.push_back(along.fast ? s.by_free_motions(kind)->state(r.Z.back(), length)
                      : kind != 0 && s.sliding
                          ? s.after_sliding(r.Z.back(), length, kind)
                          : followed(s.phase(kind), r.Z.back(), length, along.leaps[i], along.leap[i], s.effort));
    }
    put(r.F, 0, 0, part_of(o.u, 0, 0, z, 1) - part_of(r.Z.back(), 0, 0, z, 1) * Ball(o.sign()));
    return r;
}

// Newton's method, from a guess to a proof, with derivatives of few bits.
class NewtonSearch {
public:
    NewtonSearch(const ContactMechanics& s, OrbitUnknowns& o, slong bits_of_slopes)
        : s_(s), o_(o), bits_(bits_of_slopes), scale_(o.u.rows(), 1),
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
                away = std::max(away, std::abs(static_cast<double>(o_.u(k) - about(k))) / scale_[k]);
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
        for (slong k = 0; k < box.u.rows(); ++k) box.u(k) = widened(box.u(k), Ball(box_ * scale_[k]));
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
            least = std::min(least, binary_logarithm(scale_[k]) - size_in_bits(step(k)));
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

BallMatrix with_width(BallMatrix E, double part) {
    for (slong c = 0; c < E.columns(); ++c) {
        Ball largest(0);
        for (slong k = 0; k < E.rows(); ++k) largest = larger(largest, upper_bound_of(abs(E(k, c))));
        const Ball width = upper_bound_of(largest * Ball(part * (1 + 1e-9)));
        for (slong k = 0; k < E.rows(); ++k) E(k, c) = widened(E(k, c), width);
    }
    return E;
}

int OrbitUnknowns::direction(slong i) const { return i <= m() ? directions[i] : sign() * directions[1]; }

Ball OrbitUnknowns::T() const { return Ball(mirrored ? periods : 2 * periods) * PiOf<Ball>::value(); }

Ball OrbitUnknowns::instant(slong i) const { return i < m() ? u(states() + i) : u(states()) + T(); }

BallMatrix OrbitUnknowns::start() const {
    BallMatrix Z(states() + 3, 1);
    put(Z, 0, 0, part_of(u, 0, 0, states(), 1));
    Z(states()) = cos(instant(0));
    Z(states() + 1) = sin(instant(0));
    Z(states() + 2) = Ball(1);
    return Z;
}

ExponentialSeries::ExponentialSeries(const BallMatrix& B, const BallMatrix& y, Effort* effort) {
    const slong n = B.rows();
    const double theta = norm(B) * (1 + 1e-9);
    // The terms beyond the last fall by half each, from below the last bit: theta^last < last! <= ((last + 1) / 2)^last.
    slong last = 0;
    for (double left = static_cast<double>(ball_bits); left > 0 || last < 4;)
        left += binary_logarithm(std::max(theta, 1e-300) / static_cast<double>(++last));
    const SparseBalls sparse(B);
    pay(effort, cost_of_ball_products(static_cast<double>((sparse.count() + n) * last)));
    terms_ = BallMatrix(n, last + 1);
    over_factorials_ = BallMatrix(1, last + 1);
    over_factorials_(0, 0) = Ball(1);
    put(terms_, 0, 0, y);
    for (slong k = 1; k <= last; ++k) {
        sparse.times_column(terms_, k - 1, terms_, k);
        over_factorials_(0, k) = over_factorials_(0, k - 1) / Ball(k);
    }
    // Beyond k the first term is no larger than |y_k| theta / (k + 1) over k!, and so on: the rest is at most twice that. Twice
    // more holds its derivatives as well.
    Ball largest(0);
    for (slong i = 0; i < n; ++i) largest = larger(largest, abs(terms_(i, last)));
    const Ball rest = upper_bound_of(largest * Ball(4 * theta / static_cast<double>(last + 1)));
    for (slong i = 0; i < n; ++i) terms_(i, last) = widened(terms_(i, last), rest);
}

BallMatrix ExponentialSeries::powers_of(const Ball& theta) const {
    BallMatrix powers = over_factorials_;
    Ball power(1);
    for (slong k = 1; k < powers.columns(); ++k) powers(0, k) *= power *= theta;
    return powers;
}

BallMatrix ExponentialSeries::at(const Ball& theta) const {
    const BallMatrix powers = powers_of(theta);
    BallMatrix sum(terms_.rows(), 1);
    for (slong i = 0; i < sum.rows(); ++i)
        arb_dot(sum(i).a, nullptr, 0, terms_(i, 0).a, 1, powers(0, 0).a, 1, powers.columns(), ball_bits);
    return sum;
}

Ball ExponentialSeries::at(const BallMatrix& row, const Ball& theta) const {
    const BallMatrix powers = powers_of(theta);
    Ball sum(0), part;
    for (slong i = 0; i < terms_.rows(); ++i) {
        if (row(0, i).is_zero()) continue;
        arb_dot(part.a, nullptr, 0, terms_(i, 0).a, 1, powers(0, 0).a, 1, powers.columns(), ball_bits);
        sum += row(0, i) * part;
    }
    return sum;
}

std::vector<Ball> ExponentialSeries::powers(const BallMatrix& row) const {
    std::vector<Ball> sum(terms_.columns());
    for (slong i = 0; i < terms_.rows(); ++i) {
        if (row(0, i).is_zero()) continue;
        for (slong k = 0; k < terms_.columns(); ++k) arb_addmul(sum[k].a, row(0, i).a, terms_(i, k).a, ball_bits);
    }
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] *= over_factorials_(0, static_cast<slong>(k));
    return sum;
}

void ExponentialSeries::widen(const Ball& radius) {
    for (slong i = 0; i < terms_.rows(); ++i) terms_(i, 0) = widened(terms_(i, 0), radius);
}

BallMatrix followed(const BallMatrix& A, const BallMatrix& Z, const Ball& length, slong leaps, const BallMatrix& leap,
                    Effort* effort, std::vector<ExponentialSeries>* series) {
    const slong n = A.rows();
    const BallMatrix B = A * (length / Ball(static_cast<int>(leaps)));
    BallMatrix node = Z;
    mag_t size;
    mag_init(size);
    for (slong q = 0; q < leaps; ++q) {
        ExponentialSeries s(B, middle(node), effort);
        BallMatrix next = s.at(Ball(1));
        for (slong i = 0; i < n; ++i)
            for (slong k = 0; k < n; ++k) {
                arb_get_mag(size, leap(i, k).a);
                mag_addmul(arb_radref(next(i).a), size, arb_radref(node(k).a));
            }
        if (series != nullptr) { // within the leap a bound has to do: |exp(B theta)| <= exp(|B|)
            Ball radius(0);
            for (slong k = 0; k < n; ++k) radius = larger(radius, radius_of(node(k)));
            s.widen(upper_bound_of(radius * exp(Ball(norm(B)))));
            series->push_back(std::move(s));
        }
        node = std::move(next);
    }
    mag_clear(size);
    return node;
}

Linearised linearised(const ContactMechanics& s, const OrbitUnknowns& box) {
    const slong n = s.n(), z = 2 * s.N, m = box.m();
    Linearised r;
    r.J = BallMatrix(z + m, z + m);
    slong all_leaps = 0;
    for (slong i = 1; i <= m; ++i) {
        const Ball h = box.length(i);
        const double size = norm(s.phase(box.direction(i))) * std::max(std::abs(h.low()), std::abs(h.high()));
        if (!(size < 1e9)) throw Unproved("a mode is too fast for the motion to be followed");
        r.leaps.push_back(std::max<slong>(1, static_cast<slong>(std::ceil(size / longest_leap))));
        all_leaps += r.leaps.back();
    }
    r.fast = all_leaps > many_leaps &&
             std::ranges::all_of(box.directions, [&](int direction) { return s.by_free_motions(direction) != nullptr; });
    if (!r.fast && all_leaps > most_leaps)
        throw Unproved("free motions are not told apart, and too fast to be followed otherwise");
    BallMatrix Z = rounded(box.start()), D(n, z + m);
    put(D, 0, 0, unit_matrix(z));
    D(z, z) = -Z(z + 1);
    D(z + 1, z) = Z(z);
    for (slong i = 0;; ++i) {
        r.D.push_back(D);
        if (i == m) break;
        const int kind = box.direction(i + 1);
        put(r.J, z + i, 0, s.ending(box.direction(i), kind) * D);
        const Ball h = box.length(i + 1), middle_h = middle(h);
        const BallMatrix A = rounded(s.phase(kind));
        // Never exponentiate a wide ball: exp(A (h + d)) is off exp(A h), column by column, by at most exp(|A d|) - 1 of the
        // largest entry.
        const double apart = norm(A) * h.radius() * (1 + 1e-9);
        const auto leaps = static_cast<int>(r.leaps[i]);
        BallMatrix E(n, n);
        if (r.fast) {
            E = s.by_free_motions(kind)->propagator(middle_h);
        } else {
            const BallMatrix leap = s.propagator(kind, middle_h / Ball(leaps));
            arb_mat_pow_ui(E.a, leap.a, static_cast<ulong>(leaps), ball_bits);
            r.leap.push_back(with_width(leap, elementary::expm1(apart / leaps)));
        }
        r.E.push_back(E);
        r.lengths.push_back(middle_h);
        E = with_width(std::move(E), elementary::expm1(apart));
        Z = E * Z;
        D = E * D;
        const BallMatrix rate = A * Z;
        for (slong k = 0; k < n; ++k) {
            D(k, z + (i + 1) % m) += rate(k);
            D(k, z + i) -= rate(k);
        }
    }
    BallMatrix begun(z, z + m);
    put(begun, 0, 0, unit_matrix(z));
    put(r.J, 0, 0, begun - part_of(D, 0, 0, z, z + m) * Ball(box.sign())); // what comes back is what began
    return r;
}

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
    for (slong bits_of_slopes = std::max({slong(64), bits / 6, bits_a_phase * phases});; bits_of_slopes *= 2) {
        // A long motion, or its events, widen the states as they widen the slopes.
        const Bits all(std::max(bits, bits_of_slopes + 64));
        const ContactMechanics s(scene());
        OrbitUnknowns o = unknowns_of(s, guess);
        const bool last = bits_of_slopes >= std::max({bits, slong(256), 2 * bits_a_phase * phases});
        if (auto found = if_proved([&] { return NewtonSearch(s, o, bits_of_slopes).proved(); }, last)) return *std::move(found);
    }
}

} // namespace denhartog::reference

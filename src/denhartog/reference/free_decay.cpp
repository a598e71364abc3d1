// The motion without a load, until it comes to rest. Read `followed` first: it follows (6) from one standstill to the next, and
// `after_standstill` decides by (74) whether the contact moves on. An energy bound proves that a contact at rest stays.
#include "denhartog/reference/free_decay.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace denhartog::reference {
namespace {

constexpr double norm_of_leap = 2;         // of A times its length
constexpr double narrowest_part = 0x1p-60; // of a leap in which an event is looked for

// First zero of a falling curve, theta in (0, 1]; none if it stays positive. It is positive from the start on, where it
// vanishes to an order.
std::optional<Ball> first_fall(const CurveInBalls& c, int order, double a = 0, double b = 1) {
    if (derivative_over(c, a == 0 ? order : 0, a, b) > Ball(0)) return std::nullopt;
    if (derivative(c, 0, Ball(b)) < Ball(0) && derivative_over(c, 1, a, b) < Ball(0)) {
        Ball zero = Ball::within(a, b);
        for (int n = 0; n < 64; ++n) { // Newton's method on intervals
            const Ball m = middle(zero), slope = derivative_over(c, 1, std::max(a, zero.low()), std::min(b, zero.high()));
            Ball next = m - derivative(c, 0, m) / slope;
            if (arb_intersection(next.a, next.a, zero.a, ball_bits) == 0) next = zero; // rounding leaves nothing
            const bool shrinks = radius_of(next) * Ball(2) < radius_of(zero);
            zero = next;
            if (!shrinks) break;
        }
        return zero;
    }
    const double m = a + (b - a) / 2;
    if (b - a < narrowest_part || !(m > a && m < b)) throw Unproved("an event of the contact may only be touched");
    const std::optional<Ball> before = first_fall(c, order, a, m);
    return before ? before : first_fall(c, order, m, b);
}

// b A^-1 b less what a displacement of the contact takes of it: the square of the largest b y of all y with y A y = 1, w y = 0.
Ball largest_square(const BallMatrix& A, const BallMatrix& w, const BallMatrix& b) {
    const BallMatrix A_to_b = solution_of(A, b, "a matrix is not proved regular"),
                     A_to_w = solution_of(A, w, "a matrix is not proved regular");
    const Ball across = (transposed(w) * A_to_b)(0);
    return (transposed(b) * A_to_b)(0) - across * across / (transposed(w) * A_to_w)(0);
}

// The motion as it is followed.
class Decay {
public:
    Decay(const SceneInBalls& scene, const BallMatrix& x, const BallMatrix& x_prime, const std::optional<Ball>& until, bool last)
        : speed_at_start_((transposed(scene.w) * x_prime)(0)), scene_(scene), s_(without_load(scene)), Z_(s_.n(), 1),
          until_(until), last_(last) {
        put(Z_, 0, 0, x);
        put(Z_, s_.N, 0, x_prime / s_.sigma);
        Z_(2 * s_.N + 2) = Ball(1);
        const BallMatrix load_of_places = transposed(part_of(s_.load, 0, 0, 1, s_.N)),
                         load_of_rates = transposed(part_of(s_.load, 0, s_.N, 1, s_.N)) / s_.sigma;
        mass_ = scene.M * (scene.r * scene.r);
        if (s_.N > 1) reach_ = largest_square(scene.K, scene.w, load_of_places) + largest_square(mass_, scene.w, load_of_rates);
        at_unit_force_ = solution_of(scene.K, scene.w, stiffness_is_open);
        compliance_ = (transposed(scene.w) * at_unit_force_)(0);
    }

    FreeDecayOf<Ball> followed() {
        int direction = 0, order = 0;
        if (!speed_at_start_.is_zero()) {
            if (speed_at_start_.may_vanish()) throw Unproved("the contact may be at rest at the start");
            direction = speed_at_start_ > Ball(0) ? 1 : -1;
        } else {
            hold_contact();
            direction = after_standstill();
            order = 1;
        }
        while (direction != 0 || !rests_for_good()) {
            const Ball start = tau_;
            if (direction != 0) {
                if (pass({s_.speed() * Ball(direction)}, direction, order) == too_late) return std::move(out_);
                hold_contact();
                out_.turns.push_back({tau_, (s_.place() * Z_)(0)});
                direction = after_standstill();
                order = 1;
            } else {
                const Ball at = (s_.place() * Z_)(0);
                const int side = pass({-s_.ending(0, 1), s_.ending(0, -1)}, 0, 0);
                if (side == too_late) return std::move(out_);
                if (side == rest_lasts) break;
                hold_contact();
                out_.stops.push_back({start, tau_, at});
                direction = side == 0 ? 1 : -1;
                order = s_.equal ? 2 : 1; // with mu = 1 it slips without a jump of its acceleration
            }
        }
        out_.at_rest = true;
        write_rest();
        return std::move(out_);
    }

private:
    static constexpr int rest_lasts = -1, too_late = -2; // in place of a guard

    static ContactMechanics without_load(SceneInBalls scene) {
        scene.p = BallMatrix(scene.N(), 1);
        scene.p_i = BallMatrix();
        scene.zeta.clear(); // damping is in C
        return ContactMechanics(scene);
    }

    // (74) where the velocity of the contact is zero: 0 if it sticks, else the direction in which its load moves it.
    int after_standstill() {
        const Ball load = (s_.load * Z_)(0);
        if (abs(load) < s_.holds) return 0;
        if (abs(load) > s_.holds) return load > Ball(0) ? 1 : -1;
        if (!last_ || s_.N > 1) throw Unproved("the load on the contact at rest may equal static friction");
        out_.on_limit = true;
        return 0;
    }

    // Follows a phase to its end, the first fall of a guard through zero: its place among the guards.
    int pass(const std::vector<BallMatrix>& guards, int direction, int order) {
        const BallMatrix A = s_.phase(direction);
        // With more bits a leap is a little shorter: no event is at the end of one each time.
        const Ball h(norm_of_leap / norm(A) * (1 - 0x1p-20 * static_cast<double>(ball_bits)));
        const BallMatrix B = A * h;
        pay_for_exponential(B);
        const BallMatrix leap = exp(B);
        for (;; order = 0) {
            const ExponentialSeries series(B, Z_, s_.effort);
            int first = -1;
            std::optional<Ball> end;
            for (std::size_t g = 0; g < guards.size(); ++g) {
                CurveInBalls curve{series.powers(guards[g])};
                for (int n = 0; n < order; ++n) curve.powers[n] = Ball(0);
                const std::optional<Ball> fall = first_fall(curve, order);
                if (!fall || (end && *fall > *end)) continue;
                if (end && !(*fall < *end)) throw Unproved("two events of the contact may be one");
                end = fall;
                first = static_cast<int>(g);
            }
            if (end) {
                end_at(B, *end);
                tau_ += h * *end;
                return until_ && tau_ > *until_ ? too_late : first;
            }
            Z_ = leap * Z_;
            tau_ += h;
            if (direction == 0 && rests_for_good()) return rest_lasts;
            if (until_ && tau_ > *until_) return too_late;
        }
    }

    void pay_for_exponential(const BallMatrix& B) const {
        const auto n = static_cast<double>(B.rows());
        pay(s_.effort, cost_of_ball_products(n * n * n * std::sqrt(static_cast<double>(ball_bits))));
    }

    // The state at the end of a phase, theta in a ball: that in its middle, and the rate over all of it. The velocity of the contact
    // is zero there, so that its displacement is hardly wider.
    void end_at(const BallMatrix& B, const Ball& theta) {
        pay_for_exponential(B);
        pay_for_exponential(B);
        const Ball m = middle(theta);
        const BallMatrix rate = B * (exp(B * theta) * Z_);
        Z_ = exp(B * m) * Z_ + rate * (theta - m);
    }

    void hold_contact() {
        const slong N = s_.N;
        Ball others(0);
        for (slong i = 0; i < N; ++i)
            if (i != s_.lead) others += s_.w(i) * Z_(N + i);
        Z_(N + s_.lead) = s_.on_a_wall ? Ball(0) : -(others / s_.w(s_.lead));
    }

    // Displacements of the masses from their places of rest with the contact where it is.
    [[nodiscard]] BallMatrix places() const { return at_unit_force_ * ((s_.place() * Z_)(0) / compliance_); }

    // Whether the contact, at rest, rests for good: proved, or not yet. A single mass always does.
    [[nodiscard]] bool rests_for_good() const {
        if (s_.N == 1) return true;
        const BallMatrix y = part_of(Z_, 0, 0, s_.N, 1) - places(), v = part_of(Z_, s_.N, 0, s_.N, 1) * s_.sigma;
        const Ball twice_E = (transposed(y) * scene_.K * y)(0) + (transposed(v) * mass_ * v)(0);
        return abs((s_.place() * Z_)(0) / compliance_) + root_of_positive(reach_ * twice_E) < s_.holds;
    }

    void write_rest() {
        out_.rest_at = (s_.place() * Z_)(0);
        out_.rest_from = out_.turns.empty() ? Ball(0) : out_.turns.back().tau;
        const BallMatrix at = places();
        for (slong k = 0; k < s_.N; ++k) out_.masses.push_back(at(k));
        out_.others_come_to_rest = others_come_to_rest();
    }

    [[nodiscard]] std::optional<bool> others_come_to_rest() const {
        if (s_.N == 1) return std::nullopt;
        const std::shared_ptr<PhasesByFreeMotions>& free = s_.by_free_motions(0);
        if (free && free->die_out()) return true;
        if (arb_mat_is_zero(scene_.C.a) == 0) return std::nullopt;
        const BallMatrix at = places();
        for (slong k = 0; k < s_.N; ++k)
            if (!(Z_(k) - at(k)).may_vanish() || !Z_(s_.N + k).may_vanish()) return false;
        return std::nullopt;
    }

    Ball speed_at_start_; // of the contact
    const SceneInBalls& scene_;
    ContactMechanics s_;
    BallMatrix Z_;               // the state
    Ball tau_{};                 // its instant
    BallMatrix mass_{};          // of (7)
    Ball reach_{};               // square of the largest load on the contact at rest that the others exert with E = 1/2
    BallMatrix at_unit_force_{}; // static displacements by a unit force on the contact
    Ball compliance_{};          // that of the contact
    std::optional<Ball> until_;
    bool last_;
    FreeDecayOf<Ball> out_{};
};

} // namespace

FreeDecayOf<Ball> free_decay_in_balls(const SceneInBalls& scene, const BallMatrix& x, const BallMatrix& x_prime,
                                      const std::optional<Ball>& until, bool last) {
    return Decay(scene, x, x_prime, until, last).followed();
}

} // namespace denhartog::reference

// What is the state at the end of a long phase, whose exponential would cost many squarings? The solution of (6) in one phase by
// the free motions of its matrix. The constructor separates them, `state` and `propagator` put them together.
#include "denhartog/reference/fast_phase.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/reference/orbit_equations.hpp"

namespace denhartog::reference {
namespace {

constexpr slong inputs_count = 4;

// (lambda - B)^-1 g by free motions, where lambda is i for what turns with the force, and 0 for what is constant.
std::vector<ComplexBall> divided(std::vector<ComplexBall> shares, const FreeMotions& free, bool turns) {
    for (std::size_t i = 0; i < shares.size(); ++i) {
        ComplexBall apart;
        if (turns) acb_onei(apart.a);
        acb_sub(apart.a, apart.a, free.lambda(i).a, ball_bits);
        acb_div(shares[i].a, shares[i].a, apart.a, ball_bits);
        if (acb_is_finite(shares[i].a) == 0) throw Unproved("the force may excite a resonance without damping");
    }
    return shares;
}

} // namespace

FastPhases::FastPhases(const ContactMechanics& s, int direction) : N_(s.N), lead_(s.lead), slides_(direction != 0), w_(s.w) {
    const BallMatrix A = s.phase(direction);
    for (slong k = 0; k < 2 * N_; ++k)
        if (slides_ || (k != lead_ && k != N_ + lead_)) place_.push_back(k);
    const auto K = static_cast<slong>(place_.size());
    BallMatrix B(K, K), G(K, inputs_count), row(1, s.n());
    for (slong i = 0; i < K; ++i) {
        for (slong c = 0; c < s.n(); ++c) row(0, c) = A(place_[static_cast<std::size_t>(i)], c);
        const OverCoordinates parts = taken_apart(row);
        for (slong k = 0; k < K; ++k) B(i, k) = parts.y(0, k);
        for (slong c = 0; c < inputs_count; ++c) G(i, c) = parts.u(0, c);
    }
    forced_ = BallMatrix(K, inputs_count);
    free_ = std::make_unique<FreeMotions>(B, s.effort);
    if (K == 0) return;
    if (!free_->are_simple()) throw Unproved("free motions are not told apart");
    in_time_ = free_->in_time();
    const auto shares_of_input = [&](slong c) {
        BallMatrix g(K, 1);
        for (slong i = 0; i < K; ++i) g(i) = G(i, c);
        return free_->shares_of(g);
    };
    // G_c cos + G_s sin is the real part of (G_c - i G_s) e^(i tau)
    std::vector<ComplexBall> turning = shares_of_input(0);
    const std::vector<ComplexBall> shares_of_sine = shares_of_input(1);
    for (std::size_t i = 0; i < turning.size(); ++i) {
        ComplexBall turned;
        acb_div_onei(turned.a, shares_of_sine[i].a);
        acb_add(turning[i].a, turning[i].a, turned.a, ball_bits);
    }
    turning = divided(std::move(turning), *free_, true);
    const std::vector<ComplexBall> one = divided(shares_of_input(2), *free_, false),
                                   rest = divided(shares_of_input(3), *free_, false);
    std::vector<ComplexBall> turned = turning; // Re(H e^(i tau)) = Re H cos + Re(i H) sin
    for (ComplexBall& each : turned) acb_mul_onei(each.a, each.a);
    const auto set = [&](slong column, const std::vector<ComplexBall>& shares) {
        const BallMatrix y = free_->state(shares, Ball(0));
        for (slong k = 0; k < K; ++k) forced_(k, column) = y(k);
    };
    set(0, turning);
    set(1, turned);
    set(2, one);
    set(3, rest);
}

FastPhases::OverCoordinates FastPhases::taken_apart(const BallMatrix& row) const {
    OverCoordinates parts{BallMatrix(1, static_cast<slong>(place_.size())), BallMatrix(1, inputs_count)};
    for (slong c = 0; c < 3; ++c) parts.u(0, c) = row(0, 2 * N_ + c);
    for (std::size_t i = 0; i < place_.size(); ++i) {
        const slong k = place_[i], first = k < N_ ? 0 : N_;
        Ball& part = parts.y(0, static_cast<slong>(i));
        part = row(0, k);
        if (!slides_ && !w_(k - first).is_zero()) part -= row(0, first + lead_) * w_(k - first) / w_(lead_);
    }
    if (!slides_) parts.u(0, 3) = row(0, lead_) / w_(lead_);
    return parts;
}

BallMatrix FastPhases::inputs(const BallMatrix& Z) const {
    BallMatrix u(inputs_count, 1);
    for (slong c = 0; c < 3; ++c) u(c) = Z(2 * N_ + c);
    for (slong k = 0; k < N_; ++k) u(3) += w_(k) * Z(k);
    return u;
}

std::vector<ComplexBall> FastPhases::shares_at(const BallMatrix& Z, const BallMatrix& u) const {
    BallMatrix y = forced_ * u;
    for (std::size_t i = 0; i < place_.size(); ++i) y(static_cast<slong>(i)) = Z(place_[i]) - y(static_cast<slong>(i));
    return free_->shares_of(y);
}

BallMatrix FastPhases::state(const BallMatrix& Z, const Ball& length) const {
    const BallMatrix u = inputs(Z);
    const std::vector<ComplexBall> shares = shares_at(Z, u);
    BallMatrix later = Z, then = u;
    const Ball c = cos(length), s = sin(length);
    later(2 * N_) = then(0) = u(0) * c - u(1) * s;
    later(2 * N_ + 1) = then(1) = u(0) * s + u(1) * c;
    const BallMatrix forced = forced_ * then, free = free_->state(shares, length);
    for (std::size_t i = 0; i < place_.size(); ++i) {
        const auto k = static_cast<slong>(i);
        later(place_[i]) = forced(k) + free(k);
    }
    if (slides_) return later;
    Ball x = u(3), v(0);
    for (slong k = 0; k < N_; ++k) {
        if (k == lead_ || w_(k).is_zero()) continue;
        x -= w_(k) * later(k);
        v -= w_(k) * later(N_ + k);
    }
    later(lead_) = x / w_(lead_);
    later(N_ + lead_) = v / w_(lead_);
    return later;
}

BallMatrix FastPhases::propagator(const Ball& length) const {
    const slong n = 2 * N_ + 3;
    BallMatrix E(n, n);
    for (slong c = 0; c < n; ++c) {
        BallMatrix unit(n, 1);
        unit(c) = Ball(1);
        const BallMatrix later = state(unit, length);
        for (slong k = 0; k < n; ++k) E(k, c) = later(k);
    }
    return E;
}

NumberInTime FastPhases::number(const BallMatrix& row, const BallMatrix& Z) const {
    const OverCoordinates parts = taken_apart(row);
    const BallMatrix u = inputs(Z), row_of_u = parts.y * forced_ + parts.u;
    const std::vector<Ball> weights = free_->weights(parts.y, shares_at(Z, u));
    const Ball factor_of_cosine = row_of_u(0, 0) * u(0) + row_of_u(0, 1) * u(1),
               factor_of_sine = row_of_u(0, 1) * u(0) - row_of_u(0, 0) * u(1), constant = row_of_u(0, 2) + row_of_u(0, 3) * u(3);
    return [weights, factor_of_cosine, factor_of_sine, constant, in_time = in_time_](const Ball& t) {
        const SineCosineSeries both = sine_cosine_series(Series::time(t));
        Series sum(constant);
        for (std::size_t n = 0; n < 5; ++n) sum.c[n] += factor_of_cosine * both.c.c[n] + factor_of_sine * both.s.c[n];
        return weights.empty() ? sum : sum_of(weights, (*in_time)(t), sum);
    };
}

const std::shared_ptr<FastPhases>& ContactMechanics::by_free_motions(int direction) const {
    std::optional<std::shared_ptr<FastPhases>>& kind = fast[direction + 1];
    if (kind) return *kind;
    try {
        const Bits all(bits);
        kind = std::make_shared<FastPhases>(*this, direction);
    } catch (const Unproved&) {
        kind = nullptr;
    }
    return *kind;
}

} // namespace denhartog::reference

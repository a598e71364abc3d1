// The state at the end of a phase. `ContactMechanics` makes the matrices of (6). `after_sliding` has (21) for each mode, if
// each moves by itself. `FreeMotions` solves z' = B z by simple eigenvalues, which it proves: `shares_of` splits a state
// among them, `weights` and `weighted_sum` put a number together again. `PhasesByFreeMotions` adds what force and friction
// bring.
#include "denhartog/reference/phases.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "denhartog/formulas/modal_coordinate.hpp"

namespace denhartog::reference {
namespace {

BallMatrix row_of(const BallMatrix& w, slong from, slong length) {
    BallMatrix row(1, length);
    put(row, 0, from, transposed(w));
    return row;
}

// M^-1, without noise if M is diagonal, so that what is zero stays so.
BallMatrix inverse_of(const BallMatrix& M) {
    if (arb_mat_is_diag(M.a) != 0) {
        BallMatrix inverse(M.rows(), M.rows());
        for (slong k = 0; k < M.rows(); ++k) inverse(k, k) = Ball(1) / M(k, k);
        return inverse;
    }
    return solution_of(M, unit_matrix(M.rows()), "the mass matrix may be singular");
}

// e^(lambda tau) and its derivatives over n!, real and imaginary parts.
void add_free_motion(const ComplexBall& lambda, const Ball& tau, std::vector<Series>& e) {
    ComplexBall z;
    acb_mul_arb(z.a, lambda.a, tau.a, ball_bits);
    acb_exp(z.a, z.a, ball_bits);
    Series re, im;
    for (slong n = 0; n < 5; ++n) {
        re.c[n] = z.re();
        im.c[n] = z.im();
        acb_mul(z.a, z.a, lambda.a, ball_bits);
        acb_div_si(z.a, z.a, n + 1, ball_bits);
    }
    e.push_back(std::move(re));
    e.push_back(std::move(im));
}

constexpr slong inputs_count = 4;

} // namespace

ContactMechanics::ContactMechanics(const SceneInBalls& scene)
    : N(scene.N()), w(scene.w), free(n(), n()), load(1, n()), stuck(n(), n()), push(N, 1), beta(scene.beta.value()),
      holds(scene.mu * beta), equal(scene.mu == Ball(1)), on_a_wall(scene.is_the_contact(static_cast<slong>(scene.contact))),
      lead(0), effort(scene.effort) {
    const BallMatrix inverse = inverse_of(scene.M * (scene.r * scene.r));
    const BallMatrix stiffness = inverse * scene.K, damping = inverse * (scene.C * scene.r), force = inverse * scene.p;
    const BallMatrix ahead = scene.p_i.rows() > 0 ? inverse * scene.p_i : BallMatrix();
    sigma = Ball(std::sqrt(std::max(norm(stiffness), 1e-280)));
    push = inverse * w * (Ball(1) / sigma);
    for (slong i = 0; i < N; ++i) {
        free(i, N + i) = sigma;
        if (abs(w(i)) > abs(w(lead))) lead = i;
    }
    put(free, N, 0, -(stiffness / sigma));
    put(free, N, N, -damping);
    put(free, N, 2 * N, force / sigma);
    put(free, N, 2 * N + 1, -(ahead / sigma));
    free(2 * N, 2 * N + 1) = Ball(-1);
    free(2 * N + 1, 2 * N) = Ball(1);
    find_sliding(scene);
    load = speed() * free * (Ball(1) / (transposed(w) * push)(0));
    stuck = free;
    for (slong i = 0; i < N; ++i)
        for (slong c = 0; c < n(); ++c)
            if (on_a_wall && i == lead)
                stuck(N + i, c) = Ball(0);
            else if (!push(i).is_zero())
                stuck(N + i, c) -= push(i) * load(0, c);
}

BallMatrix ContactMechanics::phase(int direction) const {
    if (direction == 0) return stuck;
    BallMatrix A = free;
    put(A, N, 2 * N + 2, push * (Ball(-direction) * beta));
    return A;
}

BallMatrix ContactMechanics::place() const { return row_of(w, 0, n()); }

BallMatrix ContactMechanics::speed() const { return row_of(w, N, n()); }

BallMatrix ContactMechanics::ending(int before, int after) const {
    if (before != 0) return speed();
    BallMatrix row = load;
    row(0, n() - 1) -= Ball(after) * holds;
    return row;
}

void ContactMechanics::find_sliding(const SceneInBalls& s) {
    if (s.zeta.empty() || !std::ranges::all_of(s.zeta, [](const Ball& zeta) { return zeta < Ball(1); })) return;
    ModesInBalls m = modes_in_balls(s);
    if (!m.clusters.empty()) return;
    for (std::size_t i = 0; i < m.R.size(); ++i)
        if (!paper::complex_response(m.R[i], m.zeta[i]).re.finite()) return; // a pole
    shapes = shapes_of(m);
    from_state = transposed(shapes) * s.M * (s.r * s.r);
    sliding = std::move(m);
}

BallMatrix ContactMechanics::after_sliding(const BallMatrix& Z, const Ball& length, int direction) const {
    const slong columns = Z.columns();
    const ModesInBalls& m = *sliding;
    pay(effort, cost_of_ball_products(static_cast<double>(4 * N * (N + 5) * columns)));
    const Ball cosine = cos(length), sine = sin(length);
    BallMatrix x = from_state * part_of(Z, 0, 0, N, columns), v = from_state * part_of(Z, N, 0, N, columns) * sigma, later = Z;
    for (slong c = 0; c < columns; ++c) {
        later(2 * N, c) = Z(2 * N, c) * cosine - Z(2 * N + 1, c) * sine;
        later(2 * N + 1, c) = Z(2 * N, c) * sine + Z(2 * N + 1, c) * cosine;
    }
    for (slong i = 0; i < N; ++i) {
        const Ball R = m.R[i], zeta = m.zeta[i], square = R * R;
        const Complex<Ball> load{m.at_load()[i], m.at_load_i() != nullptr ? (*m.at_load_i())[i] : Ball(0)},
            forced = square * (paper::complex_response(R, zeta) * load); // (23)
        const Ball held = Ball(-direction) * beta * m.at_contact()[i] * square;
        const Ball d = paper::d(length, R, zeta), q = R * paper::q(length, R, zeta), // (A.8), (A.9)
            d_prime = paper::d_prime(length, R, zeta), q_prime = R * paper::q_prime(length, R, zeta);
        for (slong c = 0; c < columns; ++c) { // (21): what is not forced moves freely
            const Complex<Ball> before = forced * Complex<Ball>{Z(2 * N, c), Z(2 * N + 1, c)},
                                then = forced * Complex<Ball>{later(2 * N, c), later(2 * N + 1, c)};
            const Ball rest = held * Z(2 * N + 2, c), from = x(i, c) - before.re - rest, rate = v(i, c) + before.im;
            x(i, c) = then.re + rest + d * from + q * rate;
            v(i, c) = d_prime * from - then.im + q_prime * rate;
        }
    }
    put(later, 0, 0, shapes * x);
    put(later, N, 0, shapes * v * (1 / sigma));
    return later;
}

BallMatrix ContactMechanics::propagator(int direction, const Ball& h) const {
    if (sliding && direction != 0) return after_sliding(unit_matrix(n()), h, direction);
    pay(effort, cost_of_ball_products(20 * static_cast<double>(n() * n() * n())));
    return exp(rounded(phase(direction)) * h);
}

FreeMotions::FreeMotions(const BallMatrix& B, Effort* effort) : effort_(effort) {
    const slong n = B.rows();
    pay(effort, cost_of_ball_products(40 * static_cast<double>(n * n * n)));
    ComplexMatrix C(B), L(n, n), R(n, n), guess(n, n), near(1, n), values(1, n);
    acb_mat_approx_eig_qr(near.all(), nullptr, guess.a, C.a, nullptr, 0, ball_bits);
    simple_ = acb_mat_eig_simple(values.all(), L.a, R.a, C.a, near.all(), guess.a, ball_bits) != 0;
    for (slong i = 0; i < n && simple_; ++i) {
        acb_set(lambda_.emplace_back().a, values.all() + i);
        for (slong k = 0; k < n; ++k) {
            acb_set(L_.emplace_back().a, acb_mat_entry(L.a, i, k));
            acb_set(R_.emplace_back().a, acb_mat_entry(R.a, i, k));
        }
    }
}

std::vector<ComplexBall> FreeMotions::shares_of(const BallMatrix& z) const {
    const std::size_t n = lambda_.size();
    std::vector<ComplexBall> shares(n);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < n; ++k) acb_addmul_arb(shares[i].a, L_[n * i + k].a, z(static_cast<slong>(k)).a, ball_bits);
    return shares;
}

std::vector<Ball> FreeMotions::weights(const BallMatrix& row, const std::vector<ComplexBall>& shares) const {
    const std::size_t n = lambda_.size();
    std::vector<Ball> all;
    for (std::size_t i = 0; i < n; ++i) {
        ComplexBall sum;
        for (std::size_t k = 0; k < n; ++k) {
            const Ball& part = row(0, static_cast<slong>(k));
            if (!part.is_zero()) acb_addmul_arb(sum.a, R_[n * k + i].a, part.a, ball_bits);
        }
        acb_mul(sum.a, sum.a, shares[i].a, ball_bits);
        all.push_back(sum.re()); // Re(a e) = Re a Re e - Im a Im e
        all.push_back(-sum.im());
    }
    return all;
}

BallMatrix FreeMotions::state(std::vector<ComplexBall> shares, const Ball& t) const {
    const std::size_t n = lambda_.size();
    BallMatrix z(static_cast<slong>(n), 1);
    for (std::size_t i = 0; i < n; ++i) {
        ComplexBall then;
        acb_mul_arb(then.a, lambda_[i].a, t.a, ball_bits);
        acb_exp(then.a, then.a, ball_bits);
        acb_mul(shares[i].a, shares[i].a, then.a, ball_bits);
    }
    for (std::size_t k = 0; k < n; ++k) {
        ComplexBall sum;
        for (std::size_t i = 0; i < n; ++i) acb_addmul(sum.a, R_[n * k + i].a, shares[i].a, ball_bits);
        z(static_cast<slong>(k)) = sum.re();
    }
    return z;
}

std::shared_ptr<Remembered<std::vector<Series>>> FreeMotions::in_time() const {
    using All = std::vector<Series>;
    return std::make_shared<Remembered<All>>([lambda = lambda_, effort = effort_](const Ball& tau) {
        pay(effort, cost_of_evaluations(lambda.size()));
        All e;
        for (const ComplexBall& each : lambda) add_free_motion(each, tau, e);
        return e;
    });
}

PhasesByFreeMotions::PhasesByFreeMotions(const ContactMechanics& s, int direction)
    : N_(s.N), lead_(s.lead), slides_(direction != 0), w_(s.w) {
    const BallMatrix A = s.phase(direction);
    for (slong k = 0; k < 2 * N_; ++k)
        if (slides_ || (k != lead_ && k != N_ + lead_)) place_.push_back(k);
    const auto K = static_cast<slong>(place_.size());
    BallMatrix B(K, K), G(K, inputs_count);
    for (slong i = 0; i < K; ++i) {
        const OverCoordinates parts = taken_apart(part_of(A, place_[i], 0, 1, s.n()));
        put(B, i, 0, parts.y);
        put(G, i, 0, parts.u);
    }
    forced_ = BallMatrix(K, inputs_count);
    free_ = std::make_unique<FreeMotions>(B, s.effort);
    if (K == 0) return;
    if (!free_->are_simple()) throw Unproved("free motions are not told apart");
    in_time_ = free_->in_time();
    // y = C cos + S sin obeys y' = B y + G_c cos + G_s sin if B C - S = -G_c and B S + C = -G_s.
    BallMatrix both(2 * K, 2 * K), force(2 * K, 1);
    put(both, 0, 0, B);
    put(both, K, K, B);
    put(both, K, 0, unit_matrix(K));
    put(both, 0, K, -unit_matrix(K));
    put(force, 0, 0, -part_of(G, 0, 0, K, 1));
    put(force, K, 0, -part_of(G, 0, 1, K, 1));
    constexpr const char* resonates = "the force may excite a resonance without damping";
    const BallMatrix turning = solution_of(both, force, resonates);
    put(forced_, 0, 0, part_of(turning, 0, 0, K, 1));
    put(forced_, 0, 1, part_of(turning, K, 0, K, 1));
    put(forced_, 0, 2, solution_of(B, -part_of(G, 0, 2, K, 2), resonates));
}

PhasesByFreeMotions::OverCoordinates PhasesByFreeMotions::taken_apart(const BallMatrix& row) const {
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

BallMatrix PhasesByFreeMotions::inputs(const BallMatrix& Z) const {
    BallMatrix u(inputs_count, 1);
    for (slong c = 0; c < 3; ++c) u(c) = Z(2 * N_ + c);
    for (slong k = 0; k < N_; ++k) u(3) += w_(k) * Z(k);
    return u;
}

std::vector<ComplexBall> PhasesByFreeMotions::shares_at(const BallMatrix& Z, const BallMatrix& u) const {
    BallMatrix y = forced_ * u;
    for (std::size_t i = 0; i < place_.size(); ++i) y(static_cast<slong>(i)) = Z(place_[i]) - y(static_cast<slong>(i));
    return free_->shares_of(y);
}

BallMatrix PhasesByFreeMotions::state(const BallMatrix& Z, const Ball& length) const {
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

BallMatrix PhasesByFreeMotions::propagator(const Ball& length) const {
    const slong n = 2 * N_ + 3;
    BallMatrix E(n, n);
    for (slong c = 0; c < n; ++c) {
        BallMatrix unit(n, 1);
        unit(c) = Ball(1);
        put(E, 0, c, state(unit, length));
    }
    return E;
}

NumberInTime PhasesByFreeMotions::number(const BallMatrix& row, const BallMatrix& Z) const {
    const OverCoordinates parts = taken_apart(row);
    const BallMatrix u = inputs(Z), row_of_u = parts.y * forced_ + parts.u;
    const std::vector<Ball> weights = free_->weights(parts.y, shares_at(Z, u));
    const Ball factor_of_cosine = row_of_u(0, 0) * u(0) + row_of_u(0, 1) * u(1),
               factor_of_sine = row_of_u(0, 1) * u(0) - row_of_u(0, 0) * u(1), constant = row_of_u(0, 2) + row_of_u(0, 3) * u(3);
    return [weights, factor_of_cosine, factor_of_sine, constant, in_time = in_time_](const Ball& t) {
        const SineCosine<Series> both = sine_cosine(Series::time(t));
        Series sum(constant);
        for (std::size_t n = 0; n < 5; ++n) sum.c[n] += factor_of_cosine * both.c.c[n] + factor_of_sine * both.s.c[n];
        return weights.empty() ? sum : weighted_sum(weights, (*in_time)(t), sum);
    };
}

bool PhasesByFreeMotions::die_out() const {
    std::size_t damped = 0;
    while (damped < place_.size() && free_->lambda(damped).re() < Ball(0)) ++damped;
    return damped == place_.size();
}

const std::shared_ptr<PhasesByFreeMotions>& ContactMechanics::by_free_motions(int direction) const {
    std::optional<std::shared_ptr<PhasesByFreeMotions>>& kind = free_motions[direction + 1];
    if (kind) return *kind;
    const Bits all(bits);
    kind = if_proved([&] { return std::make_shared<PhasesByFreeMotions>(*this, direction); }).value_or(nullptr);
    return *kind;
}

} // namespace denhartog::reference

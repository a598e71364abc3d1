// What do load and friction add if damping couples the modes? The motion with the symmetry (25) of z' = A z + b, the state form
// of (6), over a half-period. Read `responses_of_state` first; `add_free_motions` and `add_states` are two ways to the free
// part.
#include <algorithm>
#include <cmath>
#include <memory>

#include "denhartog/number/effort.hpp"
#include "denhartog/reference/free_motions.hpp"
#include "denhartog/reference/friction.hpp"
#include "denhartog/reference/orbit_equations.hpp"

namespace denhartog::reference {
namespace {

// z' = A z + b between two turns of the contact, z = (x, x'); b is the acceleration by a unit force on the contact.
struct StateMatrix {
    BallMatrix A{}, rest{}; // rest: the static displacements by that force, with velocities zero
};

StateMatrix state_matrix(const SceneInBalls& s) {
    const slong N = s.N();
    StateMatrix m{BallMatrix(2 * N, 2 * N), BallMatrix(2 * N, 1)};
    const BallMatrix mass = s.M * (s.r * s.r); // (7)
    BallMatrix of_stiffness, of_damping, at_rest;
    if (!solved(mass, s.K, of_stiffness) || !solved(mass, s.C * s.r, of_damping))
        throw Unproved("the mass matrix is not proved regular");
    if (!solved(s.K, s.w, at_rest)) throw Unproved("the stiffness matrix is not proved regular");
    for (slong i = 0; i < N; ++i) {
        m.A(i, N + i) = Ball(1);
        m.rest(i) = at_rest(i);
        for (slong k = 0; k < N; ++k) {
            m.A(N + i, k) = -of_stiffness(i, k);
            m.A(N + i, N + k) = -of_damping(i, k);
        }
    }
    return m;
}

// The complex amplitudes of the masses under a harmonic force.
std::vector<Complex<Ball>> harmonic_response(const SceneInBalls& s, const BallMatrix& force, const BallMatrix& imaginary) {
    const slong N = s.N();
    BallMatrix b(2 * N, 1), X;
    for (slong i = 0; i < N; ++i) b(i) = force(i);
    for (slong i = 0; i < imaginary.rows(); ++i) b(N + i) = imaginary(i);
    if (!solved(dynamic_stiffness(s, N), b, X)) throw Unproved("the load may excite a resonance without damping");
    std::vector<Complex<Ball>> out;
    for (slong i = 0; i < N; ++i) out.push_back({X(i), X(N + i)});
    return out;
}

Complex<Ball> at_contact(const SceneInBalls& s, const std::vector<Complex<Ball>>& X) {
    Complex<Ball> sum{};
    for (slong k = 0; k < s.N(); ++k)
        if (!s.w(k).is_zero()) sum = sum + s.w(k) * X[static_cast<std::size_t>(k)];
    return sum;
}

// Number of times that A tau is halved until it is small.
double halvings_of(const BallMatrix& A, const Ball& tau) { return binary_logarithm(std::max(1.0, norm(A) * tau.high())); }

// e^(A tau): a series for a small part of A, squared as often as that was halved. Each squaring takes a bit of what is right.
BallMatrix state_after(const BallMatrix& A, const Ball& tau, Effort* effort) {
    const double halvings = halvings_of(A, tau);
    if (!(halvings < static_cast<double>(ball_bits))) throw Unproved("a mode is too fast for the state to be followed");
    const double products = halvings + std::sqrt(static_cast<double>(ball_bits)), n = static_cast<double>(A.rows());
    pay(effort, cost_of_ball_products(n * n * n * products));
    return exp(A * tau);
}

// e^(A tau) z, where z is the state `begin` at tau = 0, 2 N x 1: by Taylor's series about the middle of a stretch.
class StateInTime {
public:
    StateInTime(const BallMatrix& A, const BallMatrix& begin, Effort* effort)
        : A_(A), begin_(begin), size_(norm(A)), effort_(effort) {}

    std::vector<Series> operator()(const Ball& tau) const {
        const slong n = A_.rows();
        const Ball center = middle(tau), off = tau - center;
        const Ball reach = upper_bound_of(size_ * radius_of(off));
        if (!(reach < Ball(600))) throw Unproved("a mode is too fast for the state to be followed");
        BallMatrix term = state_after(A_, center, effort_) * begin_, sum = term;
        Ball left(norm(term)); // (reach^k / k!) |z|, a bound of the last term taken
        const Ball enough = left * power_of_two(-ball_bits);
        for (slong k = 1; !off.is_zero() && !(left < enough) && k < 10 * ball_bits; ++k) {
            term = A_ * term * (off / k);
            sum = sum + term;
            left *= reach / k;
        }
        const BallMatrix first = A_ * sum, second = A_ * first, third = A_ * second, fourth = A_ * third;
        std::vector<Series> z(static_cast<std::size_t>(n));
        // the terms after the last are at most the last times the sum of reach^n / n!
        const Ball open = off.is_zero() ? Ball(0) : left * exp(reach);
        for (slong i = 0; i < n; ++i) {
            Series& at = z[static_cast<std::size_t>(i)];
            at.c[0] = widened(sum(i), open);
            at.c[1] = widened(first(i), open * size_);
            at.c[2] = widened(second(i), open * size_ * size_) / 2;
            at.c[3] = widened(third(i), open * size_ * size_ * size_) / 6;
            at.c[4] = widened(fourth(i), open * size_ * size_ * size_ * size_) / 24;
        }
        return z;
    }

private:
    BallMatrix A_, begin_;
    Ball size_;
    Effort* effort_;
};

// Factors of e^(lambda_i tau) in F of each row: -2 (row of R_i) (L_i rest) / (1 + e^(lambda_i pi)).
void add_free_motions(const SceneInBalls& s, const FreeMotions& free, const BallMatrix& rest, FrictionInTime& f) {
    const slong N = s.N();
    std::vector<ComplexBall> shares = free.shares_of(rest);
    for (std::size_t i = 0; i < shares.size(); ++i) {
        ComplexBall once;
        acb_mul_arb(once.a, free.lambda(i).a, pi<Ball>().a, ball_bits);
        acb_exp(once.a, once.a, ball_bits);
        acb_add_si(once.a, once.a, 1, ball_bits);
        acb_div(shares[i].a, shares[i].a, once.a, ball_bits);
        acb_mul_si(shares[i].a, shares[i].a, -2, ball_bits);
    }
    for (slong k = 0; k <= N; ++k) { // the last is the contact
        BallMatrix row(1, 2 * N);
        for (slong i = 0; i < N; ++i) row(0, i) = k < N ? Ball(i == k ? 1 : 0) : s.w(i);
        f.constant.push_back((row * rest)(0));
        f.weight.push_back(free.weights(row, shares));
    }
    f.shared = free.in_time();
}

// Adds the states by the exponential of the matrix, if eigenvalues may coincide.
void add_states(const SceneInBalls& s, const StateMatrix& m, FrictionInTime& f) {
    const slong N = s.N();
    // With more bits the eigenvalues of so fast a system may prove distinct, which costs less.
    if (!(4 * halvings_of(m.A, pi<Ball>()) < static_cast<double>(ball_bits)))
        throw Unproved("a mode is too fast for the state to be followed");
    BallMatrix begin;
    const BallMatrix once = unit_matrix(2 * N) + state_after(m.A, pi<Ball>(), s.effort);
    if (!solved(once, m.rest, begin)) throw Unproved("a free motion may mirror itself after half a period");
    begin = begin * Ball(-2);
    f.constant.assign(static_cast<std::size_t>(N) + 1, Ball(0));
    f.weight.assign(static_cast<std::size_t>(N) + 1, std::vector<Ball>(static_cast<std::size_t>(2 * N)));
    for (slong k = 0; k < N; ++k) {
        const auto row = static_cast<std::size_t>(k);
        f.constant[row] = m.rest(k);
        f.constant.back() += s.w(k) * m.rest(k);
        f.weight[row][row] = Ball(1);
        f.weight.back()[row] = s.w(k);
    }
    const StateInTime z(m.A, begin, s.effort);
    f.shared =
        std::make_shared<Remembered<std::vector<Series>>>(z, [z](const std::vector<Series>&, const Ball& tau) { return z(tau); });
}

} // namespace

ResponsesInBalls responses_of_state(const SceneInBalls& s) {
    const StateMatrix m = state_matrix(s);
    ResponsesInBalls r;
    r.friction.effort = s.effort;
    r.V = harmonic_response(s, s.p, s.p_i);
    r.V.push_back(at_contact(s, r.V));
    r.Y = at_contact(s, harmonic_response(s, s.w, BallMatrix()));
    const FreeMotions free(m.A, s.effort);
    if (free.are_simple())
        add_free_motions(s, free, m.rest, r.friction);
    else
        add_states(s, m, r.friction);
    const std::vector<Series>& e = (*r.friction.shared)(Ball(0));
    for (std::size_t row = 0; row < r.V.size(); ++row) {
        const Series start = r.friction.of(row, e);
        r.G.push_back(-start.rate(0));
        r.U.push_back(-start.rate(1));
        if (!(start.rate(0).finite() && start.rate(1).finite()))
            throw Unproved("a free motion may mirror itself after half a period");
    }
    r.squares = acceleration_of_contact(s);
    r.H = r.friction.of(r.contact(), e).rate(2) - r.squares;
    return r;
}

ResponsesInBalls responses_of_one_mass(const Ball& R, const Ball& zeta, Effort* effort) {
    SceneInBalls one{unit_matrix(1), unit_matrix(1), unit_matrix(1) * (2 * zeta)};
    one.w = one.p = unit_matrix(1);
    one.r = R;
    one.effort = effort;
    return responses_of_state(one);
}

} // namespace denhartog::reference

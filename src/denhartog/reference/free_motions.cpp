// The solution of z' = B z by simple eigenvalues: `FreeMotions` proves them, `shares_of` splits a state among them, and
// `weights` and `sum_of` put a number together again.
#include "denhartog/reference/free_motions.hpp"

#include "denhartog/number/effort.hpp"
#include "denhartog/reference/orbit_equations.hpp"

namespace denhartog::reference {
namespace {

// e^(lambda tau) and its derivatives over n!, real and imaginary parts.
void add_free_motion(const ComplexBall& lambda, const Ball& tau, std::vector<Series>& e) {
    ComplexBall z;
    acb_mul_arb(z.a, lambda.a, tau.a, ball_bits);
    acb_exp(z.a, z.a, ball_bits);
    Series re, im;
    for (slong n = 0; n < 5; ++n) {
        re.c[static_cast<std::size_t>(n)] = z.re();
        im.c[static_cast<std::size_t>(n)] = z.im();
        acb_mul(z.a, z.a, lambda.a, ball_bits);
        acb_div_si(z.a, z.a, n + 1, ball_bits);
    }
    e.push_back(std::move(re));
    e.push_back(std::move(im));
}

// Adds a free motion over a stretch, from its series in the middle.
void add_over_stretch(const ComplexBall& lambda, const Series& re, const Series& im, const Ball& tau, std::vector<Series>& e) {
    const Ball speed = root_of_positive(lambda.re() * lambda.re() + lambda.im() * lambda.im()), off = tau - middle(tau);
    const Ball size = upper_bound_of(exp(larger(lambda.re() * Ball(tau.low()), lambda.re() * Ball(tau.high()))));
    for (const Series* part : {&re, &im}) e.push_back(over_stretch(*part, off, Ball(0), size, speed));
}

} // namespace

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
    return std::make_shared<Remembered<All>>(
        [lambda = lambda_, effort = effort_](const Ball& tau) {
            pay(effort, cost_of_evaluations(lambda.size()));
            All e;
            for (const ComplexBall& each : lambda) add_free_motion(each, tau, e);
            return e;
        },
        [lambda = lambda_](const All& in_the_middle, const Ball& tau) {
            All e;
            for (std::size_t i = 0; i < lambda.size(); ++i)
                add_over_stretch(lambda[i], in_the_middle[2 * i], in_the_middle[2 * i + 1], tau, e);
            return e;
        });
}

Series sum_of(const std::vector<Ball>& weights, const std::vector<Series>& e, Series sum) {
    for (std::size_t i = 0; i < e.size(); ++i)
        for (std::size_t n = 0; n < 5; ++n) arb_addmul(sum.c[n].a, weights[i].a, e[i].c[n].a, ball_bits);
    return sum;
}

} // namespace denhartog::reference

// The shares of load and friction in the motion. If each mode moves by itself V, U, G and H by (23), (28), (29), (33) to (35) and
// (64): read `responses_of_modes`; `FrictionMotionOfMode` is the brace of (40) and (41) as a function of time. If damping couples
// the modes, the motion with the symmetry (25) of z' = A z + b, the state form of (6), over a half-period: `responses_of_state`.
#include "denhartog/reference/friction.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "denhartog/formulas/modal_coordinate.hpp"
#include "denhartog/formulas/superposition.hpp"
#include "denhartog/reference/phases.hpp"

namespace denhartog::reference {
namespace {

// The parts of F - 1 that die out, for a mode that is damped critically or beyond.
std::vector<MotionThatDiesOut> parts_that_die_out(const Ball& R, const Ball& zeta) {
    const auto mirrored = [](const Ball& rate) { return 1 + exp(rate * pi<Ball>()); };
    if ((zeta - 1).is_zero()) {
        const Ball rate = -1 / R, once = mirrored(rate);
        return {{rate, -2 * (1 + rate * pi<Ball>() * (once - 1) / once) / once, 2 * rate / once}};
    }
    if (!(zeta > Ball(1))) throw Unproved("a mode may be damped critically");
    const Ball sum = zeta + sqrt((zeta - 1) * (zeta + 1)), fast = -sum / R, slow = -1 / (R * sum), both = 2 / (fast - slow);
    return {{fast, both * slow / mirrored(fast), Ball(0)}, {slow, -both * fast / mirrored(slow), Ball(0)}};
}

// (41): each mode moves by itself.
FrictionInTime friction_of_modes(const ModesInBalls& m, const std::vector<FrictionMotionOfMode>& motions) {
    FrictionInTime f;
    for (std::size_t row = 0; row <= static_cast<std::size_t>(m.N); ++row) {
        f.constant.emplace_back(0);
        std::vector<Ball>& weight = f.weight.emplace_back();
        for (std::size_t i = 0; i < m.R.size(); ++i) weight.push_back(m.psi[row][i] * m.at_contact()[i] * m.R[i] * m.R[i]);
        f.open.emplace_back(0);
        for (const ModeCluster& c : m.clusters) { // its modes move as one, but for what is left open
            for (std::size_t i = c.first + 1; i < c.last; ++i) weight[c.first] += std::exchange(weight[i], Ball(0));
            f.open[row] += m.lengths_in(c, m.psi[row], m.at_contact()) * motions[c.first].apart();
            f.fastest = larger(f.fastest, motions[c.first].changes());
        }
    }
    f.modes = motions;
    f.effort = m.effort;
    using AllModes = std::vector<Series>;
    f.shared = std::make_shared<Remembered<AllModes>>([motions, effort = m.effort](const Ball& tau) {
        pay(effort, cost_of_evaluations(motions.size()));
        AllModes e;
        for (const FrictionMotionOfMode& F : motions) e.push_back(F.at(tau));
        return e;
    });
    return f;
}

// (65): the sum of (w^T psi_i)^2 over the modes is w^T M^-1 w / r^2.
Ball acceleration_of_contact(const SceneInBalls& s) {
    return (transposed(s.w) * solution_of(s.M, s.w, mass_is_open))(0) / (s.r * s.r);
}

// z' = A z + b between two turns of the contact, z = (x, x'); b is the acceleration by a unit force on the contact.
struct StateMatrix {
    BallMatrix A{}, rest{}; // rest: the static displacements by that force, with velocities zero
};

StateMatrix state_matrix(const SceneInBalls& s) {
    const slong N = s.N();
    StateMatrix m{BallMatrix(2 * N, 2 * N), BallMatrix(2 * N, 1)};
    const BallMatrix mass = s.M * (s.r * s.r); // (7)
    put(m.A, 0, N, unit_matrix(N));
    put(m.A, N, 0, -solution_of(mass, s.K, mass_is_open));
    put(m.A, N, N, -solution_of(mass, s.C * s.r, mass_is_open));
    put(m.rest, 0, 0, solution_of(s.K, s.w, stiffness_is_open));
    return m;
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

// e^(A tau) begin at an instant or over a stretch: by Taylor's series about its middle, z and its derivatives over n!.
std::vector<Series> states_in_time(const BallMatrix& A, const BallMatrix& begin, const Ball& tau, Effort* effort) {
    const Ball center = middle(tau), off = tau - center, size(norm(A)), reach = upper_bound_of(size * radius_of(off));
    if (!(reach < Ball(600))) throw Unproved("a mode is too fast for the state to be followed");
    BallMatrix term = state_after(A, center, effort) * begin, sum = term;
    Ball left(norm(term)); // (reach^k / k!) |z|, a bound of the last term taken
    const Ball enough = left * power_of_two(-ball_bits);
    for (slong k = 1; !off.is_zero() && !(left < enough) && k < 10 * ball_bits; ++k) {
        term = A * term * (off / k);
        sum = sum + term;
        left *= reach / k;
    }
    std::vector<Series> z(A.rows());
    // the terms after the last are at most the last times the sum of reach^n / n!
    Ball open = off.is_zero() ? Ball(0) : left * exp(reach);
    slong factorial = 1;
    for (std::size_t n = 0; n < 5; ++n, sum = A * sum, open = open * size, factorial *= static_cast<slong>(n))
        for (slong i = 0; i < A.rows(); ++i) z[i].c[n] = widened(sum(i), open) / factorial;
    return z;
}

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
    const BallMatrix once = unit_matrix(2 * N) + state_after(m.A, pi<Ball>(), s.effort);
    const BallMatrix begin = solution_of(once, m.rest, "a free motion may mirror itself after half a period") * Ball(-2);
    f.constant.assign(static_cast<std::size_t>(N) + 1, Ball(0));
    f.weight.assign(static_cast<std::size_t>(N) + 1, std::vector<Ball>(2 * N));
    for (slong k = 0; k < N; ++k) {
        f.constant[k] = m.rest(k);
        f.constant.back() += s.w(k) * m.rest(k);
        f.weight[k][k] = Ball(1);
        f.weight.back()[k] = s.w(k);
    }
    const auto z = [A = m.A, begin, effort = s.effort](const Ball& tau) { return states_in_time(A, begin, tau, effort); };
    f.shared = std::make_shared<Remembered<std::vector<Series>>>(z);
}

} // namespace

std::vector<Complex<Ball>> harmonic_response(const SceneInBalls& s, const BallMatrix& force, const BallMatrix& imaginary) {
    const slong N = s.N();
    BallMatrix b(2 * N, 1);
    put(b, 0, 0, force);
    put(b, N, 0, imaginary);
    const BallMatrix X = solution_of(dynamic_stiffness(s, N), b, "the load may excite a resonance without damping");
    std::vector<Complex<Ball>> out;
    for (slong i = 0; i < N; ++i) out.push_back({X(i), X(N + i)});
    Complex<Ball>& contact = out.emplace_back();
    for (slong k = 0; k < N; ++k)
        if (!s.w(k).is_zero()) contact = contact + s.w(k) * out[k];
    return out;
}

void FrictionInTime::widen(std::span<Ball> c, Ball off) const {
    for (std::size_t n = 0; n < c.size() && !off.is_zero(); ++n) {
        c[n] = widened(c[n], upper_bound_of(off));
        off = off * fastest / static_cast<int>(n + 1);
    }
}

Series FrictionInTime::of(std::size_t row, const std::vector<Series>& e) const {
    Series F = weighted_sum(weight[row], e, Series(constant[row]));
    if (!open.empty()) widen(F.c, open[row]);
    return F;
}

Series FrictionInTime::at(std::size_t row, const Ball& tau) const {
    const Ball m = middle(tau), off = tau - m;
    if (off.is_zero() || cancels.empty() || !cancels[row]) return of(row, (*shared)(tau));
    constexpr std::size_t most_terms = 48;
    const std::vector<Ball>& weights = weight[row];
    const std::vector<Series>& in_the_middle = (*shared)(m);
    std::vector<Ball> left; // what each mode may bring to the first coefficient that is left out
    for (std::size_t i = 0; i < modes.size(); ++i) left.push_back(abs(weights[i]) * modes[i].most_of(tau));
    const auto all = [&] { return std::accumulate(left.begin(), left.end(), Ball(0)); };
    const Ball shown = all() * power_of_two(-ball_bits);
    Ball rest, power(1);
    std::size_t terms = 0;
    while (terms < in_the_middle[0].c.size() || (terms < most_terms && !(rest * power < shown))) {
        ++terms;
        power *= abs(off);
        for (std::size_t i = 0; i < modes.size(); ++i) left[i] = left[i] * modes[i].speed / static_cast<int>(terms);
        rest = all();
    }
    pay(effort, static_cast<long>(terms * modes.size()) * (1 + ball_bits / 256));
    std::vector<Ball> sums(terms), c;
    sums[0] = constant[row];
    for (std::size_t i = 0; i < modes.size(); ++i) {
        c.assign(in_the_middle[i].c.begin(), in_the_middle[i].c.end());
        modes[i].go_on(c, terms);
        for (std::size_t n = 0; n < terms; ++n) sums[n] += weights[i] * c[n];
    }
    sums.push_back(widened(Ball(0), rest));
    widen(sums, open[row]);
    Series series;
    for (std::size_t k = 0; k < series.c.size(); ++k) { // the sum of binom(n, k) times coefficient n times off^(n - k)
        Ball binomial(1);
        for (std::size_t n = k + 1; n <= terms; ++n) binomial = binomial * static_cast<int>(n) / static_cast<int>(n - k);
        for (std::size_t n = terms; n > k; --n) {
            series.c[k] = (series.c[k] + binomial * sums[n]) * off;
            binomial = binomial * static_cast<int>(n - k) / static_cast<int>(n);
        }
        series.c[k] += sums[k];
    }
    return series;
}

Series FrictionInTime::rate_and_third(std::size_t row, const std::vector<Series>& e) const {
    std::vector<Series> each;
    for (std::size_t i = 0; i < e.size(); ++i) each.push_back(modes[i].rate_and_third(e[i]));
    Series Z = weighted_sum(weight[row], each, Series());
    widen(Z.c, open[row] * (fastest + fastest * fastest * fastest));
    return Z;
}

Series FrictionMotionOfMode::rate_and_third(const Series& F) const {
    Series sum; // as F''' = -(2 zeta / R F'' + F' / R^2)
    for (int n = 0; n < 3; ++n) sum.c[n] = (1 - stiffness) * ((n + 1) * F.c[n + 1]) - damping * ((n + 1) * (n + 2) * F.c[n + 2]);
    return sum;
}

void FrictionMotionOfMode::go_on(std::vector<Ball>& c, std::size_t terms) const {
    for (std::size_t n = c.size(); n < terms; ++n) { // F^(n) = -(2 zeta / R F^(n - 1) + F^(n - 2) / R^2)
        const int order = static_cast<int>(n);
        c.push_back(-(damping * c[n - 1] + stiffness * c[n - 2] / (order - 1)) / order);
    }
}

FrictionMotionOfMode::FrictionMotionOfMode(const Ball& R_i, const Ball& zeta_i)
    : R(R_i), zeta(zeta_i), speed(1 / R), stiffness(speed * speed), damping(2 * zeta * speed) {
    if (!(zeta < Ball(1))) {
        parts = parts_that_die_out(R, zeta);
        const Series start = at(Ball(0));
        u = -start.rate(1);
        g = -start.rate(0);
        for (const MotionThatDiesOut& p : parts) largest += abs(p.factor) + 5 * abs(p.slope);
        return;
    }
    u = paper::first_damping_function(R, zeta);  // (28)
    g = paper::second_damping_function(R, zeta); // (29)
    const Ball factor_of_sine = ((1 + g) * zeta + u * R) / sqrt(1 - zeta * zeta);
    largest = root_of_positive((1 + g) * (1 + g) + factor_of_sine * factor_of_sine);
}

Ball FrictionMotionOfMode::apart() const {
    const Ball square = R * R,
               off = 2 * radius_of(damping) * square * largest * changes() + 2 * radius_of(stiffness) * square * (1 + largest);
    return (1 + R) * (2 * radius_of(square * u) + 2 * radius_of(square * g) * speed + 4 * off);
}

Series FrictionMotionOfMode::at(const Ball& tau) const {
    if (!parts.empty()) {
        const Series time = Series::time(tau);
        Series F(1);
        for (const MotionThatDiesOut& p : parts) F = F + (Series(p.factor) + p.slope * time) * exp(p.rate * time);
        return F;
    }
    const Ball d = paper::d(tau, R, zeta), q = paper::q(tau, R, zeta);
    const Ball F = paper::braces(d, q, R, u, g), rate = paper::braces_prime(d, q, R, zeta, u, g);
    // The mode obeys F'' + 2 zeta / R F' + F / R^2 = 1 / R^2.
    std::vector<Ball> c{F, rate, ((1 - F) * stiffness - damping * rate) / 2};
    Series series;
    go_on(c, series.c.size());
    std::ranges::copy(c, series.c.begin());
    return series;
}

Ball FrictionMotionOfMode::most_of(const Ball& tau) const {
    const Bits few(64);
    return upper_bound_of(largest * exp(-damping / 2 * Ball(tau.low())));
}

ResponsesInBalls responses_of_modes(const SceneInBalls& s, ModesInBalls m) {
    std::vector<FrictionMotionOfMode> motions;
    std::vector<Complex<Ball>> v;
    std::vector<Ball> u, g;
    for (std::size_t i = 0; i < m.R.size(); ++i) {
        motions.emplace_back(m.R[i], m.zeta[i]);
        v.push_back(paper::complex_response(m.R[i], m.zeta[i])); // (23)
        u.push_back(motions[i].u);                               // (28)
        g.push_back(motions[i].g);                               // (29)
    }
    using Row = std::vector<Ball>;
    const auto open = [&m](const Row& k, const Row& n, const auto& f) { // what clusters leave open, a ball about zero
        Row each(m.R.size());
        for (const ModeCluster& c : m.clusters) each[c.first] = f(c.first);
        return m.left_open(k, n, each);
    };
    const auto square = [&m](std::size_t i) { return m.R[i] * m.R[i]; };
    const auto V = [&](const Row& k, const Row& load) { // (33)
        const Complex<Ball> left{open(k, load, [&](std::size_t i) { return square(i) * v[i].re; }),
                                 open(k, load, [&](std::size_t i) { return square(i) * v[i].im; })};
        return paper::complex_response_of_mass<Ball>(k, load, m.R, v, left);
    };
    const auto U = [&](const Row& k, const Row& u) { // (34), (35)
        const Ball left = open(k, m.at_contact(), [&](std::size_t i) { return square(i) * u[i]; });
        return paper::damping_function_of_mass<Ball>(k, m.at_contact(), m.R, u, left);
    };
    ResponsesInBalls r;
    for (std::size_t row = 0; row <= static_cast<std::size_t>(m.N); ++row) {
        r.V.push_back(V(m.psi[row], m.at_load()));
        if (m.at_load_i() != nullptr) r.V.back() = paper::complex_response_to_phases(r.V.back(), V(m.psi[row], *m.at_load_i()));
        r.U.push_back(U(m.psi[row], u));
        r.G.push_back(U(m.psi[row], g));
    }
    const auto h = [&](std::size_t i) { return g[i] + 2 * m.zeta[i] * m.R[i] * u[i]; };
    r.H = paper::H<Ball>(m.at_contact(), m.R, m.zeta, u, g, open(m.at_contact(), m.at_contact(), h)); // (64)
    r.Y = V(m.at_contact(), m.at_contact());
    r.squares = acceleration_of_contact(s);
    r.friction = friction_of_modes(m, motions);
    const bool oscillate = std::ranges::all_of(motions, [](const FrictionMotionOfMode& F) { return F.parts.empty(); });
    for (std::size_t row = 0; row < r.G.size(); ++row) { // a difference so small that its terms show little of it
        Ball terms(0);
        for (std::size_t i = 0; i < motions.size(); ++i) terms += abs(r.friction.weight[row][i]) * motions[i].largest;
        r.friction.cancels.push_back(oscillate && abs(r.G[row]) + abs(r.U[row]) < Ball(0x1p-20) * terms);
    }
    r.modes = std::move(m);
    return r;
}

ResponsesInBalls responses_of_state(const SceneInBalls& s) {
    const StateMatrix m = state_matrix(s);
    ResponsesInBalls r;
    r.friction.effort = s.effort;
    r.V = harmonic_response(s, s.p, s.p_i);
    r.Y = harmonic_response(s, s.w).back();
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

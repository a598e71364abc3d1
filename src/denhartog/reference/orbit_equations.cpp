// Which equations does a motion with stops solve? One for each phase, by (6), and one for each event, by (3) and (74). The
// unknowns are the states and the instants of the events; `linearised` gives the derivatives over a box of unknowns.
#include "denhartog/reference/orbit_equations.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/number/effort.hpp"
#include "denhartog/number/sparse_balls.hpp"

namespace denhartog::reference {
namespace {

BallMatrix row_of(const BallMatrix& w, slong from, slong length) {
    BallMatrix row(1, length);
    for (slong i = 0; i < w.rows(); ++i) row(0, from + i) = w(i);
    return row;
}

// M^-1, without noise if M is diagonal, so that what is zero stays so.
BallMatrix inverse_of(const BallMatrix& M) {
    if (arb_mat_is_diag(M.a) != 0) {
        BallMatrix inverse(M.rows(), M.rows());
        for (slong k = 0; k < M.rows(); ++k) inverse(k, k) = Ball(1) / M(k, k);
        return inverse;
    }
    BallMatrix inverse;
    if (!solved(M, unit_matrix(M.rows()), inverse)) throw Unproved("the mass matrix may be singular");
    return inverse;
}

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
        free(N + i, 2 * N) = force(i) / sigma;
        if (scene.p_i.rows() > 0) free(N + i, 2 * N + 1) = -(ahead(i) / sigma);
        for (slong k = 0; k < N; ++k) {
            free(N + i, k) = -(stiffness(i, k) / sigma);
            free(N + i, N + k) = -damping(i, k);
        }
        if (abs(w(i)) > abs(w(lead))) lead = i;
    }
    free(2 * N, 2 * N + 1) = Ball(-1);
    free(2 * N + 1, 2 * N) = Ball(1);
    sliding = sliding_phases(scene, sigma);
    const BallMatrix along = row_of(w, N, n());
    load = along * free * (Ball(1) / (transposed(w) * push)(0));
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
    for (slong i = 0; i < N; ++i) A(N + i, 2 * N + 2) = Ball(-direction) * beta * push(i);
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

BallMatrix with_width(BallMatrix E, double part) {
    mag_t width, each;
    mag_init(width);
    mag_init(each);
    for (slong c = 0; c < E.columns(); ++c) {
        mag_zero(width);
        for (slong k = 0; k < E.rows(); ++k) {
            arb_get_mag(each, E(k, c).a);
            mag_max(width, width, each);
        }
        mag_set_d(each, part * (1 + 1e-9));
        mag_mul(width, width, each);
        for (slong k = 0; k < E.rows(); ++k) arb_add_error_mag(E(k, c).a, width);
    }
    mag_clear(width);
    mag_clear(each);
    return E;
}

int OrbitUnknowns::direction(slong i) const {
    return i <= m() ? directions[static_cast<std::size_t>(i)] : sign() * directions[1];
}

Ball OrbitUnknowns::T() const { return Ball(mirrored ? periods : 2 * periods) * PiOf<Ball>::value(); }

Ball OrbitUnknowns::instant(slong i) const { return i < m() ? u(states() + i) : u(states()) + T(); }

BallMatrix OrbitUnknowns::start() const {
    BallMatrix Z(states() + 3, 1);
    for (slong i = 0; i < states(); ++i) Z(i) = u(i);
    Z(states()) = cos(instant(0));
    Z(states() + 1) = sin(instant(0));
    Z(states() + 2) = Ball(1);
    return Z;
}

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
        o.u(k) = Ball(guess.x[static_cast<std::size_t>(k)]);
        o.u(N + k) = Ball(guess.x_prime[static_cast<std::size_t>(k)]) / s.sigma;
    }
    for (slong i = 0; i < m; ++i) o.u(2 * N + i) = Ball(guess.events[static_cast<std::size_t>(i)]);
    return o;
}

ExponentialSeries::ExponentialSeries(const BallMatrix& B, const BallMatrix& y, Effort* effort) {
    const slong n = B.rows();
    const double theta = norm(B) * (1 + 1e-9);
    slong last = 0; // the terms beyond fall by half each, from below the last bit
    for (double left = static_cast<double>(ball_bits); left > 0 || static_cast<double>(last) < 2 * theta || last < 4;)
        left += binary_logarithm(std::max(theta, 1e-300) / static_cast<double>(++last));
    const SparseBalls sparse(B);
    pay(effort, cost_of_ball_products(static_cast<double>((sparse.count() + n) * last)));
    terms_ = BallMatrix(n, last + 1);
    over_factorials_ = BallMatrix(1, last + 1);
    over_factorials_(0, 0) = Ball(1);
    for (slong i = 0; i < n; ++i) terms_(i, 0) = y(i);
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
    std::vector<Ball> sum(static_cast<std::size_t>(terms_.columns()));
    for (slong i = 0; i < terms_.rows(); ++i) {
        if (row(0, i).is_zero()) continue;
        for (slong k = 0; k < terms_.columns(); ++k)
            arb_addmul(sum[static_cast<std::size_t>(k)].a, row(0, i).a, terms_(i, k).a, ball_bits);
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
            Ball radius(0), each;
            for (slong k = 0; k < n; ++k) {
                arf_set_mag(arb_midref(each.a), arb_radref(node(k).a));
                radius = larger(radius, each);
            }
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
    for (slong i = 0; i < z; ++i) D(i, i) = Ball(1);
    D(z, z) = -Z(z + 1);
    D(z + 1, z) = Z(z);
    for (slong i = 0;; ++i) {
        r.D.push_back(D);
        if (i == m) break;
        const int kind = box.direction(i + 1);
        const BallMatrix slope = s.ending(box.direction(i), kind) * D;
        for (slong c = 0; c < z + m; ++c) r.J(z + i, c) = slope(0, c);
        const Ball h = box.length(i + 1), middle_h = middle(h);
        const BallMatrix A = rounded(s.phase(kind));
        // Never exponentiate a wide ball: exp(A (h + d)) is off exp(A h), column by column, by at most exp(|A d|) - 1 of the
        // largest entry.
        const double apart = norm(A) * h.radius() * (1 + 1e-9);
        const auto leaps = static_cast<int>(r.leaps[static_cast<std::size_t>(i)]);
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
    const Ball sign(box.sign()); // what comes back is what began
    for (slong i = 0; i < z; ++i)
        for (slong c = 0; c < z + m; ++c) r.J(i, c) = Ball(i == c ? 1 : 0) - sign * D(i, c);
    return r;
}

double binary_logarithm(double x) { return elementary::log(x) / elementary::log(2); }

long cost_of_ball_products(double products) {
    return static_cast<long>(products * (0.25 + static_cast<double>(ball_bits) / 1024)) + 1;
}

} // namespace denhartog::reference

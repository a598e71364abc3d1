// The equations of motion and their natural modes, proved. Read `natural_modes`, (15): it
// makes the matrix nearly diagonal and bounds what is left; modes that are not proved distinct stay together in a cluster.
// `damping_matrix_in_balls` is (19).
#include "denhartog/reference/modes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <numeric>

#include "denhartog/model/contact_and_load.hpp"

namespace denhartog::reference {
namespace {

BallMatrix in_balls(const Matrix<Ball>& A) {
    BallMatrix out(A.rows(), A.cols());
    for (Eigen::Index i = 0; i < A.rows(); ++i)
        for (Eigen::Index k = 0; k < A.cols(); ++k) out(i, k) = A(i, k);
    return out;
}

constexpr std::size_t most_kept = 8; // natural modes of one system: a few precisions, with the contact free and held

// Pays for the work on natural modes, part by part.
struct Payment {
    Effort* effort;
    long work = 0; // paid so far

    void pay(long operations) {
        denhartog::pay(effort, operations);
        work += operations;
    }
};

BallMatrix cholesky(const BallMatrix& M) {
    BallMatrix L(M.rows(), M.rows());
    if (arb_mat_cho(L.a, M.a, ball_bits) == 0) throw Unproved("the mass matrix is not proved positive definite");
    return L;
}

// L^-1 A L^-T, by two solutions with the triangle.
BallMatrix between_factors(const BallMatrix& L, const BallMatrix& A) {
    BallMatrix left(A.rows(), A.rows()), both(A.rows(), A.rows());
    arb_mat_solve_tril(left.a, L.a, A.a, 0, ball_bits);
    arb_mat_solve_tril(both.a, L.a, transposed(left).a, 0, ball_bits);
    return both;
}

// L^-T X.
BallMatrix by_transposed_factor(const BallMatrix& L, const BallMatrix& X) {
    BallMatrix out(X.rows(), X.columns());
    arb_mat_solve_triu(out.a, transposed(L).a, X.a, 0, ball_bits);
    return out;
}

// Orthonormal eigenvectors of a symmetric matrix in double, as a first guess.
BallMatrix eigenvectors_in_double(const BallMatrix& A) {
    const slong N = A.rows();
    Eigen::MatrixXd D(N, N);
    const Ball size(std::max(norm(A), std::numeric_limits<double>::min()));
    for (slong i = 0; i < N; ++i)
        for (slong k = 0; k < N; ++k) D(i, k) = static_cast<double>(A(i, k) / size);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(D);
    BallMatrix X(N, N);
    for (slong i = 0; i < N; ++i)
        for (slong k = 0; k < N; ++k) X(i, k) = Ball(solver.eigenvectors()(i, k));
    return X;
}

// Eigenvectors in the current bits, if double has lost the small entries beside the large.
BallMatrix eigenvectors_in_bits(const BallMatrix& A, Payment& payment) {
    const slong N = A.rows();
    payment.pay(N * N * N * 100);
    ComplexMatrix C(A), R(N, N), values(1, N);
    acb_mat_approx_eig_qr(values.all(), nullptr, R.a, C.a, nullptr, 0, 2 * ball_bits);
    BallMatrix X(N, N);
    for (slong k = 0; k < N; ++k) {
        Ball length(0);
        for (slong i = 0; i < N; ++i) {
            arb_get_mid_arb(X(i, k).a, acb_realref(acb_mat_entry(R.a, i, k)));
            length += X(i, k) * X(i, k);
        }
        for (slong i = 0; i < N; ++i) X(i, k) = middle(X(i, k) / sqrt(length));
    }
    return X;
}

// A bound of the Frobenius norm of what is off the diagonal, together with the radii of the entries on it.
Ball off_diagonal(const BallMatrix& A) {
    Ball sum(0);
    for (slong i = 0; i < A.rows(); ++i)
        for (slong k = 0; k < A.rows(); ++k) {
            const Ball off = i == k ? A(i, i) - middle(A(i, i)) : A(i, k);
            sum += off * off;
        }
    return root_of_positive(sum);
}

// A step of Newton's method for all eigenvectors at once: X (1 + T) has twice as many right digits as X. It computes with
// midpoints and proves nothing.
BallMatrix improved(const BallMatrix& A, const BallMatrix& X) {
    const slong N = A.rows();
    const BallMatrix across = transposed(X), B = middle(across * A * X), G = middle(across * X);
    BallMatrix T(N, N);
    const Ball off = Ball(norm(B)) * power_of_two(-ball_bits / 2);
    for (slong i = 0; i < N; ++i)
        for (slong k = 0; k < N; ++k) {
            const Ball value = B(k, k) / G(k, k), apart = value - B(i, i) / G(i, i);
            const bool pair = i != k && abs(apart) > off;
            T(i, k) = i == k ? (1 - G(i, i)) / 2 : pair ? (B(i, k) - value * G(i, k)) / apart : -G(i, k) / 2;
        }
    return middle(X + X * T);
}

// The matrix in the basis of its approximate eigenvectors X, which `factor` makes orthonormal: nearly diagonal.
struct NearlyDiagonal {
    BallMatrix X{}, factor{}, matrix{};
    Ball off{};
};

NearlyDiagonal on_vectors(const BallMatrix& A, const BallMatrix& X) {
    const BallMatrix across = transposed(X);
    BallMatrix factor = cholesky(across * X), matrix = between_factors(factor, across * A * X);
    const Ball off = off_diagonal(matrix);
    return {X, std::move(factor), std::move(matrix), off};
}

NearlyDiagonal nearly_diagonal(const BallMatrix& A, Payment& payment) {
    const Ball enough = Ball(norm(A)) * power_of_two(-ball_bits * 4 / 5);
    const auto improve = [&](BallMatrix X) {
        slong steps = 2;
        for (slong bits = 40; bits < ball_bits; bits *= 2) ++steps;
        for (slong n = 0; n < steps; ++n) {
            payment.pay(A.rows() * A.rows() * A.rows() / 2);
            X = improved(A, X);
        }
        return on_vectors(A, X);
    };
    auto found =
        if_proved([&] { return improve(eigenvectors_in_double(A)); }); // none where the guess is too far off for the factor
    if (found && found->off <= enough) return *std::move(found);
    return improve(eigenvectors_in_bits(A, payment));
}

NaturalModesInBalls natural_modes(const SceneInBalls& s) {
    const slong N = s.N();
    const auto count = static_cast<std::size_t>(N);
    NaturalModesInBalls m;
    const BallMatrix L = cholesky(s.M), A = between_factors(L, s.K);
    Payment payment{s.effort};
    const NearlyDiagonal near = nearly_diagonal(A, payment);
    m.work = payment.work;
    std::vector<slong> order(count);
    std::iota(order.begin(), order.end(), 0L);
    std::ranges::sort(
        order, [&](slong a, slong b) { return arf_cmp(arb_midref(near.matrix(a, a).a), arb_midref(near.matrix(b, b).a)) < 0; });
    const auto value = [&](std::size_t i) { return middle(near.matrix(order[i], order[i])); };
    const Ball eps = upper_bound_of(near.off);
    // Mass-normalised shapes. If the vectors turn by an angle, an entry changes by at most the angle times the length of its row.
    const BallMatrix V = by_transposed_factor(L, near.X * by_transposed_factor(near.factor, unit_matrix(N)));
    std::vector<BallMatrix> rows{V, transposed(s.w) * V, transposed(s.p) * V};
    if (s.p_i.rows() > 0) rows.push_back(transposed(s.p_i) * V);
    m.phi.assign(count + rows.size() - 1, std::vector<Ball>(count));
    for (std::size_t first = 0, last = 0; first < count; first = last) {
        for (last = first + 1; last < count && !(value(last) - value(last - 1) > 4 * eps); ++last) {
        }
        Ball rate(0); // the error over the gap, which bounds by how much a vector may be turned
        if (first > 0) rate = eps / (value(first) - value(first - 1) - eps);
        if (last < count) rate = larger(rate, eps / (value(last) - value(last - 1) - eps));
        Ball lambda = value(first);
        for (std::size_t i = first; i < last; ++i) lambda = either(lambda, value(i));
        const bool alone = last == first + 1;
        lambda = widened(lambda, alone && count > 1 ? eps * rate : eps);
        if (alone) lambda = lambda + (near.matrix(order[first], order[first]) - value(first));
        if (!(lambda.low() > 0)) throw Unproved("a natural frequency is not proved positive");
        const Ball turn = sqrt(Ball(2)) * rate;
        for (std::size_t i = first; i < last; ++i) {
            m.lambda.push_back(lambda);
            slong row = 0;
            for (const BallMatrix& part : rows)
                for (slong k = 0; k < part.rows(); ++k, ++row) {
                    Ball length(0);
                    for (slong n = 0; n < N; ++n) length += part(k, n) * part(k, n);
                    m.phi[row][i] = widened(part(k, order[i]), turn * root_of_positive(length));
                }
        }
        if (!alone) m.clusters.push_back({first, last});
    }
    return m;
}

} // namespace

BallMatrix solution_of(const BallMatrix& A, const BallMatrix& b, const char* otherwise) {
    BallMatrix x;
    if (!solved(A, b, x)) throw Unproved(otherwise);
    return x;
}

bool SceneInBalls::is_the_contact(slong k) const {
    for (slong n = 0; n < N(); ++n)
        if (!(n == k ? w(n) - Ball(1) : w(n)).is_zero()) return false;
    return true;
}

BallMatrix dynamic_stiffness(const SceneInBalls& s, slong n) {
    BallMatrix A(2 * n, 2 * n);
    for (slong i = 0; i < s.N(); ++i)
        for (slong k = 0; k < s.N(); ++k) {
            A(i, k) = A(n + i, n + k) = s.K(i, k) - s.r * s.r * s.M(i, k);
            A(n + i, k) = s.r * s.C(i, k);
            A(i, n + k) = -A(n + i, k);
        }
    return A;
}

SceneInBalls in_matrices(const Scene<Ball>& scene) {
    const System<Ball>& s = scene.system;
    SceneInBalls out{in_balls(mass_matrix(s)), in_balls(stiffness_matrix(s)), in_balls(s.damping_matrix), s.damping_ratios};
    out.w = out.p = BallMatrix(out.N(), 1);
    if (!s.load_phases.empty()) out.p_i = out.p;
    const std::vector<Ball> direction = contact_vector(s);
    const std::vector<Complex<Ball>> load = complex_load(s);
    for (slong k = 0; k < out.N(); ++k) {
        out.w(k) = direction[k];
        out.p(k) = load[k].re;
        if (!s.load_phases.empty()) out.p_i(k) = load[k].im;
    }
    out.base_motion = load_depends_on_frequency(s) ? s.base_motion : BaseMotion::none;
    out.r = *scene.r;
    out.mu = scene.mu;
    out.beta = scene.beta;
    out.contact = s.contact.index;
    return out;
}

Ball ModesInBalls::lengths_in(const ModeCluster& cluster, const std::vector<Ball>& k, const std::vector<Ball>& n) {
    Ball square_of_k(0), square_of_n(0);
    for (std::size_t i = cluster.first; i < cluster.last; ++i) {
        square_of_k += k[i] * k[i];
        square_of_n += n[i] * n[i];
    }
    return root_of_positive(square_of_k * square_of_n);
}

Ball ModesInBalls::left_open(const std::vector<Ball>& k, const std::vector<Ball>& n, const std::vector<Ball>& f) const {
    Ball open(0);
    for (const ModeCluster& c : clusters) open = widened(open, lengths_in(c, k, n) * radius_of(f[c.first]));
    return open;
}

std::shared_ptr<const NaturalModesInBalls> KeptModes::of(const SceneInBalls& s) {
    const std::scoped_lock one(one_at_a_time_); // who needs the same waits for it
    const auto same = [](const BallMatrix& x, const BallMatrix& y) {
        return x.rows() == y.rows() && arb_mat_equal(x.a, y.a) != 0;
    };
    for (const Kept& k : kept_)
        if (k.bits == ball_bits && same(k.M, s.M) && same(k.K, s.K) && same(k.w, s.w) && same(k.p, s.p) && same(k.p_i, s.p_i)) {
            pay(s.effort, k.modes->work);
            return k.modes;
        }
    if (kept_.size() == most_kept) kept_.erase(kept_.begin());
    ++solved_;
    kept_.push_back({ball_bits, s.M, s.K, s.w, s.p, s.p_i, std::make_shared<const NaturalModesInBalls>(natural_modes(s))});
    return kept_.back().modes;
}

ModesInBalls modes_in_balls(const SceneInBalls& s) {
    const auto natural = s.kept ? s.kept->of(s) : std::make_shared<const NaturalModesInBalls>(natural_modes(s));
    for (const ModeCluster& c : natural->clusters)
        for (std::size_t i = c.first; i < c.last && !s.zeta.empty(); ++i)
            if (arb_equal(s.zeta[i].a, s.zeta[c.first].a) == 0) // one ball holds all that they may be, as it does for R
                throw Unproved("modes " + std::to_string(c.first + 1) + " and " + std::to_string(c.last) +
                               " are not told apart, and have different damping ratios");
    ModesInBalls m{{}, s.zeta, natural->phi, natural->clusters, s.N(), s.effort};
    for (const Ball& lambda : natural->lambda) m.R.push_back(s.r / sqrt(lambda));
    for (std::vector<Ball>& row : m.psi)
        for (Ball& entry : row) entry /= s.r;
    return m;
}

SceneInBalls with_load_of_base(SceneInBalls s) {
    if (s.base_motion == BaseMotion::none) return s;
    BallMatrix ones(s.N(), 1);
    for (slong k = 0; k < s.N(); ++k) ones(k) = Ball(1);
    s.p = s.K * ones;
    s.p_i = (s.zeta.empty() ? s.C : damping_matrix_in_balls(s, modes_in_balls(s))) * ones * s.r;
    if (s.base_motion == BaseMotion::alone) return s;
    s.p = s.M * ones * (s.r * s.r) - s.p;
    s.p_i = s.p_i * Ball(-1);
    return s;
}

BallMatrix shapes_of(const ModesInBalls& m) {
    BallMatrix Psi(m.N, m.N);
    for (slong k = 0; k < m.N; ++k)
        for (slong i = 0; i < m.N; ++i) Psi(k, i) = m.psi[k][i];
    return Psi;
}

BallMatrix damping_matrix_in_balls(const SceneInBalls& s, const ModesInBalls& m) {
    // C = M Phi diag(2 zeta omega) (M Phi)^T, with phi = r psi and omega = r / R.
    const slong N = s.N();
    BallMatrix D(N, N);
    std::vector<Ball> rates;
    for (slong i = 0; i < N; ++i) {
        rates.push_back(2 * m.zeta[i] * s.r / m.R[i]);
        D(i, i) = rates.back();
    }
    const BallMatrix shapes = s.M * (shapes_of(m) * s.r);
    BallMatrix C = shapes * D * transposed(shapes);
    std::vector<std::vector<Ball>> rows(N);
    for (slong k = 0; k < N; ++k)
        for (slong i = 0; i < N; ++i) rows[k].push_back(shapes(k, i));
    for (slong k = 0; k < N; ++k)
        for (slong n = 0; n < N; ++n) C(k, n) += m.left_open(rows[k], rows[n], rates);
    return C;
}

} // namespace denhartog::reference

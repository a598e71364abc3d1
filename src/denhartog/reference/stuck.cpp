// What is the motion with the contact held, and up to which friction ratio does it stay held? The equation of motion without row
// j, and the limit (88) as it stands for any damping.
#include "denhartog/reference/stuck.hpp"

#include "denhartog/formulas/mode.hpp"
#include "denhartog/formulas/stuck.hpp"
#include "denhartog/formulas/superposition.hpp"

namespace denhartog::reference {
namespace {

bool same(const BallMatrix& x, const BallMatrix& y) { return arb_mat_eq(x.a, y.a) != 0 && arb_mat_is_exact(x.a) != 0; }

BallMatrix block(const BallMatrix& A, slong first, slong count) {
    BallMatrix out(count, count);
    for (slong i = 0; i < count; ++i)
        for (slong k = 0; k < count; ++k) out(i, k) = A(first + i, first + k);
    return out;
}

} // namespace

std::optional<StuckInBalls> stuck_in_balls(const SceneInBalls& s) {
    // (K - M + i C) X + w f = p, w^T X = 0 in real parts and imaginary parts: unknown are X and the force f
    const slong N = s.N(), n = N + 1;
    BallMatrix A = dynamic_stiffness(s, n), b(2 * n, 1), x, at_rest;
    for (slong i = 0; i < N; ++i) {
        b(i) = s.p(i);
        if (s.p_i.rows() > 0) b(n + i) = s.p_i(i);
        A(i, N) = A(N, i) = A(n + i, n + N) = A(n + N, n + i) = s.w(i);
    }
    if (!solved(A, b, x)) return std::nullopt;
    if (!solved(s.K, s.w, at_rest)) throw Unproved("the stiffness matrix is not proved regular");
    StuckInBalls out;
    for (slong k = 0; k < N; ++k) out.X.push_back({x(k), x(n + k)});
    out.load = {x(N), x(n + N)};
    out.compliance = (transposed(s.w) * at_rest)(0);
    return out;
}

Ball sticking_limit_in_balls(const SceneInBalls& s, const StuckInBalls& stuck) {
    return s.p_i.rows() == 0 && same(s.w, s.p) ? paper::sticking_limit_under_load(s.mu) : paper::sticking_limit(stuck.load, s.mu);
}

Ball sticking_limit_by_88(const SceneInBalls& s, std::size_t load) {
    if (load == s.contact) return paper::sticking_limit_under_load(s.mu);
    const bool before = load < s.contact;
    const auto j = static_cast<slong>(s.contact), l = static_cast<slong>(load), first = before ? 0 : j + 1,
               count = before ? j : s.N() - j - 1;
    SceneInBalls moving{block(s.M, first, count), block(s.K, first, count)};
    moving.r = s.r;
    moving.kept = s.kept;
    moving.effort = s.effort;
    moving.w = moving.p = BallMatrix(count, 1);
    moving.w(before ? count - 1 : 0) = Ball(1); // the mass next to the contact
    moving.p(l - first) = Ball(1);
    const ModesInBalls m = modes_in_balls(moving);
    if (!m.clusters.empty())
        throw Unproved("modes beside the contact are not told apart"); // those of a chain are, with more bits
    std::vector<Complex<Ball>> v;
    for (std::size_t i = 0; i < m.R.size(); ++i) { // (18) on the diagonal: 2 zeta omega = phi^T C phi, phi = r psi, omega = r / R
        Ball c(0);
        for (slong k = 0; k < count; ++k)
            for (slong n = 0; n < count; ++n)
                c += m.psi[static_cast<std::size_t>(k)][i] * s.C(first + k, first + n) * m.psi[static_cast<std::size_t>(n)][i];
        v.push_back(paper::complex_response(m.R[i], Ball(c * s.r * m.R[i] / 2)));
    }
    const Complex<Ball> X = paper::complex_response_of_mass<Ball>(m.at_contact(), m.at_load(), m.R, v);
    const Ball kappa = -s.K(j, before ? j - 1 : j + 1);
    return paper::sticking_limit_by_spring(kappa, modulus(X), s.mu);
}

} // namespace denhartog::reference

// The matrices of (6) and the load in balls, from the scene as it is written: (1), (8) and (73), or what the scene gives.
#include "denhartog/reference/scene_in_balls.hpp"

#include <span>

#include "denhartog/formulas/system.hpp"
#include "denhartog/model/contact_and_load.hpp"

namespace denhartog::reference {
namespace {

BallMatrix in_balls(const Matrix<Ball>& A) {
    BallMatrix out(A.rows(), A.cols());
    for (Eigen::Index i = 0; i < A.rows(); ++i)
        for (Eigen::Index k = 0; k < A.cols(); ++k) out(i, k) = A(i, k);
    return out;
}

// (8) without the factor r^2: mass ratios on the diagonal, or the matrix that the scene gives.
BallMatrix masses_of(const System<Ball>& s) {
    if (s.mass_matrix.size() > 0) return in_balls(s.mass_matrix);
    const auto N = static_cast<slong>(s.mass_ratios.size());
    BallMatrix M(N, N);
    for (slong k = 0; k < N; ++k) M(k, k) = s.mass_ratios[static_cast<std::size_t>(k)];
    return M;
}

// (1) with the stiffness ratios (73), or the matrix that the scene gives.
BallMatrix stiffnesses_of(const System<Ball>& s) {
    if (s.stiffness_matrix.size() > 0) return in_balls(s.stiffness_matrix);
    const std::vector<Ball> entries = paper::chain_stiffness_matrix(std::span<const Ball>(s.stiffness_ratios));
    const auto N = static_cast<slong>(s.stiffness_ratios.size());
    BallMatrix K(N, N);
    for (slong i = 0; i < N; ++i)
        for (slong k = 0; k < N; ++k) K(i, k) = entries[static_cast<std::size_t>(i * N + k)];
    return K;
}

} // namespace

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
    SceneInBalls out{masses_of(s), stiffnesses_of(s)};
    if (s.damping_matrix.size() > 0)
        out.C = in_balls(s.damping_matrix);
    else
        out.zeta = s.damping_ratios;
    out.w = BallMatrix(out.N(), 1);
    const std::vector<Ball> direction = contact_vector(s);
    for (std::size_t k = 0; k < direction.size(); ++k) out.w(static_cast<slong>(k)) = direction[k];
    out.p = BallMatrix(out.N(), 1);
    if (!s.load_phases.empty()) out.p_i = BallMatrix(out.N(), 1);
    const std::vector<Complex<Ball>> load = complex_load(s);
    for (std::size_t k = 0; k < load.size(); ++k) {
        out.p(static_cast<slong>(k)) = load[k].re;
        if (!s.load_phases.empty()) out.p_i(static_cast<slong>(k)) = load[k].im;
    }
    out.base_motion = load_depends_on_frequency(s) ? s.base_motion : BaseMotion::none;
    out.r = *scene.r;
    out.mu = scene.mu;
    out.beta = scene.beta;
    out.contact = s.contact.index;
    return out;
}

} // namespace denhartog::reference

/// @file
/// @brief Matrices of a system and their eigenvectors by Jacobi's rotations, in any number type. Header only.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Jacobi>
#include <limits>
#include <utility>
#include <vector>

#include "denhartog/number/errors.hpp"
#include "denhartog/scene/scene.hpp"

namespace denhartog {

/// @brief A matrix in another number type.
template <class W, class T>
[[nodiscard]] Matrix<W> widened(const Matrix<T>& A) {
    return A.unaryExpr([](const T& value) { return static_cast<W>(value); });
}

/// @brief The stiffness matrix of a system in units of k_1, in a number type W.
template <class W, class T>
[[nodiscard]] Matrix<W> stiffness_of(const System<T>& s) {
    if (s.stiffness_matrix.size() > 0) return widened<W>(s.stiffness_matrix);
    const Eigen::Index N = static_cast<Eigen::Index>(s.stiffness_ratios.size());
    Matrix<W> K = Matrix<W>::Zero(N, N);
    for (Eigen::Index i = 0; i < N; ++i) {
        const W k = static_cast<W>(s.stiffness_ratios[static_cast<std::size_t>(i)]);
        K(i, i) += k;
        if (i == 0) continue;
        K(i - 1, i - 1) += k;
        K(i, i - 1) -= k;
        K(i - 1, i) -= k;
    }
    return K;
}

/// @brief The mass matrix of a system in units of m_1, in a number type W.
template <class W, class T>
[[nodiscard]] Matrix<W> mass_of(const System<T>& s) {
    if (s.mass_matrix.size() > 0) return widened<W>(s.mass_matrix);
    const Eigen::Index N = static_cast<Eigen::Index>(s.mass_ratios.size());
    Matrix<W> M = Matrix<W>::Zero(N, N);
    for (Eigen::Index i = 0; i < N; ++i) M(i, i) = static_cast<W>(s.mass_ratios[static_cast<std::size_t>(i)]);
    return M;
}

/// @brief Leaves the eigenvalues of a symmetric matrix on its diagonal, ascending; Q gets the eigenvectors. PrecisionError where
/// the rotations do not come to an end.
template <class W>
void diagonalise(Matrix<W>& A, Matrix<W>& Q) {
    const Eigen::Index N = A.rows();
    Q = Matrix<W>::Identity(N, N);
    const W threshold = A.squaredNorm() * std::numeric_limits<W>::epsilon() * std::numeric_limits<W>::epsilon();
    const auto off_diagonal = [&A] { return W(A.template triangularView<Eigen::StrictlyUpper>().toDenseMatrix().squaredNorm()); };
    for (int sweep = 0; off_diagonal() > threshold; ++sweep) {
        if (sweep == 60) throw PrecisionError("the modes by Jacobi's rotations did not converge");
        for (Eigen::Index p = 0; p < N; ++p)
            for (Eigen::Index q = p + 1; q < N; ++q) {
                Eigen::JacobiRotation<W> rotation;
                rotation.makeJacobi(A, p, q);
                A.applyOnTheLeft(p, q, rotation.adjoint());
                A.applyOnTheRight(p, q, rotation);
                Q.applyOnTheRight(p, q, rotation);
            }
    }
    for (Eigen::Index i = 0; i < N; ++i)
        for (Eigen::Index n = i + 1; n < N; ++n)
            if (A(n, n) < A(i, i)) {
                std::swap(A(n, n), A(i, i));
                Q.col(n).swap(Q.col(i));
            }
}

/// @brief Natural frequency ratios and mode shapes.
template <class W>
struct ModesByRotations {
    std::vector<W> r_n; ///< natural frequency ratios, ascending
    Matrix<W> phi;      ///< mode shapes, mass by mode, phi^T M phi = 1
};

/// @brief The modes of a mass and a stiffness matrix. @eq{14,15}
template <class W>
[[nodiscard]] ModesByRotations<W> modes_by_rotations(const Matrix<W>& M, const Matrix<W>& K) {
    const Matrix<W> L = M.llt().matrixL();
    const auto lower = L.template triangularView<Eigen::Lower>();
    Matrix<W> A = lower.solve(Matrix<W>(lower.solve(K).transpose())), Q;
    diagonalise(A, Q);
    ModesByRotations<W> modes{{}, L.transpose().template triangularView<Eigen::Upper>().solve(Q)};
    for (Eigen::Index i = 0; i < A.rows(); ++i) modes.r_n.push_back(sqrt(A(i, i)));
    return modes;
}

/// @brief The damping matrix of a system in units of sqrt(k_1 m_1): as given, or by its definition from the modes. @eq{19}
template <class W, class T>
[[nodiscard]] Matrix<W> damping_of(const System<T>& s, const Matrix<W>& M, const Matrix<W>& K) {
    if (s.damping_matrix.size() > 0) return widened<W>(s.damping_matrix);
    const ModesByRotations<W> modes = modes_by_rotations(M, K);
    Matrix<W> C = Matrix<W>::Zero(M.rows(), M.cols());
    for (std::size_t i = 0; i < modes.r_n.size(); ++i) {
        const Matrix<W> M_phi = M * modes.phi.col(static_cast<Eigen::Index>(i));
        C += W(2 * static_cast<W>(s.damping_ratios[i]) * modes.r_n[i]) * M_phi * M_phi.transpose();
    }
    return C;
}

} // namespace denhartog

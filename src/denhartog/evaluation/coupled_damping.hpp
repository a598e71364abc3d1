/// @file
/// @brief The sliding motion if damping couples the modes: its energy coordinates, and friction's share of it.
///
/// The paper leaves such damping out (Section 2.1). These formulas are not in it; they follow from (12) as its own do, and are
/// its own if the modes are not coupled.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace denhartog::evaluation {

/// @brief The rates of the energy coordinates of a system that moves freely.
///
/// With \f$ \mathbf{M} = \mathbf{L}\mathbf{L}^T \f$ and \f$ \mathbf{K} = \mathbf{G}\mathbf{G}^T \f$ in units of m_1 and k_1 the
/// coordinates are \f$ \mathbf{s} = (\mathbf{G}^T\mathbf{x}/r,\ \mathbf{L}^T\mathbf{x}') \f$, and (12) without its forces is
/// \f[ \mathbf{s}' = \mathbf{A}\mathbf{s}, \qquad \mathbf{A} = \frac{1}{r}\begin{pmatrix} \mathbf{0} & \mathbf{P}^T
///     \\ -\mathbf{P} & -\mathbf{B} \end{pmatrix}, \qquad \mathbf{P} = \mathbf{L}^{-1}\mathbf{G}, \quad
///     \mathbf{B} = \mathbf{L}^{-1}\mathbf{C}\mathbf{L}^{-T}. \f]
/// @eq{20}  @derivation{forms/coupled_damping}  @domain{any positive definite M and K, any symmetric C}
/// @param P  N x N, row-major
/// @param B  N x N, row-major, symmetric
/// @param N  number of masses
/// @param r  frequency ratio, Eq. (10)
/// @return   A, 2N x 2N, row-major
template <class T>
[[nodiscard]] std::vector<T> energy_rates(std::span<const T> P, std::span<const T> B, std::size_t N, const T& r) {
    std::vector<T> A(4 * N * N, T(0));
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t k = 0; k < N; ++k) {
            A[k * 2 * N + N + i] = P[i * N + k] / r;
            A[(N + i) * 2 * N + k] = -(P[i * N + k] / r);
            A[(N + i) * 2 * N + N + k] = -(B[i * N + k] / r);
        }
    return A;
}

/// @brief A displacement under a unit friction force that changes its sign every half period.
/// \f[ \sum_i a_{ki}\,(s_{0i} - f_i), \qquad \mathbf{f} = e^{\mathbf{A}\tau}\mathbf{c}, \quad
///     (\mathbf{1}+e^{\mathbf{A}\pi})\,\mathbf{c} = 2\mathbf{s}_0 \f]
/// Of modes that are not coupled it is the sum over modes in (41).
/// @eq{41}  @derivation{forms/coupled_damping}
/// @param a_k   the displacement over the first half of the energy coordinates, N values
/// @param rest  the first half where the system rests under the force, N values
/// @param f     the first half of the free motion, N values
/// @return      the displacement over beta
template <class T>
[[nodiscard]] T displacement_under_friction(std::span<const T> a_k, std::span<const T> rest, std::span<const T> f) {
    T sum(0);
    for (std::size_t i = 0; i < a_k.size(); ++i) sum = sum + a_k[i] * (rest[i] - f[i]);
    return sum;
}

/// @brief A derivative of that displacement.
/// @eq{41}  @derivation{forms/coupled_damping}
/// @param b_k  the velocity over the second half of the energy coordinates, N values
/// @param f    the second half of the free motion or, for higher derivatives, of its derivative of one order less, N values
/// @return     the derivative over beta
template <class T>
[[nodiscard]] T derivative_under_friction(std::span<const T> b_k, std::span<const T> f) {
    T sum(0);
    for (std::size_t i = 0; i < b_k.size(); ++i) sum = sum - b_k[i] * f[i];
    return sum;
}

} // namespace denhartog::evaluation

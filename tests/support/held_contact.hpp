/// @file
/// @brief The response with the contact held from the matrices of (6): a dense linear system, and no modes.
#pragma once

#include <Eigen/LU>

#include "denhartog/formulas/complex.hpp"
#include "tests/support/half_period.hpp"

namespace denhartog::tests {

/// @brief The motion under the force cos tau on the loaded mass while the contact is held.
template <class T>
struct HeldContact {
    std::vector<Complex<T>> X; ///< complex amplitudes of the masses
    Complex<T> load;           ///< of all that acts on the contact but friction
};

/// @brief Solves for it. @param m the matrices, contact and load, each of one mass @return the motion
template <class T>
[[nodiscard]] HeldContact<T> held_contact(const HalfPeriodProblem<T>& m) {
    const Eigen::Index N = m.M.rows(), j = static_cast<Eigen::Index>(m.contact.index);
    Matrix<T> A(2 * N, 2 * N); // the real part, then the imaginary one
    const Matrix<T> D = m.K - m.M;
    A << D, Matrix<T>(-m.C), m.C, D;
    Vector<T> force = Vector<T>::Zero(2 * N);
    force(static_cast<Eigen::Index>(m.load.index)) = T(1);
    Matrix<T> held = A;
    Vector<T> on_others = force;
    for (const Eigen::Index row : {j, N + j}) {
        held.row(row).setZero();
        held(row, row) = T(1);
        on_others(row) = T(0);
    }
    const Vector<T> x = Eigen::FullPivLU<Matrix<T>>(held).solve(on_others), left = force - A * x;
    HeldContact<T> motion{{}, {left(j), left(N + j)}};
    for (Eigen::Index k = 0; k < N; ++k) motion.X.push_back({x(k), x(N + k)});
    return motion;
}

} // namespace denhartog::tests

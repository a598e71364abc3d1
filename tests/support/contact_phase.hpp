/// @file
/// @brief A phase of the contact on the physical coordinates: it slides down, rests or slides up, until something is zero.
#pragma once

#include <Eigen/LU>

#include "tests/support/half_period.hpp"

namespace denhartog {

/// @brief A row over the state z of `augmented_system`.
template <class T>
using StateRow = Eigen::Matrix<T, 1, Eigen::Dynamic>;

/// @brief Accelerations of the masses under the force on the contact that gives it a unit acceleration.
template <class T>
[[nodiscard]] Vector<T> force_that_holds(const HalfPeriodProblem<T>& p) {
    const Vector<T> w = contact_vector(p), of_unit_force = Eigen::FullPivLU<Matrix<T>>(p.M).solve(w);
    return of_unit_force / w.dot(of_unit_force);
}

/// @brief Matrix A of \f$ z' = Az \f$ in a phase; the contact slides down (-1), rests (0) or slides up (1).
template <class T>
[[nodiscard]] Matrix<T> system_of_phase(const HalfPeriodProblem<T>& p, int direction) {
    const Eigen::Index N = p.M.rows();
    Matrix<T> A = augmented_system(p);
    const Vector<T> w = contact_vector(p);
    if (direction == 0) A.middleRows(N, N) -= force_that_holds(p) * (w.transpose() * A.middleRows(N, N));
    if (direction > 0) A.block(N, 2 * N + 2, N, 1) *= T(-1);
    return A;
}

/// @brief What is zero at the end of a phase: the contact's velocity, or the load on it less static friction,
/// mu beta; `next` is the direction of the phase after it, 0 where none follows a rest.
template <class T>
[[nodiscard]] StateRow<T> end_of_phase(const HalfPeriodProblem<T>& p, const T& static_friction, int direction, int next) {
    const Eigen::Index N = p.M.rows();
    StateRow<T> row = StateRow<T>::Zero(2 * N + 3);
    if (direction != 0) {
        row.segment(N, N) = contact_vector(p).transpose();
        return row;
    }
    const Vector<T> share = force_that_holds(p); // of the forces on the masses that the contact bears
    row.head(N) = share.transpose() * p.K;
    row.segment(N, N) = share.transpose() * p.C;
    row(2 * N) = -share.dot(load_vector(p));
    row(2 * N + 1) = share.dot(leading_load(p));
    row(2 * N + 2) = static_friction * next;
    return row;
}

} // namespace denhartog

/// @file
/// @brief A phase of the contact on the physical coordinates: it slides down, rests or slides up, until something is zero.
#pragma once

#include "tests/support/half_period.hpp"

namespace denhartog {

/// @brief A row over the state z of `augmented_system`.
template <class T>
using StateRow = Eigen::Matrix<T, 1, Eigen::Dynamic>;

/// @brief Matrix A of \f$ z' = Az \f$ in a phase. @param p the problem
/// @param direction  -1 where the contact slides down, 0 where it rests, 1 where it slides up
/// @return           A, (2N+3) x (2N+3)
template <class T>
[[nodiscard]] Matrix<T> system_of_phase(const HalfPeriodProblem<T>& p, int direction) {
    const Eigen::Index N = p.M.rows(), rate = N + static_cast<Eigen::Index>(p.contact.index);
    Matrix<T> A = augmented_system(p);
    if (direction == 0) A.row(rate).setZero();
    if (direction > 0) A(rate, 2 * N + 2) *= T(-1);
    return A;
}

/// @brief What is zero at the end of a phase: the contact's velocity, or the load on it less static friction.
/// @param p                the problem
/// @param static_friction  mu beta
/// @param direction        of the phase
/// @param next             direction of the phase after it; 0 where none follows a rest
/// @return                 a row over the state
template <class T>
[[nodiscard]] StateRow<T> end_of_phase(const HalfPeriodProblem<T>& p, const T& static_friction, int direction, int next) {
    const Eigen::Index N = p.M.rows(), j = static_cast<Eigen::Index>(p.contact.index);
    StateRow<T> row = StateRow<T>::Zero(2 * N + 3);
    if (direction != 0) {
        row(N + j) = T(1);
        return row;
    }
    row.head(N) = p.K.row(j);
    row.segment(N, N) = p.C.row(j);
    if (p.load == p.contact) row(2 * N) = T(-1);
    row(2 * N + 2) = static_friction * next;
    return row;
}

} // namespace denhartog

/// @file
/// @brief What the mirrored half-period says without a phase: responses to the cosine, the sine and the friction, each by itself.
#pragma once

#include "tests/support/half_period.hpp"

namespace denhartog::conformance::generator {

/// @brief Motions of (6) that mirror themselves after half a period, under unit loads.
template <class T>
struct LinearHalfPeriod {
    Matrix<T> A; ///< matrix of z' = Az, z = (x, x', cos, sin, 1), the contact under a friction of 1
    Matrix<T> Y; ///< (x, x') at tau = 0 for the force cos tau, for the force -sin tau, for the friction: 2N x 3
    Matrix<T> f; ///< state z under the friction alone at tau = pi n / steps, (2N + 3) x (steps + 1)
    Vector<T> w; ///< displacement of the contact over the masses
};

/// @brief Number of steps that show every extremum: 32 a cycle of the fastest mode, at least 96.
/// @param fastest  largest natural frequency over that of the force
/// @return         steps of [0, pi]
template <class T>
[[nodiscard]] int steps_for(const T& fastest);

/// @brief Solves the mirrored half-period.
/// @param p      the problem; its beta does not matter
/// @param steps  equal steps that [0, pi] is sampled in
/// @return       the responses
template <class T>
[[nodiscard]] LinearHalfPeriod<T> linear_half_period(HalfPeriodProblem<T> p, int steps);

/// @brief State of z' = Az a time later, by Taylor's series in steps of norm 1, or by the matrix exponential where they are many.
/// @param A   the matrix
/// @param z   a state
/// @param dt  the time, of any sign
/// @return    the state
template <class T>
[[nodiscard]] Vector<T> moved(const Matrix<T>& A, const Vector<T>& z, const T& dt);

/// @brief First damping function (34) of a displacement: its velocity at tau = 0 under the friction alone, with the sign turned.
/// @param h  the half-period @param x the displacement over the masses @return U_dk
template <class T>
[[nodiscard]] T U_of(const LinearHalfPeriod<T>& h, const Vector<T>& x);

/// @brief Second damping function (35) of a displacement: that displacement there, with the sign turned.
/// @param h  the half-period @param x the displacement over the masses @return G_k
template <class T>
[[nodiscard]] T G_of(const LinearHalfPeriod<T>& h, const Vector<T>& x);

/// @brief Acceleration of the contact next after tau = 0 under the friction alone: H_j + w^T M^-1 w / r^2, Eqs. (64), (65), (71).
/// @param h  the half-period @return the acceleration
template <class T>
[[nodiscard]] T acceleration_at_start(const LinearHalfPeriod<T>& h);

/// @brief Largest value over (0, pi) of (U_dj cos tau + x_j') / sin tau under the friction alone, its limits included: S_j.
///
/// The velocity of the contact is -sin tau times the root of (38), plus beta times that numerator.
/// @param h  the half-period @return the largest value
template <class T>
[[nodiscard]] T largest_demand(const LinearHalfPeriod<T>& h);

/// @brief Where a row over the state is largest in size.
template <class T>
struct FurthestPlace {
    T x{0};       ///< its value there
    T instant{0}; ///< when, from the start of the stretch
};

/// @brief The turning points of a row over the state of z' = Az: where its rate changes its sign between equal samples, by Newton's
/// method, and bisection where that leaves the interval. The ends of the stretch are not among them.
/// @param A        the matrix
/// @param z        the state at the start
/// @param row      weights of the state
/// @param length   length of the stretch
/// @param samples  their number
/// @return         the turning point where the row is largest in size; zero where there is none
template <class T>
[[nodiscard]] FurthestPlace<T> furthest_turn(const Matrix<T>& A, const Vector<T>& z, const Vector<T>& row, const T& length,
                                             int samples);

} // namespace denhartog::conformance::generator

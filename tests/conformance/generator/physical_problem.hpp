/// @file
/// @brief The matrices of (6) of a question's scene.
#pragma once

#include "conformance/question.hpp"
#include "tests/support/half_period.hpp"
#include "tests/support/multiprecision.hpp"

namespace denhartog::conformance::generator {

/// @brief The boundary-value problem of a question's scene, its numbers taken as exact.
template <class T>
[[nodiscard]] HalfPeriodProblem<T> problem_of(const ProtocolQuestion& q);
/// @brief In 50 digits. @param q the question @return the problem
template <>
[[nodiscard]] HalfPeriodProblem<Real50> problem_of(const ProtocolQuestion& q);
/// @brief In 100 digits. @param q the question @return the problem
template <>
[[nodiscard]] HalfPeriodProblem<Real100> problem_of(const ProtocolQuestion& q);

/// @brief How far a base or wall moves, in units of P / k_1. @param q the question @return the amplitude of what moves
template <class T>
[[nodiscard]] T base_of(const ProtocolQuestion& q) {
    return q.base_motion == "with_wall" ? T(1 / (T(q.r) * T(q.r))) : T(1);
}

/// @brief How far the frame of the displacements moves. @param q the question @return the amplitude; 0 of a frame at rest
template <class T>
[[nodiscard]] T frame_of(const ProtocolQuestion& q) {
    return q.base_motion == "with_wall" || q.base_motion == "wall" ? base_of<T>(q) : T(0);
}

} // namespace denhartog::conformance::generator

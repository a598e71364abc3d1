/// @file
/// @brief The matrices of (6) of a question's scene.
#pragma once

#include "conformance/question.hpp"
#include "tests/support/half_period.hpp"
#include "tests/support/multiprecision.hpp"

namespace denhartog::conformance::generator {

/// @brief The boundary-value problem of a question's scene, its numbers taken as exact.
/// @param q  the question
/// @return   matrices in the number type
template <class T>
[[nodiscard]] HalfPeriodProblem<T> problem_of(const ProtocolQuestion& q);
/// @brief In 50 digits. @param q the question @return the problem
template <>
[[nodiscard]] HalfPeriodProblem<Real50> problem_of(const ProtocolQuestion& q);
/// @brief In 100 digits. @param q the question @return the problem
template <>
[[nodiscard]] HalfPeriodProblem<Real100> problem_of(const ProtocolQuestion& q);

} // namespace denhartog::conformance::generator

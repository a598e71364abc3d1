/// @file
/// @brief Numbers of vectors as text, and on how many digits two of them agree.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/support/multiprecision.hpp"

namespace denhartog::conformance::generator {

/// @brief A number rounded to some significant digits, zeros at their end left out.
template <class T>
[[nodiscard]] std::string text_of_digits(const T& x, int digits);

/// @brief A number rounded to 2 significant digits. @param x the number @return the double nearest to them
[[nodiscard]] double two_digits(const Real50& x);

/// @brief Digits on which two lists of numbers agree: of every number its own, of what counts as zero those of the largest.
/// Angles are compared round the circle, absolutely. None where the lists differ in length or hold what is no number.
template <class T>
[[nodiscard]] std::optional<int> agreement(const std::vector<T>& a, const std::vector<T>& b, bool angle);

/// @brief Largest size of a list's numbers. @param x the numbers @return the size; 1 where all are zero
template <class T>
[[nodiscard]] T scale_of(const std::vector<T>& x);

} // namespace denhartog::conformance::generator

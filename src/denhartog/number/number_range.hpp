/// @file
/// @brief The range in which numbers are read from text and written as text.
#pragma once

#include <cmath>
#include <concepts>
#include <cstdlib>

namespace denhartog {

/// @brief Largest binary exponent of a number of 50 or 100 digits, about 1e4997: the decimal exponent of its text is read again.
inline constexpr int largest_binary_exponent = 16600;

/// @brief Whether a number can be written as text and read again. A double can where it is finite. @param x a finite number
/// @return whether it can
template <class T>
[[nodiscard]] bool in_range_of_text(const T& x) {
    if constexpr (std::floating_point<T>) return true;
    return x == 0 || std::abs(static_cast<int>(ilogb(x))) <= largest_binary_exponent;
}

} // namespace denhartog

/// @file
/// @brief A number of an answer: a double with a bound of its error and, where more than 15 digits were asked for, its decimals.
#pragma once

#include <string>

namespace denhartog {

/// @brief The most significant digits that a double holds for certain.
constexpr int most_digits_of_a_double = 15;

/// @brief A number of an answer.
struct Certified {
    double value = 0;      ///< the number
    double error = 0;      ///< bound of its error: of the decimals where there are some, else of the value, its rounding included
    std::string decimal{}; ///< its decimals; empty where a double was asked for
};

} // namespace denhartog

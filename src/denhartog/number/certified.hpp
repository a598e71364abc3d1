/// @file
/// @brief A number of an answer: a double with a bound of its error and, if you ask for more than 15 digits, its decimals.
#pragma once

#include <string>

namespace denhartog {

/// @brief The largest number of significant decimal digits that every double holds.
constexpr int most_digits_of_a_double = 15;

/// @brief A number of an answer.
struct Certified {
    double value = 0;      ///< the number, rounded to a double
    double error = 0;      ///< absolute bound of the error of `decimal`; if that is empty, of `value`, rounding included
    std::string decimal{}; ///< the number with the digits asked for, as text; empty up to 15 digits
    bool proved = false;   ///< whether a proof stands behind the bound; else it is an estimate, docs/promises.md
};

} // namespace denhartog

/// @file
/// @brief Digits of a number, by its truth.
#pragma once

#include <cmath>

#include "tests/support/multiprecision.hpp"

namespace denhartog::tests {

/// @brief Correct digits of a double. @param value the double @param truth what it should be @return the digits, 16 if exact
inline double digits_of(double value, const Real100& truth) {
    const double error = static_cast<double>(abs(Real100(Real100(value) - truth)) / abs(truth));
    return error == 0 ? 16 : -std::log10(error);
}

} // namespace denhartog::tests

/// @file
/// @brief The verdict on an answer.
#pragma once

#include "conformance/verdict.hpp"

namespace denhartog::conformance {

/// @brief Largest difference between two values of one question.
struct Difference {
    double size = 0;       ///< angles are compared round the circle if they are in (-pi, pi], curves by `curve_deviation`
    std::size_t worst = 0; ///< index of the number where it is, from 0
};

/// @brief Largest size of some numbers. @param numbers any numbers @return the largest |x|; 0 if there are none
[[nodiscard]] double size_of(const std::vector<double>& numbers);

/// @brief Largest difference between two lists of numbers, measured as the quantity demands.
/// @param asked      the quantity
/// @param given      numbers
/// @param reference  as many numbers
/// @return           the difference
[[nodiscard]] Difference difference(const Quantity& asked, const std::vector<double>& given,
                                    const std::vector<double>& reference);

/// @brief The verdict on an answer. `as-printed` is not among its results: `diagnose` gives it.
/// @param v       the vector
/// @param answer  the answer to its question
/// @return        the verdict with the error; refers to `v`
[[nodiscard]] Judged grade(const Vector& v, const Answer& answer);

} // namespace denhartog::conformance

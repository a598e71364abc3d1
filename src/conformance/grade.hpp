/// @file
/// @brief The verdict on an answer.
#pragma once

#include "conformance/verdict.hpp"

namespace denhartog::conformance {

/// @brief Largest difference between two values of one question.
struct Difference {
    double size = 0;       ///< angles round the circle but for those outside (-pi, pi], curves by `curve_deviation`
    std::size_t worst = 0; ///< which number
};

/// @brief Largest of some sizes. @param numbers any numbers @return the largest |x|; 0 of none
[[nodiscard]] double size_of(const std::vector<double>& numbers);

/// @brief Largest difference of numbers from others, in the way of a quantity.
/// @param asked      the quantity
/// @param given      numbers
/// @param reference  as many numbers
/// @return           the difference
[[nodiscard]] Difference difference(const Quantity& asked, const std::vector<double>& given,
                                    const std::vector<double>& reference);

/// @brief The verdict on an answer, without what only known mistakes tell: `as-printed` comes from `diagnose`.
/// @param v       the vector
/// @param answer  the answer to its question
/// @return        the verdict with the error; refers to `v`
[[nodiscard]] Judged grade(const Vector& v, const Answer& answer);

} // namespace denhartog::conformance

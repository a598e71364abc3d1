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

/// @brief Largest deviation of a motion from the true one, both sampled at equal steps over one period.
///
/// At most samples the deviation is the difference of the two. Around an event the samples do not resolve the motion. There the
/// deviation is the least distance to the true motion within half a step, taken as linear between its samples. A sample is at an
/// event if the true second difference, which stands for the acceleration, changes by more than a quarter of its largest size
/// between neighbouring samples. The half step is allowed nowhere else, as it would pass a motion that is late by half a step.
/// @param given      the motion to be judged
/// @param reference  the true one; as many samples
/// @return           the deviation, in the units of the curves
[[nodiscard]] Difference curve_deviation(const std::vector<double>& given, const std::vector<double>& reference);

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

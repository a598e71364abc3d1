/// @file
/// @brief How far a sampled motion is from the true one.
#pragma once

#include <cstddef>
#include <vector>

namespace denhartog::conformance {

/// @brief The largest deviation of a curve.
struct CurveDeviation {
    double deviation = 0;   ///< in the units of the curves
    std::size_t sample = 0; ///< index of the sample where it is, from 0
};

/// @brief Largest deviation of a motion from the true one, both sampled at equal steps over one period.
///
/// At most samples the deviation is the difference of the two. Around an event the samples do not resolve the motion. There the
/// deviation is the least distance to the true motion within half a step, taken as linear between its samples. A sample is at an
/// event if the true second difference, which stands for the acceleration, changes by more than a quarter of its largest size
/// between neighbouring samples. The half step is allowed nowhere else, as it would pass a motion that is late by half a step.
/// @param given      the motion to be judged
/// @param reference  the true one; as many samples
/// @return           the deviation
[[nodiscard]] CurveDeviation curve_deviation(const std::vector<double>& given, const std::vector<double>& reference);

} // namespace denhartog::conformance

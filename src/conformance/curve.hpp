/// @file
/// @brief How far a sampled motion is from the true one.
#pragma once

#include <cstddef>
#include <vector>

namespace denhartog::conformance {

/// @brief The largest deviation of a curve.
struct CurveDeviation {
    double deviation = 0;   ///< in the units of the curves
    std::size_t sample = 0; ///< where it is, from 0
};

/// @brief Largest deviation of a motion from the true one, both sampled at equal steps over one period.
///
/// At a sample it is the difference. Around an event the samples do not resolve the motion, and the motion has a tube there: the
/// deviation is the least distance to the true motion over the instants within half a step, which is taken to be linear between
/// its samples. A sample is at an event where the true second difference, the acceleration, changes by more than a quarter of its
/// largest size from the sample before to it or from it to the next. Elsewhere there is no tube: one everywhere would pass a
/// motion that is late by half a step.
/// @param given      the motion to be judged
/// @param reference  the true one; as many samples
/// @return           the deviation
[[nodiscard]] CurveDeviation curve_deviation(const std::vector<double>& given, const std::vector<double>& reference);

} // namespace denhartog::conformance

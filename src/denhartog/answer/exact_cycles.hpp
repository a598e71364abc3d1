/// @file
/// @brief The exact solver asked as the paper's algorithm is: the same start, the same number of periods, the same outcome.
#pragma once

#include "denhartog/answer/scene_source.hpp"
#include "denhartog/paper_algorithm/paper_algorithm.hpp"

namespace denhartog {

/// @brief The motion over a number of periods in closed form from phase to phase, read off as the paper reads its own.
///
/// Tolerances, step limit, limit of phases and history do not apply. The phase is the instant of the largest |x_k|, half a
/// period on where x_k is negative there.
/// @eq{6,74,75}
/// @param source    the scene, with r and beta
/// @param settings  number of periods, start, samples
/// @return          the motion, or a status with its reason; of the counters `phases` alone
/// @throws          InputError where scene or settings break a rule
[[nodiscard]] PaperMotion exact_cycles(const SceneSource& source, const PaperSettings& settings);

} // namespace denhartog

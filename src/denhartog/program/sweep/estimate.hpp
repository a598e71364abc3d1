/// @file
/// @brief What a study will cost, from a sample of its points.
#pragma once

#include <nlohmann/json.hpp>

#include "denhartog/sweep/plan.hpp"

namespace denhartog::program {

/// @brief Measures some columns spread over the study, for some seconds at most.
/// @param plan  the plan
/// @return      points measured, seconds a point (mean, least and most among the places), hours of one core, bytes
[[nodiscard]] nlohmann::ordered_json estimate_of(const sweep::Plan& plan);

} // namespace denhartog::program

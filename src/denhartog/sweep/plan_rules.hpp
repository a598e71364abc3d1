/// @file
/// @brief The rules of a study that depend on several of its parts; used by `plan_of` alone.
#pragma once

#include "denhartog/sweep/plan.hpp"

namespace denhartog::sweep {

/// @brief Checks that every point has one frequency and one friction. @param study the study
/// @throws InputError where it has none, two, or both kinds of units
void check_columns(const Study& study);

/// @brief Checks what reductions are of and over. @param plan the plan; its chunks are not needed
/// @throws InputError naming the reduction
void check_reductions(const Plan& plan);

/// @brief Checks that every value of every axis makes a scene, with all else as the scene has it; a sample that makes none has
/// points with a status that says so. @param plan the plan @throws InputError as a scene has it
void check_scenes(const Plan& plan);

} // namespace denhartog::sweep

/// @file
/// @brief Closed form against second witness on the paper's scenes and on seeded ones.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>

namespace denhartog::derivation {

/// @brief Compares the two routes in double and in 50 digits.
///
/// The error of a scene is the largest of: displacement at 65 instants, initial displacement and velocity and amplitude of every
/// mass, each over the amplitude of that mass, and the phase of the mass in contact in radians.
/// @param workers  how many processes share the scenes
/// @return         an array, an object for each group: group, scenes, worst of double and of 50 digits with their scenes, faults
[[nodiscard]] nlohmann::json agreement_with_second_witness(std::size_t workers);

} // namespace denhartog::derivation

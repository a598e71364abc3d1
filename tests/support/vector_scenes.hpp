/// @file
/// @brief Random scenes whose contact is between two masses or whose load acts on several.
#pragma once

#include "tests/support/sample_scenes.hpp"

namespace denhartog {

/// @brief Those of `random_scenes`, each with a contact between two masses, a force on each mass, a load by inertia, or two of
/// these; a single mass with a force other than 1: 534 in all. Forces are multiples of 1/8.
[[nodiscard]] std::vector<RandomScene<double>> random_vector_scenes(std::uint64_t seed);

} // namespace denhartog

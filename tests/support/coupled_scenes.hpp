/// @file
/// @brief Random scenes whose dashpots couple the modes.
#pragma once

#include "tests/support/sample_scenes.hpp"

namespace denhartog {

/// @brief Those of `random_vector_scenes` with dashpots in place of their damping: between neighbours and to the ground, a third
/// of them missing, from a hundredth to a multiple of what makes a mode critical. Every other one has mu = 1, every third the
/// contact to a wall and the load on one mass.
[[nodiscard]] std::vector<RandomScene<double>> random_coupled_scenes(std::uint64_t seed);

} // namespace denhartog

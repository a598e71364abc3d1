/// @file
/// @brief Random scenes of other kinds than a chain with one contact and one load: the contact is between two masses or has any
/// direction, the load acts on several masses or out of phase, the base moves, or dashpots couple the modes.
#pragma once

#include "tests/support/sample_scenes.hpp"

namespace denhartog {

/// @brief Those of `random_scenes`, each with a contact between two masses, a force on each mass, a load by inertia, or two of
/// these; a single mass with a force other than 1: 534 in all. Forces are multiples of 1/8.
[[nodiscard]] std::vector<RandomScene<double>> random_vector_scenes(std::uint64_t seed);

/// @brief Those of `random_vector_scenes`, each with a force on two masses or more, if it has as many, and a phase for each
/// force: 534 in all. Phases are multiples of 1/8 from -4 to 4.
[[nodiscard]] std::vector<RandomScene<double>> random_phased_scenes(std::uint64_t seed);

/// @brief Those of `random_scenes` on a base that moves alone, or with the wall, or with a wall that moves alone, one in three each;
/// the contact of one in four of the first two is between two masses. A single mass without damping is left out.
[[nodiscard]] std::vector<RandomScene<double>> random_base_scenes(std::uint64_t seed);

/// @brief Those of `random_vector_scenes` and, every second one, of `random_phased_scenes`, each with a direction of the contact in
/// place of its masses: entries are multiples of 1/8 from -2 to 2, one in three is zero, that of the mass in contact is 1/2, 1 or 2
/// in size, and that of a neighbour is not zero. Single masses are left out.
[[nodiscard]] std::vector<RandomScene<double>> random_direction_scenes(std::uint64_t seed);

/// @brief Those of `random_vector_scenes` with dashpots in place of their damping: between neighbours and to the ground, a third
/// of them missing, from a hundredth to a multiple of what makes a mode critical. Every other one has mu = 1, every third the
/// contact to a wall and the load on one mass.
[[nodiscard]] std::vector<RandomScene<double>> random_coupled_scenes(std::uint64_t seed);

} // namespace denhartog

/// @file
/// @brief Questions on seeded scenes for the tests of the conformance kit.
#pragma once

#include <cstdint>
#include <vector>

#include "conformance/question.hpp"

namespace denhartog::tests {

/// @brief Scenes of chains with unequal masses, springs and damping ratios, mu above 1, contact and load anywhere.
///
/// All numbers are short binary fractions. Two thirds of the scenes slide, the others stop or rest. A question a scene, of the
/// amplitude of a mass; the same seed gives the same questions.
[[nodiscard]] std::vector<conformance::ProtocolQuestion> seeded_questions(std::uint64_t seed, int count);

/// @brief Systems beyond the paper: in turn a contact between two masses, several loads, a base that moves, dashpots; then as
/// many with, in turn, loads out of phase, a base that moves alone and is damped, a wall that moves alone, base and wall.
///
/// Half of them slide, the others stop or rest. They have no fewer than two masses. There are twice as many as `count`: a
/// question a system, of the amplitude of a mass; the same seed gives the same questions.
[[nodiscard]] std::vector<conformance::ProtocolQuestion> seeded_systems(std::uint64_t seed, int count);

} // namespace denhartog::tests

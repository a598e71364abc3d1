/// @file
/// @brief Seeded systems as people give them: kilograms, newtons per metre, dashpots, bases that shake, contacts between floors.
///
/// One to eight masses in a chain, or with further springs and with inertia that couples neighbours, as matrices. In half of the
/// systems some masses are light, down to 1e-10 of the others: the joints and sensors of a model that nobody thinned out.
#pragma once

#include "tests/support/adversarial_scenes.hpp"

namespace denhartog {

/// @brief A system read from the text of a scene in units, and where it is to stand.
[[nodiscard]] AdversarialScene scene_in_units(SplitMix64& random);

} // namespace denhartog

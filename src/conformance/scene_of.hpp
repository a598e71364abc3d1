/// @file
/// @brief The scene of a question, as the library has it.
#pragma once

#include "conformance/question.hpp"
#include "denhartog/scene/scene.hpp"

namespace denhartog::conformance {

/// @brief The scene of a question, its numbers taken as exact.
/// @param q  the question
/// @return   the scene, checked; a moving base as the load that it is
/// @throws   InputError if a number breaks a rule of the scene, or the scene does not have the mass asked about
[[nodiscard]] Scene<double> scene_of(const ProtocolQuestion& q);

} // namespace denhartog::conformance

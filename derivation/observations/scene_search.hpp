/// @file
/// @brief Searches over the sliding scenes: the paper's own, and seeded ones.
#pragma once

#include <functional>
#include <string>

#include "derivation/observations/observation.hpp"
#include "derivation/observations/sliding_scenes.hpp"

namespace denhartog::derivation {

/// @brief A scene as witness. @param s a scene @return name, N, r, beta, mu
[[nodiscard]] Witness place_of(const SlidingScene& s);

/// @brief Looks for the scene with the largest excess over what a statement allows.
/// @param excess     of a scene; not a number where the statement does not speak of it
/// @param tolerance  what rounding may make of none
/// @param witness    what is to be said of the worst scene
/// @param what       what a counterexample is
/// @return           refuted with the worst scene, or unknown; with the number of cases
[[nodiscard]] Outcome refute_by_largest(const std::function<double(const SlidingScene&)>& excess, double tolerance,
                                        const std::function<Witness(const SlidingScene&)>& witness, const std::string& what);

/// @brief A statement with a vague word and a number chosen for it: noted with the number at which the verdict turns.
/// @param excess     of a scene; not a number where the statement does not speak of it
/// @param threshold  what is compared, the number taken, and the one at which the statement is empty
/// @param witness    what is to be said of the worst scene
/// @param what       what a counterexample is
/// @return           refuted with the worst scene, or unknown; with the number of cases
[[nodiscard]] Outcome refute_by_largest(const std::function<double(const SlidingScene&)>& excess, const Threshold& threshold,
                                        const std::function<Witness(const SlidingScene&)>& witness, const std::string& what);

} // namespace denhartog::derivation

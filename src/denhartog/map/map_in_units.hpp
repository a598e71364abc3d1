/// @file
/// @brief A map over the frequency in periods a unit of time and the friction force, in the units of the scene.
#pragma once

#include <vector>

#include "denhartog/map/regime_map.hpp"

namespace denhartog {

/// @brief Frequencies of a map, with the force at each.
struct FrequenciesInUnits {
    std::vector<double> hertz; ///< periods a unit of time
    std::vector<double> r;     ///< frequency ratios, Eq. (10)
    std::vector<double> force; ///< P; where the base moves with the wall it grows with the frequency
};

/// @brief Frequencies in the units of a scene of masses, stiffnesses and a force, with their ratios; InputError if the scene
/// lacks units or force, or a frequency is not positive.
[[nodiscard]] FrequenciesInUnits frequencies_in_units(const Scene<double>& scene, const std::vector<double>& hertz);

/// @brief A map with amplitudes in the scene's unit of length. One beyond the range of a double leaves its point `failed`. Its
/// rows are friction forces; r and beta of the request are not used; `done` is told the number of columns done after each.
/// InputError where a friction force is negative, or what `regime_map` throws.
[[nodiscard]] RegimeMap map_in_units(const Scene<double>& scene, const FrequenciesInUnits& frequencies,
                                     const std::vector<double>& friction, MapRequest request, const std::atomic<bool>& stop,
                                     const std::function<void(std::size_t done)>& done);

/// @brief Boundary curves as friction forces, a point for each frequency.
[[nodiscard]] std::vector<BoundaryPoint> curves_in_units(const Scene<double>& scene, const FrequenciesInUnits& frequencies);

} // namespace denhartog

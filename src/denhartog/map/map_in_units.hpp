/// @file
/// @brief A map over the frequency and the friction force, or the level of the load, in the units of the scene.
#pragma once

#include <string>
#include <vector>

#include "denhartog/map/regime_map.hpp"

namespace denhartog {

/// @brief Frequencies of a map, with the force at each.
struct FrequenciesInUnits {
    std::vector<double> r;     ///< frequency ratios, Eq. (10)
    std::vector<double> force; ///< P; where the base moves with the wall, or of an unbalance, it grows with the frequency
};

/// @brief What varies in the rows of a map in units.
enum class RowsOf : std::uint8_t {
    friction, ///< the friction force
    force,    ///< the amplitude of the load, with the friction of the scene
    unbalance ///< the unbalance that makes the load, with the friction of the scene
};

/// @brief Frequencies of a scene of masses, stiffnesses and a force, with their ratios: `frequency` in radians a unit of time, or
/// `frequency_hz` in periods. InputError if the scene lacks units or force, or a frequency is not positive.
[[nodiscard]] FrequenciesInUnits frequencies_in_units(const Scene<double>& scene, const std::string& quantity,
                                                      const std::vector<double>& values);

/// @brief A map with amplitudes in the scene's unit of length. One beyond the range of a double leaves its point `failed`. Its
/// rows are what `of` says; r and beta of the request are not used; `done` is told the number of columns done after each.
/// InputError where a friction force is negative, a level not positive, or the scene has no such load or no friction; or what
/// `regime_map` throws.
[[nodiscard]] RegimeMap map_in_units(const Scene<double>& scene, const FrequenciesInUnits& frequencies, RowsOf of,
                                     const std::vector<double>& rows, MapRequest request, const std::atomic<bool>& stop,
                                     const std::function<void(std::size_t done)>& done);

/// @brief Boundary curves as friction forces, a point for each frequency.
[[nodiscard]] std::vector<BoundaryPoint> curves_in_units(const Scene<double>& scene, const FrequenciesInUnits& frequencies);

} // namespace denhartog

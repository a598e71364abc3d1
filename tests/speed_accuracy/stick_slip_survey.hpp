/// @file
/// @brief The exact solver against the paper's algorithm, in stick-slip.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "denhartog/scene/scene.hpp"
#include "tests/speed_accuracy/table.hpp"

namespace denhartog::tests {

/// @brief A scene in stick-slip.
struct StickSlipScene {
    std::string name;    ///< unique
    Scene<double> scene; ///< complete; numbers are short binary fractions
};

/// @brief Seeded random systems with friction between the boundary (69) and that of permanent sticking, the start from rest
/// leading to stick-slip; N from 1 to 6, every second with mu = 1.
[[nodiscard]] std::vector<StickSlipScene> stick_slip_scenes(int scenes, std::uint64_t seed);

/// @brief Differences over all scenes.
struct StickSlipSurvey {
    Worst amplitude;                      ///< amplitudes, relative to that of the mass
    Worst mixed;                          ///< amplitudes, over 1 plus the amplitude, as tolerances are: an amplitude can be tiny
    Worst event;                          ///< starts and ends of stops, radians
    Worst state;                          ///< the state at the end, over the largest displacement or velocity
    int stops = 0;                        ///< stops compared
    int most_stops = 0;                   ///< most stops in a period
    std::vector<std::string> differently; ///< scenes with another number of stops, or without an answer
};

/// @brief The motion from rest over a number of periods by both: last period's amplitudes and stops, and the state at the end.
/// The tolerance of the paper's algorithm is absolute and relative, here and below.
[[nodiscard]] StickSlipSurvey from_rest(const std::vector<StickSlipScene>& scenes, int periods, double tolerance);

/// @brief Periodic orbits of the exact solver: the paper's algorithm, started on one, has to stay there. The differences are
/// those after two of the orbit's periods.
[[nodiscard]] StickSlipSurvey on_orbits(const std::vector<StickSlipScene>& scenes, double tolerance);

/// @brief A survey as a row of a table. @param what what was compared @param s the survey @return the row
[[nodiscard]] std::vector<std::string> row_of(const std::string& what, const StickSlipSurvey& s);

/// @brief Names of the columns of `row_of`. @return the head
[[nodiscard]] std::vector<std::string> stick_slip_head();

} // namespace denhartog::tests

/// @file
/// @brief Where a number of cycles from rest is not the steady state.
#pragma once

#include <string>
#include <vector>

#include "denhartog/scene/scene.hpp"
#include "tests/speed_accuracy/table.hpp"

namespace denhartog::tests {

/// @brief The error left after a number of cycles, at one frequency ratio.
struct CyclesError {
    double r = 0;         ///< frequency ratio
    double contact = 0;   ///< of the amplitude of the mass in contact, relative
    double others = 0;    ///< of the amplitude of any mass, relative; the largest
    double amplitude = 0; ///< steady amplitude of the mass in contact
};

/// @brief The errors over a range of frequency ratios.
struct CyclesSurvey {
    std::string name;                ///< the system
    double zeta = 0;                 ///< damping ratio
    double beta = 0;                 ///< friction ratio
    std::vector<CyclesError> errors; ///< ascending in r
    int stuck = 0;                   ///< points where the contact rests for ever; left out
    int unanswered = 0;              ///< points without a periodic orbit; left out
};

/// @brief Amplitudes in the last of a number of cycles from rest, by the exact solver, against the periodic orbit; mu = 1. The
/// system has a name and its damping ratio as named; the cycles are those from rest, e.g. the paper's 200.
[[nodiscard]] CyclesSurvey survey_cycles(const std::string& name, const System<double>& system, double zeta, double beta,
                                         const std::vector<double>& r, int cycles);

/// @brief The largest error. @param s a survey @return the point where the contact's error is largest
[[nodiscard]] const CyclesError& worst(const CyclesSurvey& s);

/// @brief The surveys as a table. @param all surveys @param cycles cycles from rest @return a row each
[[nodiscard]] Table table_of(const std::vector<CyclesSurvey>& all, int cycles);

} // namespace denhartog::tests

/// @file
/// @brief Surveys of regimes, of motions with stops, and of cycles from rest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "denhartog/scene/scene.hpp"
#include "tests/speed_accuracy/table.hpp"

namespace denhartog::tests {

/// @brief How the two answers at a point go together. All but the first and the last two were verified by a further motion.
enum class Comparison {
    agree,           ///< the same regime
    on_boundary,     ///< beta is within 1e-9 of a boundary
    several_motions, ///< the formula's motion is there, and rest leads to another one: mu > 1 or a mode without damping
    never_settles,   ///< rest leads to no periodic motion in the time allowed: mu > 1 or a mode without damping
    turns,           ///< sliding without a stop, but it turns back more than twice a period
    asymmetric,      ///< sliding without a stop that does not mirror itself after half a period
    pole,            ///< a mode without damping resonates: there is no boundary
    unexplained      ///< none of these
};

/// @brief What to call a comparison. @param c the comparison @return a phrase
[[nodiscard]] std::string name(Comparison c);

/// @brief The points compared, and counts.
struct RegimeSurvey {
    int points = 0;                                   ///< points
    std::map<std::pair<bool, Comparison>, int> count; ///< unique steady velocities or not; comparison
    std::map<Comparison, std::string> example;        ///< the first point of each kind
    std::map<std::string, int> regimes;               ///< agreements by regime
    std::vector<std::string> unexplained;             ///< all that are
};

/// @brief Compares seeded points: random systems, half of them with mu = 1, friction up to 1.25 times the upper boundary. Systems
/// have at most 10 masses. After `most_periods` of propagation a motion is taken not to settle; ten times as many where the
/// steady velocities are unique.
[[nodiscard]] RegimeSurvey survey_regimes(int points, std::size_t most_masses, int most_periods, std::uint64_t seed);

/// @brief The survey as tables. @param s the survey @return counts by kind
[[nodiscard]] Table table_of(const RegimeSurvey& s);

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

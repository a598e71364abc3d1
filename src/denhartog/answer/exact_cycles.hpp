/// @file
/// @brief The exact solver asked as the paper's algorithm is: the same start, the same number of periods, the same outcome.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "denhartog/answer/scene_source.hpp"
#include "denhartog/number/number.hpp"
#include "denhartog/paper_algorithm/paper_algorithm.hpp"

namespace denhartog {

/// @brief The motion over a number of periods in closed form from phase to phase, read off as the paper reads its own.
///
/// Tolerances, step limit, limit of phases and history do not apply. The phase is the instant of the largest |x_k|, half a
/// period on where x_k is negative there.
/// @eq{6,74,75}
/// @param source    the scene, with r and beta
/// @param settings  number of periods, start, samples
/// @return          the motion, or a status with its reason; of the counters `phases` alone
/// @throws          InputError where scene or settings break a rule
[[nodiscard]] PaperMotion exact_cycles(const SceneSource& source, const PaperSettings& settings);

/// @brief What is wanted of the history of a motion.
struct HistorySettings {
    int cycles = 200;                 ///< periods over which the motion is followed, from tau = 0; from 1 to 1000000
    std::optional<int> last{};        ///< how many of these the history has, at the end; none is all of them
    State start{};                    ///< displacements and velocities at tau = 0, where the force is largest
    int samples = 0;                  ///< instants in a period at which the state is wanted, equally spaced; none where 0
    bool without_load = false;        ///< whether the harmonic load is taken away, so that P is no more than a unit
    double period = 2 * pi<double>(); ///< what counts as a period; that of the force. Radians
};

/// @brief A stop in the history of a motion.
struct HistoryStop {
    double start;              ///< tau where the contact comes to rest, counted from the start of the motion
    std::optional<double> end; ///< tau where it breaks away again; none where the motion was followed no further
    double x;                  ///< the displacement at which it rests, in units of P / k_1
};

/// @brief A motion from a start over its periods, or the last of them. Its errors are not known.
struct MotionHistory {
    IntegrationStatus status = IntegrationStatus::complete; ///< whether the end was reached; if not, nothing else is there
    std::string reason;                                     ///< why not
    int periods = 0;                                        ///< periods that the history has
    double from = 0;                                        ///< tau at its start, counted from the start of the motion
    std::vector<HistoryStop> stops;                         ///< every stop that ends in it or lasts to its end, in order
    std::vector<double> times;                              ///< the instants asked for, counted from the start of the motion
    std::vector<State> states;                              ///< the states at these
    std::vector<int> directions; ///< there, 1 or -1 as the contact slides, 0 where it sticks; at an event what was before it
};

/// @brief The history of a motion over a number of periods, in closed form from phase to phase.
/// @eq{6,74,75}
/// @param source    the scene, with r and beta
/// @param settings  start, number of periods, samples
/// @return          the history, or a status with its reason
/// @throws          InputError where scene or settings break a rule; PrecisionError where double does not tell the displacement of
///                  a contact between two masses
[[nodiscard]] MotionHistory motion_history(const SceneSource& source, const HistorySettings& settings);

} // namespace denhartog

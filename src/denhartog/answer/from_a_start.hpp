/// @file
/// @brief Motions from a start: the exact solver asked as the paper's algorithm is, with the same start, the same number of
/// periods and the same outcome; and how a motion comes to rest after its harmonic load is taken away, which the reference
/// proves.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "denhartog/answer/scene_source.hpp"
#include "denhartog/answer/solution.hpp"
#include "denhartog/number/certified.hpp"
#include "denhartog/number/number.hpp"
#include "denhartog/paper_algorithm/paper_algorithm.hpp"
#include "denhartog/stick_slip/motion_record.hpp"

namespace denhartog {

/// @brief The motion over a number of periods in closed form from phase to phase, read off as the paper reads its own, or a
/// status with its reason. Tolerances, limits and history of the settings do not apply; of the counters there is `phases` alone.
/// The phase is the instant of the largest |x_k|, half a period on where x_k is negative there. @eq{6,74,75}
[[nodiscard]] PaperMotion exact_cycles(const SceneSource& source, const PaperSettings& settings);

/// @brief The part of the history of a motion that is wanted.
struct HistorySettings {
    int cycles = 200;                 ///< periods over which the motion is followed, from tau = 0; from 1 to 1000000
    std::optional<int> last{};        ///< the number of these that the history has, at the end; none is all of them
    State start{};                    ///< displacements and velocities at tau = 0, where the force is largest
    int samples = 0;                  ///< instants in a period at which the state is wanted, equally spaced; none where 0
    bool without_load = false;        ///< whether the harmonic load is taken away, so that P is no more than a unit
    double period = 2 * pi<double>(); ///< the length of a period; that of the force. Radians
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

/// @brief The history of a motion over a number of periods, in closed form from phase to phase, or a status with its reason.
/// PrecisionError where double does not tell the displacement of a contact between two masses. @eq{6,74,75}
[[nodiscard]] MotionHistory motion_history(const SceneSource& source, const HistorySettings& settings);

/// @brief The places to which the constant load of a scene moves the masses, about which every steady motion is the one without
/// it.
/// \f[ \bar{\mathbf x}_s = \mathbf K^{-1}\mathbf s \f]
///
/// With \f$ \bar{\mathbf x} = \bar{\mathbf x}_s+\mathbf y \f$ the constant load s drops out of (6). Friction depends on the
/// velocity of the contact, and at rest on all other forces on it, (2), (3), (74), (75): both are the same functions of y as they
/// were of x without s. So y is a motion without the constant load, in every regime, with the same stops at the same instants. In
/// units of P / k_1, proved; none without a constant load. PrecisionError where the stiffness matrix is not proved regular.
/// @eq{6,74,75}
[[nodiscard]] std::vector<Certified> place_of_rest(const SceneSource& source);

/// @brief The end of a half-cycle, proved.
using DecayTurn = TurnOf<Certified>;

/// @brief The way of a motion without a load to rest, proved.
using FreeDecay = FreeDecayOf<Certified>;

/// @brief The motion of a scene from a start after its harmonic load is taken away, until the contact rests for good, or `until`
/// an instant; the constant load stays. Where nothing damps the other masses they may set the contact in motion again and again.
/// beta is positive; P and the frequency are no more than units. PrecisionError where something cannot be proved. @eq{6,74,75}
[[nodiscard]] FreeDecay free_decay(const SceneSource& source, const State& start, const std::optional<double>& until = {});

} // namespace denhartog

/// @file
/// @brief The chart: time of an answered question against digits got, for every method on every scene.
#pragma once

#include <map>

#include "tests/speed_accuracy/chart_truth.hpp"

namespace denhartog::tests {

/// @brief How a method can fail at a point, by name; an answer with another opinion on sticking than the truth is one of them.
/// They come in the order of `ChartRow::failures`.
[[nodiscard]] const std::array<std::string, 5>& failure_names();

/// @brief A method at one setting on one scene.
struct ChartRow {
    std::string scene;             ///< the scene
    std::string method;            ///< the method
    std::string setting;           ///< its setting
    double asked = 0;              ///< tolerance asked for, 0 where the setting is not one
    bool present = true;           ///< whether the method was there to be measured
    int points = 0;                ///< points of the scene
    int right = 0;                 ///< points answered, in the right regime
    std::array<int, 5> failures{}; ///< points failed, as `failure_names`; time that ran out is `did not finish`
    double worst = 0;              ///< largest relative error where right and the contact moves
    double median = 0;             ///< median of these
    double setup = 0;              ///< microseconds to prepare for a system
    double time = 0;               ///< microseconds a point, median over the points answered; over all where none was
    double longest = 0;            ///< microseconds of the slowest point
    long evaluations = 0;          ///< the method's own units of work, median over the points
    int repeats = 0;               ///< runs of which the median was taken, at the fastest point
};

/// @brief A scene with the truth at its points and the limits of any method.
struct ChartGround {
    ChartScene scene;              ///< the scene
    std::vector<ChartTruth> truth; ///< at every point
    double condition_worst = 0;    ///< largest condition number over the points
    double condition_median = 0;   ///< their median
    double bare = 0;               ///< microseconds of one exponential, sine and cosine a mode
};

/// @brief Finds the truth at the points of a scene and its limits. @param scene the scene @return both
[[nodiscard]] ChartGround ground_of(const ChartScene& scene);

/// @brief Runs a method over a scene. Setup and every point are timed apart, in processor time. After so many seconds as the
/// budget has no further point is begun.
[[nodiscard]] ChartRow measure(const Peer& peer, const ChartGround& ground, double budget);

/// @brief Digits that an error leaves. @param error relative @return at least 0
[[nodiscard]] double digits_left(double error);

/// @brief Whether a method was right at every point of its scene. @param row the row @return true where it failed nowhere
[[nodiscard]] bool right_everywhere(const ChartRow& row);

/// @brief The fastest at a number of digits on a scene: right at every point, with these digits at the worst. The error may be 5
/// in the next digit, which is what rounding to so many leaves. The setup counts for a single question, and not for one more of
/// many. `counts` tells which methods count. Null where nobody has the digits.
[[nodiscard]] const ChartRow* fastest(const std::vector<ChartRow>& rows, const std::string& scene, double digits, bool with_setup,
                                      const std::function<bool(const ChartRow&)>& counts);

} // namespace denhartog::tests

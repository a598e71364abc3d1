/// @file
/// @brief The chart of speed against accuracy: its scenes, the truth at their points, methods over them, and the tables of all.
#pragma once

#include <cstdint>
#include <map>

#include "denhartog/sliding/boundary.hpp"
#include "tests/speed_accuracy/peers/peer.hpp"
#include "tests/speed_accuracy/table.hpp"

namespace denhartog::tests {

/// @brief The chart's scenes.
///
/// SDOF, sliding: zeta = 0.1, r from 0.3 to 2.5, beta below the boundary (69). SDOF, stick-slip: zeta = 0.01, r = 0.1, beta
/// between the boundary and 0.95. 2DOF: the paper's with zeta_i = 0.01/r_n,i, beta = 0.3, r from 0.1 to 3 in equal steps, through
/// all regimes, twice as many points. 5DOF: the paper's with j = 3, l = 1, zeta = 0.1; N = 50: equal masses and springs, j = 10,
/// l = 1, zeta = 0.05, a quarter as many points; in both r from 0.3 to 1.9, beta below the boundary. What is not said is drawn at
/// random. There is at least one point a scene; the same seed gives the same points everywhere.
[[nodiscard]] std::vector<ChartScene> chart_scenes(std::uint64_t seed, int points);

/// @brief The truth at a point.
struct ChartTruth {
    Regime regime = Regime::continuous; ///< the regime
    PeerAnswer answer;                  ///< X_j to 40 digits, certain to `solve`
    double condition = 0;               ///< relative change of X_j over that of r and of beta, both added
};

/// @brief The truth at a point: `solve` asked for 40 digits, which it takes from two precisions or from a residual; its change
/// with r and beta by central differences.
[[nodiscard]] ChartTruth truth_at(const System<double>& system, const ChartPoint& point);

/// @brief Distance of an answer from the truth, relative, in 100 digits. Where the contact rests for ever its place is not asked
/// for: zero. It is at least 1e-36, which is as far as the truth is trusted.
[[nodiscard]] double error_of(const PeerAnswer& answer, const ChartTruth& truth);

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

/// @brief What a run was made with.
struct ChartRun {
    std::uint64_t seed = 0; ///< seed of the points
    std::string version;    ///< version of the source
    std::string compiler;   ///< compiler and its options
    std::string processor;  ///< the processor
};

/// @brief The processor as the system names it. @return its name, or that it is not known
[[nodiscard]] std::string processor_name();

/// @brief The rows as CSV: one a method, setting and scene, a method that was not there included.
[[nodiscard]] std::string csv(const std::vector<ChartRow>& rows, const ChartRun& run);

/// @brief The points with the truth and the limits of every scene as CSV.
[[nodiscard]] std::string csv(const std::vector<ChartGround>& grounds, const ChartRun& run);

/// @brief Data of the pictures: a block a scene and method of digits (worst, median), time, setup, tolerance asked for, share of
/// the points that were right, failures as `failure_names`; before them the limits of the scene and, as comments, all names.
[[nodiscard]] std::string picture_data(const std::vector<ChartRow>& rows, const std::vector<ChartGround>& grounds);

/// @brief Who is fastest at 2, 4, 8, 12, 15 and 30 digits on every scene, beside `solve` asked for them. With the setup a single
/// question is meant, without it one more of many.
[[nodiscard]] Table front_table(const std::vector<ChartRow>& rows, bool with_setup);

/// @brief Failures by name: every method and setting that was not right everywhere, or was not there.
[[nodiscard]] Table failure_table(const std::vector<ChartRow>& rows);

/// @brief What `solve` did for its answers: modes evaluated, eigenproblems, phases propagated, models used. A row a scene and
/// number of digits.
[[nodiscard]] Table solve_work_table(const std::vector<ChartGround>& grounds);

} // namespace denhartog::tests

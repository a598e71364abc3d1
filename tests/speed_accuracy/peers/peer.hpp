/// @file
/// @brief What a method of the chart is asked and what it says: the sizes of the motion at points of a scene.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "denhartog/scene/scene.hpp"

namespace denhartog::tests {

/// @brief A point of a scene.
struct ChartPoint {
    double r;    ///< frequency ratio
    double beta; ///< friction ratio, mu = 1
};

/// @brief A scene of the chart: a system and the points asked for. The answer is the amplitude of the mass in contact, X_j:
/// the largest |x_j| of the steady motion over y_0.
struct ChartScene {
    std::string name;               ///< e.g. `SDOF, sliding`
    System<double> system;          ///< the system
    std::vector<ChartPoint> points; ///< the points
};

/// @brief How a method ended at a point.
enum class Ending { answered, did_not_finish, stalled, not_a_number, outside_domain };

/// @brief What a method says at a point.
struct PeerAnswer {
    Ending ending = Ending::answered;           ///< how it ended
    double amplitude = 0;                       ///< X_j, where it answered
    bool sticks = false;                        ///< it saw the contact at rest for part of the period or always
    long evaluations = 0;                       ///< its own unit of work: right-hand sides, iterations, modes
    std::array<double, 3> beyond{};             ///< what a wider number has beyond `amplitude`, largest part first
    std::function<double(double tau)> motion{}; ///< x_j at an instant, where the method has it for nothing; else empty
};

/// @brief Gives an answer its amplitude, all digits of a wider number kept.
template <class T>
void set_amplitude(PeerAnswer& answer, T amplitude) {
    answer.amplitude = static_cast<double>(amplitude);
    double part = answer.amplitude;
    for (double& next : answer.beyond) {
        amplitude -= T(part);
        next = part = static_cast<double>(amplitude);
    }
    if (!std::isfinite(answer.amplitude)) answer.ending = Ending::not_a_number;
}

/// @brief A method at one setting, e.g. harmonic balance with 11 harmonics.
struct Peer {
    std::string method;  ///< e.g. `harmonic balance, augmented Lagrangian`
    std::string setting; ///< e.g. `11 harmonics`
    double asked = 0;    ///< tolerance asked for, 0 where the setting is not a tolerance
    /// Prepares for a system, once: what it returns answers one point. Empty where the method is not there: `setting` says why.
    std::function<std::function<PeerAnswer(const ChartPoint&)>(const System<double>&)> prepare;
};

} // namespace denhartog::tests

/// @file
/// @brief What the tests of the chart's methods share: points, their answer by `solve`, and the error of a method there.
#pragma once

#include <cmath>
#include <string>

#include "denhartog/solve/solve.hpp"
#include "tests/catch.hpp"
#include "tests/speed_accuracy/peers/peer.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::tests {

/// @brief The answer of `solve` at a point.
struct Truth {
    double amplitude = 0;               ///< X_j, to ten digits
    Regime regime = Regime::continuous; ///< the regime
};

/// @brief A system at a point.
struct PeerPoint {
    std::string name;      ///< unique
    System<double> system; ///< the system
    ChartPoint at;         ///< the point

    /// @brief By the closed form where the contact slides, by the exact solver's orbit where it sticks and slips. @return X_j
    [[nodiscard]] Truth truth() const {
        Scene<double> scene;
        scene.system = system;
        scene.r = at.r;
        scene.beta = at.beta;
        const Solution solution = solve(scene_source(scene), {Asked::amplitude, 10, false});
        Truth found{0, solution.regime.regime};
        if (found.regime != Regime::permanent_sticking)
            found.amplitude = mass_of(solution, system.contact).amplitude.value;
        return found;
    }
};

/// @brief Points where the contact slides. @return SDOF and 2DOF
[[nodiscard]] inline std::vector<PeerPoint> sliding_points() {
    return {{"SDOF, r = 0.9, beta = 0.2", single_mass(0.01), {0.9, 0.2}},
            {"2DOF, r = 0.8, beta = 0.3", two_masses(0.01), {0.8, 0.3}}};
}

/// @brief Points where it sticks and slips. @return SDOF at r = 0.1 with two friction ratios
[[nodiscard]] inline std::vector<PeerPoint> stick_slip_points() {
    return {{"SDOF, r = 0.1, beta = 0.2", single_mass(0.01), {0.1, 0.2}},
            {"SDOF, r = 0.1, beta = 0.7", single_mass(0.01), {0.1, 0.7}}};
}

/// @brief A point in a message. @param p the point @return its name and numbers in hexadecimal
[[nodiscard]] inline std::string where(const PeerPoint& p) {
    return p.name + ", r = " + hexadecimal(p.at.r) + ", beta = " + hexadecimal(p.at.beta);
}

/// @brief Relative error of a method at a point; infinite where it does not answer or sees another regime.
/// @param peer    the method
/// @param p       the point
/// @param factor  on the friction ratio that the method is told; 1 is right
/// @return        the error
[[nodiscard]] inline double relative_error(const Peer& peer, const PeerPoint& p, double factor = 1) {
    const Truth truth = p.truth();
    const PeerAnswer found = peer.prepare(p.system)({p.at.r, p.at.beta * factor});
    if (found.ending != Ending::answered || found.sticks != (truth.regime != Regime::continuous)) return HUGE_VAL;
    return std::abs(found.amplitude / truth.amplitude - 1);
}

} // namespace denhartog::tests

/// @file
/// @brief Invariant points of a system as doubles. Header only.
#pragma once

#include "denhartog/answer/reference.hpp"
#include "denhartog/number/number_text.hpp"

namespace denhartog::tests {

/// @brief The invariant points of every mass, damping left out, rounded to double.
[[nodiscard]] inline std::vector<InvariantPointsOfMass<double>> invariant_points_of(const System<double>& system, double r_a,
                                                                                    double r_b, Effort* effort = nullptr) {
    Scene<double> scene;
    scene.system = system;
    scene.r = 1;
    check(scene);
    std::vector<InvariantPointsOfMass<double>> all;
    for (const InvariantPointsOfMass<Certified>& each :
         invariant_points(with_effort(scene_source(scene), effort), {number_to_text(r_a), number_to_text(r_b)}, 15)) {
        all.push_back({each.mass, {}, {}});
        for (const InvariantPoint<Certified>& p : each.points)
            all.back().points.push_back({p.r.value, p.amplitude.value, p.kind});
        for (const UndecidedStretch<Certified>& u : each.undecided) all.back().undecided.push_back({u.from.value, u.to.value});
    }
    return all;
}

} // namespace denhartog::tests

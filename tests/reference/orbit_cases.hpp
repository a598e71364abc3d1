/// @file
/// @brief Motions with stops for the tests of the reference: the scene in balls, and the motion in double.
#pragma once

#include <functional>
#include <utility>

#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/orbit/periodic_orbit.hpp"
#include "denhartog/reference/modes.hpp"
#include "denhartog/reference/orbit.hpp"
#include "denhartog/scene/converted.hpp"
#include "denhartog/solve/solve.hpp"
#include "tests/support/multiprecision.hpp"
#include "tests/support/scene_builder.hpp"

namespace denhartog::tests {

/// @brief Two equal masses and springs, the contact on the second, the load on the first.
inline System<double> two_masses() { return chain_of({1, 1}, {1, 1}, {0.02, 0.01}, 2, 1); }

/// @brief Three masses whose dashpots couple the modes.
inline System<double> coupled_masses() {
    System<double> s = chain_of({1, 1, 1}, {1, 1, 1}, 0, 2, 3);
    s.damping_ratios.clear();
    s.damping_matrix = matrix_of_chain<double>({0.125, 0.0625, 0.03125});
    return s;
}

/// @brief Three masses, the contact between the first and the last, a load on both.
inline System<double> rubbing_masses() {
    System<double> s = chain_of({1, 2, 1}, {1, 1, 0.5}, 0.03125, 1, 1);
    s.contact_with = Mass{2};
    s.load_vector = {1, 0, -0.5};
    return s;
}

/// @brief What makes a scene in balls, its damping matrix filled. @param scene the scene @return the maker
inline std::function<reference::SceneInBalls()> in_bits(const Scene<double>& scene) {
    return [scene] {
        Scene<Ball> balls;
        balls.system = in_type<Ball>(scene.system);
        balls.mu = Ball(scene.mu);
        balls.r = Ball(*scene.r);
        balls.beta = Ball(*scene.beta);
        reference::SceneInBalls s = reference::in_matrices(balls);
        if (s.C.rows() == 0) s.C = reference::damping_matrix_in_balls(s, reference::modes_in_balls(s));
        return s;
    };
}

/// @brief The exact solver's motion from rest.
struct FollowedMotion {
    Scene<double> own;
    ContactSystem system;
    ExactSolver solver;
    PeriodicOrbit orbit;

    explicit FollowedMotion(const Scene<double>& scene)
        : own(scene), system(contact_system(own.system)), solver(system, {*own.r, *own.beta, own.mu}),
          orbit(periodic_orbit(solver, at_rest(system.basis.r_n.size()))) {}
};

/// @brief The guess of double precision. @param scene the scene @return it; without directions where there is none
inline OrbitGuess guess_for(const Scene<double>& scene) {
    FollowedMotion motion(scene);
    if (motion.orbit.status != OrbitStatus::periodic) return {};
    return guess_of(motion.solver, motion.orbit);
}

} // namespace denhartog::tests

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
#include "denhartog/solve/decision.hpp"
#include "tests/support/multiprecision.hpp"
#include "tests/support/scene_builder.hpp"

namespace denhartog::tests {

/// @brief A scene at a point. @param system its system @param r @param beta @param mu @return the scene
inline Scene<double> at_point(System<double> system, double r, double beta, double mu = 1) {
    Scene<double> scene;
    scene.system = std::move(system);
    scene.mu = mu;
    scene.r = r;
    scene.beta = beta;
    return scene;
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

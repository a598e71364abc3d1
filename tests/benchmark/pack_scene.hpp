/// @file
/// @brief A scene of the benchmark's pack, as `scenes.json` has it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/scene_builder.hpp"

namespace denhartog::benchmark {

/// @brief What is asked: the rest of the pack follows from it. The first mass is 1 kg, the first spring 1 N/m, the load 1 N, so
/// that numbers in SI units are those of the paper, and the frequency of the load in rad/s is its frequency ratio.
struct PackScene {
    std::string id;               ///< name of the scene
    std::vector<double> m;        ///< masses, kg, N values
    std::vector<double> k;        ///< springs, kg/s^2, N values
    std::vector<double> c;        ///< dashpots beside the springs, kg/s, N values
    std::vector<double> c_ground; ///< dashpots to the ground, kg/s, N values
    std::size_t contact;          ///< the mass in contact, j, from 1
    std::size_t load;             ///< the loaded mass, l, from 1
    double omega;                 ///< frequency of the load, rad/s
    double F;                     ///< kinetic friction, N
    double F_static;              ///< static friction, N
};

/// @brief Reads a scene. @param s an object of `scenes.json` @return the scene
template <class Json>
[[nodiscard]] PackScene pack_scene(const Json& s) {
    return {s.at("scene"),   s.at("m"),    s.at("k"),     s.at("c"), s.at("c_ground"),
            s.at("contact"), s.at("load"), s.at("omega"), s.at("F"), s.at("F_static")};
}

/// @brief The library's scene. @param s a scene of the pack @return the scene
[[nodiscard]] inline Scene<double> scene_of(const PackScene& s) {
    Scene<double> scene;
    scene.system.mass_ratios = s.m;
    scene.system.stiffness_ratios = s.k;
    scene.system.damping_matrix = matrix_of_chain(s.c);
    scene.system.damping_matrix.diagonal() += Eigen::Map<const Eigen::VectorXd>(s.c_ground.data(), std::ssize(s.c_ground));
    scene.system.contact = Mass{s.contact - 1};
    scene.system.load = Mass{s.load - 1};
    scene.r = s.omega;
    scene.beta = s.F;
    scene.mu = s.F_static / s.F;
    return scene;
}

} // namespace denhartog::benchmark

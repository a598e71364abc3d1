/// @file
/// @brief Scenes to compute on: the paper's own, and random ones that come out the same on every platform.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "denhartog/scene/scene.hpp"

namespace denhartog {

/// @brief A scene with a name that says where it is from.
template <class T>
struct NamedScene {
    std::string name; ///< unique within its list
    Scene<T> scene;   ///< complete: r and beta are given
};

/// @brief A random scene; beta is left open and given as a fraction of the boundary of the sliding regime.
template <class T>
struct RandomScene {
    std::string name;           ///< unique within its list; holds the seed, N, j, l and the number in the list
    Scene<T> scene;             ///< without beta
    double fraction_of_limit{}; ///< the wanted beta over beta_lim, Eq. (69), a multiple of 1/64 between 1/64 and 63/64
};

/// @brief The paper's scenes: Figs. 4-10.
///
/// SDOF, zeta = 0.001, 0.01, 0.1, mu = 1 (Figs. 6, 7); 2DOF with equal masses and springs, j = 2, l = 1,
/// \f$ \zeta_i = 0.001/r_{n,i}, 0.01/r_{n,i}, 0.1/r_{n,i} \f$ (Figs. 8-10); 5DOF with equal masses and springs, r = 0.9,
/// beta = 0.2, j = l = 1 and j = 3, l = 1, zeta = 0.01 and 0.1 (Figs. 4, 5). For SDOF and 2DOF a grid over the figures' range
/// of r and beta is taken, whatever the regime: both routes have to agree on where the contact slides. Decimal fractions are
/// quotients of integers, correctly rounded in every number type.
template <class T>
[[nodiscard]] std::vector<NamedScene<T>> paper_scenes();

/// @brief Seeded random systems: N = 1 to 10, every placing of contact and load, unequal masses, springs and damping ratios.
///
/// For each N there are 40 scenes or \f$ N^2 \f$, whichever is more, so that every pair (j, l) occurs: 534 in all. Every
/// number is a short binary fraction, the same in every number type. Mass and stiffness ratios are in [1/4, 4], mu in [1, 3],
/// damping ratios in [1/1024, 15/16], r in [0.1, 3]; the last two are spread over the octaves. About one scene in four has the
/// physical damping matrix \f$ C = aM + bK \f$ in place of damping ratios, one in five of the others modes without damping, one
/// in five of all a stiffness matrix that is no chain's, a third of these a mass matrix that is not diagonal.
template <class T>
[[nodiscard]] std::vector<RandomScene<T>> random_scenes(std::uint64_t seed);

/// @brief A friction ratio at a fraction of the boundary, rounded down to 20 significant bits: the same in every number type.
[[nodiscard]] double friction_ratio_at(double fraction, double beta_lim);

} // namespace denhartog

/// @file
/// @brief Systems for the tests: chains by their ratios, and springs and dashpots put into matrices one by one. Header only.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "denhartog/scene/scene.hpp"

namespace denhartog {

/// @brief A chain.
/// @param gamma  mass ratios
/// @param kappa  stiffness ratios
/// @param zeta   damping ratios
/// @param j      the mass in contact, from 1
/// @param l      the loaded mass, from 1
/// @return       the system
template <class T = double>
[[nodiscard]] System<T> chain_of(const std::vector<double>& gamma, const std::vector<double>& kappa,
                                 const std::vector<double>& zeta, std::size_t j = 1, std::size_t l = 1) {
    System<T> s;
    s.mass_ratios.assign(gamma.begin(), gamma.end());
    s.stiffness_ratios.assign(kappa.begin(), kappa.end());
    s.damping_ratios.assign(zeta.begin(), zeta.end());
    s.contact = Mass{j - 1};
    s.load = Mass{l - 1};
    return s;
}

/// @brief The same with one damping ratio for all modes.
template <class T = double>
[[nodiscard]] System<T> chain_of(const std::vector<double>& gamma, const std::vector<double>& kappa, double zeta = 0,
                                 std::size_t j = 1, std::size_t l = 1) {
    return chain_of<T>(gamma, kappa, std::vector<double>(gamma.size(), zeta), j, l);
}

/// @brief A system at a point.
/// @param system  the system
/// @param r       frequency ratio
/// @param beta    friction ratio, or nothing
/// @param mu      static over kinetic friction
/// @return        the scene
template <class T>
[[nodiscard]] Scene<T> scene_of(System<T> system, double r, std::optional<double> beta = std::nullopt, double mu = 1) {
    Scene<T> scene{std::move(system), T(mu), T(r), std::nullopt, {}, {}};
    if (beta) scene.beta = T(*beta);
    return scene;
}

/// @brief Adds a spring to a stiffness matrix, or a dashpot to a damping matrix.
/// @param K  the matrix
/// @param i  the mass at one end, from 0
/// @param k  the mass at the other; i itself or -1 for the ground
/// @param c  stiffness or damping coefficient
template <class T>
void connect(Matrix<T>& K, Eigen::Index i, Eigen::Index k, const T& c) {
    K(i, i) += c;
    if (k < 0 || k == i) return;
    K(k, k) += c;
    K(i, k) -= c;
    K(k, i) -= c;
}

/// @brief The stiffness matrix of a chain, Eq. (1), or its damping matrix. @param k spring i between masses i - 1 and i, the
/// first to the ground @return the matrix
template <class T>
[[nodiscard]] Matrix<T> matrix_of_chain(const std::vector<T>& k) {
    const auto N = static_cast<Eigen::Index>(k.size());
    Matrix<T> K = Matrix<T>::Zero(N, N);
    for (Eigen::Index i = 0; i < N; ++i) connect(K, i, i - 1, k[static_cast<std::size_t>(i)]);
    return K;
}

/// @brief The same system by its matrices, so that it is solved as any other. @param s a chain @return the system
template <class T>
[[nodiscard]] System<T> with_stiffness_matrix(System<T> s) {
    s.stiffness_matrix = matrix_of_chain(s.stiffness_ratios);
    s.stiffness_ratios.clear();
    return s;
}

} // namespace denhartog

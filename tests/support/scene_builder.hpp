/// @file
/// @brief Systems for the tests: chains by their ratios, and springs and dashpots put into matrices one by one. Header only.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "denhartog/scene/scene.hpp"

namespace denhartog {

/// @brief A chain by its ratios; the mass j in contact and the loaded mass l count from 1.
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
template <class T>
[[nodiscard]] Scene<T> scene_of(System<T> system, double r, std::optional<double> beta = std::nullopt, double mu = 1) {
    Scene<T> scene{std::move(system), T(mu), T(r), std::nullopt, {}, {}};
    if (beta) scene.beta = T(*beta);
    return scene;
}

/// @brief Adds a spring to a stiffness matrix, or a dashpot to a damping matrix, from mass i to mass k, from 0; k is i itself or -1
/// for the ground.
template <class T>
void connect(Matrix<T>& K, Eigen::Index i, Eigen::Index k, const T& c) {
    K(i, i) += c;
    if (k < 0 || k == i) return;
    K(k, k) += c;
    K(i, k) -= c;
    K(k, i) -= c;
}

/// @brief The stiffness matrix of a chain, Eq. (1), or its damping matrix: spring i is between masses i - 1 and i, the first
/// to the ground.
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

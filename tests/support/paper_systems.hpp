/// @file
/// @brief The paper's systems: chains of equal masses and springs, Figs. 4 to 12.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "tests/support/scene_builder.hpp"

namespace denhartog {

/// @brief A system with its name.
template <class T>
struct NamedSystem {
    std::string name; ///< e.g. `SDOF`
    System<T> system; ///< the system
};

/// @brief A chain of equal masses and springs; the mass j in contact and the loaded mass l count from 1.
template <class T>
[[nodiscard]] System<T> equal_chain(std::size_t N, std::size_t j, std::size_t l, const std::vector<T>& zeta) {
    System<T> s = chain_of<T>(std::vector<double>(N, 1), std::vector<double>(N, 1), 0, j, l);
    s.damping_ratios = zeta;
    return s;
}

/// @brief The mass on a spring.
template <class T>
[[nodiscard]] System<T> single_mass(const T& zeta) {
    return equal_chain<T>(1, 1, 1, {zeta});
}

/// @brief The 2DOF of Figs. 8 to 10: j = 2, l = 1, zeta_i = zeta / r_n,i.
template <class T>
[[nodiscard]] System<T> two_masses(const T& zeta) {
    using std::sqrt;
    const T first = (sqrt(T(5)) - 1) / 2, second = (sqrt(T(5)) + 1) / 2; // r_n of two equal masses and springs
    return equal_chain<T>(2, 2, 1, {T(zeta / first), T(zeta / second)});
}

/// @brief The 5DOF of Figs. 4 and 5, contact on mass j from 1, l = 1.
template <class T>
[[nodiscard]] System<T> five_masses(std::size_t j, const T& zeta) {
    return equal_chain<T>(5, j, 1, std::vector<T>(5, zeta));
}

/// @brief The four systems at one damping ratio. @param zeta damping ratio @return SDOF, 2DOF, 5DOF j = 1, 5DOF j = 3
template <class T>
[[nodiscard]] std::vector<NamedSystem<T>> paper_systems(const T& zeta) {
    return {{"SDOF", single_mass(zeta)},
            {"2DOF j=2 l=1", two_masses(zeta)},
            {"5DOF j=1 l=1", five_masses<T>(1, zeta)},
            {"5DOF j=3 l=1", five_masses<T>(3, zeta)}};
}

} // namespace denhartog

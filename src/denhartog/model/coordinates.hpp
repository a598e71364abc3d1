/// @file
/// @brief Coordinates in which the contact acts on one of them, for systems where it is between two masses, and loads on several.
///
/// With the displacement of the contact, \f$ y_a = \mathbf{w}^T\mathbf{x} = x_j - x_k \f$, in the place of the lighter of the two
/// masses, \f$ \mathbf{x} = \mathbf{O}\,\mathbf{y} \f$ and the equations (6) keep their form with
/// \f$ \mathbf{O}^T\mathbf{M}\mathbf{O} \f$, \f$ \mathbf{O}^T\mathbf{C}\mathbf{O} \f$,
/// \f$ \mathbf{O}^T\mathbf{K}\mathbf{O} \f$ and the load \f$ \mathbf{O}^T\mathbf{p} \f$: friction acts on coordinate a alone. All
/// that the paper derives from (6) holds of them, with \f$ \mathbf{w}^T\boldsymbol\psi_i \f$ for \f$ \psi_{ji} \f$ and
/// \f$ \mathbf{p}^T\boldsymbol\psi_i \f$ for \f$ \psi_{li} \f$; natural frequencies and damping ratios are the same.
#pragma once

#include "denhartog/scene/scene.hpp"

namespace denhartog {

/// @brief The mass matrix of a system in units of m_1.
template <class T>
[[nodiscard]] Matrix<T> mass_matrix(const System<T>& s);

/// @brief The stiffness matrix of a system in units of k_1. @eq{73}
template <class T>
[[nodiscard]] Matrix<T> stiffness_matrix(const System<T>& s);

/// @brief Whether a system is of the paper's form: one mass is in contact with the wall, and one is loaded.
template <class T>
[[nodiscard]] bool is_of_papers_form(const System<T>& s) {
    return !s.contact_with && s.load_vector.empty();
}

/// @brief A scene in coordinates of its own, where its contact is between two masses or its load acts on several.
///
/// The matrices are taken there in more digits and rounded once: every entry is off by no more than a unit in its last place. A
/// scene of the paper stays as it is.
/// @eq{6}
template <class T>
[[nodiscard]] Scene<T> in_own_coordinates(const Scene<T>& scene);

/// @brief Displacements that are no coordinates, in terms of these, a row for each: the mass that the contact replaces, then that
/// of the load. There are none for a scene of the paper.
template <class T>
[[nodiscard]] Matrix<T> further_displacements(const Coordinates<T>& c) {
    if (c.load.empty()) return c.displacements;
    const auto N = static_cast<Eigen::Index>(c.load.size());
    Matrix<T> rows(c.displacements.rows() + 1, N);
    if (c.displacements.rows() > 0) rows.topRows(c.displacements.rows()) = c.displacements;
    for (Eigen::Index k = 0; k < N; ++k) rows(c.displacements.rows(), k) = c.load[static_cast<std::size_t>(k)];
    return rows;
}

/// @brief The force p on each of the N coordinates, in units of P; `load` is the loaded mass, where the load is on one.
template <class T>
[[nodiscard]] std::vector<T> load_on_coordinates(const Coordinates<T>& c, Mass load, std::size_t N) {
    if (!c.load.empty()) return c.load;
    std::vector<T> p(N, T(0));
    p[load.index] = T(1);
    return p;
}

/// @brief The same of a system in its own coordinates.
template <class T>
[[nodiscard]] std::vector<T> load_on_coordinates(const System<T>& s) {
    return load_on_coordinates(s.coordinates, s.load, number_of_masses(s));
}

/// @brief The place of a mass among displacements: its own where it is a coordinate, else behind them.
template <class T>
[[nodiscard]] Mass displacement_of(const System<T>& s, Mass k) {
    for (std::size_t n = 0; n < s.coordinates.replaced.size(); ++n)
        if (s.coordinates.replaced[n] == k) return Mass{number_of_masses(s) + n};
    return k;
}

/// @brief Puts displacements in the order of the masses; what stood for a coordinate that is no mass comes last.
template <class T, class Value>
void put_in_order_of_masses(const Coordinates<T>& c, std::vector<Value>& displacements) {
    const std::size_t N = displacements.size() - c.replaced.size();
    for (std::size_t n = 0; n < c.replaced.size(); ++n) std::swap(displacements[c.replaced[n].index], displacements[N + n]);
}

/// @brief Adds the masses that are no coordinates to numbers of the coordinates.
template <class T>
void add_displacements(const Coordinates<T>& c, std::vector<T>& x) {
    const std::size_t N = x.size();
    for (std::size_t n = 0; n < c.replaced.size(); ++n) {
        T sum(0);
        for (std::size_t k = 0; k < N; ++k)
            sum += c.displacements(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(k)) * x[k];
        x.push_back(sum);
    }
}

/// @brief Numbers of the masses taken to the coordinates.
template <class T>
void take_to_coordinates(const Coordinates<T>& c, std::vector<T>& x) {
    const std::vector<T> of_masses = x;
    for (std::size_t n = 0; n < c.replaced.size(); ++n) {
        T sum(0);
        for (std::size_t k = 0; k < x.size(); ++k)
            sum += c.of_masses(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(k)) * of_masses[k];
        x[c.replaced[n].index] = sum;
    }
}

/// @brief Numbers of the coordinates taken to the masses.
template <class T>
void take_to_masses(const Coordinates<T>& c, std::vector<T>& x) {
    const std::size_t N = x.size();
    add_displacements(c, x);
    put_in_order_of_masses(c, x);
    x.resize(N);
}

} // namespace denhartog

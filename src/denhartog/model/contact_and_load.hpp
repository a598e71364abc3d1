/// @file
/// @brief Where contact and load act: the displacement of the contact is \f$ \mathbf{w}^T\mathbf{x} \f$, and the force on the
/// masses \f$ \mathrm{Re}\{\mathbf{p}\,e^{\mathrm{i}\tau}\} \f$.
///
/// In the paper w and p are unit vectors. Between two masses the displacement of the contact is \f$ x_j - x_k \f$. All that the
/// paper derives from (6) holds of them, with \f$ \mathbf{w}^T\boldsymbol\psi_i \f$ for \f$ \psi_{ji} \f$ and
/// \f$ \mathbf{p}^T\boldsymbol\psi_i \f$ for \f$ \psi_{li} \f$, which is complex where forces are out of phase. Where w or p is no
/// unit vector it has a row of its own behind those of the masses, wherever there is a row a mass: first that of w, then that of
/// p, and of a complex p those of its real and its imaginary part.
#pragma once

#include <algorithm>

#include "denhartog/formulas/complex.hpp"
#include "denhartog/scene/scene.hpp"

namespace denhartog {

/// @brief The mass matrix of a system, N x N, in units of m_1.
[[nodiscard]] Matrix<double> mass_matrix(const System<double>& s);

/// @brief The stiffness matrix of a system, N x N, in units of k_1. @eq{73}
[[nodiscard]] Matrix<double> stiffness_matrix(const System<double>& s);

/// @brief The row of the contact: that of its mass against a wall.
template <class T>
[[nodiscard]] Mass contact_row(const System<T>& s) {
    return s.contact_with ? Mass{number_of_masses(s)} : s.contact;
}

/// @brief p, N values in units of P: \f$ p_k e^{\mathrm{i}\theta_k} \f$ of a force that leads by \f$ \theta_k \f$.
template <class T>
[[nodiscard]] std::vector<Complex<T>> complex_load(const System<T>& s) {
    std::vector<Complex<T>> p(number_of_masses(s), Complex<T>{T(0), T(0)});
    if (s.load_vector.empty()) p[s.load.index].re = T(1);
    for (std::size_t k = 0; k < s.load_vector.size(); ++k) {
        p[k].re = s.load_vector[k];
        if (s.load_phases.empty() || s.load_phases[k] == T(0)) continue;
        p[k] = {s.load_vector[k] * cos(s.load_phases[k]), s.load_vector[k] * sin(s.load_phases[k])};
    }
    return p;
}

/// @brief Bounds of what errors of phases in the last place make of p, and of those that the system has besides; N values, or none
/// of a load whose entries are off by units in the last place.
[[nodiscard]] std::vector<double> error_of_load(const System<double>& s);

/// @brief w, N values.
template <class T>
[[nodiscard]] std::vector<T> contact_vector(const System<T>& s) {
    std::vector<T> w(number_of_masses(s), T(0));
    w[s.contact.index] = T(1);
    if (s.contact_with) w[s.contact_with->index] = T(-1);
    return w;
}

/// @brief The row of the load: that of its mass where it acts on one, and that of the contact where p is w.
template <class T>
[[nodiscard]] Mass load_row(const System<T>& s) {
    const std::vector<T>& p = s.load_vector;
    if (p.empty()) return s.load;
    if (!s.load_phases.empty()) return Mass{p.size() + (s.contact_with ? 1 : 0)};
    if (p == contact_vector(s)) return contact_row(s);
    const auto one = std::ranges::find(p, T(1));
    if (one != p.end() && std::ranges::count(p, T(0)) + 1 == std::ssize(p))
        return Mass{static_cast<std::size_t>(one - p.begin())};
    return Mass{p.size() + (s.contact_with ? 1 : 0)};
}

/// @brief The rows of a load: that of its real part and, where forces are out of phase, that of its imaginary part.
struct LoadRows {
    Mass re;                  ///< the row of `load_row`
    std::optional<Mass> im{}; ///< the one behind it, or none
};

/// @brief The rows of the load of a system.
template <class T>
[[nodiscard]] LoadRows load_rows(const System<T>& s) {
    const Mass re = load_row(s);
    return {re, s.load_phases.empty() ? std::nullopt : std::optional(Mass{re.index + 1})};
}

/// @brief w and p as rows of N columns, those of them that have a row of their own.
template <class T>
[[nodiscard]] Matrix<T> further_rows(const System<T>& s) {
    const auto N = static_cast<Eigen::Index>(number_of_masses(s));
    Matrix<T> rows(0, N);
    const auto add = [&](const std::vector<T>& row) {
        rows.conservativeResize(rows.rows() + 1, Eigen::NoChange);
        for (Eigen::Index k = 0; k < N; ++k) rows(rows.rows() - 1, k) = row[static_cast<std::size_t>(k)];
    };
    if (s.contact_with) add(contact_vector(s));
    if (load_row(s).index != number_of_masses(s) + static_cast<std::size_t>(rows.rows())) return rows;
    std::vector<T> re, im;
    for (const Complex<T>& each : complex_load(s)) {
        re.push_back(each.re);
        im.push_back(each.im);
    }
    add(re);
    if (!s.load_phases.empty()) add(im);
    return rows;
}

/// @brief A contact that may be held: its displacement y then stands for that of a mass, \f$ x_a = y \f$ or \f$ x_b \pm y \f$.
///
/// Of two masses that is the lighter one: the other then has the inertia of both, and neither hides in the rounding of the other.
struct Contact {
    std::size_t a = 0;              ///< the mass whose displacement y stands for
    std::optional<std::size_t> b{}; ///< the other one of two; none against a wall
    int sign = 1;                   ///< of x_a in y

    /// @brief The contact's part of one number a mass, \f$ \mathbf{w}^T\mathbf{x} \f$.
    template <class Values>
    [[nodiscard]] auto of(const Values& x) const {
        return b ? sign * (x[a] - x[*b]) : x[a];
    }
    /// @brief The same of a matrix with a row a mass.
    [[nodiscard]] Matrix<double> row_of(const Matrix<double>& A) const {
        const auto i = static_cast<Eigen::Index>(a);
        if (!b) return A.row(i);
        return sign * (A.row(i) - A.row(static_cast<Eigen::Index>(*b)));
    }
    /// @brief Makes the contact's part of a matrix with a row a mass zero, by the row of x_a.
    void hold(Matrix<double>& A) const {
        const auto i = static_cast<Eigen::Index>(a);
        if (b)
            A.row(i) = A.row(static_cast<Eigen::Index>(*b));
        else
            A.row(i).setZero();
    }
    /// @brief The same of one number a mass.
    void hold(double* v) const { v[a] = b ? v[*b] : 0; }
    /// @brief Puts the contact's part of one number a mass behind them, where it has a row of its own.
    void append(std::vector<double>& x) const {
        if (b) x.push_back(of(x));
    }
};

/// @brief The contact of a mass, or of two masses, of which the lighter one is told by the mass matrix.
template <class T>
[[nodiscard]] Contact contact_of(Mass contact, const std::optional<Mass>& contact_with, const Matrix<T>& M) {
    const std::size_t j = contact.index;
    if (!contact_with) return {j, std::nullopt, 1};
    const std::size_t k = contact_with->index;
    const auto mass = [&](std::size_t n) { return M(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n)); };
    return mass(j) <= mass(k) ? Contact{j, k, 1} : Contact{k, j, -1};
}

/// @brief Matrices of a system with y in the place of x_a, \f$ \mathbf{O}^T\mathbf{A}\mathbf{O} \f$ with
/// \f$ \mathbf{x} = \mathbf{O}\mathbf{y} \f$: every entry is off by no more than a unit in its last place.
struct HeldMatrices {
    Matrix<double> M; ///< masses in units of m_1
    Matrix<double> C; ///< damping in units of sqrt(k_1 m_1)
    Matrix<double> K; ///< stiffnesses in units of k_1
};

/// @brief The matrices of a system whose contact may be held, with its damping matrix C, given or (19) at r = 1.
[[nodiscard]] HeldMatrices held_matrices(const System<double>& s, const Contact& held, const Matrix<double>& C);

} // namespace denhartog

/// @file
/// @brief Vectors of contact and load: the displacement of the contact is \f$ \mathbf{w}^T\mathbf{x} \f$, and the force on the
/// masses \f$ \mathrm{Re}\{\mathbf{p}\,e^{\mathrm{i}\tau}\} \f$.
///
/// In the paper w and p are unit vectors. Between two masses the displacement of the contact is \f$ x_j - x_k \f$; w may be any
/// vector, and friction then acts on the masses along it. All that the paper derives from (6) holds of them, with
/// \f$ \mathbf{w}^T\boldsymbol\psi_i \f$ for \f$ \psi_{ji} \f$ and \f$ \mathbf{p}^T\boldsymbol\psi_i \f$ for \f$ \psi_{li} \f$,
/// complex where forces are out of phase. Where w or p is no unit vector it has a row of its own behind those of the masses: first
/// that of w, then that of p, and of a complex p those of its real and its imaginary part.
#pragma once

#include <algorithm>
#include <span>

#include "denhartog/formulas/complex.hpp"
#include "denhartog/formulas/system.hpp"
#include "denhartog/scene/scene.hpp"

namespace denhartog {

/// @brief A matrix of the formulas, which give its entries row by row.
template <class T>
[[nodiscard]] Matrix<T> to_matrix(const std::vector<T>& entries, std::size_t N) {
    using RowMajor = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    return Eigen::Map<const RowMajor>(entries.data(), static_cast<Eigen::Index>(N), static_cast<Eigen::Index>(N));
}

/// @brief The mass matrix of a system, N x N, in units of m_1.
template <class T>
[[nodiscard]] Matrix<T> mass_matrix(const System<T>& s) {
    if (s.mass_matrix.size() > 0) return s.mass_matrix;
    const auto N = static_cast<Eigen::Index>(s.mass_ratios.size());
    Matrix<T> M = Matrix<T>::Constant(N, N, T(0));
    for (Eigen::Index k = 0; k < N; ++k) M(k, k) = s.mass_ratios[static_cast<std::size_t>(k)];
    return M;
}

/// @brief The stiffness matrix of a system, N x N, in units of k_1. @eq{1,73}
template <class T>
[[nodiscard]] Matrix<T> stiffness_matrix(const System<T>& s) {
    if (s.stiffness_matrix.size() > 0) return s.stiffness_matrix;
    return to_matrix<T>(paper::chain_stiffness_matrix(std::span<const T>(s.stiffness_ratios)), s.stiffness_ratios.size());
}

/// @brief The row of the contact: that of its mass against a wall.
template <class T>
[[nodiscard]] Mass contact_row(const System<T>& s) {
    return contact_moves_apart(s) ? Mass{number_of_masses(s)} : s.contact;
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

/// @brief Bounds of the errors of p, N values; none of a load whose entries are off by units in the last place.
[[nodiscard]] std::vector<double> error_of_load(const System<double>& s);

/// @brief w, N values.
template <class T>
[[nodiscard]] std::vector<T> contact_vector(const System<T>& s) {
    if (!s.contact_direction.empty()) return s.contact_direction;
    std::vector<T> w(number_of_masses(s), T(0));
    w[s.contact.index] = T(1);
    if (s.contact_with) w[s.contact_with->index] = T(-1);
    return w;
}

/// @brief Adds cx to a sum that may have no terms yet. A factor 1 or -1 rounds nothing, and nor does adding the first term.
template <class Number>
void add_times(std::optional<Number>& sum, const Number& c, const Number& x) {
    const Number term = c.x == 1 ? x : c.x == -1 ? -x : c * x;
    sum = sum ? *sum + term : term;
}

/// @brief \f$ \mathbf{w}^T\mathbf{x} \f$ of one number with its error a mass, which `x_k` gives.
template <class Number, class Values>
[[nodiscard]] Number along_contact(const System<double>& s, const Values& x_k) {
    std::optional<Number> sum;
    const std::vector<double> w = contact_vector(s);
    for (std::size_t k = 0; k < w.size(); ++k)
        if (w[k] != 0) add_times<Number>(sum, Number(w[k]), x_k(k));
    return *sum;
}

/// @brief The row of the load: that of its mass where it acts on one, and that of the contact where p is w.
template <class T>
[[nodiscard]] Mass load_row(const System<T>& s) {
    const std::vector<T>& p = s.load_vector;
    if (p.empty()) return s.load;
    const Mass own{p.size() + (contact_moves_apart(s) ? 1 : 0)};
    if (!s.load_phases.empty()) return own;
    if (p == contact_vector(s)) return contact_row(s);
    const auto one = std::ranges::find(p, T(1));
    if (one != p.end() && std::ranges::count(p, T(0)) + 1 == std::ssize(p))
        return Mass{static_cast<std::size_t>(one - p.begin())};
    return own;
}

/// @brief The rows of a load: that of its real part and, where forces are out of phase, that of its imaginary part.
struct LoadRows {
    Mass re;                ///< the row of `load_row`
    std::optional<Mass> im; ///< the one behind it, or none

    /// @brief Of a load in phase its one row.
    LoadRows(Mass re_, std::optional<Mass> im_ = std::nullopt) : re(re_), im(im_) {} // NOLINT(google-explicit-constructor)
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
    if (contact_moves_apart(s)) add(contact_vector(s));
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

/// @brief A mass that the contact moves with besides mass a.
struct BesideContact {
    std::size_t k; ///< the mass
    double w;      ///< its entry of w
    double share;  ///< \f$ -w_k / w_a \f$: how far mass a goes with it while the contact is held
};

/// @brief A contact that may be held: its displacement y then stands for that of a mass,
/// \f$ x_a = (y - \sum_{k \ne a} w_k x_k) / w_a \f$.
///
/// That mass is the one with the smallest \f$ M_{aa}/w_a^2 \f$, of two masses the lighter one: the others then have its inertia
/// besides their own, and none hides in the rounding of another.
struct Contact {
    std::size_t a = 0;                   ///< the mass whose displacement y stands for
    double w_a = 1;                      ///< its entry of w
    std::vector<BesideContact> others{}; ///< the masses with the other entries that are not zero, ascending

    /// @brief The contact's part of one number a mass, \f$ \mathbf{w}^T\mathbf{x} \f$; zero of what `hold` leaves.
    template <class Values>
    [[nodiscard]] double of(const Values& x) const {
        return w_a * (x[a] - held_part(x));
    }
    /// @brief The contact's row of a matrix with a row a mass.
    [[nodiscard]] Matrix<double> row_of(const Matrix<double>& A) const {
        Matrix<double> row = A.row(static_cast<Eigen::Index>(a));
        if (!others.empty()) row -= held_row(A);
        return w_a * row;
    }
    /// @brief Makes the contact's part of a matrix with a row a mass zero, by the row of x_a.
    void hold(Matrix<double>& A) const { A.row(static_cast<Eigen::Index>(a)) = held_row(A); }
    /// @brief Makes the contact's part of one number a mass zero, by that of mass a.
    void hold(double* v) const { v[a] = held_part(v); }
    /// @brief The share of mass a in a number that the contact has, or of the contact in a force on mass a.
    [[nodiscard]] double over(double x) const { return x / w_a; }
    /// @brief True if the displacement of the contact is not that of one mass, and has a row of its own.
    [[nodiscard]] bool has_own_row() const { return w_a != 1 || !others.empty(); }
    /// @brief Puts the contact's part of one number a mass behind them, where it has a row of its own.
    void append(std::vector<double>& x) const {
        if (has_own_row()) x.push_back(of(x));
    }

private:
    // That of mass a where the contact is held.
    template <class Values>
    [[nodiscard]] double held_part(const Values& x) const {
        if (others.empty()) return 0;
        double sum = others[0].share * x[others[0].k];
        for (std::size_t n = 1; n < others.size(); ++n) sum += others[n].share * x[others[n].k];
        return sum;
    }
    [[nodiscard]] Matrix<double> held_row(const Matrix<double>& A) const {
        if (others.empty()) return Matrix<double>::Zero(1, A.cols());
        Matrix<double> row = others[0].share * A.row(static_cast<Eigen::Index>(others[0].k));
        for (std::size_t n = 1; n < others.size(); ++n) row += others[n].share * A.row(static_cast<Eigen::Index>(others[n].k));
        return row;
    }
};

/// @brief The contact of a vector w, one entry a mass, in a system of the mass matrix M.
[[nodiscard]] Contact contact_of(const std::vector<double>& w, const Matrix<double>& M);

/// @brief Mass, damping and stiffness matrices of (6).
struct NonDimensionalMatrices {
    Matrix<double> M; ///< r^2 times the mass matrix in units of m_1
    Matrix<double> C; ///< non-dimensional damping matrix, Eq. (19), or r times the damping matrix given
    Matrix<double> K; ///< stiffness matrix in units of k_1
};

/// @brief The matrices of a system whose contact may be held, at r = 1, with its damping matrix C, given or (19): those with y in the
/// place of x_a, \f$ \mathbf{O}^T\mathbf{A}\mathbf{O} \f$ with \f$ \mathbf{x} = \mathbf{O}\mathbf{y} \f$. Every entry is off by no
/// more than two units in its last place.
[[nodiscard]] NonDimensionalMatrices held_matrices(const System<double>& s, const Contact& held, const Matrix<double>& C);

} // namespace denhartog

/// @file
/// @brief A scene: the system, the place of contact and load, friction, and the point asked for, (1)-(11), (73).
///
/// A scene is non-dimensional. Dimensional input is divided by \f$ k_1 \f$, \f$ m_1 \f$ and P when it is read.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace denhartog {

/// @brief A square matrix over the number type.
template <class T>
using Matrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;

/// @brief A mass, counted from 0; input and prose count from 1.
struct Mass {
    std::size_t index = 0; ///< position in arrays over the masses
    /// @brief Same mass. @return whether it is
    bool operator==(const Mass&) const = default;
};

/// @brief A vibrating mode, counted from 0 in the order of ascending natural frequency.
struct Mode {
    std::size_t index = 0; ///< position in arrays over the modes
    /// @brief Same mode. @return whether it is
    bool operator==(const Mode&) const = default;
};

/// @brief Coordinates in which contact and load each act on one of them: those of a contact between two masses or of a load on
/// several. A scene of the paper has none of its own.
template <class T>
struct Coordinates {
    std::vector<Mass> replaced; ///< masses whose place another displacement took, ascending
    Matrix<T> displacements;    ///< the displacement of each of them over the coordinates, a row a mass, N columns
    Matrix<T> of_masses;        ///< what took their place over the masses, a row each, N columns
    std::vector<Mass> between;  ///< the two masses that rub against each other; none where one rubs against a wall
};

/// @brief The system: a chain by ratios, or symmetric matrices of any topology.
///
/// Exactly one of `stiffness_ratios` and `stiffness_matrix` is filled, exactly one of `mass_ratios` and `mass_matrix`, and
/// exactly one of `damping_ratios` and `damping_matrix`. Matrices are symmetric to the last bit: one rule in every precision.
template <class T>
struct System {
    std::vector<T> mass_ratios;         ///< gamma_i = m_i / m_1, Eq. (9), N values
    std::vector<T> stiffness_ratios;    ///< kappa_i = k_i / k_1, Eq. (73), N values
    Matrix<T> mass_matrix;              ///< M in units of m_1, N x N
    Matrix<T> stiffness_matrix;         ///< K in units of k_1, N x N
    std::vector<T> damping_ratios;      ///< zeta_i by ascending natural frequency, Eq. (18), N values
    Matrix<T> damping_matrix;           ///< C in units of sqrt(k_1 m_1), N x N
    double damping_tolerance = 0;       ///< how far K M^-1 C may be from C M^-1 K for the damping ratios nearest to it to count
    Mass contact;                       ///< the mass in contact, j
    Mass load;                          ///< the loaded mass, l
    std::optional<Mass> contact_with{}; ///< the mass that the contact rubs against, in place of a wall: x_j - x_k slides
    std::vector<T> load_vector{};       ///< force on each mass in units of P, in place of `load`; N values or none
    Coordinates<T> coordinates{};       ///< filled by `in_own_coordinates` alone
};

/// @brief What a dimensional scene was divided by, in the units that it was given in.
struct Units {
    double mass = 1;             ///< m_1
    double stiffness = 1;        ///< k_1
    std::optional<double> force; ///< P, where it is known
    std::optional<double> base;  ///< X of a base that moves with the wall: P is m_1 omega^2 X

    /// @brief P at a frequency. @param omega angular frequency @return what is known of it
    [[nodiscard]] std::optional<double> force_at(double omega) const { return base ? mass * omega * omega * *base : force; }
};

/// @brief A system with friction and the point (r, beta) asked for.
template <class T>
struct Scene {
    System<T> system;             ///< masses, springs, damping, contact, load
    T mu = T(1);                  ///< static over kinetic friction, Eq. (3), at least 1
    std::optional<T> r;           ///< frequency ratio, Eq. (10)
    std::optional<T> beta;        ///< friction ratio, Eq. (11)
    std::optional<Units> units{}; ///< of a dimensional scene: its r and beta come from frequency, force and friction
};

/// @brief Number of masses N. @param s a system @return N
template <class T>
[[nodiscard]] std::size_t number_of_masses(const System<T>& s) {
    return s.mass_matrix.size() > 0 ? static_cast<std::size_t>(s.mass_matrix.rows()) : s.mass_ratios.size();
}

/// @brief Checks every rule of a system; throws InputError naming quantity, rule and value of the first that is broken.
/// @param system  the system
/// @throws        InputError
template <class T>
void check(const System<T>& system);

/// @brief Checks every rule of a scene; throws InputError naming quantity, rule and value of the first that is broken.
/// @param scene  the scene
/// @throws       InputError
template <class T>
void check(const Scene<T>& scene);

/// @brief A scene in another number type: the same binary fractions.
/// @param scene  a scene in double
/// @return       the scene in T
template <class T>
[[nodiscard]] Scene<T> converted(const Scene<double>& scene);

} // namespace denhartog

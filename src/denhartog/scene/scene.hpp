/// @file
/// @brief A scene: the system, the places of contact and load, friction, and the point (r, beta), Eqs. (1)-(11), (73).
///
/// A scene is non-dimensional. Input in physical units is divided by \f$ k_1 \f$, \f$ m_1 \f$ and P when it is read.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace denhartog {

/// @brief A square matrix over the number type.
template <class T>
using Matrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;

/// @brief A mass, counted from 0 here. JSON input, messages and the documentation count from 1.
struct Mass {
    std::size_t index = 0; ///< position in arrays over the masses
    /// @brief Whether two are the same mass. @return true if so
    bool operator==(const Mass&) const = default;
};

/// @brief A vibrating mode, counted from 0 in the order of ascending natural frequency.
struct Mode {
    std::size_t index = 0; ///< position in arrays over the modes
    /// @brief Whether two are the same mode. @return true if so
    bool operator==(const Mode&) const = default;
};

/// @brief Part of the surroundings that moves harmonically, in place of a load.
enum class BaseMotion : std::uint8_t {
    none,      ///< nothing: a load is given
    with_wall, ///< base and wall together; displacements are relative to them
    alone,     ///< the base, and the wall stays; displacements are absolute
    wall       ///< the wall, and the base stays; displacements are relative to the wall
};

/// @brief The system: a chain by ratios, or symmetric matrices of any topology.
///
/// Fill exactly one of `stiffness_ratios` and `stiffness_matrix`, exactly one of `mass_ratios` and `mass_matrix`, and exactly one
/// of `damping_ratios` and `damping_matrix`. Matrices must be symmetric to the last bit; `check` says which rule is broken.
template <class T>
struct System {
    std::vector<T> mass_ratios;         ///< gamma_i = m_i / m_1, Eq. (9), N values; the first is 1, all are positive
    std::vector<T> stiffness_ratios;    ///< kappa_i = k_i / k_1, Eq. (73), N values; the first is 1, all are positive
    Matrix<T> mass_matrix;              ///< M in units of m_1, N x N; positive definite
    Matrix<T> stiffness_matrix;         ///< K in units of k_1, N x N; positive definite
    std::vector<T> damping_ratios;      ///< zeta_i by ascending natural frequency, Eq. (18), N values; zero or positive
    Matrix<T> damping_matrix;           ///< C in units of sqrt(k_1 m_1), N x N
    double damping_tolerance = 0;       ///< how far K M^-1 C may be from C M^-1 K for C to count as modal damping
    Mass contact;                       ///< the mass in contact, j
    Mass load;                          ///< the loaded mass, l
    std::optional<Mass> contact_with{}; ///< the mass that the contact rubs against, instead of a wall: x_j - x_k slides
    std::vector<T> load_vector{};       ///< force on each mass in units of P, instead of `load`; N values or none
    std::vector<T> load_phases{}; ///< by how much each of them leads cos(tau), radians; N values, or none if all are in phase
    BaseMotion base_motion = BaseMotion::none; ///< whose load `load_vector` is, if it is that of a moving base or wall
    std::vector<double> load_error{};          ///< bounds of errors of the force on each mass besides rounding; N values or none
    std::vector<T> contact_direction{}; ///< w, where w^T x slides instead of x_j or x_j - x_k; N values or none. Mass j is then
                                        ///< the one that stands for the contact where one mass is asked about
};

/// @brief Whether the displacement of the contact is not that of one mass. @param s a system, or an answer about one @return true if so
template <class S>
[[nodiscard]] bool contact_moves_apart(const S& s) {
    return s.contact_with.has_value() || !s.contact_direction.empty();
}

/// @brief Whether dampers, or inertia, make the load of a base or wall depend on the frequency. @param s a system @return true if so
template <class T>
[[nodiscard]] bool load_depends_on_frequency(const System<T>& s) {
    if (s.base_motion != BaseMotion::alone) return s.base_motion == BaseMotion::wall;
    for (const T& zeta : s.damping_ratios)
        if (zeta != T(0)) return true;
    for (Eigen::Index i = 0; i < s.damping_matrix.size(); ++i)
        if (s.damping_matrix.data()[i] != T(0)) return true;
    return false;
}

/// @brief Units by which a scene in physical units was divided.
struct Units {
    double mass = 1;                      ///< m_1
    double stiffness = 1;                 ///< k_1
    std::optional<double> force;          ///< P, if it is known
    std::optional<double> base;           ///< amplitude X of a base that moves with the wall; then P is m_1 omega^2 X
    std::optional<double> acceleration{}; ///< amplitude A of the acceleration of a base or wall alone; then P is k_1 A / omega^2

    /// @brief P at a frequency. @param omega angular frequency @return P; empty if it is not known
    [[nodiscard]] std::optional<double> force_at(double omega) const {
        if (acceleration) return stiffness * (*acceleration / (omega * omega));
        return base ? mass * omega * omega * *base : force;
    }
    /// @brief Whether P changes with the frequency. @return true if so
    [[nodiscard]] bool force_changes() const { return base.has_value() || acceleration.has_value(); }
};

/// @brief A system with friction, and the point (r, beta) that is asked about.
template <class T>
struct Scene {
    System<T> system;             ///< masses, springs, damping, contact, load
    T mu = T(1);                  ///< static over kinetic friction, Eq. (3); at least 1
    std::optional<T> r;           ///< frequency ratio, Eq. (10); positive
    std::optional<T> beta;        ///< friction ratio, Eq. (11); zero or positive
    std::optional<Units> units{}; ///< if the scene was in physical units: the units to convert answers back
    /// Constant force on each mass in units of P, N values or none. Displacements of a steady motion are those from the place of
    /// rest to which it moves the masses, see `place_of_rest`
    std::vector<T> static_load;
};

/// @brief Number of masses N. @param s a system @return N
template <class T>
[[nodiscard]] std::size_t number_of_masses(const System<T>& s) {
    return s.mass_matrix.size() > 0 ? static_cast<std::size_t>(s.mass_matrix.rows()) : s.mass_ratios.size();
}

/// @brief Whether a system is given as a chain. @param s a system @return true where masses and stiffnesses are ratios
template <class T>
[[nodiscard]] bool is_chain(const System<T>& s) {
    return !s.mass_ratios.empty() && !s.stiffness_ratios.empty();
}

/// @brief Checks every rule of a system.
/// @param system  the system
/// @throws        InputError that names quantity, rule and value, for the first rule that is broken
template <class T>
void check(const System<T>& system);

/// @brief Checks every rule of a scene.
/// @param scene  the scene
/// @throws       InputError that names quantity, rule and value, for the first rule that is broken
template <class T>
void check(const Scene<T>& scene);

/// @brief A scene in another number type. Every double is taken as exact.
/// @param scene  a scene in double
/// @return       the scene in T
template <class T>
[[nodiscard]] Scene<T> converted(const Scene<double>& scene);

} // namespace denhartog

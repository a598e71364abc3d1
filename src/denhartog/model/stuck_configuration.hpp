/// @file
/// @brief The stuck configuration: the masses that keep oscillating while the contact is held, Section 4.3.
///
/// Nothing of it depends on r. The blocks are those of the full matrices with row and column j taken out: on a chain the masses
/// on both sides of the contact, which the damping (19) couples across it. Between two masses the displacement of the contact has
/// the place of that of mass a, see `Contact`: row and column a of the matrices with it are taken out.
#pragma once

#include <vector>

#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/model/modal_basis.hpp"

namespace denhartog {

/// @brief Modes of the system with the contact held, and what of its motion loads the contact.
///
/// Units: masses m_1, stiffnesses k_1, damping sqrt(k_1 m_1). The arrays over masses are in the order of `masses`.
template <class T>
struct StuckConfiguration {
    Contact contact;              ///< the contact; j below is its mass a
    std::vector<Mass> masses;         ///< all masses but a, ascending, N - 1
    Matrix<T> M;                      ///< their block of the mass matrix, (N - 1) x (N - 1)
    Matrix<T> C;                      ///< their block of the full damping matrix (19)
    Matrix<T> K;                      ///< their block of the stiffness matrix
    std::vector<T> m_j;               ///< row j of the mass matrix over these masses; zero where masses are lumped
    std::vector<T> c_j;               ///< row j of the damping matrix over these masses
    std::vector<T> k_j;               ///< row j of the stiffness matrix over these masses
    T k_jj;                           ///< diagonal entry of the stiffness matrix at the contact
    T k_contact;                      ///< static stiffness of the contact with the others free to follow: 1 / (K^-1)_jj
    std::vector<T> r_n;               ///< natural frequency ratios of the stuck configuration, ascending, N - 1
    Matrix<T> phi;                    ///< mode shapes, mass by mode, phi^T M phi = 1
    Matrix<T> shapes;                 ///< the same of all N masses
    Matrix<T> momentum;               ///< phi^T M: modal coordinates of the displacements of all N masses
    std::vector<T> carried;           ///< how far each of the N masses goes with the contact while the modes are at rest
    std::vector<T> load;              ///< force on each mass where it acts on several, N values; else none
    Matrix<T> damping;                ///< phi^T C phi; its diagonal is 2 zeta*_i r_n,i
    T coupling;                       ///< largest off-diagonal |D_ik| / sqrt(D_ii D_kk) of `damping`; zero for fewer than two
    bool modes_diagonalise_damping{}; ///< whether `coupling` is explained by rounding: zeta*_i then describe the motion
    Matrix<T> left_out{};             ///< bounds of the entries of `damping` between modes where they do; else empty
};

/// @brief What more digits have found of a system, rounded once, beside the modes while the contact slides.
template <class T>
struct RoundedModes {
    Matrix<T> momentum; ///< phi^T M in units of m_1, of the modes while the contact slides, mode by mass
    Matrix<T> C;        ///< damping matrix of the whole system in units of sqrt(k_1 m_1), N x N
    std::vector<T> r_n; ///< natural frequency ratios with the contact held, ascending, N - 1
    Matrix<T> phi;      ///< mode shapes of these, mass by mode, phi^T M phi = 1
    Matrix<T> damping;  ///< phi^T C phi of these; zero where it does not couple two modes
};

/// @brief The force on a mass in units of P, where the load is on l or, if the configuration has it, on several.
template <class T>
[[nodiscard]] T force_on(const StuckConfiguration<T>& stuck, Mass k, Mass load) {
    return stuck.load.empty() ? T(k == load ? 1 : 0) : stuck.load[k.index];
}

/// @brief What a load brings to each stuck mode, phi^T p.
template <class T>
[[nodiscard]] std::vector<T> load_on_stuck_modes(const StuckConfiguration<T>& stuck, Mass load) {
    std::vector<T> of_modes(stuck.masses.size(), T(0));
    for (Eigen::Index k = 0; k < stuck.shapes.rows(); ++k) {
        const T force = force_on(stuck, Mass{static_cast<std::size_t>(k)}, load);
        if (force == 0) continue;
        for (std::size_t i = 0; i < of_modes.size(); ++i) of_modes[i] += force * stuck.shapes(k, static_cast<Eigen::Index>(i));
    }
    return of_modes;
}

/// @brief The part of a load that acts on the contact itself, delta_lj, or p_j of a load on several.
template <class T>
[[nodiscard]] T direct_load(const StuckConfiguration<T>& stuck, Mass load) {
    return stuck.contact.sign * force_on(stuck, Mass{stuck.contact.a}, load);
}

/// @brief The compliance of a row of the mode shapes, (K^-1)_jj of a mass, as a sum of squares over the modes.
template <class T>
[[nodiscard]] T compliance(const ModalBasis<T>& basis, Eigen::Index row) {
    T sum(0);
    for (std::size_t i = 0; i < basis.r_n.size(); ++i) {
        const T part = basis.phi(row, static_cast<Eigen::Index>(i)) / basis.r_n[i];
        sum += part * part;
    }
    return sum;
}

/// @brief The stuck configuration of a system; one more eigenproblem (15), none where N is 1 or 2. `held` is what more digits
/// have found, and spares the eigenproblem; it may be null. There are no masses where N = 1. InputError where `check` throws;
/// PrecisionError where the eigenproblem is not solved.
template <class T>
[[nodiscard]] StuckConfiguration<T> stuck_configuration(const System<T>& s, const ModalBasis<T>& basis,
                                                        const RoundedModes<T>* held = nullptr);

} // namespace denhartog

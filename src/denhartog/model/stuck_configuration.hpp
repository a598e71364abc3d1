/// @file
/// @brief The stuck configuration: the masses that keep oscillating while the contact is held, Section 4.3.
///
/// Nothing of it depends on r. The blocks are those of the full matrices with row and column j taken out: on a chain the masses
/// on both sides of the contact, which the damping (19) couples across it. Between two masses, and
/// along any other direction, the displacement of the contact has the place of that of mass a, see `Contact`: row and column a of
/// the matrices with it are taken out.
#pragma once

#include <vector>

#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/model/modal_basis.hpp"

namespace denhartog {

/// @brief Modes of the system with the contact held, and the parts of its motion that load the contact.
///
/// Units: masses m_1, stiffnesses k_1, damping sqrt(k_1 m_1). The arrays over masses are in the order of `masses`.
struct StuckConfiguration {
    Contact contact;                   ///< the contact; j below is its mass a
    std::vector<Mass> masses;          ///< all masses but a, ascending, N - 1
    Matrix<double> M;                  ///< their block of the mass matrix, (N - 1) x (N - 1)
    Matrix<double> C;                  ///< their block of the full damping matrix (19)
    Matrix<double> K;                  ///< their block of the stiffness matrix
    std::vector<double> m_j;           ///< row j of the mass matrix over these masses; zero where masses are lumped
    std::vector<double> c_j;           ///< row j of the damping matrix over these masses
    std::vector<double> k_j;           ///< row j of the stiffness matrix over these masses
    double k_jj;                       ///< diagonal entry of the stiffness matrix at the contact
    double k_contact;                  ///< static stiffness of the contact with the others free to follow: 1 / (K^-1)_jj
    std::vector<double> r_n;           ///< natural frequency ratios of the stuck configuration, ascending, N - 1
    Matrix<double> phi;                ///< mode shapes, mass by mode, phi^T M phi = 1
    Matrix<double> shapes;             ///< the same of all N masses
    Matrix<double> momentum;           ///< phi^T M: modal coordinates of the displacements of all N masses
    std::vector<double> carried;       ///< how far each of the N masses goes with the contact while the modes are at rest
    std::vector<Complex<double>> load; ///< force on each mass where it acts on several, N values; else none
    Matrix<double> damping;            ///< phi^T C phi; its diagonal is 2 zeta*_i r_n,i
    bool modes_diagonalise_damping{};  ///< whether `damping` is diagonal but for rounding: zeta*_i then describe the motion
    Matrix<double> left_out{};         ///< bounds of the entries of `damping` between modes where they do; else empty
};

/// @brief Matrices and modes that more digits have found, rounded once, beside the modes while the contact slides.
struct RoundedModes {
    Matrix<double> momentum; ///< phi^T M in units of m_1, of the modes while the contact slides, mode by mass
    Matrix<double> C;        ///< damping matrix of the whole system in units of sqrt(k_1 m_1), N x N
    std::vector<double> r_n; ///< natural frequency ratios with the contact held, ascending, N - 1
    Matrix<double> phi;      ///< mode shapes of these, mass by mode, phi^T M phi = 1
    Matrix<double> damping;  ///< phi^T C phi of these; zero where it does not couple two modes
};

/// @brief The complex force on a mass in units of P, where the load is on l or, if the configuration has it, on several.
[[nodiscard]] inline Complex<double> force_on(const StuckConfiguration& stuck, Mass k, Mass load) {
    return stuck.load.empty() ? Complex<double>{k == load ? 1.0 : 0.0, 0} : stuck.load[k.index];
}

/// @brief The load on each stuck mode, phi^T p.
[[nodiscard]] inline std::vector<Complex<double>> load_on_stuck_modes(const StuckConfiguration& stuck, Mass load) {
    std::vector<Complex<double>> loads(stuck.masses.size(), {0, 0});
    for (Eigen::Index k = 0; k < stuck.shapes.rows(); ++k) {
        const Complex<double> force = force_on(stuck, Mass{static_cast<std::size_t>(k)}, load);
        if (force.re == 0 && force.im == 0) continue;
        for (std::size_t i = 0; i < loads.size(); ++i)
            loads[i] = loads[i] + stuck.shapes(k, static_cast<Eigen::Index>(i)) * force;
    }
    return loads;
}

/// @brief The part of a load that acts on the contact itself, delta_lj, or p_j of a load on several.
[[nodiscard]] inline Complex<double> direct_load(const StuckConfiguration& stuck, Mass load) {
    const Complex<double> force = force_on(stuck, Mass{stuck.contact.a}, load);
    return {stuck.contact.over(force.re), stuck.contact.over(force.im)};
}

/// @brief The compliance of a row of the mode shapes, (K^-1)_jj of a mass, as a sum of squares over the modes.
[[nodiscard]] inline double compliance(const ModalBasis<double>& basis, Eigen::Index row) {
    double sum(0);
    for (std::size_t i = 0; i < basis.r_n.size(); ++i) {
        const double part = basis.phi(row, static_cast<Eigen::Index>(i)) / basis.r_n[i];
        sum += part * part;
    }
    return sum;
}

/// @brief The stuck configuration of a system; one more eigenproblem (15), none where N is 1 or 2. `held` is what more digits
/// have found, and spares the eigenproblem, which is paid from a budget; both may be null. There are no masses if N = 1.
/// InputError if `check` throws; PrecisionError if the eigenproblem is not solved.
[[nodiscard]] StuckConfiguration stuck_configuration(const System<double>& s, const ModalBasis<double>& basis,
                                                     const RoundedModes* held = nullptr, Effort* effort = nullptr);

} // namespace denhartog

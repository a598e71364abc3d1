/// @file
/// @brief Modal damping ratios of a system whose damping is given as a matrix, (18).
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "denhartog/model/modal_basis.hpp"
#include "denhartog/model/natural_modes.hpp"

namespace denhartog {

/// @brief What the natural frequencies of an eigen-solver are good to.
enum class FrequencyErrors {
    of_each,    ///< units in the last place of each, as those of a chain are
    of_highest, ///< squares good to units in the last place of the highest one
};

/// @brief Modal damping ratios from the damping matrix, \f$ 2\zeta_i r_{n,i} = \phi_i^T C \phi_i \f$, and the matrix itself in
/// the coordinates of the modes.
///
/// The modes move by themselves where \f$ K M^{-1} C = C M^{-1} K \f$. With A and B the stiffness and damping matrices that have
/// the square root of M divided out on both sides the condition is A B = B A, and the distance from it is
/// \f$ \|AB - BA\|_F / (\|A\|_F \|B\|_F) \f$, 0 to sqrt 2. Of one mode, of a matrix of zeros, and up to the distance `neglected`,
/// if that is not 0, the ratios count alone. Else the matrix counts, whether it couples the modes or not; that is told too. The
/// distance does not tell it alone: beside a stiff mode with much damping two soft ones leave no trace in it. Where natural
/// frequencies coincide the mode shapes are turned to those that diagonalise C as well, if the ratios count or rounding explains
/// the distance. L is the factor of M = L L^T in units of m_1; K is in units of k_1, C in units of sqrt(k_1 m_1). InputError
/// where C feeds energy into a motion, or gives a ratio beyond its range.
/// @eq{18}
void set_modal_damping(const Matrix<double>& L, const Matrix<double>& K, const Matrix<double>& C, double neglected,
                       FrequencyErrors errors, ModalBasis<double>& basis);

/// @brief What rounding makes of the entries of C between modes: the rounding of the shapes, and the angle by which the solver
/// may turn two modes towards each other. The bounds are zero on the diagonal. C is in units of sqrt(k_1 m_1), and D is
/// \f$ \phi^T C \phi \f$. @eq{18}
[[nodiscard]] Matrix<double> rounding_between_modes(const Matrix<double>& C, const Matrix<double>& D, const NaturalModes& modes,
                                                    FrequencyErrors errors);

/// @brief Whether C couples two modes by more than rounding makes of its entry between them, however small that entry is beside
/// those of stiffer modes. @eq{18}
[[nodiscard]] bool couples_a_pair(const Matrix<double>& D, const Matrix<double>& rounding);

/// @brief Checks that a damping matrix takes energy out of every motion, else InputError; a zero eigenvalue may be below zero by
/// rounding to double.
void check_passive(const Matrix<double>& C);

/// @brief How much damping couples modes: the largest \f$ |D_{ik}| / \sqrt{D_{ii} D_{kk}} \f$ of \f$ D = \phi^T C \phi \f$. It is
/// from 0 to 1. A product of two diagonal entries below the square of `rounding`, the error of the entries, counts as that.
/// @eq{18}
[[nodiscard]] double largest_coupling(const Matrix<double>& D, double rounding);

/// @brief What rounding may make of natural frequencies, of the entries of a modal damping matrix and of the measure by which it
/// couples modes, beside the largest of its kind. It is some units in the last place for each mode.
[[nodiscard]] inline double rounding_of_modes(std::size_t N) {
    return 8 * static_cast<int>(N) * std::numeric_limits<double>::epsilon();
}

/// @brief The same of entries that are as good as rounding lets them be.
[[nodiscard]] inline double largest_coupling(const Matrix<double>& D) {
    return largest_coupling(D, rounding_of_modes(static_cast<std::size_t>(D.rows())) * D.cwiseAbs().maxCoeff());
}

/// @brief Whether the natural frequency of mode i, not the last one, coincides with the next one: differences up to `tolerance`
/// times the highest count as none.
[[nodiscard]] inline bool coincides_with_next(const std::vector<double>& r_n, std::size_t i, double tolerance) {
    return r_n[i + 1] - r_n[i] <= tolerance * r_n.back();
}

/// @brief Turns the mode shapes of every group of coinciding natural frequencies to those that diagonalise C within the group.
/// Frequencies coincide as above.
void turn_coinciding_modes(const Matrix<double>& C, double tolerance, const std::vector<double>& r_n, Matrix<double>& phi);

} // namespace denhartog

/// @file
/// @brief Modal damping ratios of a system whose damping is given as a matrix, (18).
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "denhartog/model/modal_basis.hpp"

namespace denhartog {

/// @brief Modal damping ratios from the damping matrix, \f$ 2\zeta_i r_{n,i} = \phi_i^T C \phi_i \f$.
///
/// A system with a damping matrix moves as the exponential of its state does, whether the matrix couples the modes or not: `D` is
/// filled. Its modes move by themselves where \f$ K M^{-1} C = C M^{-1} K \f$. With A and B the stiffness and damping matrices
/// that have the square root of M divided out on both sides the condition is A B = B A, and the distance from it is measured as
/// \f$ \|AB - BA\|_F / (\|A\|_F \|B\|_F) \f$ (0 to sqrt 2). Where that is no more than what is to be neglected, the ratios count
/// and there is no `D`; nor is there one for a single mode and for a matrix of zeros. Where natural frequencies coincide the mode
/// shapes are turned to those that diagonalise C as well.
/// @eq{18}
/// @param L      lower triangular factor of the mass matrix in units of m_1, M = L L^T
/// @param K      stiffness matrix in units of k_1
/// @param C      damping matrix in units of sqrt(k_1 m_1)
/// @param neglected  the distance up to which the damping ratios count in the place of C; 0: none
/// @param basis  natural frequency ratios and mode shapes; gets the damping ratios and, where C counts, D
/// @throws InputError where C feeds energy into a motion, or gives a ratio beyond its range
template <class T>
void set_modal_damping(const Matrix<T>& L, const Matrix<T>& K, const Matrix<T>& C, double neglected, ModalBasis<T>& basis);

/// @brief Checks that a damping matrix takes energy out of every motion; a zero eigenvalue may be below zero by rounding to double.
/// @param C  damping matrix in units of sqrt(k_1 m_1)
/// @throws   InputError where it does not
template <class T>
void check_passive(const Matrix<T>& C);

/// @brief How much damping couples modes: the largest \f$ |D_{ik}| / \sqrt{D_{ii} D_{kk}} \f$ of \f$ D = \phi^T C \phi \f$.
/// @eq{18}
/// @param D  modal damping matrix; a product of two diagonal entries below the square of its rounding counts as that
/// @return   0 to 1
template <class T>
[[nodiscard]] T largest_coupling(const Matrix<T>& D);

/// @brief What rounding may make of natural frequencies, of the entries of a modal damping matrix and of the measure by which it
/// couples modes, beside the largest of its kind.
/// @param N  number of modes
/// @return   some units in the last place for each mode
template <class T>
[[nodiscard]] T rounding_of_modes(std::size_t N) {
    return 8 * static_cast<int>(N) * std::numeric_limits<T>::epsilon();
}

/// @brief The damping matrix in the modes. Mode shapes of natural frequencies that coincide are turned to those that it does not
/// couple: neighbours that are apart by no more than rounding makes of them.
/// @eq{18}
/// @param C    damping matrix in units of sqrt(k_1 m_1)
/// @param r_n  natural frequency ratios, ascending, at least one
/// @param phi  mode shapes, mass by mode; those that coincide are turned, the signs are those of `fix_signs`
/// @return     phi^T C phi, symmetric; zero between modes that were turned
/// @throws     PrecisionError where an eigenproblem is not solved
template <class T>
[[nodiscard]] Matrix<T> damping_in_modes(const Matrix<T>& C, const std::vector<T>& r_n, Matrix<T>& phi);

} // namespace denhartog

/// @file
/// @brief The modal basis of a system: natural frequency ratios, mode shapes, damping ratios, (13)-(19).
///
/// Nothing of it depends on r: \f$ R_i = r/r_{n,i} \f$ and \f$ \psi_i = \phi_i/r \f$ at every r, so that one eigen-solve serves a
/// whole map.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/model/natural_modes.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/work_counted.hpp"
#include "denhartog/scene/scene.hpp"

namespace denhartog {

/// @brief Natural frequency ratios and mode shapes normalised with the mass matrix in units of m_1.
///
/// The sign of a mode shape: positive is the first component that has more than three eighths of the size of the largest.
template <class T>
struct ModalBasis {
    std::vector<T> r_n;          ///< natural frequency ratios omega_i sqrt(m_1 / k_1), ascending, N values
    Matrix<T> phi;               ///< mode shapes, mass by mode, phi^T M phi = 1, N x N; `further_rows` of the system behind them
    std::vector<T> zeta;         ///< modal damping ratios, N values; of a damping matrix those that its diagonal has
    Matrix<T> D{};               ///< phi^T C phi where a damping matrix counts, N x N; else empty
    T distance_from_classical{}; ///< of a damping matrix, \f$ \|AB - BA\|_F / (\|A\|_F \|B\|_F) \f$, 0 to sqrt 2, where A and B are
                                 ///< K and C with the square root of M divided out on both sides; 0 without one
    bool couples{}; ///< whether D couples two modes by more than rounding tells: they then have no functions of their own

    /// @brief True if a damping matrix counts: the modes then are not taken to move by themselves, even if it does not couple them.
    [[nodiscard]] bool coupled() const { return D.size() > 0; }
};

/// @brief True if the damping matrix that was given counts, and not the damping ratios nearest to it: damping was given neither by
/// ratios, nor by a matrix within `damping_tolerance` of having them.
template <class T, class Number>
[[nodiscard]] bool damping_matrix_counts(const System<T>& s, const ModalBasis<Number>& basis) {
    return s.damping_matrix.size() > 0 && (s.damping_tolerance == 0 || basis.coupled());
}

/// @brief The lower triangular factor of the mass matrix, M = L L^T: the roots of the masses where these are lumped.
/// PrecisionError where rounding leaves the matrix indefinite.
[[nodiscard]] Matrix<double> mass_factor(const System<double>& s);

/// @brief True if every motion is damped: with mu = 1 two motions under the same force then come to the same velocities. Modes
/// that are coupled are damped if the damping matrix is positive definite.
template <class T>
[[nodiscard]] bool every_motion_is_damped(const ModalBasis<T>& basis);

/// @brief Solves the eigenproblem (15) once, paid from a budget; not at all where N = 1.
///
/// A chain given by ratios is solved through a bidiagonal matrix: each natural frequency comes with an error of about N eps of
/// itself, however stiff its springs. Other systems are solved through a symmetric matrix: errors of the squared frequencies are
/// about N eps of the highest one, or of each one where the masses are very different, see `graded_modes`.
/// InputError where `check` throws, or C feeds energy into the motion. PrecisionError where the iteration does not converge, the
/// lowest natural frequency is too low beside the highest, or a mode is beyond the range of the number type.
/// @eq{14,15}
[[nodiscard]] ModalBasis<double> modal_basis(const System<double>& s, Effort* effort = nullptr);

/// @brief The basis of a chain of two masses and more with damping ratios, with the shapes at a few masses alone, a row for each in
/// that order, and each mode with any sign: O(N^2) operations in place of O(N^3). @eq{14,15}
[[nodiscard]] ModalBasis<double> modal_basis_at(const System<double>& s, const std::vector<Mass>& masses,
                                                Effort* effort = nullptr);

/// @brief Number of eigenproblems (15) solved since the program started; tests gate on it.
[[nodiscard]] inline long eigen_solves() { return work_counted.eigen_solves; }

/// @brief Matrices M, C, K of (6) at a frequency ratio; InputError where that is not positive and finite. The basis is used where
/// damping is given by ratios. @eq{7,8,19}
[[nodiscard]] NonDimensionalMatrices non_dimensional_matrices(const System<double>& s, const ModalBasis<double>& basis, double r);

/// @brief Accuracy of the natural frequencies of an eigen-solver.
enum class FrequencyErrors {
    each,   ///< units in the last place of each, as those of a chain are
    highest ///< squares good to units in the last place of the highest one
};

/// @brief Bounds of the rounding of the entries of \f$ D = \phi^T C \phi \f$ between modes: by that of the shapes, and by the angle
/// through which the solver may turn two modes towards each other; zero on the diagonal. @eq{18}
[[nodiscard]] Matrix<double> rounding_between_modes(const Matrix<double>& C, const Matrix<double>& D, const NaturalModes& modes,
                                                    FrequencyErrors errors);

/// @brief True if an entry of D between two modes is larger than rounding makes it, however small it is beside those of stiffer
/// modes. @eq{18}
[[nodiscard]] bool couples_a_pair(const Matrix<double>& D, const Matrix<double>& rounding);

/// @brief Bound of the rounding of natural frequencies, of the entries of D and of the distance from classical damping, beside the
/// largest of its kind: some units in the last place for each mode.
[[nodiscard]] inline double rounding_of_modes(std::size_t N) {
    return 8 * static_cast<int>(N) * std::numeric_limits<double>::epsilon();
}

/// @brief The coupling of modes by damping, from 0 to 1: the largest \f$ |D_{ik}| / \sqrt{D_{ii} D_{kk}} \f$ of
/// \f$ D = \phi^T C \phi \f$. A product of two diagonal entries below the square of `rounding`, the error of the entries, counts
/// as that; by default it is `rounding_of_modes`. @eq{18}
[[nodiscard]] double largest_coupling(const Matrix<double>& D, std::optional<double> rounding = std::nullopt);

/// @brief Turns the shapes of modes whose natural frequencies coincide to those that diagonalise C among them.
void turn_coinciding_modes(const Matrix<double>& C, double tolerance, const std::vector<double>& r_n, Matrix<double>& phi);

} // namespace denhartog

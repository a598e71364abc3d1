/// @file
/// @brief The sums (33) to (35) and (64) of a system whose damping couples the modes, found without modes.
#pragma once

#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/sums/bounded_modes.hpp"
#include "denhartog/sums/coupled_friction.hpp"

namespace denhartog {

/// @brief A linear system whose solutions have bounds of their errors, by what they leave over.
class BoundedSystem {
public:
    /// @brief Of a matrix whose entries are off by no more than `error`, and by rounding.
    BoundedSystem(const Matrix<double>& A, const Matrix<double>& error);
    /// @brief Whether no pivot is rounding of the others.
    [[nodiscard]] bool is_regular() const { return is_regular_; }
    /// @brief The solution of \f$ Ax=b \f$.
    [[nodiscard]] std::vector<Bounded<double>> solved(const Column& b) const { return solved(b, Column::Zero(b.size())); }
    /// @brief The solution for b, with bounds that include errors of b besides rounding.
    [[nodiscard]] std::vector<Bounded<double>> solved(const Column& b, const Column& error) const;

private:
    Matrix<double> A_, error_, inverse_;
    bool is_regular_;
};

/// @brief \f$ \mathbf K - r^2\mathbf M + \mathrm ir\mathbf C \f$ as a real system of twice the size; C is off by no more than
/// `error_of_C`.
[[nodiscard]] BoundedSystem harmonic_system(const Matrix<double>& M, const Matrix<double>& C, const Matrix<double>& K,
                                            const Matrix<double>& error_of_C, const Bounded<double>& r);

/// @brief Complex responses of such a system to harmonic forces, which are off by no more than `errors` besides rounding; none
/// where they are not.
[[nodiscard]] std::vector<Complex<Bounded<double>>>
harmonic_responses(const BoundedSystem& system, const std::vector<Complex<double>>& forces, const std::vector<double>& errors);

/// @brief V, U, G, Y_jj, H_j of a system whose damping couples the modes; it has no modes, and their lists are empty.
/// @eq{33,34,35,64,65}
[[nodiscard]] ModeSums<Bounded<double>> coupled_sums(const System<double>& system, const Bounded<double>& r,
                                                     Effort* effort = nullptr);

/// @brief The sums over modes with bounds of their errors, or their substitute if damping couples the modes. DomainError
/// at a pole of a mode without damping. @eq{33,34,35,64,65}
[[nodiscard]] inline ModeSums<Bounded<double>> bounded_sums(const System<double>& system,
                                                            const ModalBasis<Bounded<double>>& basis, const Bounded<double>& r,
                                                            Effort* effort = nullptr) {
    return basis.coupled() ? coupled_sums(system, r, effort) : mode_sums(basis, contact_row(system), load_rows(system), r);
}

} // namespace denhartog

/// @file
/// @brief Friction's share of the sliding motion of a system whose damping couples the modes, for any symmetric damping matrix, and
/// the functions that take the place of the sums (33) to (35) and (64) there.
///
/// Between two stops (12) is linear whatever its damping matrix is, and the friction force is constant. With
/// \f$ \mathbf{M} = \mathbf{L}\mathbf{L}^T \f$, \f$ \mathbf{K} = \mathbf{G}\mathbf{G}^T \f$ and the energy coordinates
/// \f$ \mathbf{s} = (\mathbf{G}^T\mathbf{x}/r,\ \mathbf{L}^T\mathbf{x}') \f$ the free motion obeys
/// \f[ \mathbf{s}' = \mathbf{A}\mathbf{s}, \qquad \mathbf{A} = \frac{1}{r}\begin{pmatrix} \mathbf{0} & \mathbf{P}^T
///     \\ -\mathbf{P} & -\mathbf{B} \end{pmatrix}, \qquad \mathbf{P} = \mathbf{L}^{-1}\mathbf{G}, \quad
///     \mathbf{B} = \mathbf{L}^{-1}\mathbf{C}\mathbf{L}^{-T}, \f]
/// and \f$ |\mathbf{s}| \f$ never grows, so that errors add up and do not multiply. A unit friction force that changes sign every
/// half period moves the system by
/// \f[ \mathbf{s}_F(\tau) = \mathbf{s}_0 - e^{\mathbf{A}\tau}\mathbf{c}, \qquad (\mathbf{1}+e^{\mathbf{A}\pi})\,\mathbf{c} =
///     2\mathbf{s}_0, \f]
/// where \f$ \mathbf{s}_0 \f$ is rest under the force: the only such motion that mirrors itself, (25). Of mass k it is what the
/// sum over modes of the braces of (40) is where the modes are not coupled, and \f$ U_{dk} \f$, \f$ G_k \f$ are its velocity and
/// its displacement at \f$ \tau = 0 \f$ with the other sign. All that the paper builds of V, U and G then holds as it stands.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "denhartog/evaluation/mode_values.hpp"
#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/model/coupled_motion.hpp"
#include "denhartog/number/bounded.hpp"
#include "denhartog/sliding/mode_sums.hpp"

namespace denhartog {

/// @brief \f$ e^{\mathbf{A}\tau}\mathbf{c} \f$ at an instant, and its first three derivatives.
using CoupledState = std::array<Column, 4>;

/// @brief Friction's share of the motion at one frequency ratio, if damping couples the modes. Not for two threads at once.
class CoupledFriction {
public:
    /// @brief Of a system with a damping matrix, at a frequency ratio; exponentials are paid from a budget. DomainError at a
    /// pole, a motion without damping that mirrors itself every half-period; PrecisionError if the number type does not have the
    /// digits of its coordinates.
    CoupledFriction(const System<double>& system, double r, Effort* effort = nullptr);

    [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(A_.rows() / 2); } ///< number of coordinates
    [[nodiscard]] long cost() const { return motion_.cost() + 10; } ///< operations that an instant costs
    /// @brief The static compliance between a displacement and the contact: its movement under a unit force on the contact.
    [[nodiscard]] Bounded<double> compliance(std::size_t k) const { return along(displacement_, k, rest_, error_of_rest_); }
    /// @brief \f$ \mathbf{w}^T\mathbf{M}^{-1}\mathbf{w}/r^2 \f$, which (65) is at the contact.
    [[nodiscard]] Bounded<double> inverse_inertia() const { return inverse_inertia_; }

    /// @brief The free part of the motion at an instant in [0, pi], valid until the next call.
    [[nodiscard]] const CoupledState& at(double tau) const;
    /// @brief A derivative, of order 1 to 3, of a displacement over the half-period, with the free part at the instant.
    [[nodiscard]] double derivative(std::size_t k, int order, const CoupledState& s) const;
    /// @brief Bound of a derivative, of order 1 to 3, of a displacement from the instant of the free part on.
    [[nodiscard]] double largest_derivative(std::size_t k, int order, const CoupledState& s) const;
    /// @brief Largest rate of the sum of the third and the first derivative of a displacement, from an instant on.
    [[nodiscard]] double rate_of_demand(std::size_t k, const CoupledState& s) const;

    /// @brief Displacement, velocity and acceleration of a mass under the friction force alone, at an instant in [0, pi]; they
    /// have the place of the sum over modes of the braces of (40).
    [[nodiscard]] evaluation::FrictionMotion<double> motion(std::size_t k, double tau) const;
    /// @brief Friction's share with bounds of its errors.
    [[nodiscard]] evaluation::FrictionMotion<Bounded<double>> motion(std::size_t k, const Bounded<double>& tau) const;

private:
    // Rows that give displacements or velocities from half of the energy coordinates, with their errors.
    struct Rows {
        Matrix<double> value, error;
    };

    void set_coordinates(const System<double>& system, double r);
    void set_start();
    [[nodiscard]] double error_at(double tau) const;
    [[nodiscard]] Bounded<double> along(const Rows& rows, std::size_t k, const Column& half, double error) const;

    Matrix<double> A_;        // of the energy coordinates
    double size_of_A_;        // its Frobenius norm
    double error_of_A_;       // of its entries, in the same norm
    Rows displacement_;       // from the first half
    Rows velocity_;           // from the second
    Column rest_;             // first half of s_0
    double error_of_rest_;    // in size
    Column c_;                // as above
    double error_of_c_ = 0.0; // in size
    Bounded<double> inverse_inertia_;
    mutable CoupledMotion motion_;
    mutable std::map<double, CoupledState> known_;
};

/// @brief (57)'s expression summed over the contact, if damping couples the modes: what of X_j + beta G_j friction demands.
/// The limits at both ends of [0, pi] are included. @eq{56,57,71}
template <class Number>
[[nodiscard]] Number coupled_demand(const CoupledFriction& friction, Mass contact, const Number& tau) {
    const evaluation::FrictionMotion<Number> now = friction.motion(contact.index, tau);
    if (!(tau > Number(0))) return now.double_prime;
    if (!(tau < pi<Number>())) return -now.double_prime;
    const evaluation::FrictionMotion<Number> start = friction.motion(contact.index, Number(0));
    return (now.prime - start.prime * cos(tau)) / sin(tau);
}

/// @brief A linear system whose solutions have bounds of their errors, by what they leave over.
class BoundedSystem {
public:
    /// @brief Of a matrix whose entries are off by no more than `error`, and by rounding.
    BoundedSystem(const Matrix<double>& A, const Matrix<double>& error);
    [[nodiscard]] bool is_regular() const { return is_regular_; } ///< whether no pivot is rounding of the others
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

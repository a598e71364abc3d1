/// @file
/// @brief The map over half-periods of the force, mirrored after each, with its Jacobian, its rounding and a norm.
#pragma once

#include <vector>

#include "denhartog/orbit/map_rounding.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {

/// @brief Difference of two states. @param a a state @param b another @return a - b: displacements, then velocities
[[nodiscard]] Column<double> difference(const State& a, const State& b);

/// @brief A Jacobian over displacements and velocities between modal velocities and modal displacements times frequencies.
/// @param J         2N x 2N
/// @param momentum  phi^T M
/// @param phi       mode shapes
/// @param r_n       natural frequency ratios
/// @param r         frequency ratio
/// @return          the matrix in these coordinates
[[nodiscard]] Matrix<double> in_energy_coordinates(Matrix<double> J, const Matrix<double>& momentum, const Matrix<double>& phi,
                                                   const std::vector<double>& r_n, double r);

/// @brief \f$ z \mapsto (-1)^h\Phi_{0\to h\pi}(z) \f$, as it was applied last.
class OrbitMap {
public:
    /// @param solver  system, frequency and friction; must outlive this
    explicit OrbitMap(ExactSolver& solver)
        : N(static_cast<Eigen::Index>(solver.system().basis.r_n.size())), solver_(&solver), difference_(2 * N),
          image_(at_rest(static_cast<std::size_t>(N))) {}

    const Eigen::Index N; ///< number of masses

    /// @brief Applies the map.
    /// @param z              the state at tau = 0
    /// @param half_periods   how many half-periods, h
    /// @param with_jacobian  whether the Jacobian and the rounding of the image are wanted
    /// @return               false where the motion chatters
    bool apply(const State& z, int half_periods, bool with_jacobian);

    /// @brief Whether the contact rested throughout. @return true where it did
    [[nodiscard]] bool held() const;

    /// @brief Whether the contact did not rest at all. @return true where it did not
    [[nodiscard]] bool slides_throughout() const;

    /// @brief Jacobian of the map. @return 2N x 2N
    [[nodiscard]] Matrix<double> jacobian() const { return h_ % 2 != 0 ? Matrix<double>(-motion_->jacobian) : motion_->jacobian; }

    /// @brief The matrix of Newton's method. @return 1 - Jacobian
    [[nodiscard]] Matrix<double> newton_matrix() const;

    /// @brief A deviation as modal displacements times frequencies, then modal velocities.
    /// @param dz  displacements, then velocities
    /// @return    its 2N coordinates
    [[nodiscard]] Column<double> in_energy(const Column<double>& dz) const;

    /// @brief Square root of twice the energy of a deviation, times 1/r: what friction with mu = 1 lets no two motions increase.
    /// @param dz  displacements, then velocities
    /// @return    the norm
    [[nodiscard]] double norm(const Column<double>& dz) const { return in_energy(dz).norm(); }

    /// @brief The norm of a state. @param z the state @return its norm
    [[nodiscard]] double norm(const State& z) const { return norm(denhartog::difference(z, at_rest(z.x.size()))); }

    /// @brief Jacobian of the map between modal velocities and modal displacements times frequencies: `norm` is Euclid's there.
    /// @return  2N x 2N; its eigenvalues are those of `jacobian`
    [[nodiscard]] const Matrix<double>& energy_jacobian() const;

    /// @brief What rounding and the errors of the modes make of the Jacobian. @return a bound of the error, in `norm`
    [[nodiscard]] double rounding_of_jacobian() const {
        return denhartog::rounding_of_jacobian(*solver_, *motion_, h_ * pi<double>());
    }

    /// @brief The rounding measured last, as modal displacements times frequencies, then modal velocities.
    /// @param of_modes  whether with what turned modes make of it
    /// @return          bounds, 2N values
    [[nodiscard]] Column<double> rounding_in_energy(bool of_modes = false) const;

    /// @brief The rounding measured last, mass by mass.
    /// @param of_modes  whether with what turned modes make of it
    /// @return          bounds for displacements, then velocities
    [[nodiscard]] Column<double> rounding(bool of_modes = false) const;

    /// @brief The solver. @return the solver, which holds the motion of the last application
    [[nodiscard]] ExactSolver& solver() const { return *solver_; }
    /// @brief The motion from the start, in the frame that is not mirrored. @return the motion
    [[nodiscard]] const ExactMotion& motion() const { return *motion_; }
    /// @brief Image of the last application. @return the state
    [[nodiscard]] const State& image() const { return image_; }
    /// @brief Image less start. @return displacements, then velocities
    [[nodiscard]] const Column<double>& difference() const { return difference_; }
    /// @brief Half-periods of the last application. @return h
    [[nodiscard]] int half_periods() const { return h_; }
    /// @brief Half-periods of all applications. @return their sum
    [[nodiscard]] long half_periods_in_all() const { return half_periods_in_all_; }

private:
    ExactSolver* solver_;
    Column<double> difference_;
    State image_;
    const ExactMotion* motion_ = nullptr;
    mutable Matrix<double> in_energy_; // of the last application, once it was asked for
    int h_ = 1;
    long half_periods_in_all_ = 0;
    MapRounding rounding_; // of the image
};

} // namespace denhartog

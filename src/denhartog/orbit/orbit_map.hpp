/// @file
/// @brief The map over half-periods of the force, mirrored after each, with its Jacobian, its rounding and a norm.
#pragma once

#include <vector>

#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {

/// @brief The difference a - b of two states: displacements, then velocities.
[[nodiscard]] Column difference(const State& a, const State& b);

/// @brief A Jacobian over displacements and velocities between modal displacements times frequencies and modal velocities, of
/// modes with natural frequency ratios r_n: `momentum`, phi^T M, takes displacements to modes, and `shapes` takes them back.
[[nodiscard]] Matrix<double> in_energy_coordinates(const Matrix<double>& J, const Matrix<double>& momentum,
                                                   const Matrix<double>& shapes, const std::vector<double>& r_n, double r);

/// @brief The motion over h half-periods of the force, mirrored after each: the map whose fixed points are the steady motions.
/// \f[ P^h(z) = (-1)^h\,\Phi_{0\to h\pi}(z) \f]
/// \f$ \Phi \f$ carries a state, displacements and velocities at tau = 0, to a later instant. The force changes its sign after
/// half a period, so that P is the same map for every half-period. A fixed point with h = 1 has the symmetry (25).
///
/// An object keeps what the last application left: the image, the motion to it, the Jacobian if it was asked for, and bounds of
/// the rounding errors of both. Energy coordinates are modal displacements times frequencies, then modal velocities, 2N values:
/// in them the distance of two motions never grows if mu = 1. `of_modes` adds the errors of the modes to the
/// rounding; no step of Newton's method reduces these.
class OrbitMap {
public:
    /// @brief The map of a system at one frequency and friction; the solver must outlive it.
    explicit OrbitMap(ExactSolver& solver)
        : N(static_cast<Eigen::Index>(solver.system().basis.r_n.size())), solver_(&solver), difference_(2 * N),
          image_(at_rest(static_cast<std::size_t>(N))) {}

    const Eigen::Index N; ///< number of masses

    /// @brief Applies the map to the state at tau = 0, with the Jacobian if that is wanted. False where the motion chatters.
    bool apply(const State& z, int half_periods, bool with_jacobian);

    /// @brief Whether the contact rested throughout.
    [[nodiscard]] bool held() const;
    /// @brief Whether the contact did not rest at all.
    [[nodiscard]] bool slides_throughout() const;

    /// @brief Jacobian of the map, 2N x 2N.
    [[nodiscard]] Matrix<double> jacobian() const { return h_ % 2 != 0 ? Matrix<double>(-motion_->jacobian) : motion_->jacobian; }
    /// @brief The Jacobian in energy coordinates, where `norm` is Euclid's.
    [[nodiscard]] const Matrix<double>& energy_jacobian() const;
    /// @brief Bound in `norm` of the error of the Jacobian by rounding and the errors of the modes, without that of the events.
    [[nodiscard]] double rounding_of_jacobian() const;

    /// @brief The energy of a deviation.
    [[nodiscard]] Column in_energy(const Column& dz) const;
    /// @brief Square root of twice the energy of a deviation, times 1/r: with mu = 1 it never grows between two motions.
    [[nodiscard]] double norm(const Column& dz) const { return in_energy(dz).norm(); }
    /// @brief The norm of a state.
    [[nodiscard]] double norm(const State& z) const { return norm(denhartog::difference(z, at_rest(z.x.size()))); }

    /// @brief The rounding in energy.
    [[nodiscard]] Column rounding_in_energy(bool of_modes = false) const;
    /// @brief The rounding mass by mass: of displacements, then velocities.
    [[nodiscard]] Column rounding(bool of_modes = false) const;

    /// @brief The solver, which holds the motion of the last application.
    [[nodiscard]] ExactSolver& solver() const { return *solver_; }
    /// @brief The motion from the start, in the frame that is not mirrored.
    [[nodiscard]] const ExactMotion& motion() const { return *motion_; }
    /// @brief Image of the last application.
    [[nodiscard]] const State& image() const { return image_; }
    /// @brief Image less start: displacements, then velocities.
    [[nodiscard]] const Column& difference() const { return difference_; }
    /// @brief Half-periods of the last application, h.
    [[nodiscard]] int half_periods() const { return h_; }
    /// @brief Half-periods of all applications.
    [[nodiscard]] long half_periods_in_all() const { return half_periods_in_all_; }

private:
    [[nodiscard]] double omega(Eigen::Index i) const; // natural frequency over that of the force
    [[nodiscard]] Column largest_energies() const;
    [[nodiscard]] Matrix<double> errors_between_modes(double units, bool of_modes) const;
    [[nodiscard]] double rounding_of_coupled_modes() const;

    ExactSolver* solver_;
    Column difference_;
    State image_;
    const ExactMotion* motion_ = nullptr;
    mutable Matrix<double> in_energy_; // of the last application, once it was asked for
    int h_ = 1;
    long half_periods_in_all_ = 0;
    Column rounding_, of_modes_; // of each mode in energy, without and with the errors of the modes
};

} // namespace denhartog

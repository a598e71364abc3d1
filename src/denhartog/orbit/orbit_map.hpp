/// @file
/// @brief The map over half-periods of the force, mirrored after each, with its Jacobian, its rounding and a norm, and Newton's
/// method for its fixed points.
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

/// @brief Largest number of steps without a fall of the residual: Newton's method halves such a step, and with the last choice
/// goes on from the image of the last good state.
enum class BadSteps : int { none = 0, some = 16, all_and_go_on_from_image = 40 };

/// @brief The map whose fixed points are the steady motions: the motion over h half-periods of the force, mirrored after each.
/// \f[ P^h(z) = (-1)^h\,\Phi_{0\to h\pi}(z) \f]
/// \f$ \Phi \f$ carries a state, displacements and velocities at \f$ \tau=0 \f$, to a later instant. The force changes its sign
/// after half a period, so that P is the same map for every half-period. A fixed point with h = 1 has the symmetry (25).
///
/// Call `apply` first: the object then holds the image, the motion to it and, if you asked for it, the Jacobian with bounds of
/// the rounding errors of both. Energy coordinates are 2N values, modal displacements times frequencies and then modal
/// velocities: if \f$ \mu=1 \f$, the distance of two motions in them never grows. With `mode_errors` the bounds include the
/// errors of the modes, which no step of Newton's method reduces.
class OrbitMap {
public:
    /// @brief The map of a system at one frequency and friction; the solver must outlive it.
    explicit OrbitMap(ExactSolver& solver)
        : N(static_cast<Eigen::Index>(solver.system().basis.r_n.size())), solver_(&solver), difference_(2 * N),
          image_(at_rest(static_cast<std::size_t>(N))) {}

    const Eigen::Index N; ///< number of masses

    /// @brief Applies the map to the state z at \f$ \tau=0 \f$, with the Jacobian if that is wanted; false if the
    /// motion was not followed to its end, see `MotionStatus`.
    bool apply(const State& z, int half_periods, bool with_jacobian);

    /// @brief Looks from z, by Newton's method, for a fixed point of h half-periods in which the contact moves. If one was found the
    /// map was applied to it last, with its Jacobian; else z is the state that the search ended at. If the map jumps, or the contact
    /// rests for ever, Newton's method may come nearer to that place by every half step and be taken back by every whole one; nearly
    /// every orbit is found without a bad step.
    bool find_fixed_point(State& z, int h, BadSteps bad_steps);
    /// @brief Least residual since the last start or image; negative if the contact rested.
    [[nodiscard]] double residual() const { return residual_; }
    /// @brief Number of steps of Newton's method so far.
    [[nodiscard]] int newton_steps() const { return newton_steps_; }

    /// @brief True if the contact rested throughout the last application.
    [[nodiscard]] bool held() const;
    /// @brief True if the contact did not rest at all in the last application.
    [[nodiscard]] bool slides_throughout() const;

    /// @brief Jacobian of the map, 2N x 2N.
    [[nodiscard]] Matrix<double> jacobian() const { return h_ % 2 != 0 ? Matrix<double>(-motion_->jacobian) : motion_->jacobian; }
    /// @brief The Jacobian in energy coordinates, in which `norm` is the Euclidean norm.
    [[nodiscard]] const Matrix<double>& energy_jacobian() const;
    /// @brief Bound in `norm` of the error of the Jacobian by rounding and by the modes, not by the events.
    [[nodiscard]] double rounding_of_jacobian() const;

    /// @brief A deviation in energy coordinates.
    [[nodiscard]] Column in_energy(const Column& dz) const;
    /// @brief Square root of twice the energy of a deviation, over r: if \f$ \mu=1 \f$ it never grows between two motions.
    [[nodiscard]] double norm(const Column& dz) const { return in_energy(dz).norm(); }
    /// @brief The norm of a state.
    [[nodiscard]] double norm(const State& z) const { return norm(denhartog::difference(z, at_rest(z.x.size()))); }
    /// @brief The largest displacement of any mass that a unit of the norm can make.
    [[nodiscard]] double displacement_of_energy() const;

    /// @brief Bound of the rounding errors of the image, in energy coordinates.
    [[nodiscard]] Column rounding_in_energy(bool mode_errors = false) const;
    /// @brief Bound of the rounding errors of the image, mass by mass: of displacements, then velocities.
    [[nodiscard]] Column rounding(bool mode_errors = false) const;

    /// @brief The solver, which holds the motion of the last application.
    [[nodiscard]] ExactSolver& solver() const { return *solver_; }
    /// @brief The motion of the last application from its start, not mirrored.
    [[nodiscard]] const ExactMotion& motion() const { return *motion_; }
    /// @brief The image of the last application.
    [[nodiscard]] const State& image() const { return image_; }
    /// @brief The image less the start: displacements, then velocities.
    [[nodiscard]] const Column& difference() const { return difference_; }
    /// @brief Number h of half-periods of the last application.
    [[nodiscard]] int half_periods() const { return h_; }
    /// @brief Number of half-periods of all applications.
    [[nodiscard]] long half_periods_in_all() const { return half_periods_in_all_; }

private:
    [[nodiscard]] double omega(Eigen::Index i) const; // natural frequency over that of the force
    [[nodiscard]] Column largest_energies() const;
    void bound_rounding(); // of the last application
    [[nodiscard]] Matrix<double> errors_between_modes(double units, bool mode_errors) const;
    [[nodiscard]] double rounding_of_coupled_modes() const;

    ExactSolver* solver_;
    Column difference_;
    State image_;
    const ExactMotion* motion_ = nullptr;
    mutable Matrix<double> in_energy_; // of the last application, once it was asked for
    int h_ = 1;
    long half_periods_in_all_ = 0;
    double residual_ = -1;
    int newton_steps_ = 0;
    Column rounding_, with_mode_errors_; // of each mode in energy, without and with the errors of the modes
};

} // namespace denhartog

/// @file
/// @brief The map over half-periods of the force, mirrored after each, with its Jacobian, its rounding and a norm.
#pragma once

#include <algorithm>
#include <limits>

#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/number/number.hpp"
#include "denhartog/orbit/map_rounding.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {

/// @brief A matrix in double. @param A a matrix @return its entries, rounded
template <class T>
[[nodiscard]] Matrix<double> in_double(const Matrix<T>& A) {
    return A.unaryExpr([](const T& value) { return static_cast<double>(value); });
}

/// @brief Difference of two states. @param a a state @param b another @return a - b: displacements, then velocities
template <class T>
[[nodiscard]] Column<T> difference(const State<T>& a, const State<T>& b) {
    const auto N = static_cast<Eigen::Index>(a.x.size());
    Column<T> d(2 * N);
    for (Eigen::Index k = 0; k < N; ++k) {
        const auto n = static_cast<std::size_t>(k);
        d(k) = a.x[n] - b.x[n];
        d(N + k) = a.x_prime[n] - b.x_prime[n];
    }
    return d;
}

/// @brief A Jacobian over displacements and velocities between modal velocities and modal displacements times frequencies.
/// @param J         2N x 2N
/// @param momentum  phi^T M
/// @param phi       mode shapes
/// @param r_n       natural frequency ratios
/// @param r         frequency ratio
/// @return          the matrix in these coordinates
template <class T>
[[nodiscard]] Matrix<T> in_energy_coordinates(Matrix<T> J, const Matrix<T>& momentum, const Matrix<T>& phi,
                                              const std::vector<T>& r_n, const T& r) {
    const Eigen::Index N = phi.rows();
    J.topRows(N) = momentum * J.topRows(N);
    J.bottomRows(N) = momentum * J.bottomRows(N);
    J.leftCols(N) = J.leftCols(N) * phi;
    J.rightCols(N) = J.rightCols(N) * phi;
    for (Eigen::Index i = 0; i < N; ++i) {
        const T omega = r_n[static_cast<std::size_t>(i)] / r;
        J.row(i) *= omega;
        J.col(i) /= omega;
    }
    return J;
}

/// @brief \f$ z \mapsto (-1)^h\Phi_{0\to h\pi}(z) \f$, as it was applied last.
template <class T>
class OrbitMap {
public:
    /// @param solver  system, frequency and friction; must outlive this
    explicit OrbitMap(ExactSolver<T>& solver)
        : N(static_cast<Eigen::Index>(solver.system().basis.r_n.size())), solver_(&solver), pi_(pi<T>()), difference_(2 * N),
          image_(at_rest<T>(static_cast<std::size_t>(N))) {}

    const Eigen::Index N; ///< number of masses

    /// @brief Applies the map.
    /// @param z              the state at tau = 0
    /// @param half_periods   how many half-periods, h
    /// @param with_jacobian  whether the Jacobian and the rounding of the image are wanted
    /// @return               false where the motion chatters
    bool apply(const State<T>& z, int half_periods, bool with_jacobian) {
        h_ = half_periods;
        half_periods_in_all_ += h_;
        in_energy_.resize(0, 0);
        const long before = solver_->effort().spent;
        motion_ = &solver_->run(z, T(0), h_ * pi_, with_jacobian);
        effort_ = solver_->effort().spent - before;
        if (motion_->status != MotionStatus::complete) return false;
        const bool turned = h_ % 2 != 0;
        for (Eigen::Index k = 0; k < N; ++k) {
            const auto n = static_cast<std::size_t>(k);
            image_.x[n] = turned ? T(-motion_->end.x[n]) : motion_->end.x[n];
            image_.x_prime[n] = turned ? T(-motion_->end.x_prime[n]) : motion_->end.x_prime[n];
            difference_(k) = image_.x[n] - z.x[n];
            difference_(N + k) = image_.x_prime[n] - z.x_prime[n];
        }
        if (with_jacobian) rounding_ = rounding_of_map(*solver_, *motion_, T(h_ * pi_));
        return true;
    }

    /// @brief Whether the contact rested throughout. @return true where it did
    [[nodiscard]] bool held() const {
        for (const Phase<T>& p : motion_->phases)
            if (p.direction != 0 && p.end > p.start) return false;
        return true;
    }

    /// @brief Whether the contact did not rest at all. @return true where it did not
    [[nodiscard]] bool slides_throughout() const {
        return std::ranges::none_of(motion_->phases, [](const Phase<T>& p) { return p.direction == 0 && p.end > p.start; });
    }

    /// @brief Jacobian of the map. @return 2N x 2N
    [[nodiscard]] Matrix<T> jacobian() const { return h_ % 2 != 0 ? Matrix<T>(-motion_->jacobian) : motion_->jacobian; }

    /// @brief The matrix of Newton's method. @return 1 - Jacobian
    [[nodiscard]] Matrix<T> newton_matrix() const {
        Matrix<T> A = h_ % 2 != 0 ? motion_->jacobian : Matrix<T>(-motion_->jacobian);
        for (Eigen::Index n = 0; n < 2 * N; ++n) A(n, n) += T(1);
        return A;
    }

    /// @brief A deviation as modal displacements times frequencies, then modal velocities.
    /// @param dz  displacements, then velocities
    /// @return    its 2N coordinates
    [[nodiscard]] Column<T> in_energy(const Column<T>& dz) const {
        const ContactSystem<T>& s = solver_->system();
        Column<T> modal(2 * N);
        for (Eigen::Index i = 0; i < N; ++i) {
            T q(0), p(0);
            for (Eigen::Index k = 0; k < N; ++k) {
                q += s.momentum(i, k) * dz(k);
                p += s.momentum(i, k) * dz(N + k);
            }
            modal(i) = q * (s.basis.r_n[static_cast<std::size_t>(i)] / solver_->excitation().r);
            modal(N + i) = p;
        }
        return modal;
    }

    /// @brief Square root of twice the energy of a deviation, times 1/r: what friction with mu = 1 lets no two motions increase.
    /// @param dz  displacements, then velocities
    /// @return    the norm
    [[nodiscard]] T norm(const Column<T>& dz) const { return in_energy(dz).norm(); }

    /// @brief The norm of a state. @param z the state @return its norm
    [[nodiscard]] T norm(const State<T>& z) const { return norm(denhartog::difference(z, at_rest<T>(z.x.size()))); }

    /// @brief Jacobian of the map between modal velocities and modal displacements times frequencies: `norm` is Euclid's there.
    /// @return  2N x 2N; its eigenvalues are those of `jacobian`
    [[nodiscard]] const Matrix<T>& energy_jacobian() const {
        const ContactSystem<T>& s = solver_->system();
        if (in_energy_.size() == 0)
            in_energy_ = in_energy_coordinates(jacobian(), s.momentum, s.basis.phi, s.basis.r_n, solver_->excitation().r);
        return in_energy_;
    }

    /// @brief What rounding and the errors of the modes make of the Jacobian. @return a bound of the error, in `norm`
    [[nodiscard]] T rounding_of_jacobian() const { return denhartog::rounding_of_jacobian(*solver_, *motion_, T(h_ * pi_)); }

    /// @brief The rounding measured last, as modal displacements times frequencies, then modal velocities.
    /// @param of_modes  whether with what turned modes make of it
    /// @return          bounds, 2N values
    [[nodiscard]] Column<T> rounding_in_energy(bool of_modes = false) const {
        Column<T> bound(2 * N);
        for (Eigen::Index i = 0; i < N; ++i) {
            const T omega = solver_->system().basis.r_n[static_cast<std::size_t>(i)] / solver_->excitation().r;
            bound(i) = bound(N + i) = rounding_.of(i, of_modes) * omega;
        }
        return bound;
    }

    /// @brief The rounding measured last, mass by mass.
    /// @param of_modes  whether with what turned modes make of it
    /// @return          bounds for displacements, then velocities
    [[nodiscard]] Column<T> rounding(bool of_modes = false) const {
        using std::abs;
        const ContactSystem<T>& s = solver_->system();
        Column<T> bound = Column<T>::Zero(2 * N);
        for (Eigen::Index k = 0; k < N; ++k)
            for (Eigen::Index i = 0; i < N; ++i) {
                const T x = abs(s.basis.phi(k, i)) * rounding_.of(i, of_modes);
                bound(k) += x;
                bound(N + k) += x * s.basis.r_n[static_cast<std::size_t>(i)] / solver_->excitation().r;
            }
        return bound;
    }

    /// @brief The solver. @return the solver, which holds the motion of the last application
    [[nodiscard]] ExactSolver<T>& solver() const { return *solver_; }
    /// @brief The motion from the start, in the frame that is not mirrored. @return the motion
    [[nodiscard]] const ExactMotion<T>& motion() const { return *motion_; }
    /// @brief Image of the last application. @return the state
    [[nodiscard]] const State<T>& image() const { return image_; }
    /// @brief Image less start. @return displacements, then velocities
    [[nodiscard]] const Column<T>& difference() const { return difference_; }
    /// @brief Half-periods of the last application. @return h
    [[nodiscard]] int half_periods() const { return h_; }
    /// @brief Half-periods of all applications. @return their sum
    [[nodiscard]] long half_periods_in_all() const { return half_periods_in_all_; }

private:
    ExactSolver<T>* solver_;
    T pi_;
    Column<T> difference_;
    State<T> image_;
    const ExactMotion<T>* motion_ = nullptr;
    mutable Matrix<T> in_energy_; // of the last application, once it was asked for
    int h_ = 1;
    long effort_ = 0;
    long half_periods_in_all_ = 0;
    MapRounding<T> rounding_; // of the image
};

} // namespace denhartog

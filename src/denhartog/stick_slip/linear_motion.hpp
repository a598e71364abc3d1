/// @file
/// @brief One linear stretch of motion in modal coordinates:
/// \f$ q_i'' + \sum_m D_{im} q_m' + \omega_i^2 q_i = F_i\cos(\tau+\theta_i) + G_i \f$.
///
/// A coordinate whose force leads by \f$ \theta_i \f$ has the closed form of one in phase at \f$ \tau+\theta_i \f$.
/// If D is diagonal each coordinate has its closed form, that of `evaluation/driven_motion.hpp`. If it is not, as it may be
/// while the contact sticks and with a damping matrix that couples the modes, they are carried together, as `coupled_motion.hpp`
/// has it.
#pragma once

#include <array>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <type_traits>

#include "denhartog/evaluation/driven_motion.hpp"
#include "denhartog/model/coupled_motion.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/scene/scene.hpp"

namespace denhartog {

/// @brief A view of numbers as a column, to be read or written.
template <class Values>
[[nodiscard]] auto column(Values& values) {
    return Eigen::Map<std::conditional_t<std::is_const_v<Values>, const Column, Column>>(
        values.data(), static_cast<Eigen::Index>(values.size()));
}

/// @brief Numbers of the coordinates, a few of them without memory of their own.
template <class T>
using OfCoordinates = boost::container::small_vector<T, 4>;

/// @brief A linear stretch of motion; the time t counts from its start.
struct LinearMotion {
    static constexpr int orders = 6; ///< derivatives kept: 0 to 5

    OfCoordinates<double> omega_0;               ///< natural frequencies over the frequency of the force
    OfCoordinates<double> gap;                   ///< 1 - omega_0^2
    OfCoordinates<double> decay;                 ///< half the diagonal of D
    Matrix<double> D;                            ///< damping matrix if it is not diagonal, else empty
    OfCoordinates<double> F;                     ///< amplitudes of the harmonic force
    OfCoordinates<Complex<double>> lead;         ///< exp(i theta) of each; empty if all are in phase
    OfCoordinates<double> G;                     ///< constant force
    std::array<OfCoordinates<double>, orders> q; ///< coordinates and derivatives at the instant last evaluated
    Effort* const* effort = nullptr; ///< where the budget stands that exponentials of a coupled system spend; null: none

    /// @brief Sets the number of coordinates.
    void resize(std::size_t n);
    /// @brief Number of coordinates.
    [[nodiscard]] std::size_t size() const { return omega_0.size(); }
    /// @brief Whether D couples the coordinates.
    [[nodiscard]] bool coupled() const { return D.size() > 0; }
    /// @brief Operations that an evaluation costs.
    [[nodiscard]] long cost() const {
        const auto n = static_cast<long>(size());
        return coupled() ? 10 + n * n : n;
    }

    /// @brief Sets F and lead: amplitudes of the force on the coordinates in units of r^2.
    void set_force(const std::vector<Complex<double>>& load, double r2);
    /// @brief To be called when omega_0, gap, decay, D or F have changed.
    void prepare();
    /// @brief Starts the stretch at tau from the coordinates and velocities in q[0], q[1].
    void start(double tau);
    /// @brief Coordinates and velocities at a time from the start, into q[0], q[1].
    void move_to(double t);
    /// @brief All derivatives at a time from the start.
    void differentiate_at(double t);

    /// @brief Cosine of tau at the instant last evaluated.
    [[nodiscard]] double cos_tau() const { return now_.c; }
    /// @brief Sine of tau at the instant last evaluated.
    [[nodiscard]] double sin_tau() const { return now_.s; }

    /// @brief Energy norm of derivative m, at most 4, and its velocity at the instant last evaluated, sqrt(sum q^(m+1)^2 +
    /// omega_0^2 q^(m)^2): it grows by |F| a unit of time at most.
    [[nodiscard]] double energy_norm(int m) const;
    /// @brief Bound of the norm of one coordinate if D is diagonal: the sum of both sizes, at most sqrt(2) times the norm.
    [[nodiscard]] double energy_norm(int m, std::size_t i) const {
        return std::abs(q[m + 1][i]) + omega_0[i] * std::abs(q[m][i]);
    }

    /// @brief Carries deviations over a time, free of force: columns of dq and dp, of the coordinates and of their velocities.
    void carry(double t, Matrix<double>& dq, Matrix<double>& dp);

private:
    // Sine and cosine of tau + theta_i from those of tau.
    [[nodiscard]] SineCosine<double> at_force(const SineCosine<double>& tau, std::size_t i) const {
        if (lead.empty()) return tau;
        return {tau.s * lead[i].re + tau.c * lead[i].im, tau.c * lead[i].re - tau.s * lead[i].im};
    }
    // A derivative of the force on a coordinate.
    [[nodiscard]] double force(int order, std::size_t i) const {
        const SineCosine<double> at = at_force(now_, i);
        const std::array<double, 4> wave{at.c, -at.s, -at.c, at.s};
        return order == 0 ? F[i] * wave[0] + G[i] : F[i] * wave[static_cast<std::size_t>(order)];
    }

    // Of the coupled system: z = (q less that at rest, q', cos tau, sin tau) obeys z' = A z.
    [[nodiscard]] Eigen::Index rows() const { return 2 * static_cast<Eigen::Index>(size()) + 2; }
    void prepare_coupled();

    double tau_0_;
    SineCosine<double> now_;      // of tau at the instant last evaluated
    bool differentiated_ = false; // whether q holds all derivatives, at the instant at_
    double at_;
    OfCoordinates<double> at_rest_;                                   // where the constant force would hold the coordinates
    OfCoordinates<evaluation::DrivenCoordinate<double>> coordinates_; // prepared for any start
    OfCoordinates<evaluation::DrivenStart<double>> starts_;           // the last start
    OfCoordinates<evaluation::FreeMotion<double>> free_;              // the free motions at free_at_, whatever the start
    double free_at_ = -1;
    CoupledMotion together_; // all coordinates if D couples them
};

} // namespace denhartog

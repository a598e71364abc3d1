/// @file
/// @brief One linear stretch of motion in modal coordinates:
/// \f$ q_i'' + \sum_m D_{im} q_m' + \omega_i^2 q_i = F_i\cos\tau + G_i \f$.
///
/// Where D is diagonal each coordinate has its closed form, that of `evaluation/driven_motion.hpp`. Where it is not, as it may be
/// while the contact sticks and with a damping matrix that couples the modes, they are carried together, as `coupled_motion.hpp`
/// has it.
#pragma once

#include <algorithm>
#include <array>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <limits>
#include <type_traits>

#include "denhartog/evaluation/driven_motion.hpp"
#include "denhartog/model/coupled_motion.hpp"
#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/scene/scene.hpp"

namespace denhartog {

/// @brief A vector of numbers as a column, to be read or written. @param values the numbers @return a view of them
template <class Values>
[[nodiscard]] auto column(Values& values) {
    using Numbers = Column<typename Values::value_type>;
    return Eigen::Map<std::conditional_t<std::is_const_v<Values>, const Numbers, Numbers>>(
        values.data(), static_cast<Eigen::Index>(values.size()));
}

/// @brief Numbers of the coordinates, a few of them without memory of their own.
template <class T>
using OfCoordinates = boost::container::small_vector<T, 4>;

/// @brief A linear stretch of motion; the time t counts from its start.
template <class T>
struct LinearMotion {
    static constexpr int orders = 6; ///< derivatives kept: 0 to 5

    OfCoordinates<T> omega_0;             ///< natural frequencies over the frequency of the force
    OfCoordinates<T> gap;                 ///< 1 - omega_0^2
    OfCoordinates<T> decay;               ///< half the diagonal of D
    Matrix<T> D;                          ///< damping matrix where it is not diagonal, else empty
    OfCoordinates<T> F;                   ///< amplitudes of the harmonic force
    OfCoordinates<T> G;                   ///< constant force
    std::array<OfCoordinates<T>, orders> q; ///< coordinates and derivatives at the instant last evaluated
    Effort* const* effort = nullptr;      ///< where the budget stands that exponentials of a coupled system spend; null: none

    /// @brief Sets the number of coordinates. @param n their number
    void resize(std::size_t n) {
        for (OfCoordinates<T>* v : {&omega_0, &gap, &decay, &F, &G, &at_rest_}) v->resize(n);
        for (OfCoordinates<T>& v : q) v.resize(n);
        coordinates_.resize(n);
        starts_.resize(n);
        free_.resize(n);
    }

    /// @brief Number of coordinates. @return their number
    [[nodiscard]] std::size_t size() const { return omega_0.size(); }
    /// @brief Whether D couples the coordinates. @return true where it is not diagonal
    [[nodiscard]] bool coupled() const { return D.size() > 0; }
    /// @brief Operations that an evaluation costs. @return their number
    [[nodiscard]] long cost() const {
        const auto n = static_cast<long>(size());
        return coupled() ? 10 + n * n : n;
    }

    /// @brief To be called when omega_0, gap, decay, D or F have changed.
    void prepare() {
        for (std::size_t i = 0; i < size(); ++i)
            coordinates_[i] = evaluation::driven_coordinate(omega_0[i], gap[i], decay[i], F[i]);
        free_at_ = T(-1);
        if (coupled()) prepare_coupled();
    }

    /// @brief Starts the stretch from the coordinates and velocities in q[0], q[1].
    /// @param tau  the instant
    void start(const T& tau) {
        tau_0_ = tau;
        const auto [sin_0, cos_0] = sine_cosine(tau);
        differentiated_ = false;
        for (std::size_t i = 0; i < size(); ++i) {
            at_rest_[i] = G[i] / (omega_0[i] * omega_0[i]);
            const InitialValues<T> now{q[0][i], q[1][i]};
            starts_[i] = {evaluation::free_start(now, at_rest_[i], coordinates_[i].X, cos_0, sin_0), at_rest_[i], cos_0, sin_0};
        }
        if (!coupled()) return;
        Column<T> z(rows());
        z << column(q[0]) - column(at_rest_), column(q[1]), cos_0, sin_0;
        together_.start(std::move(z));
    }

    /// @brief Coordinates and velocities at an instant, into q[0], q[1]. @param t the time from the start
    void move_to(const T& t) {
        differentiated_ = false;
        now_ = sine_cosine(T(tau_0_ + t));
        if (coupled()) {
            const Column<T> z = together_.at(t);
            const auto n = static_cast<Eigen::Index>(size());
            column(q[0]) = column(at_rest_) + z.head(n);
            column(q[1]) = z.segment(n, n);
            return;
        }
        free_at_ = t;
        for (std::size_t i = 0; i < size(); ++i) {
            const evaluation::DrivenCoordinate<T>& c = coordinates_[i];
            free_[i] = evaluation::free_motion(t, c.R, c.zeta, c.w);
            const InitialValues<T> now = evaluation::motion_of_coordinate(free_[i], t, c, starts_[i], now_.c, now_.s);
            q[0][i] = now.eta_0;
            q[1][i] = now.eta_prime_0;
        }
    }

    /// @brief All derivatives at an instant. @param t the time from the start
    void differentiate_at(const T& t) {
        if (differentiated_ && t == at_) return;
        move_to(t);
        differentiated_ = true;
        at_ = t;
        const std::array<T, 4> wave{now_.c, T(-now_.s), T(-now_.c), now_.s};
        if (coupled()) {
            for (int m = 0; m + 2 < orders; ++m)
                for (std::size_t i = 0; i < size(); ++i) {
                    T damping(0);
                    for (std::size_t n = 0; n < size(); ++n) damping += D(i, n) * q[m + 1][n];
                    q[m + 2][i] = evaluation::acceleration(q[m][i], omega_0[i], damping, force(wave, m, i));
                }
            return;
        }
        for (std::size_t i = 0; i < size(); ++i) {
            T below = q[0][i], last = q[1][i];
            const T &omega = omega_0[i], twice = 2 * decay[i];
            for (int m = 0; m + 2 < orders; ++m) {
                const T next = evaluation::acceleration(below, omega, T(twice * last), force(wave, m, i));
                below = last;
                last = q[m + 2][i] = next;
            }
        }
    }

    /// @brief Cosine of tau at the instant last evaluated. @return cos tau
    [[nodiscard]] const T& cos_tau() const { return now_.c; }
    /// @brief Sine of tau at the instant last evaluated. @return sin tau
    [[nodiscard]] const T& sin_tau() const { return now_.s; }

    /// @brief Energy norm of derivative m and its velocity at the instant last evaluated: it grows by |F| a unit of time at most.
    /// @param m  order, at most 4
    /// @return   sqrt(sum q^(m+1)^2 + omega_0^2 q^(m)^2), formed without the overflow of a square
    [[nodiscard]] T energy_norm(int m) const {
        T largest(0), sum(0);
        for (std::size_t i = 0; i < size(); ++i) largest = std::max(largest, energy_norm(m, i));
        if (!(largest > 0)) return largest;
        for (std::size_t i = 0; i < size(); ++i) {
            const T v = q[m + 1][i] / largest, y = omega_0[i] * q[m][i] / largest;
            sum += v * v + y * y;
        }
        return largest * sqrt(sum);
    }

    /// @brief Bound of the same of one coordinate where D is diagonal: the sum of both sizes.
    /// @param m  order, at most 4
    /// @param i  the coordinate
    /// @return   the bound, at most sqrt(2) times the norm
    [[nodiscard]] T energy_norm(int m, std::size_t i) const {
        using std::abs;
        return abs(q[m + 1][i]) + omega_0[i] * abs(q[m][i]);
    }

    /// @brief Carries deviations over a time: columns of dq and dp, free of force.
    /// @param t   the time
    /// @param dq  deviations of the coordinates, coordinate by column
    /// @param dp  deviations of the velocities
    void carry(const T& t, Matrix<T>& dq, Matrix<T>& dp) {
        if (coupled()) {
            Matrix<T> z(rows(), dq.cols());
            z << dq, dp, Matrix<T>::Zero(2, dq.cols());
            z = together_.carried(t, z);
            dq = z.topRows(dq.rows());
            dp = z.middleRows(dq.rows(), dq.rows());
            return;
        }
        for (std::size_t i = 0; i < size(); ++i) {
            const evaluation::DrivenCoordinate<T>& c_i = coordinates_[i];
            const evaluation::FreeMotion<T> free = t == free_at_ ? free_[i] : evaluation::free_motion(t, c_i.R, c_i.zeta, c_i.w);
            for (Eigen::Index c = 0; c < dq.cols(); ++c) {
                const T x = dq(i, c), v = dp(i, c);
                dq(i, c) = x * free.d + v * (c_i.R * free.q);
                dp(i, c) = x * free.d_prime + v * (c_i.R * free.q_prime);
            }
        }
    }

private:
    // A derivative of the force on a coordinate, `wave` being those of cos tau.
    [[nodiscard]] T force(const std::array<T, 4>& wave, int order, std::size_t i) const {
        return order == 0 ? T(F[i] * wave[0] + G[i]) : T(F[i] * wave[order]);
    }

    // Of the coupled system: z = (q less that at rest, q', cos tau, sin tau) obeys z' = A z.
    [[nodiscard]] Eigen::Index rows() const { return 2 * static_cast<Eigen::Index>(size()) + 2; }

    void prepare_coupled() {
        const auto n = static_cast<Eigen::Index>(size());
        Matrix<T> A = Matrix<T>::Zero(rows(), rows());
        T rate(1);
        for (Eigen::Index i = 0; i < n; ++i) {
            const T& omega = omega_0[static_cast<std::size_t>(i)];
            A(i, n + i) = T(1);
            A(n + i, i) = -omega * omega;
            A(n + i, 2 * n) = F[static_cast<std::size_t>(i)];
            rate = std::max(rate, omega);
        }
        A.block(n, n, n, n) = -D;
        A(2 * n, 2 * n + 1) = T(-1);
        A(2 * n + 1, 2 * n) = T(1);
        rate += largest_row_sum(D);
        together_ = CoupledMotion<T>(A, rate, CoupledMotion<T>::Asked::many_starts, effort);
    }

    T tau_0_;
    SineCosine<T> now_;           // of tau at the instant last evaluated
    bool differentiated_ = false; // whether q holds all derivatives, at the instant at_
    T at_;
    OfCoordinates<T> at_rest_;                                   // where the constant force would hold the coordinates
    OfCoordinates<evaluation::DrivenCoordinate<T>> coordinates_; // prepared for any start
    OfCoordinates<evaluation::DrivenStart<T>> starts_;           // the last start
    OfCoordinates<evaluation::FreeMotion<T>> free_;              // the free motions at free_at_, whatever the start
    T free_at_ = T(-1);
    CoupledMotion<T> together_;                                // all coordinates where D couples them
};

} // namespace denhartog

/// @file
/// @brief The derivative of a motion with respect to its start: deviations carried through phases and events.
///
/// Within a phase deviations obey the motion without its forces. At an event the instant shifts with them, and the acceleration
/// jumps there: what the shift adds is the jump times the shift, along the accelerations that a force on the contact makes.
#pragma once

#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/stick_slip/contact_phases.hpp"

namespace denhartog {

/// @brief Deviations of the state over the 2N deviations of the start.
template <class T>
struct Deviations {
    Matrix<T> dx; ///< deviations of displacements, N x 2N
    Matrix<T> dv; ///< deviations of velocities, N x 2N

    /// @brief Starts from those of the state itself. If the contact sticks its velocity cannot deviate: an impulse of friction
    /// takes that away, and has the others move with it that inertia ties to the contact.
    /// @param phases     the phases
    /// @param direction  of the first one
    void start(const ContactPhases<T>& phases, int direction) {
        const std::size_t N = phases.N, j = phases.system->contact.index;
        dx = Matrix<T>::Zero(N, 2 * N);
        dv = Matrix<T>::Zero(N, 2 * N);
        for (std::size_t k = 0; k < N; ++k) dx(k, k) = dv(k, N + k) = T(1);
        if (direction != 0) return;
        const std::vector<T>& ties = phases.system->stuck.m_j;
        if (std::ranges::any_of(ties, [](const T& tie) { return tie != 0; })) dv.col(N + j) = -phases.inertia * phases.w;
        dv.row(j).setZero();
    }

    /// @brief Carries them over the phase that stands at its end.
    /// @param phases     the phases, evaluated at the end of this one
    /// @param direction  its direction
    /// @param event      how it ends
    void carry(ContactPhases<T>& phases, int direction, const Event<T>& event) {
        const std::size_t j = phases.system->contact.index, N = phases.N;
        phases.effort->spend(cost_of_products(static_cast<long>(8 * N * N * N)));
        if (direction != 0) {
            dq = product(phases.system->momentum, dx);
            dp = product(phases.system->momentum, dv);
            phases.sliding.carry(event.t, dq, dp);
            dx = product(phases.system->basis.phi, dq);
            dv = product(phases.system->basis.phi, dp);
            if (!event.found) return;
            // x_j' = 0 fixes the instant; the friction force jumps there.
            T acceleration(0);
            for (std::size_t i = 0; i < N; ++i) acceleration += phases.system->basis.phi(j, i) * phases.sliding.q[2][i];
            const T jump = event.next == direction ? T(0)
                           : event.next == 0       ? T(event.load - direction * phases.e.beta)
                                                   : T(-2 * direction * phases.e.beta);
            if (acceleration != 0) shift(phases.w, jump, Matrix<T>(dv.row(j) / -acceleration));
            if (event.next == 0) dv.row(j).setZero();
            return;
        }
        if (N > 1) carry_stuck(phases, event);
        if (!event.found || phases.e.mu == 1) return;
        const Jet<T> Q = phases.load(event.t);
        Matrix<T> dQ = -phases.system->stuck.k_jj * dx.row(j);
        const T r2 = phases.e.r * phases.e.r;
        for (std::size_t i = 0; i + 1 < N; ++i) {
            dQ -= phases.k_j[i] * dq.row(i) + phases.c_j[i] * dp.row(i);
            if (phases.m_j[i] == 0) continue;
            const LinearMotion<T>& stuck = phases.sticking;
            Matrix<T> acceleration = -phases.k_j[i] / r2 * dx.row(j) - stuck.omega_0[i] * stuck.omega_0[i] * dq.row(i);
            if (stuck.coupled())
                acceleration -= stuck.D.row(i) * dp;
            else
                acceleration -= 2 * stuck.decay[i] * dp.row(i);
            dQ -= phases.m_j[i] * acceleration;
        }
        shift(phases.w, T(-event.next * (phases.e.mu - 1) * phases.e.beta), Matrix<T>(dQ / -Q.f[1]));
    }

private:
    Matrix<T> dq, dp;

    void carry_stuck(ContactPhases<T>& phases, const Event<T>& event) {
        const StuckConfiguration<T>& s = phases.system->stuck;
        const std::size_t j = phases.system->contact.index, N = phases.N;
        Matrix<T> others_x(N - 1, 2 * N), others_v(N - 1, 2 * N);
        for (std::size_t n = 0; n + 1 < N; ++n) {
            others_x.row(n) = dx.row(s.masses[n].index);
            others_v.row(n) = dv.row(s.masses[n].index);
        }
        dq = product(phases.stuck_momentum, others_x);
        dp = product(phases.stuck_momentum, others_v);
        Matrix<T> at_rest(N - 1, 2 * N); // where the stuck modes would rest for the shifted contact
        for (std::size_t i = 0; i + 1 < N; ++i) at_rest.row(i) = -phases.k_j[i] / (s.r_n[i] * s.r_n[i]) * dx.row(j);
        dq -= at_rest;
        phases.sticking.carry(event.t, dq, dp);
        dq += at_rest;
        others_x = product(s.phi, dq);
        others_v = product(s.phi, dp);
        for (std::size_t n = 0; n + 1 < N; ++n) {
            dx.row(s.masses[n].index) = others_x.row(n);
            dv.row(s.masses[n].index) = others_v.row(n);
        }
    }

    // The acceleration before the event exceeds that after it by jump times w; the event comes d_tau later.
    void shift(const Column<T>& w, const T& jump, const Matrix<T>& d_tau) {
        if (jump != 0) dv += jump * w * d_tau;
    }
};

} // namespace denhartog

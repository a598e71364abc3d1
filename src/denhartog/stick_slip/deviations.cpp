#include <algorithm>

#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/stick_slip/working_space.hpp"

namespace denhartog {

void Deviations::start(const ContactPhases& phases, int direction) {
    const std::size_t N = phases.N, j = phases.system->contact.index;
    dx = Matrix<double>::Zero(N, 2 * N);
    dv = Matrix<double>::Zero(N, 2 * N);
    for (std::size_t k = 0; k < N; ++k) dx(k, k) = dv(k, N + k) = 1;
    if (direction != 0) return;
    const std::vector<double>& ties = phases.system->stuck.m_j;
    if (std::ranges::any_of(ties, [](double tie) { return tie != 0; })) dv.col(N + j) = -phases.inertia * phases.w;
    dv.row(j).setZero();
}

void Deviations::carry(ContactPhases& phases, int direction, const Event& event) {
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
        double acceleration = 0;
        for (std::size_t i = 0; i < N; ++i) acceleration += phases.system->basis.phi(j, i) * phases.sliding.q[2][i];
        const double jump = event.next == direction ? 0.0
                            : event.next == 0       ? event.load - direction * phases.e.beta
                                                    : -2 * direction * phases.e.beta;
        if (acceleration != 0) shift(phases.w, jump, Matrix<double>(dv.row(j) / -acceleration));
        if (event.next == 0) dv.row(j).setZero();
        return;
    }
    if (N > 1) carry_stuck(phases, event);
    if (!event.found || phases.e.mu == 1) return;
    const Jet<double> Q = phases.load(event.t);
    Matrix<double> dQ = -phases.system->stuck.k_jj * dx.row(j);
    const double r2 = phases.e.r * phases.e.r;
    for (std::size_t i = 0; i + 1 < N; ++i) {
        dQ -= phases.k_j[i] * dq.row(i) + phases.c_j[i] * dp.row(i);
        if (phases.m_j[i] == 0) continue;
        const LinearMotion& stuck = phases.sticking;
        Matrix<double> acceleration = -phases.k_j[i] / r2 * dx.row(j) - stuck.omega_0[i] * stuck.omega_0[i] * dq.row(i);
        if (stuck.coupled())
            acceleration -= stuck.D.row(i) * dp;
        else
            acceleration -= 2 * stuck.decay[i] * dp.row(i);
        dQ -= phases.m_j[i] * acceleration;
    }
    shift(phases.w, -event.next * (phases.e.mu - 1) * phases.e.beta, Matrix<double>(dQ / -Q.f[1]));
}

void Deviations::carry_stuck(ContactPhases& phases, const Event& event) {
    const StuckConfiguration<double>& s = phases.system->stuck;
    const std::size_t j = phases.system->contact.index, N = phases.N;
    Matrix<double> others_x(N - 1, 2 * N), others_v(N - 1, 2 * N);
    for (std::size_t n = 0; n + 1 < N; ++n) {
        others_x.row(n) = dx.row(s.masses[n].index);
        others_v.row(n) = dv.row(s.masses[n].index);
    }
    dq = product(phases.stuck_momentum, others_x);
    dp = product(phases.stuck_momentum, others_v);
    Matrix<double> at_rest(N - 1, 2 * N); // where the stuck modes would rest for the shifted contact
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
void Deviations::shift(const Column<double>& w, double jump, const Matrix<double>& d_tau) {
    if (jump != 0) dv += jump * w * d_tau;
}

} // namespace denhartog

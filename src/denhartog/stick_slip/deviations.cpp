#include <algorithm>

#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/stick_slip/contact_phases.hpp"

namespace denhartog {

void Deviations::start(const ContactPhases& phases, int direction) {
    const std::size_t N = phases.N;
    dx = Matrix<double>::Zero(N, 2 * N);
    dv = Matrix<double>::Zero(N, 2 * N);
    for (std::size_t k = 0; k < N; ++k) dx(k, k) = dv(k, N + k) = 1;
    if (direction != 0) return;
    const StuckConfiguration<double>& stuck = phases.system->stuck;
    if (stuck.contact.b || std::ranges::any_of(stuck.m_j, [](double tie) { return tie != 0; }))
        dv -= phases.inertia * phases.w * stuck.contact.row_of(dv);
    stuck.contact.hold(dv);
}

void Deviations::carry(ContactPhases& phases, int direction, const Event& event) {
    const Contact& contact = phases.system->stuck.contact;
    const std::size_t N = phases.N;
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
        for (std::size_t i = 0; i < N; ++i) acceleration += phases.system->contact_shape(i) * phases.sliding.q[2][i];
        const double jump = event.next == direction ? 0.0
                            : event.next == 0       ? event.load - direction * phases.e.beta
                                                    : -2 * direction * phases.e.beta;
        if (acceleration != 0) shift(phases.w, jump, contact.row_of(dv) / -acceleration);
        if (event.next == 0) contact.hold(dv);
        return;
    }
    if (N > 1) carry_stuck(phases, event);
    if (!event.found || phases.e.mu == 1) return;
    const Jet<double> Q = phases.load(event.t);
    const Matrix<double> d_rest = contact.row_of(dx);
    Matrix<double> dQ = -phases.system->stuck.k_jj * d_rest;
    const double r2 = phases.e.r * phases.e.r;
    for (std::size_t i = 0; i + 1 < N; ++i) {
        dQ -= phases.k_j[i] * dq.row(i) + phases.c_j[i] * dp.row(i);
        if (phases.m_j[i] == 0) continue;
        const LinearMotion& stuck = phases.sticking;
        Matrix<double> acceleration = -phases.k_j[i] / r2 * d_rest - stuck.omega_0[i] * stuck.omega_0[i] * dq.row(i);
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
    const Matrix<double> d_rest = s.contact.row_of(dx);
    dq = product(s.momentum, dx);
    dp = product(s.momentum, dv);
    Matrix<double> at_rest(dq.rows(), dq.cols()); // where the stuck modes would rest for the shifted contact
    for (Eigen::Index i = 0; i < dq.rows(); ++i) {
        const double r_n = s.r_n[static_cast<std::size_t>(i)];
        at_rest.row(i) = -phases.k_j[i] / (r_n * r_n) * d_rest;
    }
    dq -= at_rest;
    phases.sticking.carry(event.t, dq, dp);
    dq += at_rest;
    dx = product(s.shapes, dq) + column(s.carried) * d_rest;
    dv = product(s.shapes, dp);
}

// The acceleration before the event exceeds that after it by jump times w; the event comes d_tau later.
void Deviations::shift(const Column<double>& w, double jump, const Matrix<double>& d_tau) {
    if (jump != 0) dv += jump * w * d_tau;
}

} // namespace denhartog

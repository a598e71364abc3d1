// What ends a phase? Sliding ends if the velocity of the contact is zero, sticking if the load (75) on it exceeds static
// friction, (74). `velocity` and `load` give these quantities with three derivatives and a bound of the fourth; `end_of_sliding`
// and `end_of_sticking` find their first zero with none missed. `set` comes before: what one frequency and friction ratio make
// of (6).
#include "denhartog/stick_slip/contact_phases.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "elementary/elementary.hpp"

namespace denhartog {

constexpr int most_tangencies = 64; // in one phase; more are a load that lies on the limit to rounding

ContactPhases::ContactPhases(const ContactSystem& s, const Excitation& excitation, Effort& allowed)
    : system(&s), N(s.basis.r_n.size()), effort(&allowed) {
    sliding.resize(N);
    sticking.resize(N - 1);
    sliding.effort = sticking.effort = &effort;
    set(excitation);
}

void ContactPhases::set(const Excitation& excitation) {
    check_frequency_ratio(excitation.r);
    check_friction_ratio(excitation.beta);
    check_static_friction(excitation.mu);
    step = 1;
    const bool same_frequency = excitation.r == e.r;
    e = excitation;
    if (same_frequency) return;
    const ModalBasis<double>& basis = system->basis;
    const double r2 = e.r * e.r;
    for (std::size_t i = 0; i < N; ++i) {
        set_mode(sliding, i, basis.r_n[i], basis.zeta[i] * basis.r_n[i]);
    }
    sliding.set_force(system->modal_load, r2);
    if (basis.coupled()) sliding.D = basis.D / e.r;
    sliding.prepare();
    w = basis.phi * system->contact_shape / r2;
    inertia = r2 / system->contact_shape.squaredNorm();
    direct = direct_load(system->stuck, system->load);
    size_of_direct = direct.im == 0 ? std::abs(direct.re) : elementary::hypot(direct.re, direct.im);
    set_sticking(r2);
}

void ContactPhases::set_mode(LinearMotion& m, std::size_t i, double r_n, double half_damping) const {
    m.omega_0[i] = r_n / e.r;
    m.gap[i] = (e.r - r_n) / e.r * (1 + m.omega_0[i]);
    m.decay[i] = half_damping / e.r;
}

void ContactPhases::set_sticking(double r2) {
    const StuckConfiguration& s = system->stuck;
    k_j = s.phi.transpose() * column(s.k_j);
    c_j = s.phi.transpose() * column(s.c_j) * e.r;
    m_j = s.phi.transpose() * column(s.m_j) * r2;
    sticking.set_force(system->stuck_load, r2);
    for (std::size_t i = 0; i + 1 < N; ++i) set_mode(sticking, i, s.r_n[i], s.damping(i, i) / 2);
    if (!s.modes_diagonalise_damping) sticking.D = s.damping / e.r;
    sticking.prepare();
    double stiffness = 0, fastest = 0; // for the bound of a derivative of the load by the energy of the stuck modes
    for (std::size_t i = 0; i + 1 < N; ++i) {
        const double k = k_j[i] / sticking.omega_0[i];
        stiffness += k * k;
        fastest = std::max(fastest, sticking.omega_0[i] + 2 * sticking.decay[i]);
    }
    if (sticking.coupled()) fastest += largest_row_sum(sticking.D);
    const double force = column(sticking.F).norm(), inertial = m_j.norm();
    load_per_energy = sqrt(stiffness) + c_j.norm() + fastest * inertial;
    load_rest = inertial * force;
    load_growth = load_per_energy * force;
}

void ContactPhases::start_phase(int direction, double tau) {
    LinearMotion& motion = direction == 0 ? sticking : sliding;
    const double r2 = e.r * e.r;
    const Matrix<double>& momentum = direction == 0 ? system->stuck.momentum : system->momentum;
    column(motion.q[0]).noalias() = momentum * column(x);
    column(motion.q[1]).noalias() = momentum * column(v);
    if (direction != 0) {
        column(sliding.G) = -direction * e.beta / r2 * system->contact_shape;
        if (!system->constant.modal.empty()) column(sliding.G) += column(system->constant.modal) / r2;
    } else {
        rest = system->stuck.contact.of(x);
        column(sticking.G) = -rest / r2 * k_j;
        if (!system->constant.stuck.empty()) column(sticking.G) += column(system->constant.stuck) / r2;
    }
    motion.start(tau);
}

void ContactPhases::masses_of(int direction, int order, std::vector<double>& out) const {
    out.resize(N);
    if (direction != 0) {
        column(out).noalias() = system->basis.phi * column(sliding.q[order]);
        return;
    }
    column(out).noalias() = system->stuck.shapes * column(sticking.q[order]);
    if (order == 0)
        for (std::size_t k = 0; k < N; ++k) out[k] += rest * system->stuck.carried[k];
    else if (const Contact& contact = system->stuck.contact; !contact.others.empty())
        contact.hold(out.data()); // to the last bit, which rounded rows of shapes do not
}

evaluation::LinearSum ContactPhases::motion_of_masses(int direction, double tau) const {
    const LinearMotion& motion = direction == 0 ? sticking : sliding;
    const Matrix<double>& shapes = direction == 0 ? system->stuck.shapes : system->basis.phi;
    const std::size_t n = motion.size();
    const std::vector<double> none(N);
    evaluation::LinearSum sum{tau, {}, std::vector<double>(N * n), none, none, none, none};
    const auto [sin_0, cos_0] = sine_cosine(tau);
    for (std::size_t i = 0; i < n; ++i) {
        const double omega = motion.omega_0[i], zeta = motion.decay[i] / omega, at_rest = motion.G[i] / (omega * omega);
        Complex<double> X = motion.F[i] * evaluation::response_by_R_squared(motion.gap[i], motion.decay[i]);
        if (!motion.lead.empty()) X = evaluation::product(motion.lead[i], X);
        const auto [s, s_prime] = evaluation::free_start({motion.q[0][i], motion.q[1][i]}, 0.0, X, cos_0, sin_0);
        sum.coordinates.push_back({1 / omega, zeta, evaluation::w_if_oscillating(zeta), at_rest, s, s_prime});
        for (std::size_t k = 0; k < N; ++k) {
            const double shape = sum.shapes[k * n + i] = shapes(k, i);
            sum.A[k] += shape * X.re;
            sum.B[k] -= shape * X.im;
            sum.harmonic[k] += std::abs(shape) * (std::abs(X.re) + std::abs(X.im));
        }
    }
    if (direction == 0)
        for (std::size_t k = 0; k < N; ++k) sum.constant[k] = rest * system->stuck.carried[k];
    return sum;
}

Jet ContactPhases::velocity(int direction, double t) {
    effort->spend(sliding.cost());
    sliding.differentiate_at(t);
    Jet jet{{}, 0, 0, 0, 0};
    for (std::size_t i = 0; i < N; ++i) {
        const double phi = direction * system->contact_shape(i);
        for (int m = 0; m < 4; ++m) jet.f[m] += phi * sliding.q[m + 1][i];
        if (!sliding.coupled()) {
            jet.bound += std::abs(phi) * sliding.energy_norm(4, i);
            jet.second += std::abs(phi) * sliding.energy_norm(2, i);
        }
        jet.growth += std::abs(phi * sliding.F[i]);
        jet.noise += std::abs(phi * sliding.q[1][i]);
    }
    if (sliding.coupled()) { // energy goes from mode to mode
        const double size = system->contact_shape.norm();
        jet.bound = size * sliding.energy_norm(4);
        jet.second = size * sliding.energy_norm(2);
        jet.growth = size * column(sliding.F).norm();
    }
    jet.noise *= std::numeric_limits<double>::epsilon();
    return jet;
}

Jet ContactPhases::load(double t) {
    effort->spend(sticking.cost());
    sticking.differentiate_at(t);
    const double c = sticking.cos_tau(), s = sticking.sin_tau();
    const double constant = system->constant.direct, pull = system->stuck.k_jj * rest - constant;
    const double force = direct.re * c - direct.im * s, rate = -direct.re * s - direct.im * c;
    Jet jet{{force - pull, rate, -force, -rate},
            size_of_direct,
            0.0,
            std::abs(pull) + size_of_direct + std::abs(constant),
            size_of_direct};
    for (std::size_t i = 0; i + 1 < N; ++i) {
        for (int m = 0; m < 4; ++m)
            jet.f[m] -= k_j[i] * sticking.q[m][i] + c_j[i] * sticking.q[m + 1][i] + m_j[i] * sticking.q[m + 2][i];
        jet.noise +=
            std::abs(k_j[i] * sticking.q[0][i]) + std::abs(c_j[i] * sticking.q[1][i]) + std::abs(m_j[i] * sticking.q[2][i]);
    }
    if (N > 1) {
        jet.bound += load_per_energy * sticking.energy_norm(4) + load_rest;
        jet.second += load_per_energy * sticking.energy_norm(2) + load_rest;
        jet.growth = load_growth;
    }
    jet.noise *= std::numeric_limits<double>::epsilon();
    return jet;
}

Event ContactPhases::end_of_sliding(int direction, double length, int order) {
    auto at = [&](double t) { return velocity(direction, t); };
    const std::optional<Crossing> zero = first_crossing(at, 0., length, order, step, *effort);
    if (!zero) return {length, direction, 0, 0, false};
    if (zero->open) return {zero->t, direction, 0, 0, false, true};
    const Jet jet = velocity(direction, zero->t);
    touching += zero->touches;
    const double along = e.beta + inertia * jet.f[1]; // load on the contact along the motion
    if (zero->touches && e.mu == 1 && jet.f[2] > 0 && order == 0)
        return {zero->t, direction, 2, direction * e.beta, true}; // it touches zero and goes on
    if (along < -e.mu * e.beta) return {zero->t, -direction, 1, direction * along, true};
    if (along > e.mu * e.beta) return {zero->t, direction, 1, direction * along, true};
    return {zero->t, 0, 0, direction * along, true};
}

Event ContactPhases::end_of_sticking_alone(double tau, double length) {
    const double holds = e.mu * e.beta;
    const double force = system->stuck.k_jj * rest - system->constant.direct;
    Event event{length, 0, 0, 0, false};
    for (const int side : {1, -1}) {
        const double y = (force + side * holds) / direct.re;
        if (!(y > -1 && y < 1)) continue;
        const double angle = atan2(sqrt((1 - y) * (1 + y)), y), passage = direct.re < 0 ? side * angle : -side * angle;
        const double t = std::max(0.0, passage + 2 * pi<double>() * std::ceil((tau - passage) / (2 * pi<double>())) - tau);
        if (t < event.t) event = {t, side, e.mu == 1 ? 2 : 1, side * holds, true};
    }
    return event;
}

Event ContactPhases::end_of_sticking(double length) {
    const double holds = e.mu * e.beta;
    Event event{length, 0, 0, 0, false};
    const Jet at_start = load(0);
    for (const int side : {1, -1}) {
        auto at = [&](double t) {
            Jet jet = t == 0 ? at_start : load(t);
            for (double& f : jet.f) f = -side * f;
            jet.f[0] += holds;
            return jet;
        };
        double from = 0;
        int order = 0;
        for (int tangencies = 0; from < event.t;) {
            const std::optional<Crossing> zero = first_crossing(at, from, event.t, order, step, *effort);
            if (!zero) break;
            if (!zero->open && zero->touches) {
                ++touching;
                const Jet jet = at(zero->t);
                const bool turns_back = jet.f[2] > 0 && zero->t > from, recedes = jet.f[1] > 0;
                if ((turns_back || recedes) && ++tangencies < most_tangencies) {
                    from = zero->t; // the load reaches what friction holds and draws back: the contact stays
                    order = turns_back ? 2 : 1;
                    continue;
                }
            }
            event = {zero->t, side, e.mu == 1 ? 2 : 1, side * holds, true};
            if (zero->open) event = {zero->t, 0, 0, 0, false, true};
            break;
        }
    }
    return event;
}

std::pair<int, int> ContactPhases::first_direction(double tau) {
    const double v_j = system->stuck.contact.of(v);
    if (v_j != 0) return {v_j > 0 ? 1 : -1, 0};
    start_phase(0, tau);
    const Jet Q = load(0);
    const double holds = e.mu * e.beta;
    for (const int side : {1, -1})
        if (side * Q.f[0] > holds) return {side, 1};
    return {0, 0};
}

} // namespace denhartog

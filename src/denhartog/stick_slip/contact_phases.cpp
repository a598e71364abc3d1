// How do the masses move in one phase, and what ends it? `LinearMotion` moves them by (21), in closed form, or by the exponential of
// a matrix if damping couples the modes. Sliding ends if the velocity of the contact is zero, sticking if the load (75) on it
// exceeds static friction, (74): `velocity` and `load` give these with three derivatives, `end_of_sliding` and `end_of_sticking`
// find their first zero with none missed. `set` comes before: what one frequency and friction ratio make of (6).
#include "denhartog/stick_slip/contact_phases.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "elementary/elementary.hpp"

namespace denhartog {

constexpr int most_tangencies = 64; // in one phase; more are a load that lies on the limit to rounding

void LinearMotion::resize(std::size_t n) {
    for (CoordinateValues<double>* v : {&omega_0, &gap, &decay, &F, &G, &at_rest_}) v->resize(n);
    for (CoordinateValues<double>& v : q) v.resize(n);
    coordinates_.resize(n);
    starts_.resize(n);
    free_.resize(n);
}

void LinearMotion::set_force(const std::vector<Complex<double>>& load, double r2) {
    const bool in_phase = std::ranges::all_of(load, [](const Complex<double>& each) { return each.im == 0; });
    lead.clear();
    for (std::size_t i = 0; i < size(); ++i) {
        F[i] = in_phase ? load[i].re / r2 : elementary::hypot(load[i].re, load[i].im) / r2;
        if (in_phase) continue;
        lead.push_back({1, 0});
        if (F[i] > 0) lead[i] = {load[i].re / (F[i] * r2), load[i].im / (F[i] * r2)};
    }
}

void LinearMotion::prepare() {
    for (std::size_t i = 0; i < size(); ++i) coordinates_[i] = evaluation::driven_coordinate(omega_0[i], gap[i], decay[i], F[i]);
    free_at_ = -1;
    if (!coupled()) return;
    const auto n = static_cast<Eigen::Index>(size());
    Matrix<double> A = Matrix<double>::Zero(rows(), rows());
    double rate = 1;
    for (Eigen::Index i = 0; i < n; ++i) {
        const auto k = static_cast<std::size_t>(i);
        A(i, n + i) = 1;
        A(n + i, i) = -omega_0[k] * omega_0[k];
        A(n + i, 2 * n) = lead.empty() ? F[k] : F[k] * lead[k].re;
        if (!lead.empty()) A(n + i, 2 * n + 1) = -F[k] * lead[k].im;
        rate = std::max(rate, omega_0[k]);
    }
    A.block(n, n, n, n) = -D;
    A(2 * n, 2 * n + 1) = -1;
    A(2 * n + 1, 2 * n) = 1;
    together_ = CoupledMotion(A, rate + largest_row_sum(D), CoupledMotion::Asked::many_starts, effort);
}

void LinearMotion::start(double tau) {
    tau_0_ = tau;
    const SineCosine<double> at_start = sine_cosine(tau);
    differentiated_ = false;
    for (std::size_t i = 0; i < size(); ++i) {
        at_rest_[i] = G[i] / (omega_0[i] * omega_0[i]);
        const InitialValues<double> now{q[0][i], q[1][i]};
        const auto [sin_0, cos_0] = at_force(at_start, i);
        starts_[i] = {evaluation::free_start(now, at_rest_[i], coordinates_[i].X, cos_0, sin_0), at_rest_[i], cos_0, sin_0};
    }
    if (!coupled()) return;
    Column z(rows());
    z << column(q[0]) - column(at_rest_), column(q[1]), at_start.c, at_start.s;
    together_.start(std::move(z));
}

void LinearMotion::move_to(double t) {
    differentiated_ = false;
    now_ = sine_cosine(tau_0_ + t);
    if (coupled()) {
        const Column z = together_.at(t);
        const auto n = static_cast<Eigen::Index>(size());
        column(q[0]) = column(at_rest_) + z.head(n);
        column(q[1]) = z.segment(n, n);
        return;
    }
    free_at_ = t;
    for (std::size_t i = 0; i < size(); ++i) {
        const evaluation::DrivenCoordinate<double>& c = coordinates_[i];
        free_[i] = evaluation::free_motion(t, c.R, c.zeta, c.w);
        const SineCosine<double> at = at_force(now_, i);
        const InitialValues<double> now = evaluation::motion_of_coordinate(free_[i], t, c, starts_[i], at.c, at.s);
        q[0][i] = now.eta_0;
        q[1][i] = now.eta_prime_0;
    }
}

void LinearMotion::differentiate_at(double t) {
    if (differentiated_ && t == at_) return;
    move_to(t);
    differentiated_ = true;
    at_ = t;
    if (coupled()) {
        for (int m = 0; m + 2 < orders; ++m)
            for (std::size_t i = 0; i < size(); ++i) {
                double damping = 0;
                for (std::size_t n = 0; n < size(); ++n) damping += D(i, n) * q[m + 1][n];
                q[m + 2][i] = evaluation::acceleration(q[m][i], omega_0[i], damping, force(m, i));
            }
        return;
    }
    for (std::size_t i = 0; i < size(); ++i) {
        double below = q[0][i], last = q[1][i];
        const double omega = omega_0[i], twice = 2 * decay[i];
        for (int m = 0; m + 2 < orders; ++m) {
            const double next = evaluation::acceleration(below, omega, twice * last, force(m, i));
            below = last;
            last = q[m + 2][i] = next;
        }
    }
}

void LinearMotion::carry(double t, Matrix<double>& dq, Matrix<double>& dp) {
    if (coupled()) {
        Matrix<double> z(rows(), dq.cols());
        z << dq, dp, Matrix<double>::Zero(2, dq.cols());
        z = together_.carried(t, z);
        dq = z.topRows(dq.rows());
        dp = z.middleRows(dq.rows(), dq.rows());
        return;
    }
    for (std::size_t i = 0; i < size(); ++i) {
        const evaluation::DrivenCoordinate<double>& c_i = coordinates_[i];
        const evaluation::FreeMotion<double> free = t == free_at_ ? free_[i] : evaluation::free_motion(t, c_i.R, c_i.zeta, c_i.w);
        for (Eigen::Index c = 0; c < dq.cols(); ++c) {
            const double x = dq(i, c), v = dp(i, c);
            dq(i, c) = x * free.d + v * (c_i.R * free.q);
            dp(i, c) = x * free.d_prime + v * (c_i.R * free.q_prime);
        }
    }
}

ContactPhases::ContactPhases(const ContactSystem& s, const Excitation& excitation) : system(&s), N(s.basis.r_n.size()) {
    sliding.resize(N);
    sticking.resize(N - 1);
    sliding.effort = sticking.effort = &effort;
    set(excitation);
}

// A mode by its natural frequency and decay rate, zeta r_n, over omega_1.
static void set_mode(LinearMotion& motion, std::size_t i, double r, double r_n, double decay) {
    motion.omega_0[i] = r_n / r;
    motion.gap[i] = (r - r_n) / r * (1 + motion.omega_0[i]);
    motion.decay[i] = decay / r;
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
    for (std::size_t i = 0; i < N; ++i) set_mode(sliding, i, e.r, basis.r_n[i], basis.zeta[i] * basis.r_n[i]);
    sliding.set_force(system->modal_load, r2);
    if (basis.coupled()) sliding.D = basis.D / e.r;
    sliding.prepare();
    w = basis.phi * system->contact_shape / r2;
    inertia = r2 / system->contact_shape.squaredNorm();
    direct = direct_load(system->stuck, system->load);
    size_of_direct = direct.im == 0 ? std::abs(direct.re) : elementary::hypot(direct.re, direct.im);
    const StuckConfiguration& s = system->stuck;
    k_j = s.phi.transpose() * column(s.k_j);
    c_j = s.phi.transpose() * column(s.c_j) * e.r;
    m_j = s.phi.transpose() * column(s.m_j) * r2;
    sticking.set_force(system->stuck_load, r2);
    for (std::size_t i = 0; i + 1 < N; ++i) set_mode(sticking, i, e.r, s.r_n[i], s.damping(i, i) / 2);
    if (!s.modes_diagonalise_damping) sticking.D = s.damping / e.r;
    sticking.prepare();
    set_bounds_of_load();
}

void ContactPhases::start_phase(int direction, double tau) {
    LinearMotion& part = motion_of(direction);
    const double r2 = e.r * e.r;
    const Matrix<double>& momentum = direction == 0 ? system->stuck.momentum : system->momentum;
    column(part.q[0]).noalias() = momentum * column(x);
    column(part.q[1]).noalias() = momentum * column(v);
    if (direction != 0) {
        column(sliding.G) = -direction * e.beta / r2 * system->contact_shape;
        if (!system->constant.modal.empty()) column(sliding.G) += column(system->constant.modal) / r2;
    } else {
        rest = system->stuck.contact.of(x);
        column(sticking.G) = -rest / r2 * k_j;
        if (!system->constant.stuck.empty()) column(sticking.G) += column(system->constant.stuck) / r2;
    }
    part.start(tau);
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
    const LinearMotion& part = direction == 0 ? sticking : sliding;
    const Matrix<double>& shapes = direction == 0 ? system->stuck.shapes : system->basis.phi;
    const std::size_t n = part.size();
    const std::vector<double> none(N);
    evaluation::LinearSum sum{tau, {}, std::vector<double>(N * n), none, none, none, none};
    const auto [sin_0, cos_0] = sine_cosine(tau);
    for (std::size_t i = 0; i < n; ++i) {
        const double omega = part.omega_0[i], zeta = part.decay[i] / omega, at_rest = part.G[i] / (omega * omega);
        Complex<double> X = part.F[i] * evaluation::response_by_R_squared(part.gap[i], part.decay[i]);
        if (!part.lead.empty()) X = evaluation::product(part.lead[i], X);
        const auto [s, s_prime] = evaluation::free_start({part.q[0][i], part.q[1][i]}, 0.0, X, cos_0, sin_0);
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

std::array<double, 4> ContactPhases::velocity(int direction, double t) {
    effort->spend(sliding.cost());
    sliding.differentiate_at(t);
    std::array<double, 4> f{};
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t m = 0; m < 4; ++m) f[m] += direction * system->contact_shape(i) * sliding.q[m + 1][i];
    return f;
}

std::array<double, 4> ContactPhases::load(double t) {
    effort->spend(sticking.cost());
    sticking.differentiate_at(t);
    const auto [s, c] = sticking.now();
    const double pull = system->stuck.k_jj * rest - system->constant.direct;
    const double force = direct.re * c - direct.im * s, rate = -direct.re * s - direct.im * c;
    std::array<double, 4> f{force - pull, rate, -force, -rate};
    for (std::size_t i = 0; i + 1 < N; ++i)
        for (std::size_t m = 0; m < 4; ++m)
            f[m] -= k_j[i] * sticking.q[m][i] + c_j[i] * sticking.q[m + 1][i] + m_j[i] * sticking.q[m + 2][i];
    return f;
}

Event ContactPhases::end_of_sliding(int direction, double length, int order) {
    auto at = [&](double t) { return velocity_ahead(direction, t); };
    const std::optional<Crossing> zero = first_crossing(at, 0., length, order, step, *effort);
    if (!zero) return {length, direction, 0, 0, false};
    if (zero->open) return {zero->t, direction, 0, 0, false, true};
    const std::array<double, 4> f = velocity(direction, zero->t);
    touching += zero->touches;
    const double along = e.beta + inertia * f[1]; // load on the contact along the motion
    if (zero->touches && e.mu == 1 && f[2] > 0 && order == 0)
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
    const Jet at_start = load_ahead(0);
    for (const int side : {1, -1}) {
        auto at = [&](double t) {
            Jet jet = t == 0 ? at_start : load_ahead(t);
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
    const double Q = load(0)[0];
    const double holds = e.mu * e.beta;
    for (const int side : {1, -1})
        if (side * Q > holds) return {side, 1};
    return {0, 0};
}

} // namespace denhartog

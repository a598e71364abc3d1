// One phase of a motion with stops, and its end. `LinearMotion` carries the modes through a phase by (21), in closed form, or by
// the exponential of a matrix if damping couples them. Sliding ends if the velocity of the contact is zero, sticking if the load
// (75) on it exceeds static friction, (74): `velocity` and `load` give these with five derivatives, `end_of_sliding` and
// `end_of_sticking` find the first of these events and miss none. `set` comes first: it prepares (6) for one frequency and
// friction ratio.
#include "denhartog/stick_slip/exact_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/search/zeros.hpp"
#include "elementary/elementary.hpp"

namespace denhartog {

constexpr int most_tangencies = 64; // in one phase; more are a load that lies on the limit to rounding

void LinearMotion::resize(std::size_t n) {
    for (CoordinateValues<double>* v : {&omega_0, &gap, &decay, &F, &G, &at_rest_}) v->resize(n);
    for (CoordinateValues<double>& v : q) v.resize(n);
    coordinates_.resize(n);
    starts_.resize(n);
    free_.resize(n);
    free_at_start_.resize(n);
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
    for (std::size_t i = 0; i < size(); ++i) {
        coordinates_[i] = evaluation::driven_coordinate(omega_0[i], gap[i], decay[i], F[i]);
        free_at_start_[i] = free_at(0, i);
    }
    free_t_ = -1;
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
    at_start_ = sine_cosine(tau);
    differentiated_ = false;
    for (std::size_t i = 0; i < size(); ++i) {
        at_rest_[i] = G[i] / (omega_0[i] * omega_0[i]);
        const InitialValues<double> now{q[0][i], q[1][i]};
        const auto [sin_0, cos_0] = at_force(at_start_, i);
        starts_[i] = {evaluation::free_start(now, at_rest_[i], coordinates_[i].X, cos_0, sin_0), at_rest_[i], cos_0, sin_0};
    }
    if (!coupled()) return;
    together_at_start_.resize(rows());
    together_at_start_ << column(q[0]) - column(at_rest_), column(q[1]), at_start_.c, at_start_.s;
    together_.start(together_at_start_);
}

void LinearMotion::move_to(double t) {
    if (differentiated_ && t == at_) return;
    differentiated_ = false;
    now_ = t == 0 ? at_start_ : sine_cosine(tau_0_ + t);
    if (coupled()) {
        const Column& z = together_.at(t);
        const auto n = static_cast<Eigen::Index>(size());
        column(q[0]) = column(at_rest_) + z.head(n);
        column(q[1]) = z.segment(n, n);
        return;
    }
    free_t_ = t;
    for (std::size_t i = 0; i < size(); ++i) {
        const evaluation::DrivenCoordinate<double>& c = coordinates_[i];
        free_[i] = t == 0 ? free_at_start_[i] : free_at(t, i);
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
                const double force = harmonic_force(i)[static_cast<std::size_t>(m % 4)] + (m == 0 ? G[i] : 0);
                q[m + 2][i] = evaluation::acceleration(q[m][i], omega_0[i], damping, force);
            }
        return;
    }
    for (std::size_t i = 0; i < size(); ++i) {
        double below = q[0][i], last = q[1][i];
        const double omega = omega_0[i], twice = 2 * decay[i];
        const std::array<double, 4> harmonic = harmonic_force(i);
        for (int m = 0; m + 2 < orders; ++m) {
            const double force = harmonic[static_cast<std::size_t>(m % 4)] + (m == 0 ? G[i] : 0);
            const double next = evaluation::acceleration(below, omega, twice * last, force);
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
        const double R = coordinates_[i].R;
        const evaluation::FreeMotion<double> free = t == free_t_ ? free_[i] : free_at(t, i);
        for (Eigen::Index c = 0; c < dq.cols(); ++c) {
            const double x = dq(i, c), v = dp(i, c);
            dq(i, c) = x * free.d + v * (R * free.q);
            dp(i, c) = x * free.d_prime + v * (R * free.q_prime);
        }
    }
}

ExactSolver::ExactSolver(const ContactSystem& system, const Excitation& excitation)
    : system_(&system), N_(system.basis.r_n.size()) {
    motion_.end = at_rest(N_);
    sliding_.resize(N_);
    sticking_.resize(N_ - 1);
    sliding_.effort = sticking_.effort = &effort_;
    set(excitation);
}

// A mode by its natural frequency and decay rate, zeta r_n, over omega_1.
static void set_mode(LinearMotion& motion, std::size_t i, double r, double r_n, double decay) {
    motion.omega_0[i] = r_n / r;
    motion.gap[i] = (r - r_n) / r * (1 + motion.omega_0[i]);
    motion.decay[i] = decay / r;
}

void ExactSolver::set(const Excitation& excitation) {
    check_frequency_ratio(excitation.r);
    check_friction_ratio(excitation.beta);
    check_static_friction(excitation.mu);
    step_ = 1;
    const bool same_frequency = excitation.r == e_.r;
    e_ = excitation;
    if (same_frequency) return;
    const ModalBasis<double>& basis = system_->basis;
    const double r2 = e_.r * e_.r;
    for (std::size_t i = 0; i < N_; ++i) set_mode(sliding_, i, e_.r, basis.r_n[i], basis.zeta[i] * basis.r_n[i]);
    sliding_.set_force(system_->modal_load, r2);
    if (basis.coupled()) sliding_.D = basis.D / e_.r;
    sliding_.prepare();
    w_ = basis.phi * system_->contact_shape / r2;
    inertia_ = r2 / system_->contact_shape.squaredNorm();
    direct_ = direct_load(system_->stuck, system_->load);
    size_of_direct_ = direct_.im == 0 ? std::abs(direct_.re) : elementary::hypot(direct_.re, direct_.im);
    const StuckConfiguration& s = system_->stuck;
    k_j_ = s.phi.transpose() * column(s.k_j);
    c_j_ = s.phi.transpose() * column(s.c_j) * e_.r;
    m_j_ = s.phi.transpose() * column(s.m_j) * r2;
    sticking_.set_force(system_->stuck_load, r2);
    for (std::size_t i = 0; i + 1 < N_; ++i) set_mode(sticking_, i, e_.r, s.r_n[i], s.damping(i, i) / 2);
    if (!s.modes_diagonalise_damping) sticking_.D = s.damping / e_.r;
    sticking_.prepare();
    set_bounds_of_load();
}

void ExactSolver::start_phase(int direction, double tau) {
    LinearMotion& part = motion_of(direction);
    const double r2 = e_.r * e_.r;
    const Matrix<double>& momentum = direction == 0 ? system_->stuck.momentum : system_->momentum;
    column(part.q[0]).noalias() = momentum.lazyProduct(column(z_.x));
    column(part.q[1]).noalias() = momentum.lazyProduct(column(z_.x_prime));
    if (direction != 0) {
        column(sliding_.G) = -direction * e_.beta / r2 * system_->contact_shape;
        if (!system_->constant.modal.empty()) column(sliding_.G) += column(system_->constant.modal) / r2;
    } else {
        rest_ = system_->stuck.contact.of(z_.x);
        column(sticking_.G) = -rest_ / r2 * k_j_;
        if (!system_->constant.stuck.empty()) column(sticking_.G) += column(system_->constant.stuck) / r2;
    }
    part.start(tau);
}

void ExactSolver::masses_of(int direction, int order, std::vector<double>& out) const {
    out.resize(N_);
    if (direction != 0) {
        column(out).noalias() = system_->basis.phi.lazyProduct(column(sliding_.q[order]));
        return;
    }
    column(out).noalias() = system_->stuck.shapes.lazyProduct(column(sticking_.q[order]));
    if (order == 0)
        for (std::size_t k = 0; k < N_; ++k) out[k] += rest_ * system_->stuck.carried[k];
    else if (const Contact& contact = system_->stuck.contact; !contact.others.empty())
        contact.hold(out.data()); // to the last bit, which rounded rows of shapes do not
}

std::array<double, 6> ExactSolver::velocity(int direction, double t) {
    effort_->spend(sliding_.cost());
    sliding_.differentiate_at(t);
    std::array<double, 6> f{};
    for (std::size_t i = 0; i < N_; ++i)
        for (std::size_t m = 0; m < f.size(); ++m) f[m] += direction * system_->contact_shape(i) * sliding_.q[m + 1][i];
    return f;
}

std::array<double, 6> ExactSolver::load(double t) {
    effort_->spend(sticking_.cost());
    sticking_.differentiate_at(t);
    const auto [s, c] = sticking_.now();
    const double pull = system_->stuck.k_jj * rest_ - system_->constant.direct;
    const double force = direct_.re * c - direct_.im * s, rate = -direct_.re * s - direct_.im * c;
    std::array<double, 6> f{force - pull, rate, -force, -rate, force, rate};
    for (std::size_t i = 0; i + 1 < N_; ++i)
        for (std::size_t m = 0; m < f.size(); ++m)
            f[m] -= k_j_[i] * sticking_.q[m][i] + c_j_[i] * sticking_.q[m + 1][i] + m_j_[i] * sticking_.q[m + 2][i];
    return f;
}

Event ExactSolver::end_of_sliding(int direction, double length, int order) {
    auto at = [&](double t) { return velocity_ahead(direction, t); };
    const std::optional<Crossing> zero = first_crossing(at, 0., length, order, step_, *effort_);
    if (!zero) return {length, direction, 0, 0, false};
    if (zero->open) return {zero->t, direction, 0, 0, false, true};
    const std::array<double, 6> f = velocity(direction, zero->t);
    motion_.touching += zero->touches;
    const double along = e_.beta + inertia_ * f[1]; // load on the contact along the motion
    if (zero->touches && e_.mu == 1 && f[2] > 0 && order == 0)
        return {zero->t, direction, 2, direction * e_.beta, true}; // it touches zero and goes on
    if (along < -e_.mu * e_.beta) return {zero->t, -direction, 1, direction * along, true};
    if (along > e_.mu * e_.beta) return {zero->t, direction, 1, direction * along, true};
    return {zero->t, 0, 0, direction * along, true};
}

Event ExactSolver::end_of_sticking_alone(double tau, double length) {
    const double holds = e_.mu * e_.beta;
    const double force = system_->stuck.k_jj * rest_ - system_->constant.direct;
    Event event{length, 0, 0, 0, false};
    for (const int side : {1, -1}) {
        const double y = (force + side * holds) / direct_.re;
        if (!(y > -1 && y < 1)) continue;
        const double angle = atan2(sqrt((1 - y) * (1 + y)), y), passage = direct_.re < 0 ? side * angle : -side * angle;
        const double t = std::max(0.0, passage + 2 * pi<double>() * std::ceil((tau - passage) / (2 * pi<double>())) - tau);
        if (t < event.t) event = {t, side, e_.mu == 1 ? 2 : 1, side * holds, true};
    }
    return event;
}

Event ExactSolver::end_of_sticking(double tau, double length) {
    if (N_ == 1 && direct_.im == 0) return end_of_sticking_alone(tau, length);
    const double holds = e_.mu * e_.beta;
    const auto reserve = [&](double t) { // what friction holds less the load, on either side
        std::array<Jet, 2> sides{load_ahead(t)};
        sides[1] = sides[0];
        for (double& f : sides[0].f) f = -f;
        for (Jet& jet : sides) jet.f[0] += holds;
        return sides;
    };
    std::array<int, 2> order{};
    double from = 0;
    for (int tangencies = 0;;) {
        const std::optional<Crossing> zero = first_crossing(reserve, from, length, order, step_, *effort_);
        if (!zero) return {length, 0, 0, 0, false};
        if (zero->open) return {zero->t, 0, 0, 0, false, true};
        const int side = zero->which == 0 ? 1 : -1;
        if (zero->touches) {
            ++motion_.touching;
            const Jet jet = reserve(zero->t)[zero->which];
            const bool turns_back = jet.f[2] > 0 && zero->t > from, recedes = jet.f[1] > 0;
            if ((turns_back || recedes) && ++tangencies < most_tangencies) {
                from = zero->t; // the load reaches what friction holds and draws back: the contact stays
                order[zero->which] = turns_back ? 2 : 1;
                continue;
            }
        }
        return {zero->t, side, e_.mu == 1 ? 2 : 1, side * holds, true};
    }
}

std::pair<int, int> ExactSolver::first_direction(double tau) {
    const double v_j = system_->stuck.contact.of(z_.x_prime);
    if (v_j != 0) return {v_j > 0 ? 1 : -1, 0};
    start_phase(0, tau);
    const double Q = load(0)[0];
    const double holds = e_.mu * e_.beta;
    for (const int side : {1, -1})
        if (side * Q > holds) return {side, 1};
    return {0, 0};
}

} // namespace denhartog

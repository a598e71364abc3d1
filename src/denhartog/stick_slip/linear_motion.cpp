// How do the masses move in one phase, between two events? By (21) for each mode, in closed form, or by the exponential of a
// matrix if damping couples the modes. Read `start` and `move_to` first; `differentiate_at` gives the derivatives that the
// search for events needs, and `carry` what becomes of small deviations.
#include "denhartog/stick_slip/linear_motion.hpp"

#include <algorithm>
#include <utility>

#include "denhartog/model/linear_algebra.hpp"
#include "elementary/elementary.hpp"

namespace denhartog {

void LinearMotion::resize(std::size_t n) {
    for (OfCoordinates<double>* v : {&omega_0, &gap, &decay, &F, &G, &at_rest_}) v->resize(n);
    for (OfCoordinates<double>& v : q) v.resize(n);
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
    if (coupled()) prepare_coupled();
}

void LinearMotion::prepare_coupled() {
    const auto n = static_cast<Eigen::Index>(size());
    Matrix<double> A = Matrix<double>::Zero(rows(), rows());
    double rate = 1;
    for (Eigen::Index i = 0; i < n; ++i) {
        const double omega = omega_0[static_cast<std::size_t>(i)];
        A(i, n + i) = 1;
        A(n + i, i) = -omega * omega;
        const auto k = static_cast<std::size_t>(i);
        A(n + i, 2 * n) = lead.empty() ? F[k] : F[k] * lead[k].re;
        if (!lead.empty()) A(n + i, 2 * n + 1) = -F[k] * lead[k].im;
        rate = std::max(rate, omega);
    }
    A.block(n, n, n, n) = -D;
    A(2 * n, 2 * n + 1) = -1;
    A(2 * n + 1, 2 * n) = 1;
    rate += largest_row_sum(D);
    together_ = CoupledMotion(A, rate, CoupledMotion::Asked::many_starts, effort);
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

double LinearMotion::energy_norm(int m) const {
    double largest = 0, sum = 0;
    for (std::size_t i = 0; i < size(); ++i) largest = std::max(largest, energy_norm(m, i));
    if (!(largest > 0)) return largest;
    for (std::size_t i = 0; i < size(); ++i) {
        const double v = q[m + 1][i] / largest, y = omega_0[i] * q[m][i] / largest;
        sum += v * v + y * y;
    }
    return largest * sqrt(sum);
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

} // namespace denhartog

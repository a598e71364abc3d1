// The map over half-periods of the force, seen in a mirror. A fixed point over h of them is a steady motion; if h = 1 it has the
// symmetry (25). `OrbitMap::apply` follows the motion, and `find_fixed_point` looks for such a state. `bounds_of_orbit.cpp` has
// bounds of the rounding of the image and of its derivative.
#include "denhartog/orbit/orbit_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "denhartog/stick_slip/exact_motion.hpp"
#include "elementary/elementary.hpp"

namespace denhartog {

Column difference(const State& a, const State& b) {
    Column d(2 * static_cast<Eigen::Index>(a.x.size()));
    d << column(a.x) - column(b.x), column(a.x_prime) - column(b.x_prime);
    return d;
}

Matrix<double> in_energy_coordinates(const Matrix<double>& J, const Matrix<double>& momentum, const Matrix<double>& shapes,
                                     const std::vector<double>& r_n, double r) {
    const Eigen::Index N = momentum.cols(), n = momentum.rows();
    Matrix<double> E(2 * n, 2 * n);
    for (const Eigen::Index row : {0, 1})
        for (const Eigen::Index column : {0, 1})
            E.block(row * n, column * n, n, n) = momentum * J.block(row * N, column * N, N, N) * shapes;
    for (Eigen::Index i = 0; i < n; ++i) {
        const double omega = r_n[static_cast<std::size_t>(i)] / r;
        E.row(i) *= omega;
        E.col(i) /= omega;
    }
    return E;
}

bool OrbitMap::held() const {
    return std::ranges::none_of(motion_->phases, [](const Phase& p) { return p.direction != 0 && p.end > p.start; });
}

bool OrbitMap::slides_throughout() const {
    return std::ranges::none_of(motion_->phases, [](const Phase& p) { return p.direction == 0 && p.end > p.start; });
}

bool OrbitMap::apply(const State& z, int half_periods, bool with_jacobian) {
    h_ = half_periods;
    half_periods_in_all_ += h_;
    in_energy_.resize(0, 0);
    motion_ = &solver_->run(z, 0, h_ * pi<double>(), with_jacobian);
    if (motion_->status != MotionStatus::complete) return false;
    const double side = h_ % 2 != 0 ? -1 : 1;
    column(image_.x) = side * column(motion_->end.x);
    column(image_.x_prime) = side * column(motion_->end.x_prime);
    difference_ = denhartog::difference(image_, z);
    if (with_jacobian) bound_rounding();
    return true;
}

double OrbitMap::omega(Eigen::Index i) const {
    return solver_->system().basis.r_n[static_cast<std::size_t>(i)] / solver_->excitation().r;
}

Column OrbitMap::in_energy(const Column& dz) const {
    const Matrix<double>& momentum = solver_->system().momentum;
    Column modal(2 * N);
    for (Eigen::Index i = 0; i < N; ++i) {
        double q = 0, p = 0;
        for (Eigen::Index k = 0; k < N; ++k) {
            q += momentum(i, k) * dz(k);
            p += momentum(i, k) * dz(N + k);
        }
        modal(i) = q * omega(i);
        modal(N + i) = p;
    }
    return modal;
}

const Matrix<double>& OrbitMap::energy_jacobian() const {
    const ContactSystem& s = solver_->system();
    if (in_energy_.size() == 0)
        in_energy_ = in_energy_coordinates(jacobian(), s.momentum, s.basis.phi, s.basis.r_n, solver_->excitation().r);
    return in_energy_;
}

double OrbitMap::displacement_of_energy() const {
    const ContactSystem& s = solver_->system();
    const auto reach = [&](const auto& row) { // of a displacement, squared
        double sum = 0;
        for (Eigen::Index i = 0; i < N; ++i) {
            const double each = row(i) * solver_->excitation().r / s.basis.r_n[static_cast<std::size_t>(i)];
            sum += each * each;
        }
        return sum;
    };
    double largest = reach(s.contact_shape);
    for (Eigen::Index k = 0; k < N; ++k) largest = std::max(largest, reach(s.basis.phi.row(k)));
    return sqrt(largest);
}

bool OrbitMap::find_fixed_point(State& z, int h, BadSteps bad_steps) {
    constexpr int most_runs = 40;
    const Contact& contact = solver_->system().stuck.contact;
    const int above =
        solver_->system().basis.coupled() ? 128 : 8; // what is seen is farther below the bound with a damping matrix
    State from, onto;                                // where the step starts, and the image of that
    Column step;                                     // from there
    bool rests_at_0 = false; // the contact sticks at the end of the stretch: its velocity is zero there, without rounding
    double least = -1;       // residual where the last step started, negative if there is none
    double part = 1;         // of the step, that is taken
    int bad = 0;
    residual_ = -1;
    const auto prepare_step = [&] {
        from = z;
        onto = image_;
        rests_at_0 = contact.of(image_.x_prime) == 0 && motion_->phases.back().direction == 0;
        const LinearSystem system(Matrix<double>(Matrix<double>::Identity(2 * N, 2 * N) - jacobian()));
        if (!system.is_regular()) return false;
        step = system.solve(difference_);
        ++newton_steps_;
        return true;
    };
    for (int n = 0; n < most_runs; ++n) {
        if (!apply(z, h, true)) return false;
        const bool rests = held();
        if (rests && least < 0) return false;
        const double residual = norm(difference_), rounding = rounding_in_energy().norm();
        if (!(residual - residual == 0)) return false;
        const bool falls = !rests && (least < 0 || residual < least * (1 - part / 8));
        if (falls) residual_ = residual;
        if (!rests && residual <= (falls ? rounding / above : 8 * rounding)) return true;
        bad += !falls;
        if (bad > static_cast<int>(bad_steps)) return false;
        part = !falls ? part / 2 : prepare_step() ? 1 : 0;
        if (falls) least = residual;
        if (8 * part >= 1) {
            column(z.x) = column(from.x) + part * step.head(N);
            column(z.x_prime) = column(from.x_prime) + part * step.tail(N);
            if (rests_at_0 && part == 1) contact.hold(z.x_prime.data());
            continue;
        }
        if (bad_steps != BadSteps::all_and_go_on_from_image) return false;
        z = onto;
        least = -1;
        part = 1;
    }
    return false;
}

} // namespace denhartog

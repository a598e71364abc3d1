// Which state follows half a period later, seen in a mirror? A state that this map returns is a steady motion with the symmetry
// (25). `OrbitMap::apply` follows the motion, `find_fixed_point` looks for such a state; the rest bounds what rounding makes of
// the image and of its derivative.
#include "denhartog/orbit/orbit_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "denhartog/sliding/bounded_modes.hpp"
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
    if (!with_jacobian) return true;
    const Column energies = largest_energies();
    const double units = double_epsilon * static_cast<int>(motion_->phases.size());
    const double rounding_of_coupled = rounding_of_coupled_modes() * energies.sum();
    rounding_ = (errors_between_modes(units, false) * energies).array() + rounding_of_coupled;
    with_mode_errors_ = (errors_between_modes(units, true) * energies).array() + rounding_of_coupled;
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

// The largest size of each mode over the motion, in energy; between the starts of phases friction may shift it.
Column OrbitMap::largest_energies() const {
    const ContactSystem& s = solver_->system();
    const auto n = static_cast<std::size_t>(N);
    Column largest = Column::Zero(N);
    for (std::size_t phase = 0; phase < motion_->phases.size(); ++phase) {
        const Column z = in_energy(Eigen::Map<const Column>(&motion_->states[2 * n * phase], 2 * N));
        for (Eigen::Index i = 0; i < N; ++i) largest(i) = std::max(largest(i), elementary::hypot(z(i), z(N + i)));
    }
    for (std::size_t i = 0; i < n; ++i)
        largest(i) += solver_->excitation().beta * std::abs(s.contact_shape(i)) / (s.basis.r_n[i] * solver_->excitation().r);
    return largest;
}

// Error in each mode, the row, over the stretch, by a unit of energy of one mode, the column.
//
// Every phase adds some units in the last place of what it makes of the modes; Newton's method settles each mode to its own. A
// natural frequency that is some units off, at least N, turns the mode by that part of its phase angle, which is the larger the
// more of its periods fit in the stretch. Modes are turned towards each other by rounding: the difference of their stiffnesses
// and of their dampings then lets the one force the other, which follows it at rest or is driven over the stretch. Of modes of
// nearly one frequency the angle may be large; if they are damped differently, that damps each of them by some of the
// other's damping. All these errors are taken as an eighth of the bounds of the closed form. What a damping matrix loses on its
// way to the modes, where large dashpots nearly cancel, is a force on each mode over the whole stretch.
Matrix<double> OrbitMap::errors_between_modes(double units, bool mode_errors) const {
    const ContactSystem& s = solver_->system();
    const double r = solver_->excitation().r, length = h_ * pi<double>();
    Matrix<double> E = Matrix<double>::Zero(N, N);
    for (std::size_t i = 0; i < s.basis.r_n.size(); ++i) {
        const double r_i = s.basis.r_n[i];
        for (std::size_t k = 0; k < s.basis.r_n.size(); ++k) {
            const double r_k = s.basis.r_n[k];
            E(i, k) += units * (mode_errors ? std::max(1.0, r_i / r_k) : i == k);
            if (i == k)
                E(i, i) += length * r_i / r * std::max(mode_errors ? s.detuned[i] / 8 : 0, static_cast<int>(N) * double_epsilon);
            if (i == k || !mode_errors) continue;
            const double angle =
                static_cast<int>(N + 1) * double_epsilon +
                angle_of_turn(Bounded<double>(r_i, r_i * s.detuned[i]), Bounded<double>(r_k, r_k * s.detuned[k])) / 8;
            const double damping = 2 * std::abs(s.basis.zeta[i] * r_i - s.basis.zeta[k] * r_k);
            const double stiffness = std::abs(r_i - r_k) * (r_i + r_k) + damping * std::max(r, r_k);
            E(i, k) += (2 + length) * angle * stiffness / (r_k * std::max(r, r_i));
            if (s.damping_fixes_modes && 64 * std::abs(r_i - r_k) <= r_i + r_k) continue;
            E(i, k) += (2 + length) * angle * damping / r;
            E(i, i) += length * angle * angle * damping / r;
        }
    }
    if (mode_errors && s.damping_error.size() > 0) E += length / r * s.damping_error;
    return E;
}

// Damping hands the rounding of one mode to the others: in energy it is that of all of them, over the steps of the series.
double OrbitMap::rounding_of_coupled_modes() const {
    const ModalBasis<double>& basis = solver_->system().basis;
    if (!basis.coupled()) return 0;
    const double rate = 1 + (basis.r_n.back() + largest_row_sum(basis.D)) / solver_->excitation().r;
    const double steps = static_cast<int>(motion_->phases.size()) + h_ * pi<double>() * rate;
    return 4 * static_cast<int>(2 * N + 2) * double_epsilon * steps;
}

double OrbitMap::rounding_of_jacobian() const {
    const double phases = static_cast<int>(motion_->phases.size());
    const double units = 4 * (static_cast<int>(N) + 8) * double_epsilon * phases;
    const Matrix<double> E = errors_between_modes(units, true);
    return sqrt(E.rowwise().sum().maxCoeff() * E.colwise().sum().maxCoeff()) + rounding_of_coupled_modes();
}

Column OrbitMap::rounding_in_energy(bool mode_errors) const {
    return (mode_errors ? with_mode_errors_ : rounding_).replicate(2, 1);
}

Column OrbitMap::rounding(bool mode_errors) const {
    const Column& of = mode_errors ? with_mode_errors_ : rounding_;
    Column bound = Column::Zero(2 * N);
    for (Eigen::Index k = 0; k < N; ++k)
        for (Eigen::Index i = 0; i < N; ++i) {
            const double v = std::abs(solver_->system().basis.phi(k, i)) * of(i);
            bound(k) += v / omega(i);
            bound(N + k) += v;
        }
    return bound;
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

// Which state follows half a period later, seen in a mirror? A state that this map returns is a steady motion with the symmetry
// (25). `apply` follows the motion; the rest bounds what rounding makes of the image and of its derivative.
#include "denhartog/orbit/orbit_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "denhartog/sliding/bounded_modes.hpp"
#include "elementary/elementary.hpp"

namespace denhartog {

Column difference(const State& a, const State& b) {
    const auto N = static_cast<Eigen::Index>(a.x.size());
    Column d(2 * N);
    for (Eigen::Index k = 0; k < N; ++k) {
        const auto n = static_cast<std::size_t>(k);
        d(k) = a.x[n] - b.x[n];
        d(N + k) = a.x_prime[n] - b.x_prime[n];
    }
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
    const bool turned = h_ % 2 != 0;
    for (Eigen::Index k = 0; k < N; ++k) {
        const auto n = static_cast<std::size_t>(k);
        image_.x[n] = turned ? -motion_->end.x[n] : motion_->end.x[n];
        image_.x_prime[n] = turned ? -motion_->end.x_prime[n] : motion_->end.x_prime[n];
        difference_(k) = image_.x[n] - z.x[n];
        difference_(N + k) = image_.x_prime[n] - z.x_prime[n];
    }
    if (!with_jacobian) return true;
    const Column energies = largest_energies();
    const double units = std::numeric_limits<double>::epsilon() * static_cast<int>(motion_->phases.size());
    const double rounding_of_coupled = rounding_of_coupled_modes() * energies.sum();
    rounding_ = (errors_between_modes(units, false) * energies).array() + rounding_of_coupled;
    of_modes_ = (errors_between_modes(units, true) * energies).array() + rounding_of_coupled;
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
Matrix<double> OrbitMap::errors_between_modes(double units, bool of_modes) const {
    const ContactSystem& s = solver_->system();
    const double r = solver_->excitation().r, length = h_ * pi<double>(), eps = std::numeric_limits<double>::epsilon();
    Matrix<double> E = Matrix<double>::Zero(N, N);
    for (std::size_t i = 0; i < s.basis.r_n.size(); ++i) {
        const double r_i = s.basis.r_n[i];
        for (std::size_t k = 0; k < s.basis.r_n.size(); ++k) {
            const double r_k = s.basis.r_n[k];
            E(i, k) += units * (of_modes ? std::max(1.0, r_i / r_k) : i == k);
            if (i == k) E(i, i) += length * r_i / r * std::max(of_modes ? s.detuned[i] / 8 : 0, static_cast<int>(N) * eps);
            if (i == k || !of_modes) continue;
            const double angle =
                static_cast<int>(N + 1) * eps +
                angle_of_turn(Bounded<double>(r_i, r_i * s.detuned[i]), Bounded<double>(r_k, r_k * s.detuned[k])) / 8;
            const double damping = 2 * std::abs(s.basis.zeta[i] * r_i - s.basis.zeta[k] * r_k);
            const double stiffness = std::abs(r_i - r_k) * (r_i + r_k) + damping * std::max(r, r_k);
            E(i, k) += (2 + length) * angle * stiffness / (r_k * std::max(r, r_i));
            if (s.damping_fixes_modes && 64 * std::abs(r_i - r_k) <= r_i + r_k) continue;
            E(i, k) += (2 + length) * angle * damping / r;
            E(i, i) += length * angle * angle * damping / r;
        }
    }
    if (of_modes && s.damping_error.size() > 0) E += length / r * s.damping_error;
    return E;
}

// Damping hands the rounding of one mode to the others: in energy it is that of all of them, over the steps of the series.
double OrbitMap::rounding_of_coupled_modes() const {
    const ModalBasis<double>& basis = solver_->system().basis;
    if (!basis.coupled()) return 0;
    const double rate = 1 + (basis.r_n.back() + largest_row_sum(basis.D)) / solver_->excitation().r;
    const double steps = static_cast<int>(motion_->phases.size()) + h_ * pi<double>() * rate;
    return 4 * static_cast<int>(2 * N + 2) * std::numeric_limits<double>::epsilon() * steps;
}

double OrbitMap::rounding_of_jacobian() const {
    const double phases = static_cast<int>(motion_->phases.size());
    const double units = 4 * (static_cast<int>(N) + 8) * std::numeric_limits<double>::epsilon() * phases;
    const Matrix<double> E = errors_between_modes(units, true);
    return sqrt(E.rowwise().sum().maxCoeff() * E.colwise().sum().maxCoeff()) + rounding_of_coupled_modes();
}

Column OrbitMap::rounding_in_energy(bool of_modes) const {
    Column bound(2 * N);
    bound << (of_modes ? of_modes_ : rounding_), (of_modes ? of_modes_ : rounding_);
    return bound;
}

Column OrbitMap::rounding(bool of_modes) const {
    const Column& of = of_modes ? of_modes_ : rounding_;
    Column bound = Column::Zero(2 * N);
    for (Eigen::Index k = 0; k < N; ++k)
        for (Eigen::Index i = 0; i < N; ++i) {
            const double v = std::abs(solver_->system().basis.phi(k, i)) * of(i);
            bound(k) += v / omega(i);
            bound(N + k) += v;
        }
    return bound;
}

} // namespace denhartog

#include "denhartog/orbit/orbit_map.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/number/number.hpp"

namespace denhartog {

Column<double> difference(const State& a, const State& b) {
    const auto N = static_cast<Eigen::Index>(a.x.size());
    Column<double> d(2 * N);
    for (Eigen::Index k = 0; k < N; ++k) {
        const auto n = static_cast<std::size_t>(k);
        d(k) = a.x[n] - b.x[n];
        d(N + k) = a.x_prime[n] - b.x_prime[n];
    }
    return d;
}

Matrix<double> in_energy_coordinates(Matrix<double> J, const Matrix<double>& momentum, const Matrix<double>& phi,
                                     const std::vector<double>& r_n, double r) {
    const Eigen::Index N = phi.rows();
    J.topRows(N) = momentum * J.topRows(N);
    J.bottomRows(N) = momentum * J.bottomRows(N);
    J.leftCols(N) = J.leftCols(N) * phi;
    J.rightCols(N) = J.rightCols(N) * phi;
    for (Eigen::Index i = 0; i < N; ++i) {
        const double omega = r_n[static_cast<std::size_t>(i)] / r;
        J.row(i) *= omega;
        J.col(i) /= omega;
    }
    return J;
}

bool OrbitMap::held() const {
    for (const Phase& p : motion_->phases)
        if (p.direction != 0 && p.end > p.start) return false;
    return true;
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
    if (with_jacobian) rounding_ = rounding_of_map(*solver_, *motion_, h_ * pi<double>());
    return true;
}

Matrix<double> OrbitMap::newton_matrix() const {
    Matrix<double> A = h_ % 2 != 0 ? motion_->jacobian : Matrix<double>(-motion_->jacobian);
    for (Eigen::Index n = 0; n < 2 * N; ++n) A(n, n) += 1;
    return A;
}

Column<double> OrbitMap::in_energy(const Column<double>& dz) const {
    const ContactSystem& s = solver_->system();
    Column<double> modal(2 * N);
    for (Eigen::Index i = 0; i < N; ++i) {
        double q = 0, p = 0;
        for (Eigen::Index k = 0; k < N; ++k) {
            q += s.momentum(i, k) * dz(k);
            p += s.momentum(i, k) * dz(N + k);
        }
        modal(i) = q * (s.basis.r_n[static_cast<std::size_t>(i)] / solver_->excitation().r);
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

Column<double> OrbitMap::rounding_in_energy(bool of_modes) const {
    Column<double> bound(2 * N);
    for (Eigen::Index i = 0; i < N; ++i) {
        const double omega = solver_->system().basis.r_n[static_cast<std::size_t>(i)] / solver_->excitation().r;
        bound(i) = bound(N + i) = rounding_.of(i, of_modes) * omega;
    }
    return bound;
}

Column<double> OrbitMap::rounding(bool of_modes) const {
    const ContactSystem& s = solver_->system();
    Column<double> bound = Column<double>::Zero(2 * N);
    for (Eigen::Index k = 0; k < N; ++k)
        for (Eigen::Index i = 0; i < N; ++i) {
            const double x = std::abs(s.basis.phi(k, i)) * rounding_.of(i, of_modes);
            bound(k) += x;
            bound(N + k) += x * s.basis.r_n[static_cast<std::size_t>(i)] / solver_->excitation().r;
        }
    return bound;
}

} // namespace denhartog

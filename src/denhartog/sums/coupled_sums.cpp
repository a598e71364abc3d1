// V, U and G of every mass if damping couples the modes: linear systems take the place of the sums (33)-(35). Read
// `coupled_sums` first; `BoundedSystem` adds a bound of the error to each solution.
#include "denhartog/sums/coupled_sums.hpp"

#include <algorithm>

#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/number/why.hpp"

namespace denhartog {

BoundedSystem::BoundedSystem(const Matrix<double>& A, const Matrix<double>& error)
    : A_(A), error_(error + (4 * static_cast<int>(A.rows() + 2) * unit_of<double>()) * A.cwiseAbs()) {
    const LinearSystem system(A_);
    is_regular_ = system.is_regular();
    inverse_ = system.inverse();
}

std::vector<Bounded<double>> BoundedSystem::solved(const Column& b, const Column& error_of_b) const {
    const Column x = product(inverse_, b);
    const Column left_over =
        (b - product(A_, x)).cwiseAbs() + product_of_sizes(error_, x) + (4 * unit_of<double>()) * b.cwiseAbs() + error_of_b;
    const Column error = 2.0 * (product_of_sizes(inverse_, left_over) + unit_of<double>() * x.cwiseAbs());
    std::vector<Bounded<double>> all;
    for (Eigen::Index k = 0; k < x.size(); ++k) all.emplace_back(x(k), error(k));
    return all;
}

BoundedSystem harmonic_system(const Matrix<double>& M, const Matrix<double>& C, const Matrix<double>& K,
                              const Matrix<double>& error_of_C, const Bounded<double>& r) {
    const Eigen::Index n = K.rows();
    const double error_of_r = 2 * r.e / r.x;
    const Matrix<double> inertia = (r.x * r.x) * M, damping = r.x * C, rest = K - inertia;
    const Matrix<double> error_of_rest =
                             error_of_r * inertia.cwiseAbs() + (4 * unit_of<double>()) * (K.cwiseAbs() + inertia.cwiseAbs()),
                         error_of_damping = error_of_r * damping.cwiseAbs() + r.x * error_of_C;
    Matrix<double> A(2 * n, 2 * n), error(2 * n, 2 * n);
    A << rest, -damping, damping, rest;
    error << error_of_rest, error_of_damping, error_of_damping, error_of_rest;
    return {A, error};
}

std::vector<Complex<Bounded<double>>> harmonic_responses(const BoundedSystem& system, const std::vector<Complex<double>>& forces,
                                                         const std::vector<double>& errors) {
    const std::size_t n = forces.size();
    Column b = Column::Zero(static_cast<Eigen::Index>(2 * n)), error_of_b = b;
    for (std::size_t k = 0; k < n; ++k) {
        const auto row = static_cast<Eigen::Index>(k), row_of_sine = static_cast<Eigen::Index>(n + k);
        b(row) = forces[k].re;
        b(row_of_sine) = forces[k].im;
        if (!errors.empty()) error_of_b(row) = error_of_b(row_of_sine) = errors[k];
    }
    const std::vector<Bounded<double>> X = system.solved(b, error_of_b);
    std::vector<Complex<Bounded<double>>> V;
    for (std::size_t k = 0; k < n; ++k) V.push_back({X[k], X[n + k]});
    return V;
}

ModeSums<Bounded<double>> coupled_sums(const System<double>& system, const Bounded<double>& r, Effort* effort) {
    const auto friction = std::make_shared<const CoupledFriction>(system, r.x, effort);
    const Matrix<double> M = mass_matrix(system), C = system.damping_matrix;
    const BoundedSystem motion = harmonic_system(M, C, stiffness_matrix(system), Matrix<double>::Zero(C.rows(), C.rows()), r);
    if (!motion.is_regular()) throw DomainError(Why::response_33_is_infinite);
    const auto to = [&](const std::vector<Complex<double>>& forces, const std::vector<double>& errors) {
        std::vector<Complex<Bounded<double>>> V = harmonic_responses(motion, forces, errors);
        if (contact_moves_apart(system))
            V.push_back({along_contact<Bounded<double>>(system, [&](std::size_t k) { return V[k].re; }),
                         along_contact<Bounded<double>>(system, [&](std::size_t k) { return V[k].im; })});
        return V;
    };
    ModeSums<Bounded<double>> s;
    s.r = r;
    s.contact = contact_row(system);
    s.load = load_row(system);
    s.load_im = load_rows(system).im;
    s.V = to(complex_load(system), error_of_load(system));
    std::vector<Complex<double>> w;
    for (const double each : contact_vector(system)) w.push_back({each, 0});
    s.Y_jj = (s.load == s.contact ? s.V : to(w, {}))[s.contact.index];
    for (std::size_t k = 0; k < s.V.size(); ++k) {
        const evaluation::FrictionMotion<Bounded<double>> start = friction->motion(k, Bounded<double>(0));
        s.U.push_back(-start.prime);
        s.G.push_back(-start.value);
        if (k == s.contact.index) s.H_j = start.double_prime - friction->inverse_inertia();
    }
    s.sum_of_squares = friction->inverse_inertia();
    s.coupled = friction;
    return s;
}

} // namespace denhartog

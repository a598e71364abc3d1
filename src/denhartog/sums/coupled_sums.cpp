#include "denhartog/sums/coupled_sums.hpp"

#include <algorithm>

#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/number/errors.hpp"

namespace denhartog {

template <class T>
BoundedSystem<T>::BoundedSystem(const Matrix<T>& A, const Matrix<T>& error)
    : A_(A), error_(error + T(4 * static_cast<int>(A.rows() + 2) * unit_of<T>()) * A.cwiseAbs()) {
    const LinearSystem<T> system(A_);
    is_regular_ = system.is_regular();
    inverse_ = system.inverse();
}

template <class T>
std::vector<Bounded<T>> BoundedSystem<T>::solved(const Column<T>& b) const {
    const Column<T> x = product(inverse_, b);
    const Column<T> left_over =
        (b - product(A_, x)).cwiseAbs() + product_of_sizes(error_, x) + T(4 * unit_of<T>()) * b.cwiseAbs();
    const Column<T> error = T(2) * (product_of_sizes(inverse_, left_over) + unit_of<T>() * x.cwiseAbs());
    std::vector<Bounded<T>> all;
    for (Eigen::Index k = 0; k < x.size(); ++k) all.emplace_back(x(k), error(k));
    return all;
}

template <class T>
BoundedSystem<T> harmonic_system(const Matrix<T>& M, const Matrix<T>& C, const Matrix<T>& K, const Matrix<T>& error_of_C,
                                 const Bounded<T>& r) {
    const Eigen::Index n = K.rows();
    const T of_r = 2 * r.e / r.x;
    const Matrix<T> inertia = T(r.x * r.x) * M, damping = r.x * C, rest = K - inertia;
    const Matrix<T> of_rest = of_r * inertia.cwiseAbs() + T(4 * unit_of<T>()) * (K.cwiseAbs() + inertia.cwiseAbs()),
                    of_damping = of_r * damping.cwiseAbs() + r.x * error_of_C;
    Matrix<T> A(2 * n, 2 * n), error(2 * n, 2 * n);
    A << rest, -damping, damping, rest;
    error << of_rest, of_damping, of_damping, of_rest;
    return {A, error};
}

template <class T>
std::vector<Complex<Bounded<T>>> harmonic_responses(const BoundedSystem<T>& system, const std::vector<T>& forces) {
    const std::size_t n = forces.size();
    Column<T> b = Column<T>::Zero(static_cast<Eigen::Index>(2 * n));
    std::ranges::copy(forces, b.begin());
    const std::vector<Bounded<T>> X = system.solved(b);
    std::vector<Complex<Bounded<T>>> V;
    for (std::size_t k = 0; k < n; ++k) V.push_back({X[k], X[n + k]});
    return V;
}

template <class T>
ModeSums<Bounded<T>> coupled_sums(const System<T>& system, const Bounded<T>& r) {
    const auto friction = std::make_shared<const CoupledFriction<T>>(system, r.x);
    const Matrix<T> M = mass_matrix(system), C = system.damping_matrix;
    const BoundedSystem<T> motion = harmonic_system<T>(M, C, stiffness_matrix(system), Matrix<T>::Zero(C.rows(), C.rows()), r);
    if (!motion.is_regular())
        throw DomainError("the load excites a resonance without damping: the complex response (33) is infinite there");
    const auto to = [&](const std::vector<T>& forces) {
        std::vector<Complex<Bounded<T>>> V = harmonic_responses(motion, forces);
        if (system.contact_with) {
            const auto &of_j = V[system.contact.index], &of_k = V[system.contact_with->index];
            V.push_back({of_j.re - of_k.re, of_j.im - of_k.im});
        }
        return V;
    };
    ModeSums<Bounded<T>> s;
    s.r = r;
    s.contact = contact_row(system);
    s.load = load_row(system);
    s.V = to(load_vector(system));
    s.Y_jj = (s.load == s.contact ? s.V : to(contact_vector(system)))[s.contact.index];
    for (std::size_t k = 0; k < s.V.size(); ++k) {
        const evaluation::FrictionMotion<Bounded<T>> start = friction->motion(k, Bounded<T>(0));
        s.U.push_back(-start.prime);
        s.G.push_back(-start.value);
        if (k == s.contact.index) s.H_j = start.double_prime - friction->inverse_inertia();
    }
    s.sum_of_squares = friction->inverse_inertia();
    s.coupled = friction;
    return s;
}

template class BoundedSystem<double>;
template BoundedSystem<double> harmonic_system(const Matrix<double>&, const Matrix<double>&, const Matrix<double>&,
                                               const Matrix<double>&, const Bounded<double>&);
template std::vector<Complex<Bounded<double>>> harmonic_responses(const BoundedSystem<double>&, const std::vector<double>&);
template ModeSums<Bounded<double>> coupled_sums(const System<double>&, const Bounded<double>&);

} // namespace denhartog

#include "denhartog/sums/coupled_sums.hpp"

#include <algorithm>

#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/number/errors.hpp"

namespace denhartog {
namespace {

// Complex responses of masses and contact to forces on the masses, by the equations of motion taken as real ones of twice the
// size; errors by what the solution leaves over.
template <class T>
class Responses {
public:
    Responses(const System<T>& s, const Bounded<T>& r)
        : N_(static_cast<Eigen::Index>(number_of_masses(s))), system_(s), A_(2 * N_, 2 * N_), size_(2 * N_, 2 * N_) {
        const Matrix<T> M = r.x * r.x * mass_matrix(s), C = r.x * s.damping_matrix, K = stiffness_matrix(s), KM = K - M;
        A_ << KM, -C, C, KM;
        const Matrix<T> both = K.cwiseAbs() + M.cwiseAbs(), damping = C.cwiseAbs();
        const T of_r = 2 * r.e / r.x;
        error_ = Matrix<T>(2 * N_, 2 * N_);
        const Matrix<T> of_both = of_r * M.cwiseAbs(), of_C = of_r * damping;
        size_ << both, damping, damping, both;
        error_ << of_both, of_C, of_C, of_both;
        error_ += T(4 * static_cast<int>(N_ + 2) * unit_of<T>()) * size_;
        const LinearSystem<T> system(A_);
        if (!system.is_regular())
            throw DomainError("the load excites a resonance without damping: the complex response (33) is infinite there");
        inverse_ = system.inverse();
    }

    std::vector<Complex<Bounded<T>>> to(const std::vector<T>& forces) const {
        Column<T> b = Column<T>::Zero(2 * N_);
        std::ranges::copy(forces, b.begin());
        const Column<T> X = product(inverse_, b);
        const Column<T> left_over =
            (b - product(A_, X)).cwiseAbs() + product_of_sizes(error_, X) + T(4 * unit_of<T>()) * b.cwiseAbs();
        const Column<T> error = T(2) * (product_of_sizes(inverse_, left_over) + unit_of<T>() * X.cwiseAbs());
        std::vector<Complex<Bounded<T>>> V;
        for (Eigen::Index k = 0; k < N_; ++k) V.push_back({{X(k), error(k)}, {X(N_ + k), error(N_ + k)}});
        if (system_.contact_with) {
            const auto &of_j = V[system_.contact.index], &of_k = V[system_.contact_with->index];
            V.push_back({of_j.re - of_k.re, of_j.im - of_k.im});
        }
        return V;
    }

private:
    Eigen::Index N_;
    const System<T>& system_;
    Matrix<T> A_, size_, error_, inverse_;
};

} // namespace

template <class T>
ModeSums<Bounded<T>> coupled_sums(const System<T>& system, const Bounded<T>& r) {
    const auto friction = std::make_shared<const CoupledFriction<T>>(system, r.x);
    const Responses<T> responses(system, r);
    ModeSums<Bounded<T>> s;
    s.r = r;
    s.contact = contact_row(system);
    s.load = load_row(system);
    s.V = responses.to(load_vector(system));
    s.Y_jj = (s.load == s.contact ? s.V : responses.to(contact_vector(system)))[s.contact.index];
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

template ModeSums<Bounded<double>> coupled_sums(const System<double>&, const Bounded<double>&);

} // namespace denhartog

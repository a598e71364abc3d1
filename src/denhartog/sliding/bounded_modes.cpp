#include "denhartog/sliding/bounded_modes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>


namespace denhartog {
namespace {

constexpr double unit_of_double = std::numeric_limits<double>::epsilon();

// A number of a wider type, within an error, rounded to double.
template <class T>
Bounded as_double(const T& x, const T& error) {
    const double value = static_cast<double>(x);
    const double all = static_cast<double>(std::abs(x - T(value)) + error);
    return {value, all * (1 + 4 * unit_of_double) + std::numeric_limits<double>::min()};
}

// Errors that a solver in T is trusted with, and those of inputs in S that are off by a few units of it. A mode of a chain is a
// unit vector over the roots of the masses, and turns by an angle: this bounds its entries where not all of them are there.
template <class T, class S>
ModalBasis<Bounded> bounded_basis(const System<S>& system, const ModalBasis<T>& basis, Inputs inputs, int trust,
                                  const std::vector<Mass>* masses = nullptr) {
    const std::size_t N = basis.r_n.size();
    const T of_input = inputs == Inputs::rounded ? T(std::numeric_limits<S>::epsilon()) : T(0);
    const T unit = trust * static_cast<T>(N) * std::numeric_limits<T>::epsilon() + 4 * of_input;
    const bool chain = !system.stiffness_ratios.empty() && !system.mass_ratios.empty();
    const T highest = basis.r_n.back();
    ModalBasis<Bounded> bounded;
    bounded.phi.resize(basis.phi.rows(), static_cast<Eigen::Index>(N));
    for (std::size_t i = 0; i < N; ++i) {
        const T r_n = basis.r_n[i];
        const T of_square = chain ? 2 * unit * r_n * r_n : unit * highest * highest; // error of the squared frequency
        bounded.r_n.push_back(as_double(r_n, T(of_square / (2 * r_n))));
        const T zeta = system.damping_ratios[i];
        bounded.zeta.push_back(as_double(zeta, T(of_input * zeta)));
        T nearest = std::numeric_limits<T>::infinity(); // difference of the squares, of the chain's relative to both
        for (const std::size_t n : {i - 1, i + 1}) {
            if (n >= N) continue;
            const T apart = std::abs(basis.r_n[n] - r_n) * (basis.r_n[n] + r_n);
            nearest = std::min(nearest, chain ? T(apart * r_n / std::max(basis.r_n[n], r_n)) : apart);
        }
        const T turn = std::min(T(1), N == 1 ? unit : T(of_square / nearest + unit));
        const auto column = static_cast<Eigen::Index>(i);
        const T norm = masses ? T(1) : basis.phi.col(column).norm();
        for (Eigen::Index row = 0; row < basis.phi.rows(); ++row) {
            const T size =
                masses ? norm / std::sqrt(T(system.mass_ratios[(*masses)[static_cast<std::size_t>(row)].index])) : norm;
            bounded.phi(row, column) = as_double(basis.phi(row, column), T(turn * size));
        }
    }
    return bounded;
}

std::vector<double> values_of(const std::vector<Bounded>& numbers) {
    std::vector<double> values;
    values.reserve(numbers.size());
    for (const Bounded& number : numbers) values.push_back(number.x);
    return values;
}

std::vector<Complex<double>> values_of(const std::vector<Complex<Bounded>>& numbers) {
    std::vector<Complex<double>> values;
    values.reserve(numbers.size());
    for (const Complex<Bounded>& number : numbers) values.push_back({number.re.x, number.im.x});
    return values;
}

template <class T>
ModalBasis<Bounded> bounded_basis_at(const System<T>& system, const std::vector<Mass>& masses, int trust) {
    if (!system.stiffness_ratios.empty() && !system.mass_ratios.empty())
        return bounded_basis(system, modal_basis_at(system, masses), Inputs::rounded, trust, &masses);
    ModalBasis<Bounded> all = bounded_basis(system, modal_basis(system), Inputs::rounded, trust);
    Matrix<Bounded> rows(static_cast<Eigen::Index>(masses.size()), all.phi.cols());
    for (std::size_t n = 0; n < masses.size(); ++n)
        rows.row(static_cast<Eigen::Index>(n)) = all.phi.row(static_cast<Eigen::Index>(masses[n].index));
    all.phi = std::move(rows);
    return all;
}

} // namespace

Bounded as_input(double x, Inputs inputs) { return {x, inputs == Inputs::rounded ? unit_of_double * std::abs(x) : 0}; }

Bounded as_input(long double x) { return as_double(x, std::numeric_limits<long double>::epsilon() * std::abs(x)); }

ModalBasis<Bounded> with_errors(const System<double>& system, const ModalBasis<double>& basis) {
    return bounded_basis(system, basis, Inputs::rounded, 8);
}

ModalBasis<Bounded> sharp_basis(const System<double>& system, Inputs inputs) {
    Scene<double> scene;
    scene.system = system;
    return bounded_basis(system, modal_basis(converted<long double>(scene).system), inputs, 3);
}

ModalBasis<Bounded> basis_with_errors_at(const System<double>& system, const std::vector<Mass>& masses) {
    return bounded_basis_at(system, masses, 8);
}

ModalBasis<Bounded> sharp_basis_at(const System<long double>& system, const std::vector<Mass>& masses) {
    return bounded_basis_at(system, masses, 3);
}

BoundedModes::BoundedModes(const Scene<double>& scene, const ModalBasis<double>& basis)
    : BoundedModes(with_errors(scene.system, basis), as_input(*scene.r)) {}

BoundedModes::BoundedModes(ModalBasis<Bounded> basis, const Bounded& r)
    : BoundedModes(std::make_shared<const ModalBasis<Bounded>>(std::move(basis)), r) {}

BoundedModes::BoundedModes(std::shared_ptr<const ModalBasis<Bounded>> basis, const Bounded& r)
    : basis_(std::move(basis)), r_(r), known_(basis_->r_n.size()) {}

const evaluation::ModeFunctions<Bounded>& BoundedModes::at(std::size_t i) {
    if (!known_[i]) known_[i] = mode_functions_at(*basis_, i, r_);
    return *known_[i];
}

std::vector<evaluation::ModeFunctions<Bounded>> BoundedModes::all() {
    std::vector<evaluation::ModeFunctions<Bounded>> functions;
    for (std::size_t i = 0; i < known_.size(); ++i) functions.push_back(at(i));
    return functions;
}

ModeSums<double> values_of(const ModeSums<Bounded>& s) {
    return {s.r.x,
            s.contact,
            s.load,
            values_of(s.R),
            values_of(s.zeta),
            values_of(s.psi),
            values_of(s.v),
            values_of(s.u),
            values_of(s.g),
            values_of(s.V),
            values_of(s.U),
            values_of(s.G),
            {s.Y_jj.re.x, s.Y_jj.im.x},
            s.H_j.x,
            s.sum_of_squares.x};
}

} // namespace denhartog

#include "denhartog/response/bounded_modes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "denhartog/response/scene_source.hpp"

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

// Errors that a solver in T is trusted with, and those of inputs that are off by a few units of double.
template <class T>
ModalBasis<Bounded> bounded_basis(const System<double>& system, const ModalBasis<T>& basis, Inputs inputs, int trust) {
    const std::size_t N = basis.r_n.size();
    const T of_inputs = inputs == Inputs::rounded ? T(4 * unit_of_double) : T(0);
    const T unit = trust * static_cast<T>(N) * std::numeric_limits<T>::epsilon() + of_inputs;
    const bool chain = !system.stiffness_ratios.empty() && !system.mass_ratios.empty();
    const T highest = basis.r_n.back();
    ModalBasis<Bounded> bounded;
    bounded.phi.resize(static_cast<Eigen::Index>(N), static_cast<Eigen::Index>(N));
    for (std::size_t i = 0; i < N; ++i) {
        const T r_n = basis.r_n[i];
        const T of_square = chain ? 2 * unit * r_n * r_n : unit * highest * highest; // error of the squared frequency
        bounded.r_n.push_back(as_double(r_n, T(of_square / (2 * r_n))));
        bounded.zeta.push_back(as_input(system.damping_ratios[i], inputs));
        T nearest = std::numeric_limits<T>::infinity(); // difference of the squares, of the chain's relative to both
        for (const std::size_t n : {i - 1, i + 1}) {
            if (n >= N) continue;
            const T apart = std::abs(basis.r_n[n] - r_n) * (basis.r_n[n] + r_n);
            nearest = std::min(nearest, chain ? T(apart * r_n / std::max(basis.r_n[n], r_n)) : apart);
        }
        const T turn = std::min(T(1), N == 1 ? unit : T(of_square / nearest + unit));
        const auto column = static_cast<Eigen::Index>(i);
        const T size = basis.phi.col(column).norm();
        for (std::size_t k = 0; k < N; ++k) {
            const auto row = static_cast<Eigen::Index>(k);
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

} // namespace

Bounded as_input(double x, Inputs inputs) { return {x, inputs == Inputs::rounded ? unit_of_double * std::abs(x) : 0}; }

ModalBasis<Bounded> with_errors(const System<double>& system, const ModalBasis<double>& basis) {
    return bounded_basis(system, basis, Inputs::rounded, 8);
}

ModalBasis<Bounded> sharp_basis(const System<double>& system, Inputs inputs) {
    Scene<double> scene;
    scene.system = system;
    return bounded_basis(system, modal_basis(converted<long double>(scene).system), inputs, 3);
}

BoundedModes::BoundedModes(const Scene<double>& scene, const ModalBasis<double>& basis)
    : BoundedModes(with_errors(scene.system, basis), as_input(*scene.r)) {}

BoundedModes::BoundedModes(ModalBasis<Bounded> basis, const Bounded& r)
    : basis_(std::move(basis)), r_(r), known_(basis_.r_n.size()) {}

const evaluation::ModeFunctions<Bounded>& BoundedModes::at(std::size_t i) {
    if (!known_[i]) known_[i] = mode_functions_at(basis_, i, r_);
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

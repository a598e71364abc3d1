// The sums over the modes at one frequency ratio: (22), (23), (28), (29) of each mode, then (33)-(35), (64) and (65) of every
// mass. Read the longest `mode_sums` first.
#include "denhartog/sliding/mode_sums.hpp"

#include <boost/container/small_vector.hpp>
#include <boost/math/special_functions/fpclassify.hpp>
#include <utility>

#include "denhartog/formulas/superposition.hpp"
#include "denhartog/number/bounded.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/scene/point_rules.hpp"

namespace denhartog {
namespace {

template <class T>
void check_arguments(const ModalBasis<T>& basis, Mass contact, const LoadRows& load, const T& r) {
    const auto N = static_cast<std::size_t>(basis.phi.rows());
    check_frequency_ratio(r);
    for (const auto& [name, mass] : {std::pair("contact", contact), std::pair("load", load.im.value_or(load.re))})
        check_mass(mass, N, name);
    check_uncoupled(basis);
}

template <class T>
void check_pole(const evaluation::ModeFunctions<T>& f, std::size_t i, const T& R, const T& zeta) {
    const bool v_finite = boost::math::isfinite(f.v.re) && boost::math::isfinite(f.v.im);
    if (v_finite && boost::math::isfinite(f.u) && boost::math::isfinite(f.g)) return;
    const double at = ValueOf<T>::of(R);
    if (zeta > 0) throw PrecisionError({Why::functions_out_of_range, i + 1, at}, Outcome::out_of_range);
    throw DomainError({Why::pole, i + 1, at, v_finite});
}

} // namespace

template <class T>
std::vector<evaluation::ModeFunctions<T>> mode_functions_at(const ModalBasis<T>& basis, const T& r) {
    std::vector<evaluation::ModeFunctions<T>> functions;
    functions.reserve(basis.r_n.size());
    for (std::size_t i = 0; i < basis.r_n.size(); ++i) {
        const T R = r / basis.r_n[i];
        functions.push_back(evaluation::mode_functions(R, basis.zeta[i]));
        check_pole(functions.back(), i, R, basis.zeta[i]);
        ++work_counted.mode_evaluations;
    }
    return functions;
}

template <class T>
ModeSums<T> mode_sums(const ModalBasis<T>& basis, Mass contact, const LoadRows& load, const T& r) {
    check_arguments(basis, contact, load, r);
    return mode_sums(basis, contact, load, r, mode_functions_at(basis, r));
}

template <class T>
ModeSums<T> mode_sums(const ModalBasis<T>& basis, Mass contact, const LoadRows& load, const T& r,
                      const std::vector<evaluation::ModeFunctions<T>>& functions) {
    check_arguments(basis, contact, load, r);
    const std::size_t N = basis.r_n.size();
    ModeSums<T> s;
    s.r = r;
    s.contact = contact;
    s.load = load.re;
    s.load_im = load.im;
    s.zeta = basis.zeta;
    const auto rows = static_cast<std::size_t>(basis.phi.rows());
    // The row of a load on several masses, behind all others, is that of a displacement where it is the contact's alone.
    const std::size_t masses = load.re.index < N || load.re == contact ? rows : load.re.index;
    s.psi.reserve(rows * N);
    for (std::size_t k = 0; k < rows; ++k)
        for (std::size_t i = 0; i < N; ++i) s.psi.push_back(basis.phi(k, i) / r);
    for (std::vector<T>* numbers_of_modes : {&s.R, &s.w, &s.u, &s.g}) numbers_of_modes->reserve(N);
    for (std::vector<T>* numbers_of_masses : {&s.U, &s.G}) numbers_of_masses->reserve(masses);
    s.v.reserve(N);
    s.V.reserve(masses);
    for (std::size_t i = 0; i < N; ++i) {
        s.R.push_back(r / basis.r_n[i]);
        s.w.push_back(evaluation::w_if_oscillating(s.zeta[i]));
        s.v.push_back(functions[i].v);
        s.u.push_back(functions[i].u);
        s.g.push_back(functions[i].g);
    }
    const auto psi_j = mode_shapes_at(s, contact);
    const auto psi_l = mode_shapes_at(s, load.re);
    const std::span<const T> R(s.R), zeta(s.zeta), u(s.u), g(s.g);
    const std::span<const Complex<T>> v(s.v);
    for (std::size_t k = 0; k < masses; ++k) {
        const auto psi_k = mode_shapes_at(s, Mass{k});
        s.V.push_back(paper::complex_response_of_mass(psi_k, psi_l, R, v));
        if (load.im)
            s.V.back() = paper::complex_response_to_phases(
                s.V.back(), paper::complex_response_of_mass(psi_k, mode_shapes_at(s, *load.im), R, v));
        s.U.push_back(paper::damping_function_of_mass(psi_k, psi_j, R, u));
        s.G.push_back(paper::damping_function_of_mass(psi_k, psi_j, R, g));
    }
    s.Y_jj = paper::complex_response_of_mass(psi_j, psi_j, R, v);
    s.H_j = paper::H(psi_j, R, zeta, u, g);
    const boost::container::small_vector<T, 8> ones(N, T(1));
    s.sum_of_squares = paper::sum_over_contact(psi_j, std::span<const T>(ones.data(), N));
    return s;
}

template ModeSums<double> mode_sums(const ModalBasis<double>&, Mass, const LoadRows&, const double&);
template ModeSums<Bounded<double>> mode_sums(const ModalBasis<Bounded<double>>&, Mass, const LoadRows&, const Bounded<double>&);
template ModeSums<Bounded<double>> mode_sums(const ModalBasis<Bounded<double>>&, Mass, const LoadRows&, const Bounded<double>&,
                                             const std::vector<evaluation::ModeFunctions<Bounded<double>>>&);
template std::vector<evaluation::ModeFunctions<Bounded<double>>> mode_functions_at(const ModalBasis<Bounded<double>>&,
                                                                                   const Bounded<double>&);

} // namespace denhartog

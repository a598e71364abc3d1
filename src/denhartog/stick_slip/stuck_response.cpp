#include "denhartog/stick_slip/stuck_response.hpp"

#include <algorithm>
#include <boost/math/special_functions/fpclassify.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "denhartog/elementary/elementary.hpp"
#include "denhartog/formulas/stuck.hpp"
#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/model/natural_modes.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/work_counted.hpp"
#include "denhartog/scene/point_rules.hpp"

namespace denhartog {
namespace {

using std::abs;

// The modulus, also where its square is at an end of the range of a double.
double amplitude_of(const Complex<double>& X) {
    const double square = squared_modulus(X);
    return square > 0x1p-900 && square < 0x1p900 ? std::sqrt(square) : elementary::hypot(X.re, X.im);
}

template <class T>
T amplitude_of(const Complex<T>& X) {
    return modulus(X);
}

template <class T>
T rounding(std::size_t modes) {
    return 4 * static_cast<int>(modes) * std::numeric_limits<T>::epsilon();
}

[[noreturn]] void resonates() {
    throw DomainError(
        "the load excites the resonance of an undamped mode of the stuck configuration: no motion with the contact held "
        "lasts");
}

template <class T>
void check_arguments(const StuckConfiguration<T>& stuck, Mass contact, Mass load, const T& r) {
    const std::size_t N = stuck.masses.size() + 1;
    check_frequency_ratio(r);
    if (load.index >= N && stuck.load.empty())
        throw InputError("load", "must be one of the masses", std::to_string(load.index + 1));
    if (contact.index >= N) throw InputError("contact", "must be one of the masses", std::to_string(contact.index + 1));
    for (const Mass& k : stuck.masses)
        if (k == contact)
            throw InputError("contact", "must be the mass that the stuck configuration holds", std::to_string(contact.index + 1));
}

/// Amplitude of an uncoupled mode under the force p; D is the diagonal entry of the damping, 2 zeta r_n.
template <class T>
Complex<T> mode_amplitude(const T& p, const T& r_n, const T& D, const T& r, const T& tolerance) {
    if (p == 0) return {T(0), T(0)};
    const T a = (r_n - r) * (r_n + r), b = r * D;
    if (abs(a) <= tolerance * r_n * r_n && abs(b) <= tolerance * r_n * r_n) resonates();
    return amplitude_of_mode(p, a, b);
}

/// Amplitudes of coupled modes: the complex system as a real one of twice the size, its rows and columns scaled.
template <class T>
std::vector<Complex<T>> coupled_amplitudes(const StuckConfiguration<T>& stuck, const std::vector<T>& p, const T& r) {
    const auto n = static_cast<Eigen::Index>(p.size());
    Matrix<T> A = Matrix<T>::Zero(2 * n, 2 * n);
    Eigen::Matrix<T, Eigen::Dynamic, 1> scale(2 * n), force = Eigen::Matrix<T, Eigen::Dynamic, 1>::Zero(2 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const T& r_n = stuck.r_n[static_cast<std::size_t>(i)];
        A(i, i) = A(n + i, n + i) = (r_n - r) * (r_n + r);
        scale(i) = scale(n + i) = 1 / sqrt(T(r_n * r_n + r * r));
        force(i) = p[static_cast<std::size_t>(i)];
    }
    A.topRightCorner(n, n) = -r * stuck.damping;
    A.bottomLeftCorner(n, n) = r * stuck.damping;
    A = scale.asDiagonal() * A * scale.asDiagonal();
    const LinearSystem<T> system(A);
    if (!(system.reciprocal_condition() > rounding<T>(p.size()))) resonates();
    force = scale.cwiseProduct(system.solve(scale.cwiseProduct(force)));
    std::vector<Complex<T>> q;
    for (Eigen::Index i = 0; i < n; ++i) q.push_back({force(i), force(n + i)});
    return q;
}

template <class T>
std::vector<Complex<T>> mode_amplitudes(const StuckConfiguration<T>& stuck, const std::vector<T>& p, const T& r) {
    if (!stuck.modes_diagonalise_damping) return coupled_amplitudes(stuck, p, r);
    std::vector<Complex<T>> q;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const auto n = static_cast<Eigen::Index>(i);
        q.push_back(mode_amplitude(p[i], stuck.r_n[i], T(stuck.damping(n, n)), r, rounding<T>(p.size())));
    }
    return q;
}

/// Amplitude by (88)'s modal superposition of the mass of the chain next to the contact.
template <class T>
T neighbour_amplitude(const StuckChain<T>& chain, const StuckResponse<T>& response) {
    const auto [neighbour, load] = rows_of_neighbour_and_load(chain, response);
    Complex<T> X{T(0), T(0)};
    for (std::size_t i = 0; i < chain.r_n.size(); ++i) {
        const auto n = static_cast<Eigen::Index>(i);
        X = X + chain.phi(neighbour, n) * mode_amplitude(T(chain.phi(load, n)), chain.r_n[i], T(2 * chain.zeta[i] * chain.r_n[i]),
                                                         response.r, rounding<T>(chain.r_n.size()));
    }
    return amplitude_of(X);
}

} // namespace

template <class T>
StuckMass<T> motion_of(const Complex<T>& X) {
    StuckMass<T> mass{X, amplitude_of(X), std::nullopt};
    if (mass.amplitude == 0) return mass;
    mass.phase = X.im == 0 ? (X.re < 0 ? pi<T>() : T(0)) : T(-argument(X));
    return mass;
}

template <class T>
StuckResponse<T> stuck_response(const StuckConfiguration<T>& stuck, Mass contact, Mass load, const T& r) {
    check_arguments(stuck, contact, load, r);
    const std::size_t n = stuck.masses.size();
    StuckResponse<T> response{r, contact, load, {}, {}, {}};
    std::vector<Complex<T>> X(n, Complex<T>{T(0), T(0)});
    const std::vector<T> p = load_on_stuck_modes(stuck, load);
    if (std::ranges::any_of(p, [](const T& of_mode) { return of_mode != 0; })) {
        const std::vector<Complex<T>> q = mode_amplitudes(stuck, p, r);
        for (std::size_t k = 0; k < n; ++k)
            for (std::size_t i = 0; i < n; ++i)
                X[k] = X[k] + T(stuck.phi(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i))) * q[i];
    }
    std::vector<T> C_j, K_j;
    for (std::size_t k = 0; k < n; ++k) {
        C_j.push_back(r * stuck.c_j[k]);
        K_j.push_back(stuck.k_j[k] - r * r * stuck.m_j[k]);
    }
    const std::vector<T> none(n, T(0));
    const auto load_with = [&](const std::vector<T>& C) {
        return paper::load_on_held_contact(std::span<const T>(C), std::span<const T>(K_j), std::span<const Complex<T>>(X),
                                           direct_load(stuck, contact, load));
    };
    response.contact_load = load_with(C_j);
    response.elastic_load = load_with(none);
    for (const Complex<T>& X_k : X) response.masses.push_back(motion_of(X_k));
    const StuckMass<T> held{{T(0), T(0)}, T(0), std::nullopt};
    response.masses.insert(response.masses.begin() + static_cast<std::ptrdiff_t>(contact.index), held);
    for (const StuckMass<T>& mass : response.masses)
        if (!boost::math::isfinite(mass.amplitude))
            throw PrecisionError("the stuck response is beyond the range of the number type");
    return response;
}

template <class T>
std::optional<StuckChain<T>> stuck_chain(const System<T>& s, const StuckConfiguration<T>& stuck) {
    if (!is_chain(s) || !s.coordinates.load.empty()) return std::nullopt;
    StuckChain<T> chain;
    if (s.load == s.contact) return chain;
    const auto j = static_cast<std::ptrdiff_t>(s.contact.index);
    const bool before = s.load.index < s.contact.index;
    const auto N = static_cast<std::ptrdiff_t>(s.mass_ratios.size());
    const std::ptrdiff_t first = before ? 0 : j + 1, last = before ? j : N; // masses; in the stuck configuration one less after j
    const auto gamma = s.mass_ratios.begin(), kappa = s.stiffness_ratios.begin();
    if (last - first > 1) ++work_counted.eigen_solves;
    NaturalModes<T> modes = chain_modes(std::vector<T>(gamma + first, gamma + last),
                                        std::vector<T>(kappa + first, before ? kappa + last + 1 : kappa + last));
    const Matrix<T> C = stuck.C.block(before ? 0 : j, before ? 0 : j, last - first, last - first);
    for (std::ptrdiff_t k = first; k < last; ++k) chain.masses.push_back(Mass{static_cast<std::size_t>(k)});
    for (std::size_t i = 0; i < modes.r_n.size(); ++i) {
        const auto phi_i = modes.phi.col(static_cast<Eigen::Index>(i));
        chain.zeta.push_back(T(phi_i.dot(C * phi_i)) / (2 * modes.r_n[i]));
    }
    chain.r_n = std::move(modes.r_n);
    chain.phi = std::move(modes.phi);
    chain.kappa = before ? s.stiffness_ratios[s.contact.index] : s.stiffness_ratios[s.contact.index + 1];
    return chain;
}

template <class T>
StickingBoundary<T> sticking_boundary(const StuckResponse<T>& response, const std::optional<StuckChain<T>>& chain, const T& mu) {
    check_static_friction(mu);
    StickingBoundary<T> b{paper::sticking_limit(response.contact_load, mu), paper::sticking_limit(response.elastic_load, mu),
                          std::nullopt};
    if (!chain) return b;
    if (chain->kappa)
        b.paper = paper::sticking_limit_by_spring(*chain->kappa, neighbour_amplitude(*chain, response), mu);
    else
        b.paper = paper::sticking_limit_under_load(mu);
    return b;
}

template <class T>
std::pair<Eigen::Index, Eigen::Index> rows_of_neighbour_and_load(const StuckChain<T>& chain, const StuckResponse<T>& response) {
    const bool before = response.load.index < response.contact.index;
    return {before ? chain.phi.rows() - 1 : 0, static_cast<Eigen::Index>(response.load.index - chain.masses.front().index)};
}

template <class T>
std::optional<T> rest_interval(const StuckConfiguration<T>& stuck, const StuckResponse<T>& response, const T& mu, const T& beta) {
    check_static_friction(mu);
    check_friction_ratio(beta);
    const T margin = paper::sticking_margin(T(modulus(response.contact_load)), mu, beta);
    if (margin < 0) return std::nullopt;
    return margin / stuck.k_contact;
}

template StuckMass<double> motion_of(const Complex<double>&);
template StuckResponse<double> stuck_response(const StuckConfiguration<double>&, Mass, Mass, const double&);
template std::optional<StuckChain<double>> stuck_chain(const System<double>&, const StuckConfiguration<double>&);
template StickingBoundary<double> sticking_boundary(const StuckResponse<double>&, const std::optional<StuckChain<double>>&,
                                                    const double&);
template std::pair<Eigen::Index, Eigen::Index> rows_of_neighbour_and_load(const StuckChain<double>&,
                                                                          const StuckResponse<double>&);
template std::optional<double> rest_interval(const StuckConfiguration<double>&, const StuckResponse<double>&, const double&,
                                             const double&);

} // namespace denhartog

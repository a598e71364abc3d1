#include "denhartog/solve/held_solution.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <complex>
#include <limits>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/multiprecision.hpp"

namespace denhartog {
namespace {

using std::abs;
using std::asin;

// The response with the contact held; its errors are still to be filled in.
template <class T>
struct Held {
    StuckResponse<T> response;
    HeldSolution<T> solution;
};

template <class T>
Held<T> held(const Scene<T>& scene, const StuckConfiguration<T>& stuck) {
    const System<T>& s = scene.system;
    Held<T> all{stuck_response(stuck, s.contact, s.load, *scene.r), {}};
    for (const StuckMass<T>& mass : all.response.masses)
        all.solution.masses.push_back({mass.amplitude, mass.phase, T(0), T(0), std::nullopt});
    const std::optional<T> reach = rest_interval(stuck, all.response, scene.mu, *scene.beta);
    // On the boundary rounding may leave less than nothing of the interval.
    all.solution.rest_interval.to = reach.value_or(T(0));
    all.solution.rest_interval.from = -all.solution.rest_interval.to;
    all.solution.sticking_by_88 = sticking_boundary(all.response, stuck_chain(s, stuck), scene.mu).paper;
    return all;
}

template <class T>
StuckConfiguration<T> stuck_of(const Scene<T>& scene) {
    return stuck_configuration(scene.system, modal_basis(scene.system));
}

// Sets the errors of a mass and notes them in the largest.
template <class T>
void set_errors(HeldSolution<T>& solution, std::size_t k, const T& error, std::optional<Mass> only) {
    SolvedMass<T>& mass = solution.masses[k];
    mass.error_bound = error;
    T largest(0);
    for (const SolvedMass<T>& each : solution.masses) largest = std::max(largest, each.amplitude);
    if (mass.amplitude <= error && error <= largest * 1024 * std::numeric_limits<T>::epsilon()) {
        mass.phase.reset(); // it does not move
        return;
    }
    mass.phase_error =
        error < mass.amplitude ? T(asin(T(error / mass.amplitude)) + 4 * std::numeric_limits<T>::epsilon()) : pi<T>();
    if (only && k != only->index) return;
    solution.relative =
        std::max({solution.relative, static_cast<double>(T(mass.amplitude > 0 ? T(error / mass.amplitude) : T(1))),
                  static_cast<double>(mass.phase_error)});
}

} // namespace

HeldSolution<double> held_solution(const Scene<double>& scene, const StuckConfiguration<double>& stuck,
                                   std::optional<Mass> only) {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    Held<double> all = held(scene, stuck);
    HeldSolution<double>& solution = all.solution;
    const auto n = static_cast<Eigen::Index>(stuck.masses.size());
    const double r = *scene.r, rounding = 8 * static_cast<double>(n + 1) * epsilon;
    double load_error = epsilon;
    if (n > 0) {
        const Eigen::MatrixXcd A =
            (stuck.K - r * r * stuck.M).cast<std::complex<double>>() + std::complex<double>(0, r) * stuck.C;
        Eigen::VectorXcd X(n), b = Eigen::VectorXcd::Zero(n);
        for (Eigen::Index i = 0; i < n; ++i) {
            const Mass k = stuck.masses[static_cast<std::size_t>(i)];
            X(i) = {all.response.masses[k.index].X.re, all.response.masses[k.index].X.im};
            if (k == scene.system.load) b(i) = 1;
        }
        const Eigen::VectorXd size = X.cwiseAbs();
        const Eigen::VectorXd entries = (stuck.K.cwiseAbs() + r * r * stuck.M.cwiseAbs()) * size +
                                        Eigen::VectorXd::Constant(n, r * stuck.C.cwiseAbs().maxCoeff() * size.sum());
        const Eigen::VectorXd left_over = (b - A * X).cwiseAbs() + rounding * (entries + b.cwiseAbs());
        const Eigen::VectorXd error = 2 * (A.inverse().cwiseAbs() * left_over + epsilon * size);
        if (!error.allFinite()) throw DomainError("the load excites a resonance of the system with the contact held");
        for (Eigen::Index i = 0; i < n; ++i) {
            const auto m = static_cast<std::size_t>(i);
            set_errors(solution, stuck.masses[m].index, error(i), only);
            load_error +=
                (abs(stuck.k_j[m]) + r * abs(stuck.c_j[m]) + r * r * abs(stuck.m_j[m])) * (error(i) + rounding * size(i));
        }
    }
    solution.rest_interval.error_bound = (load_error + rounding * scene.mu * *scene.beta) / stuck.k_contact;
    return solution;
}

template <class T, class Wide>
HeldSolution<T> held_solution(const Scene<T>& scene, const Scene<Wide>& wide_scene, std::optional<Mass> only) {
    constexpr int ulps = 4;
    Held<T> all = held(scene, stuck_of(scene));
    const Held<Wide> wide = held(wide_scene, stuck_of(wide_scene));
    HeldSolution<T>& solution = all.solution;
    for (std::size_t k = 0; k < solution.masses.size(); ++k) {
        const Complex<T>& X = all.response.masses[k].X;
        const Complex<Wide>& W = wide.response.masses[k].X;
        const Wide apart = modulus(Complex<Wide>{Wide(Wide(X.re) - W.re), Wide(Wide(X.im) - W.im)});
        if (k == scene.system.contact.index) continue;
        set_errors(solution, k, T(T(2 * apart) + ulps * std::numeric_limits<T>::epsilon() * solution.masses[k].amplitude), only);
    }
    const Wide apart = abs(Wide(Wide(solution.rest_interval.to) - wide.solution.rest_interval.to));
    solution.rest_interval.error_bound = T(2 * apart) + ulps * std::numeric_limits<T>::epsilon() * solution.rest_interval.to;
    return solution;
}

template <class T>
std::optional<T> sticking_by_88(const Scene<T>& scene) {
    try {
        const StuckConfiguration<T> stuck = stuck_of(scene);
        const StuckResponse<T> response = stuck_response(stuck, scene.system.contact, scene.system.load, *scene.r);
        return sticking_boundary(response, stuck_chain(scene.system, stuck), scene.mu).paper;
    } catch (const DomainError&) {
        return std::nullopt;
    }
}

template HeldSolution<double> held_solution(const Scene<double>&, const Scene<Real50>&, std::optional<Mass>);
template HeldSolution<Real50> held_solution(const Scene<Real50>&, const Scene<Real100>&, std::optional<Mass>);
template std::optional<double> sticking_by_88(const Scene<double>&);
template std::optional<Real50> sticking_by_88(const Scene<Real50>&);
template std::optional<Real100> sticking_by_88(const Scene<Real100>&);

} // namespace denhartog

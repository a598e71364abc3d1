/// @file
/// @brief Ways to a limit of the response of the mass in contact, with that limit, and the digits that (38) keeps on the way with
/// plain sums over modes, in the paper's forms and in those that callers get.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "denhartog/formulas/contact.hpp"
#include "denhartog/formulas/response_limits.hpp"
#include "denhartog/formulas/superposition.hpp"
#include "denhartog/number/ball_or_none.hpp"
#include "denhartog/solve/solve.hpp"
#include "kept_digits.hpp"
#include "tests/support/closed_form.hpp"

namespace denhartog::figures {

/// @brief What (33)-(35) of the contact are made of: its modes, and where the load and the frequency are.
template <class T>
struct ModesAtContact {
    std::vector<T> r_n;   ///< natural frequency ratios
    std::vector<T> zeta;  ///< modal damping ratios
    std::vector<T> phi_j; ///< mode shapes at the contact
    std::vector<T> phi_l; ///< mode shapes at the load
    T r;                  ///< frequency ratio
    T beta;               ///< friction ratio
};

/// @brief Modes rounded to another type: what an eigen-solve without errors would give.
template <class T>
[[nodiscard]] ModesAtContact<T> rounded(const ModesAtContact<Real100>& m) {
    const auto all = [](const std::vector<Real100>& x) {
        std::vector<T> y;
        for (const Real100& each : x) y.push_back(static_cast<T>(each));
        return y;
    };
    return {all(m.r_n), all(m.zeta), all(m.phi_j), all(m.phi_l), static_cast<T>(m.r), static_cast<T>(m.beta)};
}

/// @brief Which forms of (23), (28), (29) are summed.
enum class Forms { printed, shipped };

/// @brief (38) by plain sums over the modes. @param m the modes @param forms which forms @return amplitude of the contact
template <class T>
[[nodiscard]] T amplitude_of_contact(const ModesAtContact<T>& m, Forms forms) {
    std::vector<T> R, psi_j, psi_l, u, g;
    std::vector<Complex<T>> v;
    for (std::size_t i = 0; i < m.r_n.size(); ++i) {
        R.push_back(m.r / m.r_n[i]);
        psi_j.push_back(m.phi_j[i] / m.r);
        psi_l.push_back(m.phi_l[i] / m.r);
        if (forms == Forms::printed) {
            v.push_back(paper::complex_response(R[i], m.zeta[i]));
            u.push_back(paper::first_damping_function(R[i], m.zeta[i]));
            g.push_back(paper::second_damping_function(R[i], m.zeta[i]));
        } else {
            const evaluation::ModeFunctions<T> f = evaluation::mode_functions(R[i], m.zeta[i]);
            v.push_back(f.v), u.push_back(f.u), g.push_back(f.g);
        }
    }
    const std::span<const T> at_j(psi_j), at_l(psi_l), ratios(R);
    return paper::displacement_transmissibility_of_contact(
        paper::complex_response_of_mass(at_j, at_l, ratios, std::span<const Complex<T>>(v)),
        paper::damping_function_of_mass(at_j, at_j, ratios, std::span<const T>(u)),
        paper::damping_function_of_mass(at_j, at_j, ratios, std::span<const T>(g)), m.beta);
}

/// @brief (38) of a system by the library: its eigen-solve, its forms, its sums. @param scene system, r and beta
template <class T>
[[nodiscard]] T amplitude_by_library(const Scene<T>& scene) {
    const ModeSums<T> s = mode_sums(modal_basis(scene.system), scene.system.contact, scene.system.load, *scene.r);
    const std::size_t j = s.contact.index;
    return paper::displacement_transmissibility_of_contact(s.V[j], s.U[j], s.G[j], *scene.beta);
}

/// @brief A path of scenes to a limit; all numbers of a scene are binary fractions of few digits, the same in every type.
struct ResponsePath {
    std::string name;                                                   ///< of its tables
    std::string words;                                                  ///< what falls to zero, and what is fixed
    std::function<Scene<double>(int k)> scene;                          ///< the scene at x = 2^-k, or with k masses
    std::function<ModesAtContact<Real100>(const Scene<double>&)> modes; ///< its modes, by a route of their own
    std::function<Real100(const Scene<double>&)> limit;                 ///< what (38) tends to
    std::vector<int> steps;                                             ///< the k of the chart
};

namespace response_paths {

/// @brief A chain with equal damping ratios at r and beta.
/// @param gamma masses @param kappa springs @param j contact, from 1 @param l load, from 1
[[nodiscard]] inline Scene<double> chain(const std::vector<double>& gamma, const std::vector<double>& kappa, std::size_t j,
                                         std::size_t l, double zeta, double r, double beta) {
    Scene<double> scene;
    scene.system.mass_ratios = gamma;
    scene.system.stiffness_ratios = kappa;
    scene.system.damping_ratios.assign(gamma.size(), zeta);
    scene.system.contact = Mass{j - 1}, scene.system.load = Mass{l - 1};
    scene.r = r, scene.beta = beta;
    return scene;
}

/// @brief Modes at contact and load from shapes. @param phi mass by mode
[[nodiscard]] inline ModesAtContact<Real100> contact_modes(const Scene<double>& s, const std::vector<Real100>& r_n,
                                                           const std::function<Real100(std::size_t k, std::size_t i)>& phi) {
    ModesAtContact<Real100> m{r_n, {}, {}, {}, Real100(*s.r), Real100(*s.beta)};
    for (std::size_t i = 0; i < r_n.size(); ++i) {
        m.zeta.push_back(Real100(s.system.damping_ratios[i]));
        m.phi_j.push_back(phi(s.system.contact.index, i));
        m.phi_l.push_back(phi(s.system.load.index, i));
    }
    return m;
}

/// @brief Modes of two masses from the quadratic equation.
[[nodiscard]] inline ModesAtContact<Real100> modes_of_two(const Scene<double>& s) {
    const Real100 gamma(s.system.mass_ratios[1]), kappa(s.system.stiffness_ratios[1]),
        a = 1 + kappa, d = kappa / gamma, b = -kappa / sqrt(gamma), half = (a - d) / 2, root = sqrt(Real100(half * half + b * b)),
        high = (a + d) / 2 + root,
        low = kappa / gamma / high; // the determinant is that of the springs over that of the masses
    const Real100 larger = half < 0 ? Real100(root - half) : Real100(root + half);
    const Real100 p = half < 0 ? b : larger, q = half < 0 ? larger : b, norm = sqrt(Real100(p * p + q * q)), scale = sqrt(gamma);
    const std::array<std::array<Real100, 2>, 2> phi{
        {{Real100(-q / norm), Real100(p / norm)}, {Real100(p / norm / scale), Real100(q / norm / scale)}}};
    return contact_modes(s, {Real100(sqrt(low)), Real100(sqrt(high))},
                         [&phi](std::size_t k, std::size_t i) { return phi[k][i]; });
}

/// @brief Modes of equal masses and springs: sin(k theta), theta = (2i-1) pi / (2N+1).
[[nodiscard]] inline ModesAtContact<Real100> modes_of_chain(const Scene<double>& s) {
    const std::size_t N = s.system.mass_ratios.size();
    const Real100 all(static_cast<int>(2 * N + 1));
    const auto theta = [&](std::size_t i) { return Real100(static_cast<int>(2 * i + 1) * pi<Real100>() / all); };
    std::vector<Real100> r_n;
    for (std::size_t i = 0; i < N; ++i) r_n.push_back(2 * sin(Real100(theta(i) / 2)));
    return contact_modes(s, r_n, [&](std::size_t k, std::size_t i) {
        return Real100(2 * sin(Real100(static_cast<int>(k + 1) * theta(i))) / sqrt(all));
    });
}

/// @brief (38) of one mass on a spring of stiffness lambda. @param s scene, for r, beta and zeta @param lambda stiffness ratio
[[nodiscard]] inline Real100 amplitude_of_one_mass(const Scene<double>& s, int lambda) {
    const ModesAtContact<Real100> one{{Real100(sqrt(Real100(lambda)))},
                                      {Real100(s.system.damping_ratios[0])},
                                      {Real100(1)},
                                      {Real100(1)},
                                      Real100(*s.r),
                                      Real100(*s.beta)};
    return amplitude_of_contact(one, Forms::printed);
}

/// @brief (38) where the two modes have merged.
[[nodiscard]] inline Real100 amplitude_of_merged_modes(const Scene<double>& s) {
    const Real100 r(*s.r), zeta(s.system.damping_ratios[0]);
    return paper::displacement_transmissibility_of_contact(limits::response_of_merged_modes(r, zeta),
                                                           paper::first_damping_function(r, zeta),
                                                           paper::second_damping_function(r, zeta), Real100(*s.beta));
}

/// @brief From a first to a last number in equal steps.
[[nodiscard]] inline std::vector<int> steps(int first, int last, int step) {
    std::vector<int> k;
    for (int n = first; n <= last; n += step) k.push_back(n);
    return k;
}

} // namespace response_paths

/// @brief The paths of two masses. @return frequencies that merge, a heavy mass, a light mass
[[nodiscard]] inline std::vector<ResponsePath> paths_of_two_masses() {
    using namespace response_paths;
    const double zeta = 0x1p-4, r = 0.75, beta = 0x1p-3;
    return {{"merging", "γ₂ = κ₂ = x: natural frequencies merge",
             [=](int k) {
                 return chain({1, std::ldexp(1, -k)}, {1, std::ldexp(1, -k)}, 1, 2, zeta, r, beta);
             },
             modes_of_two, amplitude_of_merged_modes, steps(2, 100, 7)},
            {"heavy", "γ₂ = 1/x: a heavy mass",
             [=](int k) {
                 return chain({1, std::ldexp(1, k)}, {1, 1}, 1, 1, zeta, r, beta);
             },
             modes_of_two, [](const Scene<double>& s) { return amplitude_of_one_mass(s, 2); }, steps(2, 100, 7)},
            {"light", "γ₂ = x: a light mass",
             [=](int k) {
                 return chain({1, std::ldexp(1, -k)}, {1, 1}, 1, 2, zeta, r, beta);
             },
             modes_of_two, [](const Scene<double>& s) { return amplitude_of_one_mass(s, 1); }, steps(2, 58, 4)}};
}

/// @brief A single mass at r = 1 with zeta = 2^-k next to the boundary: beta = (pi/4)(1 - 2 zeta), rounded to double.
[[nodiscard]] inline Scene<double> next_to_boundary_at_resonance(int k) {
    const double zeta = std::ldexp(1, -k);
    return response_paths::chain({1}, {1}, 1, 1, zeta, 1, pi<double>() / 4 * (1 - 2 * zeta));
}

/// @brief The path to resonance next to the boundary; (38) tends to 1, less what the rounding of beta takes off.
[[nodiscard]] inline ResponsePath path_to_resonance_at_boundary() {
    return {"resonance",
            "r = 1, ζ = x, β = (π/4)(1 − 2x)",
            next_to_boundary_at_resonance,
            response_paths::modes_of_chain,
            [](const Scene<double>& s) {
                const Real100 zeta(s.system.damping_ratios[0]), beta(*s.beta), quarter = pi<Real100>() / 4;
                return Real100((quarter - beta) / (quarter * 2 * zeta));
            },
            response_paths::steps(2, 29, 3)};
}

/// @brief A single mass, r = 3/4, zeta = 1/16, mu = 1, at a friction ratio that is the same in every number type.
[[nodiscard]] inline SceneSource single_mass_at(const Real100& beta) {
    const auto scene =
        std::make_shared<const Scene<double>>(response_paths::chain({1}, {1}, 1, 1, 0x1p-4, 0.75, static_cast<double>(beta)));
    SceneReader reader{scene, {}, {}, {}};
#if DENHARTOG_REFERENCE
    reader.in_balls = [scene, beta](Scene<Ball>& in_balls) {
        in_balls = converted<Ball>(*scene);
        in_balls.beta = Ball::of_text(beta.str(0, std::ios_base::scientific));
    };
#endif
    return std::make_shared<const SceneReader>(std::move(reader));
}

/// @brief The boundary of that mass, the amplitude there and its rate of change.
struct AtBoundary {
    Real100 beta_lim; ///< (67), which is (69) there
    Real100 exact;    ///< (69)
    Real100 X;        ///< what (38) tends to
    Real100 slope;    ///< and its rate, over the relative distance from the boundary
};

/// @brief The boundary of the single mass by the formulas of one mode. @return in 100 digits
[[nodiscard]] inline AtBoundary boundary_of_single_mass() {
    const Scene<Real100> scene = converted<Real100>(single_mass_at(Real100(0))->in_double());
    const ModeSums<Real100> s = mode_sums(modal_basis(scene.system), Mass{0}, Mass{0}, *scene.r);
    const Boundary<Real100> b = boundary(s, Real100(1));
    const Real100 S = s.H_j + s.sum_of_squares;
    return {b.approximate, b.exact, limits::displacement_transmissibility_at_boundary(b.approximate, S, s.G[0]),
            limits::slope_at_boundary(b.approximate, S, s.U[0], s.G[0])};
}

/// @brief The steady amplitude by `solve`, and the regime it finds.
struct SolvedAmplitude {
    Regime regime; ///< the regime
    Real100 X;     ///< amplitude of the mass
};

/// @brief The single mass at beta_lim (1 + side x). @param x distance @param side 1 or -1 @param digits digits asked for
[[nodiscard]] inline SolvedAmplitude solved_next_to(const AtBoundary& b, const Real100& x, int side, int digits) {
    const Solution s = solve(single_mass_at(Real100(b.exact * (1 + side * x))), {Asked::amplitude, digits, false});
    const Certified& X = s.masses[0].amplitude;
    return {s.regime.regime, X.decimal.empty() ? Real100(X.value) : Real100(X.decimal)};
}

/// @brief What `sliding_solution` gives for (38), asked for 12 digits.
[[nodiscard]] inline Real100 answered_amplitude(const Scene<double>& scene) {
    const Solution s = sliding_answer(scene_source(scene), Question{Asked::motion, 12});
    return s.masses.empty() ? Real100(NAN) : Real100(mass_of(s, s.contact).amplitude.value);
}

/// @brief A chain of k equal masses, the load on the first.
/// @param j contact: 1, or 0 for the last mass @param r frequency ratio @param beta friction ratio
[[nodiscard]] inline Scene<double> chain_of(int k, std::size_t j, double r, double beta) {
    const std::vector<double> ones(static_cast<std::size_t>(k), 1);
    return response_paths::chain(ones, ones, j == 0 ? ones.size() : j, 1, 0x1p-4, r, beta);
}

} // namespace denhartog::figures

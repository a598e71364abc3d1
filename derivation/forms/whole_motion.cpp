// The motion that is shipped, put into (12), (25) and (30) for one, two and three masses, every place of contact and load.
//
// No relation between the steps of the paper is used: modes with any modal matrix, the formulas (23), (28), (29), (33)-(35),
// (38), (39), (46) as templates, and the conditions. An error that the formulas and the derivation of the steps share shows here.
#include "derivation/forms/whole_motion.hpp"

#include <algorithm>
#include <utility>

#include "denhartog/formulas/motion.hpp"
#include "denhartog/formulas/superposition.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/provenance.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::matrix;
using GiNaC::numeric;

namespace {

const GiNaC::symbol& tau_symbol() { return GiNaC::ex_to<GiNaC::symbol>(symbols().tau); }

ex velocity_of(const ex& e) { return e.diff(tau_symbol()); }

ex value_at(const ex& e, const ex& tau) { return e.subs(symbols().tau == tau); }

WholeSystem make_whole_system(int N) {
    WholeSystem s{matrix(N, N), matrix(N, N), matrix(N, N), matrix(N, N)};
    const SymbolicModes m = symbolic_modes(N);
    for (int k = 0; k < N; ++k)
        for (int i = 0; i < N; ++i) {
            const std::string n = std::to_string(k + 1) + std::to_string(i + 1), suffix = n + "_of_" + std::to_string(N);
            const bool diagonal = k == i; // apart from zero at the sample points, so that the matrix has an inverse there
            s.Psi(k, i) = new_symbol("psi_" + suffix, "\\psi_{" + n + "}", diagonal ? numeric(1) : numeric(-1, 2),
                                     diagonal ? numeric(2) : numeric(1, 2));
        }
    const matrix inverse = s.Psi.inverse();
    s.M = inverse.transpose().mul(inverse);
    for (int k = 0; k < N; ++k)
        for (int n = 0; n < N; ++n)
            for (int i = 0; i < N; ++i) {
                const ex Omega = 1 / m.R[i].expression(), shape = inverse(i, k) * inverse(i, n);
                s.K(k, n) = s.K(k, n) + Omega * Omega * shape;
                s.C(k, n) = s.C(k, n) + 2 * m.zeta[i].expression() * Omega * shape;
            }
    return s;
}

std::vector<Symbolic> mode_shapes_at(const WholeSystem& s, int k) {
    std::vector<Symbolic> shapes;
    for (unsigned i = 0; i < s.Psi.cols(); ++i) shapes.emplace_back(s.Psi(k, i));
    return shapes;
}

std::vector<Complex<Symbolic>> responses(const SymbolicModes& m) {
    std::vector<Complex<Symbolic>> v;
    for (std::size_t i = 0; i < m.R.size(); ++i) v.push_back(paper::complex_response(m.R[i], m.zeta[i]));
    return v;
}

/// Modes with the damping functions (28), (29) in place of symbols for them.
SymbolicModes with_damping_functions(SymbolicModes m) {
    std::ranges::transform(m.R, m.zeta, m.u.begin(), paper::first_damping_function<Symbolic>);
    std::ranges::transform(m.R, m.zeta, m.g.begin(), paper::second_damping_function<Symbolic>);
    return m;
}

Symbolic friction_motion(const SymbolicModes& m, const std::vector<Symbolic>& psi_k, const std::vector<Symbolic>& psi_j) {
    return paper::friction_motion_of_mass<Symbolic>(Symbolic(symbols().tau), psi_k, psi_j, m.R, m.zeta, m.u, m.g);
}

/// Row n of the left side of (12).
ex left_side_of_12(const WholeSystem& s, const std::vector<ex>& x, int n) {
    ex sum = 0;
    for (std::size_t k = 0; k < x.size(); ++k)
        sum += s.M(n, k) * x[k].diff(tau_symbol(), 2) + s.C(n, k) * velocity_of(x[k]) + s.K(n, k) * x[k];
    return sum;
}

/// Row n of the right side of (12): (6) where x_j' < 0, the sign that friction has.
ex right_side_of_12(int n, int j, int l, const ex& beta, const ex& load) {
    const ex sgn = -1;
    return from_premise() * ((n == l ? load : ex(0)) - (n == j ? beta * sgn : ex(0)));
}

/// The harmonic part of every mass under the load on the mass l, its phase any angle.
std::vector<ex> harmonic_parts(int N, int l) {
    const WholeSystem& s = whole_system(N);
    const SymbolicModes m = symbolic_modes(N);
    const Symbolic angle(symbols().tau + symbols().phi_j);
    std::vector<ex> x;
    for (int k = 0; k < N; ++k)
        x.push_back(
            times_cosine(paper::complex_response_of_mass<Symbolic>(mode_shapes_at(s, k), mode_shapes_at(s, l), m.R, responses(m)),
                         angle)
                .expression());
    return x;
}

/// The part of every mass's motion that friction on the mass j makes, over beta; u_di and g_i are any numbers.
std::vector<ex> friction_parts(int N, int j) {
    const WholeSystem& s = whole_system(N);
    std::vector<ex> x;
    for (int k = 0; k < N; ++k)
        x.push_back(friction_motion(symbolic_modes(N), mode_shapes_at(s, k), mode_shapes_at(s, j)).expression());
    return x;
}

constexpr int nowhere = -1;

Values left_sides(int N, const std::vector<ex>& x) {
    Values values;
    for (int n = 0; n < N; ++n) values.emplace_back(left_side_of_12(whole_system(N), x, n));
    return values;
}

std::vector<ex> right_sides(int N, int j, int l, const ex& beta) {
    const ex load = GiNaC::cos(symbols().tau + symbols().phi_j);
    std::vector<ex> values;
    for (int n = 0; n < N; ++n) values.push_back(right_side_of_12(n, j, l, beta, load));
    return values;
}

/// (46) of a mass with a row of mode shapes, for any V_dk and V_dj.
ex motion_of_any_mass(const SymbolicModes& m) {
    const Symbols& s = symbols();
    return paper::steady_displacement(Symbolic(s.tau), symbolic_V_k(), symbolic_V_j(), Symbolic(s.U_j), Symbolic(s.beta),
                                      friction_motion(m, m.psi_k, m.psi_j))
        .expression();
}

/// The quantities that (25) and (30) set to zero.
std::vector<ex> zeros_by_condition(std::size_t count) { return std::vector<ex>(count, from_premise() - 1); }

/// x_k and x_k' of any mass at an instant.
std::vector<ex> state_at(int N, const ex& tau) {
    const ex x = motion_of_any_mass(with_damping_functions(symbolic_modes(N)));
    return {value_at(x, tau), value_at(velocity_of(x), tau)};
}

Values state_after_half_a_period(int N) {
    Values values;
    for (const ex& e : state_at(N, GiNaC::Pi)) values.emplace_back(e);
    return values;
}

/// The state that (25) makes of the one at the start.
std::vector<ex> mirrored_start(int N) {
    std::vector<ex> values;
    for (const ex& e : state_at(N, 0)) values.push_back(-from_premise() * e);
    return values;
}

/// x_j'(0) and x_j(0) less the amplitude (38).
Values start_residuals(int N) {
    const SymbolicModes m = symbolic_modes(N);
    const Symbolic tau(symbols().tau), beta(symbols().beta);
    const Symbolic U = paper::damping_function_of_mass<Symbolic>(m.psi_j, m.psi_j, m.R, m.u);
    const Symbolic G = paper::damping_function_of_mass<Symbolic>(m.psi_j, m.psi_j, m.R, m.g);
    const Symbolic F = friction_motion(m, m.psi_j, m.psi_j);
    const ex x = paper::steady_displacement(tau, symbolic_V_j(), symbolic_V_j(), U, beta, F).expression();
    const Symbolic X = paper::displacement_transmissibility_of_contact(symbolic_V_j(), U, G, beta);
    return {Symbolic(value_at(velocity_of(x), 0)), Symbolic(value_at(x, 0) - X.expression())};
}

/// Every row of a comparison by the zero test; for three masses, where the twins of a claim would take minutes.
Outcome rows_of(const Values& kernel, const std::vector<ex>& derived) {
    Outcome outcome{Verdict::proved, {}, {}};
    for (std::size_t n = 0; n < kernel.size(); ++n) {
        const ex left = kernel[n].expression();
        const std::vector<ex> real = roots_in({derived[n]});
        const Verdict verdict = decide_component(kernel[n], derived[n], real).verdict;
        if (verdict != Verdict::proved) outcome.verdict = verdict;
        if (differs_at_samples(left, derived[n] + 1, domain_of({left, derived[n]}), real)) ++altered_statements_refuted();
        outcome.steps.push_back({"Component " + std::to_string(n + 1) + ": " + to_string(verdict), ""});
    }
    return outcome;
}

/// A claim that compares by kernel and derived side up to two masses, by `rows_of` for three.
Claim comparison(int N, Claim claim) {
    claim.assumptions.push_back("N = " + std::to_string(N));
    claim.special_case = true; // of a part of the motion: of the whole see tests/derivation/whole_motion.cpp
    if (N < 3) return claim;
    claim.check = [kernel = std::exchange(claim.kernel, {}), derived = std::exchange(claim.derived, {})] {
        return rows_of(kernel(), derived());
    };
    return claim;
}

const Register claims_of_whole_motion([] {
    const Symbols& s = symbols();
    const std::vector<std::string> system{"any modal matrix with an inverse", "R_i > 0", "0 <= zeta_i < 1"};
    std::vector<Claim> list;
    list.push_back({.id = "46/whole-motion/phase",
                    .equations = {"46", "39"},
                    .role = Role::step,
                    .title = "(46) with the phase (39) is Re{V_dk exp(i(tau + phi_j))} and beta times the sum of (41)",
                    .assumptions = {"V_dj not zero", "beta |U_dj| <= |V_dj|"},
                    .kernel =
                        [&s] {
                            return Values{paper::steady_displacement(Symbolic(s.tau), symbolic_V_k(), symbolic_V_j(),
                                                                     Symbolic(s.U_j), Symbolic(s.beta), Symbolic(s.F_k))};
                        },
                    .derived =
                        [&s] {
                            const Symbolic phi_j = paper::phase_of_contact(symbolic_V_j(), Symbolic(s.U_j), Symbolic(s.beta));
                            const Symbolic angle(s.tau + phi_j.expression());
                            return std::vector<ex>{times_cosine(symbolic_V_k(), angle).expression() + s.beta * s.F_k};
                        }});
    list.push_back({.id = "46/whole-motion/N=1",
                    .equations = {"46", "23", "33", "34", "39"},
                    .role = Role::shipped,
                    .title = "The motion (46) of one mass with the phase (39), all at once, satisfies (12) for any u_di, g_i",
                    .assumptions = {"R_i > 0", "0 <= zeta_i < 1", "x_j' < 0 for 0 < tau < pi"},
                    .kernel =
                        [] {
                            const WholeMotion motion = whole_motion(1, 0, 0, symbolic_modes(1));
                            return Values{Symbolic(left_side_of_12(whole_system(1), motion.x, 0))};
                        },
                    .derived =
                        [&s] {
                            const WholeMotion motion = whole_motion(1, 0, 0, symbolic_modes(1));
                            return std::vector<ex>{motion.load + right_sides(1, 0, nowhere, s.beta).front()};
                        },
                    .special_case = true});
    for (int N = 1; N <= 3; ++N) {
        const std::string of_N = "/N=" + std::to_string(N);
        for (int l = 0; l < N; ++l)
            list.push_back(
                comparison(N, {.id = "46/whole-motion/load" + of_N + "/l=" + std::to_string(l + 1),
                               .equations = {"46", "23", "33"},
                               .role = Role::shipped,
                               .title = "The harmonic part of the motion, (33) with (23) in it, balances the load in (12)",
                               .assumptions = system,
                               .kernel = [N, l] { return left_sides(N, harmonic_parts(N, l)); },
                               .derived = [N, l] { return right_sides(N, nowhere, l, 0); }}));
        for (int j = 0; j < N; ++j)
            list.push_back(
                comparison(N, {.id = "46/whole-motion/friction" + of_N + "/j=" + std::to_string(j + 1),
                               .equations = {"46"},
                               .role = Role::shipped,
                               .title = "The rest of the motion, over beta, balances friction in (12), for any u_di and g_i",
                               .assumptions = {system[0], system[1], system[2], "x_j' < 0 for 0 < tau < pi"},
                               .kernel = [N, j] { return left_sides(N, friction_parts(N, j)); },
                               .derived = [N, j] { return right_sides(N, j, nowhere, 1); }}));
        list.push_back(
            comparison(N, {.id = "46/whole-motion/mirror" + of_N,
                           .equations = {"46", "28", "29"},
                           .role = Role::shipped,
                           .title = "With the shipped (28) and (29) half a period turns displacement and velocity of every "
                                    "mass into their opposites, (25)",
                           .assumptions = {system[1], system[2], "V_dj not zero", "beta |U_dj| <= |V_dj|"},
                           .kernel = [N] { return state_after_half_a_period(N); },
                           .derived = [N] { return mirrored_start(N); }}));
        list.push_back({.id = "46/whole-motion/start" + of_N,
                        .equations = {"46", "34", "35", "38"},
                        .role = Role::shipped,
                        .title = "With (34) and (35) the contact starts from the amplitude (38) without velocity, (30)",
                        .assumptions = {system[1], system[2], "V_dj not zero", "N = " + std::to_string(N)},
                        .kernel = [N] { return start_residuals(N); },
                        .derived = [] { return zeros_by_condition(2); },
                        .special_case = true});
    }
    return list;
});

} // namespace

const WholeSystem& whole_system(int N) {
    static const WholeSystem all[]{make_whole_system(1), make_whole_system(2), make_whole_system(3)};
    return all[N - 1];
}

WholeMotion whole_motion(int N, int j, int l, const SymbolicModes& m) {
    const WholeSystem& s = whole_system(N);
    const std::vector<Symbolic> psi_j = mode_shapes_at(s, j), psi_l = mode_shapes_at(s, l);
    const std::vector<Complex<Symbolic>> v = responses(m);
    const auto V_j = paper::complex_response_of_mass<Symbolic>(psi_j, psi_l, m.R, v);
    const Symbolic tau(symbols().tau), beta(symbols().beta);
    const Symbolic U_j = paper::damping_function_of_mass<Symbolic>(psi_j, psi_j, m.R, m.u);
    const Symbolic G_j = paper::damping_function_of_mass<Symbolic>(psi_j, psi_j, m.R, m.g);
    WholeMotion motion{{},
                       cos(tau + paper::phase_of_contact(V_j, U_j, beta)).expression(),
                       paper::displacement_transmissibility_of_contact(V_j, U_j, G_j, beta).expression()};
    for (int k = 0; k < N; ++k) {
        const std::vector<Symbolic> psi_k = mode_shapes_at(s, k);
        const auto V_k = paper::complex_response_of_mass<Symbolic>(psi_k, psi_l, m.R, v);
        const Symbolic F_k = friction_motion(m, psi_k, psi_j);
        motion.x.push_back(paper::steady_displacement(tau, V_k, V_j, U_j, beta, F_k).expression());
    }
    return motion;
}

std::vector<ex> whole_conditions(int N, int j, int l) {
    const WholeMotion motion = whole_motion(N, j, l, with_damping_functions(symbolic_modes(N)));
    std::vector<ex> left_over;
    for (int n = 0; n < N; ++n)
        left_over.push_back(left_side_of_12(whole_system(N), motion.x, n) -
                            right_side_of_12(n, j, l, symbols().beta, motion.load));
    for (const ex& x : motion.x)
        for (const ex& e : {x, velocity_of(x)}) left_over.push_back(value_at(e, GiNaC::Pi) + value_at(e, 0));
    left_over.push_back(value_at(velocity_of(motion.x[j]), 0));
    left_over.push_back(value_at(motion.x[j], 0) - motion.amplitude);
    return left_over;
}

} // namespace denhartog::derivation

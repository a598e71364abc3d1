// Section 2.6, (54), (58), (67)-(69): the load on the contact, and the limits that the conditions set to the friction ratio.
#include "denhartog/formulas/boundary.hpp"
#include "derivation/algebra/limits.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/claim.hpp"
#include "derivation/claims/provenance.hpp"
#include "derivation/paper/modal_sums.hpp"
#include "derivation/paper/system_matrices.hpp"

namespace denhartog::derivation {

using GiNaC::ex;

namespace {

/// Distance of beta^2 below the square of friction_ratio_limit(S), over a positive number: U_dj^2 + S^2 times it.
Symbolic room_below_limit(const Symbolic& S) {
    const Symbolic U(symbols().U_j);
    const ex limit = square(paper::friction_ratio_limit(symbolic_V_j(), U, S)).expression();
    return Symbolic((limit - GiNaC::pow(symbols().beta, 2)) * (symbols().U_j * symbols().U_j + GiNaC::pow(S.expression(), 2)));
}

/// (X_j + beta G_j)^2 - (beta S)^2 in the steady state: positive where X_j + beta G_j, which is not negative, exceeds beta |S|.
ex derived_room(const ex& S) {
    const Symbols& s = symbols();
    const auto [c, sine] = derived_steady_phase(s.V_jr, s.V_ji, s.U_j);
    return GiNaC::pow(s.V_jr * c - s.V_ji * sine, 2) - GiNaC::pow(s.beta * S, 2);
}

/// Row j of the matrices, displacements and velocities of two masses as symbols.
struct ContactRow {
    std::vector<Symbolic> C_j, K_j, x, x_prime;
};

ContactRow contact_row() {
    const SymbolicModes m = symbolic_modes(2);
    return {m.u, m.g, m.psi_k, m.psi_l};
}

/// The load by (12) at tau = 0, through the acceleration of the contact: gamma_j r^2 x_j'' is beta less it.
ex load_by_acceleration() {
    const Symbols& s = symbols();
    const ContactRow row = contact_row();
    const GiNaC::symbol acceleration("acceleration");
    const ex mass = s.gamma * s.r * s.r;
    ex left = from_premise() * mass * acceleration; // (12)
    for (std::size_t k = 0; k < row.x.size(); ++k)
        left += row.C_j[k].expression() * row.x_prime[k].expression() + row.K_j[k].expression() * row.x[k].expression();
    return s.beta - mass * GiNaC::lsolve(left == s.beta + GiNaC::cos(s.phi_j), acceleration);
}

Outcome no_modulus() {
    Outcome outcome;
    add_claim(outcome, "54/load-by-acceleration", "at tau = 0 the load on the contact is beta less gamma_j r^2 x_j''");
    add_argument(
        outcome,
        "After tau = 0 the contact moves back, (54)a, from velocity zero: its acceleration is not positive, and the load is "
        "at least beta",
        "\\bar{x}_j''(0)\\le0");
    outcome.why_no_twin = "an argument from a claim that has twins";
    return outcome;
}

const Register claims_of_section_2_6_limits([] {
    const Symbols& s = symbols();
    std::vector<Claim> list{
        {.id = "54/load-by-acceleration",
         .equations = {"54"},
         .title = "Row j of (12) at tau = 0: the load on the contact is beta less gamma_j r^2 x_j''",
         .assumptions = {"diagonal mass matrix", "x_j' < 0 for 0 < tau < pi"},
         .kernel =
             [] {
                 const ContactRow row = contact_row();
                 return Values{paper::contact_load<Symbolic>(row.C_j, row.K_j, row.x, row.x_prime, 1, Symbolic(0),
                                                             Symbolic(symbols().phi_j))};
             },
         .derived = [] { return std::vector<ex>{load_by_acceleration()}; },
         .departure = Departure::convention,
         .correction = "\\bar{x}_j' < 0 \\ \\text{if}\\ 0<\\tau<\\pi, \\qquad \\sum_{k=1}^N\\overline{C}_{jk}\\bar{x}_k' + "
                       "\\sum_{k=1}^N\\overline{K}_{jk}\\bar{x}_k - \\delta_{lj}\\cos(\\tau+\\phi_j) > \\mu\\beta \\ "
                       "\\text{if}\\ \\tau=0",
         .special_case = true,
         .steps = {{"Row j of (12), solved for the acceleration of the contact", ""}}},
        {.id = "54/no-modulus",
         .equations = {"54"},
         .role = Role::step,
         .title = "The load at tau = 0 is positive and needs no modulus",
         .assumptions = {"diagonal mass matrix", "x_j' < 0 for 0 < tau < pi", "beta > 0"},
         .check = no_modulus},
        {.id = "58/limit",
         .equations = {"58"},
         .title = "(55) with (38) holds where beta is below the limit, and not above it",
         .assumptions = {"S_dj > 0"},
         .kernel = [&s] { return Values{room_below_limit(Symbolic(s.S))}; },
         .derived = [&s] { return std::vector<ex>{derived_room(s.S)}; },
         .steps = {{"(55) asks that $\\overline{X}_j+\\beta G_j$, which is not negative, exceed $\\beta S_{dj}$; the squares "
                    "differ by "
                    "$U_{dj}^2+S_{dj}^2$ times the difference of the squares of the limit and of $\\beta$",
                    ""}}},
        {.id = "67/limit",
         .equations = {"67"},
         .title = "The load (66) exceeds mu beta sum psi_ji^2 where beta is below the limit, and not above it",
         .assumptions = {"H_j >= 0", "mu >= 1"},
         .kernel =
             [&s] {
                 return Values{room_below_limit(paper::static_friction_demand(Symbolic(s.H), Symbolic(s.mu), Symbolic(s.x)))};
             },
         .derived = [&s] { return std::vector<ex>{derived_room(s.H + s.mu * s.x)}; },
         .steps = {{"(66) with (65) asks that $\\overline{X}_j+\\beta G_j$ exceed $\\beta(H_j+\\mu/(\\gamma_jr^2))$", ""}}},
        {.id = "68/limit",
         .equations = {"68"},
         .role = Role::shipped,
         .title = "The load (66) is below - mu beta sum psi_ji^2 where beta is above the limit and H_j above mu sum psi_ji^2",
         .assumptions = {"H_j > mu sum psi_ji^2"},
         .kernel =
             [&s] {
                 return Values{room_below_limit(paper::static_friction_demand(Symbolic(s.H), Symbolic(-s.mu), Symbolic(s.x)))};
             },
         .derived = [&s] { return std::vector<ex>{derived_room(s.H - s.mu * s.x)}; },
         .steps = {{"The other branch asks that $\\overline{X}_j+\\beta G_j$, which is not negative, be below "
                    "$\\beta(H_j-\\mu/(\\gamma_jr^2))$, which has to be positive",
                    ""}}},
        {.id = "69/limit",
         .equations = {"69"},
         .role = Role::shipped,
         .title = "At the limit of the larger of two numbers the condition of the smaller one is met: the larger one decides",
         .assumptions = {"S > 0", "the larger number is S + t, t >= 0"},
         .kernel =
             [&s] {
                 const Symbolic limit = paper::friction_ratio_limit(symbolic_V_j(), Symbolic(s.U_j), Symbolic(s.S + s.t));
                 return Values{Symbolic(derived_room(s.S).subs(s.beta == limit.expression()))};
             },
         .derived =
             [&s] {
                 const ex V_squared = s.V_jr * s.V_jr + s.V_ji * s.V_ji;
                 return std::vector<ex>{V_squared * s.t * (2 * s.S + s.t) / (s.U_j * s.U_j + GiNaC::pow(s.S + s.t, 2))};
             },
         .steps =
             {{"What (58) and (67) ask for is met below their limits; at the limit of the larger number the room of the other "
               "is positive",
               ""}}},
    };
    for (int N = 1; N <= 2; ++N) {
        const std::string of_N = "/N=" + std::to_string(N);
        list.push_back(
            {.id = "54/contact-load" + of_N,
             .equations = {"54"},
             .role = Role::shipped,
             .title = "The load on the contact from the matrices is gamma_j r^2 times the sum of the modes' contributions",
             .assumptions = {"diagonal mass matrix", "j = l = 1", "N = " + std::to_string(N)},
             .kernel =
                 [N, &s] {
                     const SymbolicSystem& system = symbolic_system(N);
                     const SymbolicModes m = symbolic_modes(N);
                     std::vector<Symbolic> C_j, K_j, x, x_prime;
                     for (int k = 0; k < N; ++k) {
                         C_j.emplace_back(system.C(0, k));
                         K_j.emplace_back(system.K(0, k));
                         ex displacement = 0, velocity = 0;
                         for (int i = 0; i < N; ++i) {
                             displacement += system.Psi(k, i) * m.u[i].expression();
                             velocity += system.Psi(k, i) * m.g[i].expression();
                         }
                         x.emplace_back(displacement);
                         x_prime.emplace_back(velocity);
                     }
                     return Values{paper::contact_load<Symbolic>(C_j, K_j, x, x_prime, 1, Symbolic(0), Symbolic(s.phi_j))};
                 },
             .derived =
                 [N, &s] {
                     const SymbolicSystem& system = symbolic_system(N);
                     const SymbolicModes m = symbolic_modes(N);
                     const ex by_18 = from_premise();
                     ex load = 0;
                     for (int i = 0; i < N; ++i) {
                         const ex eta_0 = m.u[i].expression(), eta_prime_0 = m.g[i].expression();
                         load +=
                             system.Psi(0, i) * (2 * by_18 * system.zeta[i] * system.Omega[i] * eta_prime_0 +
                                                 GiNaC::pow(system.Omega[i], 2) * eta_0 - system.Psi(0, i) * GiNaC::cos(s.phi_j));
                     }
                     return std::vector<ex>{system.gamma[0] * system.r * system.r * load};
                 },
             .special_case = true});
    }
    return list;
});

} // namespace
} // namespace denhartog::derivation

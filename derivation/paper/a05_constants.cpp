// (A.3), (A.5): the integration constants from the initial values.
#include "derivation/algebra/symbols.hpp"
#include "derivation/paper/derived.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::lst;

std::pair<ex, ex> derived_constants() {
    const Symbols& s = symbols();
    const ex eta = derived_general_solution();
    const ex at_start = eta.subs(s.tau == 0);
    const ex rate_at_start = eta.diff(GiNaC::ex_to<GiNaC::symbol>(s.tau)).subs(s.tau == 0);
    const ex solution = GiNaC::lsolve(lst{at_start == s.eta_0, rate_at_start == s.eta_prime_0}, lst{s.A, s.B});
    return {s.A.subs(solution), s.B.subs(solution)};
}

namespace {

const Register claims_of_a05_constants([] {
    const Symbols& s = symbols();
    return std::vector<Claim>{
        {.id = "A.5/constants",
         .equations = {"A.5"},
         .title = "The integration constants that meet the initial conditions (24), (A.3)",
         .assumptions = {"R_i > 0", "0 <= zeta_i < 1"},
         .kernel =
             [&s] {
                 const IntegrationConstants<Symbolic> c =
                     paper::integration_constants(symbolic_mode(), symbolic_start(), Symbolic(s.beta), Symbolic(s.phi_j));
                 return Values{c.A, c.B};
             },
         .derived =
             [] {
                 const auto [A, B] = derived_constants();
                 return std::vector<ex>{in_phi_j(A), in_phi_j(B)};
             },
         .departure = Departure::convention,
         .steps = {{"The general solution (A.2) and its rate at $\\tau=0$ are set to the initial values (24)",
                    "\\eta_i(0)=\\eta_{i0},\\qquad \\eta_i'(0)=\\eta_{i0}'"},
                   step("Two linear equations; the first gives", "A_i", derived_constants().first),
                   step("and the second", "B_i", derived_constants().second)}},
        {.id = "A.3/initial-conditions",
         .equations = {"24", "A.3"},
         .role = Role::step,
         .title = "The general solution with these constants starts from the initial values",
         .assumptions = {"R_i > 0", "0 <= zeta_i < 1"},
         .kernel =
             [&s] {
                 const ModeInScene<Symbolic> m = symbolic_mode();
                 const IntegrationConstants<Symbolic> c =
                     paper::integration_constants(m, symbolic_start(), Symbolic(s.beta), Symbolic(s.phi_j));
                 const ex eta = paper::general_solution(Symbolic(s.tau), m, c, Symbolic(s.beta), Symbolic(s.phi_j)).expression();
                 return Values{Symbolic(eta.subs(s.tau == 0)),
                               Symbolic(eta.diff(GiNaC::ex_to<GiNaC::symbol>(s.tau)).subs(s.tau == 0))};
             },
         .derived =
             [&s] {
                 return std::vector<ex>{s.eta_0, s.eta_prime_0};
             },
         .special_case = true,
         .steps = {{"The constants (A.5) are put into (A.2), which is then evaluated at $\\tau=0$, and so is its rate", ""}}},
    };
});

} // namespace
} // namespace denhartog::derivation

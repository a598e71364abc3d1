// (A.15), (40): the modal displacement over the half-period of the steady state.
#include "denhartog/formulas/as_printed.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/paper/derived.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::lst;

ex derived_modal_displacement() {
    // the solution of the final conditions put into the displacement; the parts of it that friction makes keep the names u and g
    const Symbols& s = symbols();
    const auto [v_cos, v_sin] = derived_phase_by_functions();
    return derived_displacement_by_v().subs(lst{s.v_cos == v_cos, s.v_sin == v_sin});
}

namespace {

const Register claims_of_a15_modal_displacement([] {
    const Symbols& s = symbols();
    const std::vector<std::string> domain{"R_i > 0", "0 <= zeta_i < 1", "0 <= tau <= pi"};
    const auto derived = [] { return std::vector<ex>{derived_modal_displacement()}; };
    return std::vector<Claim>{
        {.id = "A.15/printed",
         .equations = {"40", "A.15"},
         .role = Role::printed,
         .title = "Modal displacement as printed, with sine and cosine exchanged in the bracket",
         .assumptions = domain,
         .kernel =
             [&s] {
                 return Values{as_printed::modal_displacement(Symbolic(s.tau), symbolic_mode(), symbolic_start(), Symbolic(s.u),
                                                              Symbolic(s.g), Symbolic(s.beta))};
             },
         .derived = derived,
         .departure = Departure::misprint,
         .correction_left = {"\\eta_i"}},
        {.id = "A.15/displacement",
         .equations = {"40", "A.15"},
         .role = Role::shipped,
         .title = "Modal displacement over the half-period, with the bracket d of (A.8)",
         .assumptions = domain,
         .kernel =
             [&s] {
                 return Values{paper::modal_displacement(Symbolic(s.tau), symbolic_mode(), symbolic_start(), Symbolic(s.u),
                                                         Symbolic(s.g), Symbolic(s.beta))};
             },
         .derived = derived,
         .steps = {{"(A.13) and (A.14) are put into the displacement (A.6)",
                    "[v_{di}\\cos\\phi_j] = \\frac{\\eta_{i0}+\\psi_{ji}R_i^2g_i\\beta}{\\psi_{li}R_i^2},\\qquad "
                    "[v_{di}\\sin\\phi_j] = -\\frac{\\eta_{i0}'+\\psi_{ji}R_i^2u_{di}\\beta}{\\psi_{li}R_i^2}"},
                   {"The initial values lose their free motions $d_i$ and $q_i$; friction keeps $1-(1+g_i)d_i-u_{di}R_iq_i$",
                    "d_i\\eta_{i0} - d_i(\\eta_{i0}+\\psi_{ji}R_i^2g_i\\beta) = -d_i\\psi_{ji}R_i^2g_i\\beta"},
                   step("The displacement over the half-period", "\\eta_i", derived_modal_displacement())}},
        {.id = "40/rate",
         .equations = {"40"},
         .role = Role::shipped,
         .title = "Rate of the braces of (40)",
         .assumptions = domain,
         .kernel =
             [&s] {
                 return Values{paper::friction_motion_prime(Symbolic(s.tau), Symbolic(s.R), Symbolic(s.zeta), Symbolic(s.u),
                                                            Symbolic(s.g))};
             },
         .derived =
             [&s] {
                 const ex friction_alone = derived_modal_displacement().subs(
                     lst{s.eta_0 == -s.psi_ji * s.R * s.R * s.g * s.beta, s.eta_prime_0 == -s.psi_ji * s.R * s.R * s.u * s.beta});
                 return std::vector<ex>{friction_alone.diff(GiNaC::ex_to<GiNaC::symbol>(s.tau)) /
                                        (s.beta * s.psi_ji * s.R * s.R)};
             }},
    };
});

} // namespace
} // namespace denhartog::derivation

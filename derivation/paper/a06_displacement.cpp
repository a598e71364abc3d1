// (A.6), (A.8): the modal displacement from its initial values, and the functions d and q.
#include "derivation/algebra/symbols.hpp"
#include "derivation/paper/derived.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::lst;

ex derived_displacement() {
    const Symbols& s = symbols();
    const auto [A, B] = derived_constants();
    return derived_general_solution().subs(lst{s.A == A, s.B == B});
}

ex derived_displacement_by_v() {
    // v_cos = Re v c_phi - Im v s_phi, v_sin = Re v s_phi + Im v c_phi, solved for c_phi and s_phi
    const Symbols& s = symbols();
    const auto [re, im] = derived_complex_response();
    const ex solution =
        GiNaC::lsolve(lst{re * s.c_phi - im * s.s_phi == s.v_cos, re * s.s_phi + im * s.c_phi == s.v_sin}, lst{s.c_phi, s.s_phi});
    return derived_displacement().subs(solution);
}

namespace {

const Register claims_of_a06_displacement([] {
    const Symbols& s = symbols();
    const std::vector<std::string> domain{"R_i > 0", "0 <= zeta_i < 1", "0 <= tau <= pi"};
    return std::vector<Claim>{
        {.id = "A.6/displacement",
         .equations = {"A.6"},
         .title = "Modal displacement from the initial values",
         .assumptions = domain,
         .kernel =
             [&s] {
                 return Values{paper::modal_displacement_from_start(Symbolic(s.tau), symbolic_mode(), symbolic_start(),
                                                                    Symbolic(s.beta), Symbolic(s.phi_j))};
             },
         .derived = [] { return std::vector<ex>{in_phi_j(derived_displacement())}; },
         .departure = Departure::convention,
         .steps = {step(
             "The constants (A.5) are put into the general solution (A.2), and the terms ordered by the initial values, "
             "friction and load",
             "\\eta_i", derived_displacement())}},
        {.id = "A.8/free-motion",
         .equations = {"A.8"},
         .title = "d is the answer to a unit displacement, R q the answer to a unit velocity",
         .assumptions = domain,
         .kernel =
             [&s] {
                 const Symbolic R(s.R), zeta(s.zeta), tau(s.tau);
                 return Values{paper::d(tau, R, zeta), R * paper::q(tau, R, zeta)};
             },
         .derived =
             [&s] {
                 const ex eta = derived_displacement();
                 return std::vector<ex>{eta.diff(GiNaC::ex_to<GiNaC::symbol>(s.eta_0)),
                                        eta.diff(GiNaC::ex_to<GiNaC::symbol>(s.eta_prime_0))};
             },
         .steps = {step("The factor of the initial displacement in the derived displacement", "d_i",
                        derived_displacement().diff(GiNaC::ex_to<GiNaC::symbol>(s.eta_0))),
                   step("The factor of the initial velocity", "R_iq_i",
                        derived_displacement().diff(GiNaC::ex_to<GiNaC::symbol>(s.eta_prime_0)))}},
    };
});

} // namespace
} // namespace denhartog::derivation

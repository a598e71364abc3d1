// (A.7), (A.9): the modal velocity, and the rates of d and q.
#include "denhartog/formulas/as_printed.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/paper/derived.hpp"

namespace denhartog::derivation {

using GiNaC::ex;

namespace {

ex rate(const ex& e) { return e.diff(GiNaC::ex_to<GiNaC::symbol>(symbols().tau)); }

const Register claims_of_a07_velocity([] {
    const Symbols& s = symbols();
    const std::vector<std::string> domain{"R_i > 0", "0 <= zeta_i < 1", "0 <= tau <= pi"};
    const auto derived = [] { return std::vector<ex>{in_phi_j(rate(derived_displacement()))}; };
    return std::vector<Claim>{
        {.id = "A.7/printed",
         .equations = {"A.7"},
         .role = Role::printed,
         .title = "Modal velocity as printed, with - d' eta_0",
         .assumptions = domain,
         .kernel =
             [&s] {
                 return Values{as_printed::modal_velocity_from_start(Symbolic(s.tau), symbolic_mode(), symbolic_start(),
                                                                     Symbolic(s.beta), Symbolic(s.phi_j))};
             },
         .derived = derived,
         .departure = Departure::misprint,
         .correction_left = {"\\eta_i'"}},
        {.id = "A.7/velocity",
         .equations = {"A.7"},
         .role = Role::shipped,
         .title = "Modal velocity from the initial values, with + d' eta_0",
         .assumptions = domain,
         .kernel =
             [&s] {
                 return Values{paper::modal_velocity_from_start(Symbolic(s.tau), symbolic_mode(), symbolic_start(),
                                                                Symbolic(s.beta), Symbolic(s.phi_j))};
             },
         .derived = derived,
         .steps = {{"The displacement (A.6) is differentiated with respect to $\\tau$; $d_i'$ multiplies $+\\eta_{i0}$, as $d_i$ "
                    "does there",
                    "\\frac{\\mathrm{d}}{\\mathrm{d}\\tau}(d_i\\eta_{i0}) = d_i'\\eta_{i0}"},
                   step("With $d_i' = -q_i/R_i$, (A.9), the rate is", "\\eta_i'", rate(derived_displacement()))}},
        {.id = "A.9/rates",
         .equations = {"A.9"},
         .title = "Rates of d and q",
         .assumptions = domain,
         .kernel =
             [&s] {
                 const Symbolic R(s.R), zeta(s.zeta), tau(s.tau);
                 return Values{paper::d_prime(tau, R, zeta), R * paper::q_prime(tau, R, zeta)};
             },
         .derived =
             [&s] {
                 const ex velocity = rate(derived_displacement());
                 return std::vector<ex>{velocity.diff(GiNaC::ex_to<GiNaC::symbol>(s.eta_0)),
                                        velocity.diff(GiNaC::ex_to<GiNaC::symbol>(s.eta_prime_0))};
             },
         .steps = {step("The factor of $\\eta_{i0}$ in the rate of (A.6)", "d_i'",
                        rate(derived_displacement()).diff(GiNaC::ex_to<GiNaC::symbol>(s.eta_0))),
                   step("The factor of $\\eta'_{i0}$, the rate of $R_iq_i$", "R_iq_i'",
                        rate(derived_displacement()).diff(GiNaC::ex_to<GiNaC::symbol>(s.eta_prime_0)))}},
    };
});

} // namespace
} // namespace denhartog::derivation

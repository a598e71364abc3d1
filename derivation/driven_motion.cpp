// The motion of a coordinate from its start as the exact solver forms it: (A.6), (A.7) regrouped, and the response from rest.
#include "denhartog/evaluation/driven_motion.hpp"

#include "derived.hpp"
#include "symbols.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::lst;

namespace {

std::vector<ex> with_rate(const ex& displacement) {
    return {displacement, displacement.diff(GiNaC::ex_to<GiNaC::symbol>(symbols().tau))};
}

Values values(const InitialValues<Symbolic>& motion) { return {motion.eta_0, motion.eta_prime_0}; }

const Register registered([] {
    const Symbols& s = symbols();
    const std::vector<std::string> domain{"R_i > 0", "0 <= zeta_i < 1"};
    const std::vector<std::string> in_time{"R_i > 0", "0 <= zeta_i < 1", "0 < tau < pi"};
    const Symbolic R(s.R), zeta(s.zeta), tau(s.tau), beta(s.beta), psi_ji(s.psi_ji), psi_li(s.psi_li);
    const Symbolic gap(1 - 1 / (s.R * s.R)), decay(s.zeta / s.R);
    const Symbolic cos_0(GiNaC::cos(s.phi_j)), sin_0(GiNaC::sin(s.phi_j));
    return std::vector<Claim>{
        {.id = "evaluation/response-by-R-squared",
         .equations = {"23"},
         .role = Role::shipped,
         .title = "R^2 v from the distance to resonance and the decay rate",
         .assumptions = domain,
         .kernel =
             [=] {
                 const Complex<Symbolic> X = evaluation::response_by_R_squared(gap, decay);
                 return Values{X.re, X.im};
             },
         .derived =
             [&s] {
                 const auto [re, im] = derived_complex_response();
                 return std::vector<ex>{s.R * s.R * re, s.R * s.R * im};
             }},
        {.id = "evaluation/driven-motion",
         .equations = {"A.6", "A.7"},
         .role = Role::shipped,
         .title = "Displacement and velocity as rest, harmonic motion and the free motion of what the start has more",
         .assumptions = in_time,
         .kernel =
             [=, &s] {
                 const Symbolic at_rest = psi_ji * (R * R) * beta;
                 const Complex<Symbolic> X = psi_li * evaluation::response_by_R_squared(gap, decay);
                 const InitialValues<Symbolic> start = evaluation::free_start(symbolic_start(), at_rest, X, cos_0, sin_0);
                 const Symbolic cosine(GiNaC::cos(s.tau + s.phi_j)), sine(GiNaC::sin(s.tau + s.phi_j));
                 return values(evaluation::driven_motion(evaluation::oscillating_free_motion(tau, R, zeta), R, start, at_rest, X,
                                                         cosine, sine));
             },
         .derived = [] { return with_rate(in_phi_j(derived_displacement())); }},
        {.id = "evaluation/response-from-rest",
         .equations = {"A.6", "A.7"},
         .role = Role::shipped,
         .title = "The response from rest as one, without the difference of harmonic and free motion",
         .assumptions = in_time,
         .kernel =
             [=] {
                 return values(evaluation::response_from_rest(tau, R, zeta, gap,
                                                              evaluation::oscillating_free_motion(tau, R, zeta), cos_0, sin_0));
             },
         .derived =
             [&s] {
                 const lst from_rest{s.eta_0 == 0, s.eta_prime_0 == 0, s.beta == 0, s.psi_li == 1};
                 return with_rate(in_phi_j(derived_displacement()).subs(from_rest));
             }},
        {.id = "evaluation/acceleration",
         .equations = {"20", "A.1"},
         .role = Role::shipped,
         .title = "The acceleration leaves nothing over in the equation of motion",
         .assumptions = domain,
         .kernel =
             [=] {
                 const InitialValues<Symbolic> eta = symbolic_start();
                 const Symbolic force = psi_ji * beta + psi_li * cos_0, damping = 2 * decay * eta.eta_prime_0;
                 return Values{evaluation::acceleration(eta.eta_0, Symbolic(1 / R.expression()), damping, force)};
             },
         .derived =
             [&s] {
                 const GiNaC::symbol acceleration("acceleration");
                 const ModeInScene<Symbolic> m = symbolic_mode();
                 const ex residual =
                     paper::modal_equation_residual(Symbolic(s.eta_0), Symbolic(s.eta_prime_0), Symbolic(acceleration),
                                                    Symbolic(0), m, Symbolic(s.beta), Symbolic(s.phi_j))
                         .expression();
                 return std::vector<ex>{GiNaC::lsolve(residual == 0, acceleration)};
             }},
    };
});

} // namespace

} // namespace denhartog::derivation

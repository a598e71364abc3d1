// The motion of a coordinate from its start as the exact solver forms it: (A.6), (A.7) regrouped, and the response from rest.
#include "denhartog/evaluation/driven_motion.hpp"

#include "derivation/algebra/symbols.hpp"
#include "derivation/paper/derived.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::lst;

namespace {

std::vector<ex> with_rate(const ex& displacement) {
    return {displacement, displacement.diff(GiNaC::ex_to<GiNaC::symbol>(symbols().tau))};
}

Values values(const InitialValues<Symbolic>& motion) { return {motion.eta_0, motion.eta_prime_0}; }

/// The free motions and their rates; the forms that callers get are claims of their own.
evaluation::FreeMotion<Symbolic> free_motions() {
    const Symbolic tau(symbols().tau), R(symbols().R), zeta(symbols().zeta);
    return {paper::d(tau, R, zeta), paper::q(tau, R, zeta), paper::d_prime(tau, R, zeta), paper::q_prime(tau, R, zeta),
            Symbolic(ex(0))};
}

/// From rest under cos(tau + phi_j): a harmonic motion and a free one that takes displacement and velocity off it at tau = 0.
ex derived_response_from_rest(const ex& a, const ex& b) {
    const Symbols& s = symbols();
    const ex angle = s.tau + s.phi_j, decay = GiNaC::exp(-a * s.tau);
    const ex harmonic = s.A * GiNaC::cos(angle) + s.B * GiNaC::sin(angle);
    const auto rate = [&](const ex& e) { return e.diff(GiNaC::ex_to<GiNaC::symbol>(s.tau)); };
    // x'' + 2 a x' + (a^2 + b^2) x = cos(tau + phi_j), by the factors of the cosine and of the sine
    const ex stiffness = a * a + b * b;
    const ex forced = harmonic.subs(
        GiNaC::lsolve(lst{(stiffness - 1) * s.A + 2 * a * s.B == 1, (stiffness - 1) * s.B - 2 * a * s.A == 0}, lst{s.A, s.B}));
    const ex free = decay * (s.A * GiNaC::cos(b * s.tau) + s.B * GiNaC::sin(b * s.tau));
    const ex motion = forced + free;
    return motion.subs(GiNaC::lsolve(lst{motion.subs(s.tau == 0) == 0, rate(motion).subs(s.tau == 0) == 0}, lst{s.A, s.B}));
}

const Register claims_of_driven_motion([] {
    const Symbols& s = symbols();
    const std::vector<std::string> domain{"R_i > 0", "0 <= zeta_i < 1"};
    const std::vector<std::string> in_time{"R_i > 0", "0 <= zeta_i < 1", "0 < tau < pi"};
    const Symbolic R(s.R), zeta(s.zeta), tau(s.tau), beta(s.beta), psi_ji(s.psi_ji), psi_li(s.psi_li);
    const Symbolic gap(1 - 1 / (s.R * s.R)), decay(s.zeta / s.R);
    const Symbolic cos_0(GiNaC::cos(s.phi_j)), sin_0(GiNaC::sin(s.phi_j));
    const ex a = new_symbol("a_i", "a_i", GiNaC::numeric(1, 50), GiNaC::numeric(1, 2));
    const ex b = new_symbol("b_i", "b_i", GiNaC::numeric(1, 2), GiNaC::numeric(3, 2));
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
        {.id = "evaluation/detuning",
         .equations = {"A.8"},
         .role = Role::shipped,
         .title = "The difference of the damped frequency and that of the force, without a difference",
         .assumptions = domain,
         .kernel = [=] { return Values{evaluation::detuning(R, zeta, gap)}; },
         .derived = [&s] { return std::vector<ex>{1 - GiNaC::sqrt(1 - s.zeta * s.zeta) / s.R}; }},
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
                 return values(evaluation::driven_motion(free_motions(), R, start, at_rest, X, cosine, sine));
             },
         .derived = [] { return with_rate(in_phi_j(derived_displacement())); }},
        {.id = "evaluation/response-from-rest",
         .equations = {"A.6", "A.7"},
         .role = Role::shipped,
         .title = "The response from rest as one, without the difference of harmonic and free motion",
         .assumptions = {"a_i > 0", "b_i > 0", "0 < tau < pi"},
         .kernel =
             [=, &s] {
                 const Symbolic decayed(GiNaC::exp(-a * s.tau)), apart(1 - b);
                 const Complex<Symbolic> e{decayed * Symbolic(GiNaC::cos(b * s.tau)), decayed * Symbolic(GiNaC::sin(b * s.tau))};
                 return values(evaluation::response_from_rest(tau, Symbolic(a), Symbolic(b), apart, e, cos_0, sin_0));
             },
         .derived = [=] { return with_rate(derived_response_from_rest(a, b)); }},
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

// The forms of (A.8), (A.9) and of the expression in (57) that callers get, each equal to the paper's.
#include "denhartog/evaluation/demand.hpp"

#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/claim.hpp"

namespace denhartog::derivation {

using GiNaC::ex;

namespace {

const Register claims_of_evaluation_of_motion([] {
    const Symbols& s = symbols();
    const std::vector<std::string> domain{"R_i > 0", "0 <= zeta_i < 1"};
    const std::vector<std::string> in_time{"R_i > 0", "0 <= zeta_i < 1", "0 < tau < pi"};
    const Symbolic R(s.R), zeta(s.zeta), tau(s.tau), u(s.u), g(s.g);
    const auto angle = [=] { return evaluation::half_angle_of_heavy_damping(R, zeta); };
    const evaluation::HalfAngle<Symbolic> half = angle();
    const auto functions = [=] {
        return std::pair{paper::first_damping_function(R, zeta), paper::second_damping_function(R, zeta)};
    };
    // The expression of (57) at the time sigma before the end, u and g the functions that they are.
    const auto before_the_end = [=] {
        const auto [u_d, g_i] = functions();
        const Symbolic time(GiNaC::Pi - s.tau);
        return std::vector<ex>{paper::s_d_integrand(time, R, zeta, u_d, g_i).expression()};
    };
    const auto at_the_end = [=] {
        const auto [u_d, g_i] = functions();
        const GiNaC::symbol& time = GiNaC::ex_to<GiNaC::symbol>(s.tau);
        const ex acceleration = paper::friction_motion(tau, R, zeta, u_d, g_i).expression().diff(time, 2);
        return std::vector<ex>{-s.R * s.R * acceleration.subs(s.tau == GiNaC::Pi)};
    };
    return std::vector<Claim>{
        {.id = "evaluation/free-motion",
         .equations = {"A.8", "A.9"},
         .role = Role::shipped,
         .title = "Free motion and its rates from one exponential, sine and cosine",
         .assumptions = in_time,
         .kernel =
             [=] {
                 const evaluation::FreeMotion<Symbolic> f =
                     evaluation::oscillating_free_motion(tau, R, zeta, evaluation::oscillating_w(zeta));
                 return Values{f.d, f.q, f.d_prime, f.q_prime, f.q_double_prime};
             },
         .derived =
             [=, &s] {
                 const ex q_prime = paper::q_prime(tau, R, zeta).expression();
                 return std::vector<ex>{paper::d(tau, R, zeta).expression(), paper::q(tau, R, zeta).expression(),
                                        paper::d_prime(tau, R, zeta).expression(), q_prime,
                                        q_prime.diff(GiNaC::ex_to<GiNaC::symbol>(s.tau))};
             }},
        {.id = "evaluation/one-minus-d",
         .equations = {"A.8"},
         .role = Role::shipped,
         .title = "1 - d from the half angle, and as a sum of positive terms",
         .assumptions = in_time,
         .kernel =
             [=, &s] {
                 const Symbolic x(s.tau / s.R), q(paper::q(tau, R, zeta).expression());
                 const Symbolic w = evaluation::oscillating_w(zeta);
                 return Values{evaluation::one_minus_d_half_angle(x, zeta, w, q),
                               evaluation::one_minus_d_of_positive_terms(x, zeta, w)};
             },
         .derived =
             [=] {
                 const ex difference = 1 - paper::d(tau, R, zeta).expression();
                 return std::vector<ex>{difference, difference};
             }},
        {.id = "evaluation/first-function-by-R-squared",
         .equations = {"28"},
         .role = Role::shipped,
         .title = "The first damping function times R^2 without either factor",
         .assumptions = domain,
         .kernel = [=] { return Values{evaluation::first_damping_function_by_R_squared(R, zeta, half)}; },
         .derived = [=] { return std::vector<ex>{s.R * s.R * paper::first_damping_function(R, zeta).expression()}; }},
        {.id = "evaluation/demand-from-start",
         .equations = {"57"},
         .role = Role::shipped,
         .title = "The expression in (57) as a sum of small terms at the start of the half-period",
         .assumptions = in_time,
         .kernel = [=] { return Values{evaluation::s_d_integrand_from_start(tau, R, zeta, Symbolic(s.u * s.R * s.R), g)}; },
         .derived = [=] { return std::vector<ex>{paper::s_d_integrand(tau, R, zeta, u, g).expression()}; }},
        {.id = "evaluation/demand-from-end",
         .equations = {"57"},
         .role = Role::shipped,
         .title = "The expression in (57) at pi - tau, backwards in time",
         .assumptions = in_time,
         .kernel =
             [=] {
                 const auto [u_d, g_i] = functions();
                 const Symbolic u_R2(u_d.expression() * s.R * s.R);
                 return Values{evaluation::s_d_integrand_from_end(tau, R, zeta, u_R2, g_i)};
             },
         .derived = before_the_end},
        {.id = "evaluation/decay-taken-out",
         .equations = {"28", "29"},
         .role = Role::shipped,
         .title = "1 - g and u R^2 over the decay of the half-period",
         .assumptions = domain,
         .kernel =
             [=] {
                 const evaluation::DecayTakenOut<Symbolic> f = evaluation::decay_taken_out(R, zeta, angle());
                 return Values{f.one_minus_g, f.u_R2};
             },
         .derived =
             [=] {
                 const auto [u_d, g_i] = functions();
                 const ex decay = GiNaC::exp(-GiNaC::Pi * s.zeta / s.R);
                 return std::vector<ex>{(1 - g_i.expression()) / decay, s.R * s.R * u_d.expression() / decay};
             }},
        {.id = "evaluation/demand-after-decay",
         .equations = {"57"},
         .role = Role::shipped,
         .title = "The expression in (57) at pi - tau, backwards in time, the decay taken out",
         .assumptions = in_time,
         .kernel =
             [=] {
                 const evaluation::DecayTakenOut<Symbolic> f = evaluation::decay_taken_out(R, zeta, angle());
                 return Values{evaluation::s_d_integrand_after_decay(tau, R, zeta, f)};
             },
         .derived = before_the_end},
        {.id = "evaluation/demand-at-the-end",
         .equations = {"57", "71"},
         .role = Role::shipped,
         .title = "The limit of the expression in (57) at tau = pi, where the velocity of the braces and sin tau vanish",
         .assumptions = domain,
         .kernel =
             [=] {
                 const auto [u_d, g_i] = functions();
                 const evaluation::DecayTakenOut<Symbolic> f = evaluation::decay_taken_out(R, zeta, angle());
                 return Values{evaluation::s_d_at_pi(R, zeta, u_d, g_i), evaluation::s_d_at_pi_after_decay(R, zeta, f)};
             },
         .derived =
             [=] {
                 const ex limit = at_the_end().front();
                 return std::vector<ex>{limit, limit};
             }},
    };
});

} // namespace

} // namespace denhartog::derivation

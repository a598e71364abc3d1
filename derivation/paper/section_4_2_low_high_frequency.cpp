// Section 4.2: (86), the limit of (69) for r -> infinity, and its limit for r -> 0.
#include <stdexcept>

#include "denhartog/evaluation/mode.hpp"
#include "denhartog/formulas/as_printed.hpp"
#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/high_frequency.hpp"
#include "denhartog/sliding/boundary.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/limit_twins.hpp"
#include "derivation/observations/observed_systems.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::Pi;

namespace {

/// A small quantity x: 1/R_i for high frequency ratios.
const ex& small() {
    static const ex x = new_symbol("x_small", "x", numeric(1, 1000), numeric(1, 10));
    return x;
}

/// Re and Im of R^2 v at R = 1/x.
std::pair<ex, ex> response_at(const ex& x) {
    const Complex<Symbolic> v = paper::complex_response(Symbolic(1 / x), Symbolic(symbols().zeta));
    return {v.re.expression() / (x * x), v.im.expression() / (x * x)};
}

ex limit_of(const ex& e) {
    const LeadingTerm term = leading_term(e, small());
    if (term.power < 0) throw std::logic_error("a limit that is not finite");
    return term.power == 0 ? term.coefficient : ex(0);
}

/// The square of (67) for r -> infinity, j = l. With the mode shapes phi_i = r psi_i each of its sums is the sum of the phi_ji^2
/// times one limit, the same for all modes.
ex derived_squared_limit(int N) {
    const ex x = small(), zeta = symbols().zeta, R = 1 / x;
    const ex v = limit_of(response_at(x).first), u = limit_of(first_function(R, zeta) / (x * x));
    const ex s = limit_of(second_function(R, zeta) + 2 * zeta * R * first_function(R, zeta));
    if (!limit_of(response_at(x).second).is_zero()) throw std::logic_error("the response at high frequencies is not real");
    ex V = 0, U = 0, S = 0;
    for (const Symbolic& psi : symbolic_modes(N).psi_j) {
        const ex square = psi.expression() * psi.expression();
        V += square * v, U += square * u, S += square * (s + symbols().mu);
    }
    return V * V / (U * U + S * S);
}

/// (57)'s expression of a mode at its u and g.
ex s_of_mode(const ex& R, const ex& zeta) {
    return paper::s_d_integrand(Symbolic(symbols().tau), Symbolic(R), Symbolic(zeta), Symbolic(first_function(R, zeta)),
                                Symbolic(second_function(R, zeta)))
        .expression();
}

/// The velocity vanishes at both ends of the half-period, so that the quotient (57) has values there.
void add_ends_of_half_period(Outcome& outcome) {
    const ex tau = symbols().tau;
    const ex numerator = s_of_mode(symbols().R, symbols().zeta) * GiNaC::sin(tau);
    add_statement(outcome, decide_zero_and_twin(numerator.subs(tau == 0)), "The numerator of (57) is zero at tau = 0", "");
    add_statement(outcome, decide_zero_and_twin(numerator.subs(tau == Pi)), "and at tau = pi", "");
}

/// (57) for R -> infinity, and that it falls from 1 to -1 over the half-period: static friction binds, (69) is (67).
Outcome velocity_at_high_frequency() {
    const ex x = small(), zeta = symbols().zeta, tau = symbols().tau;
    const GiNaC::symbol& t = GiNaC::ex_to<GiNaC::symbol>(tau);
    const ex numerator = tau - Pi / 2 * (1 - GiNaC::cos(tau));
    Outcome outcome;
    add_ends_of_half_period(outcome);
    add_argument(outcome, "The quotient is analytic in tau from 0 to pi and in x = 1/R_i next to 0: its limit is uniform", "");
    add_statement(outcome, decide_term_and_twins(s_of_mode(1 / x, zeta), x, {numerator / GiNaC::sin(tau), 0}),
                  "(57) for R_i = 1/x, x -> 0",
                  "s_i(\\tau) \\to f(\\tau) = \\frac{\\tau-\\frac{\\pi}{2}(1-\\cos\\tau)}{\\sin\\tau}");
    const ex slope = GiNaC::sin(tau) - tau * GiNaC::cos(tau) - Pi / 2 * (1 - GiNaC::cos(tau));
    const ex from_rates = numerator.diff(t) * GiNaC::sin(tau) - numerator * GiNaC::cos(tau);
    add_statement(outcome, decide_zero_and_twin(from_rates - slope), "Its slope",
                  "f'\\sin^2\\tau = h(\\tau) = \\sin\\tau-\\tau\\cos\\tau-\\frac{\\pi}{2}(1-\\cos\\tau)");
    add_statement(outcome, decide_zero_and_twin(slope.subs(tau == 0)), "h starts at zero", "h(0) = 0");
    add_statement(outcome, decide_zero_and_twin(slope.subs(tau == Pi)), "and ends at zero", "h(\\pi) = 0");
    add_statement(outcome, decide_zero_and_twin(slope.diff(t) - (tau - Pi / 2) * GiNaC::sin(tau)),
                  "and falls to pi/2 and rises after it, so that it is negative between",
                  "h' = \\left(\\tau-\\frac{\\pi}{2}\\right)\\sin\\tau");
    add_argument(outcome,
                 "f falls from its limit 1 at tau = 0: the largest sum over the modes tends to the sum of squares, "
                 "which is at most mu times that sum, what static friction asks",
                 "S_{dj} \\to \\sum_i\\psi_{ji}^2 \\le \\mu\\sum_i\\psi_{ji}^2");
    return outcome;
}

/// Rates at which V_dj over the sum of psi_ji^2, and (69) with it, falls where j is not l.
Outcome rates_off_the_contact() {
    const ex x = small(), zeta = symbols().zeta;
    const auto [re, im] = response_at(x);
    Outcome outcome;
    add_statement(outcome, decide_term_and_twins(re, x, {-1, 0}),
                  "R_i^2 v_di has one limit for all modes, and by (17) the sum of psi_ji psi_li is zero",
                  "V_{dj}/\\textstyle\\sum_i\\psi_{ji}^2 \\to 0");
    add_statement(outcome, decide_term_and_twins(im, x, {-2 * zeta, 1}),
                  "Next is a term of first order in 1/R_i = r_n,i / r: an element of the damping matrix, as a rule not zero",
                  "\\beta_{\\lim} \\sim \\frac{4}{\\sqrt{4\\mu^2+\\pi^2}}\\frac{|\\sum_i\\phi_{ji}\\phi_{li}\\zeta_ir_{n,i}|}"
                  "{\\sum_i\\phi_{ji}^2}\\,\\frac{1}{r}");
    add_statement(outcome, decide_term_and_twins(re + 1, x, {4 * zeta * zeta - 1, 2}),
                  "Where zeta_i r_n,i is the same for all modes, as in Fig. 10, that sum is zero as well; next is stiffness", "");
    const ex undamped = re.subs(zeta == 0);
    add_statement(outcome, decide_zero_and_twin(undamped + 1 / (1 - x * x)),
                  "Without damping only even powers: the n-th is an element of the n-th power of stiffness over mass, which "
                  "in a chain is zero for n below |j - l|",
                  "R_i^2v_i = -\\sum_n R_i^{-2n}, \\qquad \\beta_{\\lim} \\propto r^{-2|j-l|}");
    for (const ObservedSystem& s : systems_of_the_paper()) {
        if (s.system.contact == s.system.load || s.zeta != 0.1) continue;
        std::string line = s.name + ": (69) at r = 100, 1000, 10000:";
        for (const double r : {100.0, 1000.0, 10000.0}) line += " " + rounded(boundary(sums_at(s, r), 1.0).exact);
        outcome.steps.push_back({line, ""});
    }
    return outcome;
}

/// Powers of stiffness over mass of a chain of four, with symbols for springs and masses.
Outcome powers_of_chain() {
    constexpr int N = 4;
    GiNaC::matrix A(N, N);
    std::vector<ex> k, m;
    for (int i = 1; i <= N; ++i) {
        k.push_back(new_symbol("kappa" + std::to_string(i), "\\kappa_" + std::to_string(i), numeric(1, 5), 2));
        m.push_back(new_symbol("gamma" + std::to_string(i), "\\gamma_" + std::to_string(i), numeric(1, 5), 2));
    }
    for (int i = 0; i < N; ++i) {
        A(i, i) = (k[i] + (i + 1 < N ? k[i + 1] : ex(0))) / m[i];
        if (i > 0) A(i, i - 1) = -k[i] / m[i];
        if (i + 1 < N) A(i, i + 1) = -k[i + 1] / m[i];
    }
    Outcome outcome;
    GiNaC::matrix power = A;
    for (int n = 1; n < N; ++n, power = power.mul(A))
        for (int d = n; d < N; ++d) {
            const ex entry = power(0, d).normal();
            ex product = 1;
            for (int i = 0; i < d; ++i) product *= -k[i + 1] / m[i];
            const Verdict verdict = decide_zero_and_twin(d == n ? ex(entry - product) : entry);
            const std::string name = "Element (1, " + std::to_string(d + 1) + ") of the power " + std::to_string(n);
            const std::string what = d == n ? " is the product of the springs between over the masses" : " is zero";
            add_statement(outcome, verdict, name + what, "");
        }
    return outcome;
}

/// (67) for r -> 0 with damping: E = exp(-pi zeta / R) is smaller than every power of r.
Outcome damped_at_low_frequency() {
    const Symbols& s = symbols();
    const ex r = small(), zeta = s.zeta, mu = s.mu;
    const ex E = new_symbol("E_low", "E", numeric(1, 1000), numeric(1, 10));
    const ex c = new_symbol("c_low", "c", numeric(1, 10), numeric(9, 10));
    const ex sc = c * GiNaC::sqrt(1 - c * c), w = s.w, denominator = GiNaC::pow(1 - E, 2) + 4 * E * c * c;
    Outcome outcome;
    add_claim(outcome, "evaluation/half-angle", "u and g in E, the sine and the cosine of the half angle");
    add_statement(outcome, decide_term_and_twins(4 * E * sc / (w * denominator), E, {4 * sc / w, 1}),
                  "R u is of the order of E = exp(-pi zeta / R)", "R_iu_{di} = O(E)");
    add_statement(outcome, decide_term_and_twins(((1 - E * E) - 4 * E * zeta / w * sc) / denominator, E, {1, 0}),
                  "and g is 1 but for such a term", "g_i = 1 + O(E)");
    const ex limit = squared_response(r, zeta) / GiNaC::pow((1 + mu) / (r * r), 2);
    add_statement(outcome, decide_term_and_twins(limit, r, {1 / GiNaC::pow(1 + mu, 2), 4}),
                  "(67) of a single mass with u = 0, g = 1", "\\beta_{\\lim} \\sim \\frac{r^2}{1+\\mu}");
    const ex V = new_symbol("V_static", "V", numeric(1, 5), 2), gamma = new_symbol("gamma_low", "\\gamma_j", numeric(1, 5), 2);
    const Symbolic squares(1 / (gamma * r * r)), none(ex(0)); // H_j where every g_i is 1 is the sum (65)
    const Symbolic of_67 = paper::friction_ratio_limit(Complex<Symbolic>{Symbolic(V), none}, none,
                                                       paper::static_friction_demand(squares, Symbolic(mu), squares));
    const Symbolic shipped =
        paper::friction_ratio_limit_at_low_frequency(Symbolic(V), Symbolic(gamma), Symbolic(r), Symbolic(mu));
    add_statement(outcome, decide_zero_and_twin((square(shipped) - square(of_67)).expression()),
                  "(67) with U_dj = 0 and H_j the sum (65); |V_dj| tends to the displacement under a static load",
                  "\\beta_{\\lim} \\sim \\frac{\\gamma_jr^2}{1+\\mu}|V_{dj}|_{r=0}");
    const ObservedSystem single = systems_of_the_paper(0.1).front();
    std::string line = "Single mass, zeta = 0.1, mu = 1: (69) over r^2 at r = 0.1, 0.05, 0.02:";
    for (const double at : {0.1, 0.05, 0.02}) line += " " + rounded(boundary(sums_at(single, at), 1.0).exact / (at * at));
    outcome.steps.push_back({line, ""});
    return outcome;
}

/// With damping the largest sum over the modes tends to what (67) asks for mu = 1: for r -> 0 (69) is (67).
Outcome velocity_at_low_frequency() {
    const ex tau = symbols().tau, R = symbols().R, zeta = symbols().zeta, w = symbols().w, angle = w * tau / R;
    const GiNaC::symbol& t = GiNaC::ex_to<GiNaC::symbol>(tau);
    const Symbolic at(tau), of_R(R), of_zeta(zeta);
    const ex R_q = R * paper::q(at, of_R, of_zeta).expression(), R_q_prime = R * paper::q_prime(at, of_R, of_zeta).expression();
    const ex u = first_function(R, zeta), g = second_function(R, zeta), s = s_of_mode(R, zeta);
    Outcome outcome;
    add_claim(outcome, "69/low-frequency/damped", "R u and g - 1 are of the order of E = exp(-pi zeta / R)");
    add_statement(outcome,
                  decide_zero_and_twin(s * GiNaC::sin(tau) - (2 + g - 1) * R_q + u * R * R * (R_q_prime - GiNaC::cos(tau))),
                  "(57) with 1 + g = 2 + O(E)", "s_i\\sin\\tau = 2R_iq_i+(g_i-1)R_iq_i-u_{di}R_i^2(R_iq_i'-\\cos\\tau)");
    const ex rate =
        -GiNaC::exp(-zeta * tau / R) * (2 * zeta * GiNaC::cos(angle) + (1 - 2 * zeta * zeta) / w * GiNaC::sin(angle)) / R;
    add_statement(
        outcome, decide_zero_and_twin(R_q_prime.diff(t) - rate),
        "R q is at most tau exp(-zeta tau / R); R q' is 1 at tau = 0 and its rate at most (2 zeta + 1/w) / R: up to pi/2 "
        "the terms with g - 1 and u are of the order of E",
        "R_iq_i'' = -\\frac{e^{-\\zeta_i\\tau/R_i}}{R_i}\\left(2\\zeta_i\\cos\\frac{w\\tau}{R_i}+"
        "\\frac{1-2\\zeta_i^2}{w}\\sin\\frac{w\\tau}{R_i}\\right)");
    const ex quotient = tau / GiNaC::sin(tau), slope = 1 / tau - GiNaC::cos(tau) / GiNaC::sin(tau);
    add_statement(outcome, decide_zero_and_twin(quotient.diff(t) / quotient - slope), "The slope of log(tau / sin(tau))",
                  "\\frac{1}{\\tau}-\\cot\\tau");
    add_statement(outcome, decide_zero_and_twin(slope.diff(t) - 1 / GiNaC::pow(GiNaC::sin(tau), 2) + 1 / (tau * tau)),
                  "grows, as its rate is positive", "\\frac{1}{\\sin^2\\tau}-\\frac{1}{\\tau^2}");
    add_statement(
        outcome, decide_zero_and_twin(slope.subs(tau == Pi / 2) - 2 / Pi),
        "up to 2/pi at pi/2: for R at most pi zeta / 2 the first term is at most 2 there, its value for tau -> 0",
        "\\frac{2R_iq_i}{\\sin\\tau} \\le 2\\exp\\left[\\left(\\frac{2}{\\pi}-\\frac{\\zeta_i}{R_i}\\right)\\tau\\right]");
    add_ends_of_half_period(outcome);
    add_argument(outcome,
                 "From pi/2 on the numerator has a slope of the order of sqrt(E), and sin(tau) is at least "
                 "2 (pi - tau) / pi: s is of that order there",
                 "");
    add_argument(outcome,
                 "The largest sum over the modes is the sum of 2 psi_ji^2 but for terms of the order of the E_i, what (67) asks "
                 "for mu = 1",
                 "S_{dj} = 2\\sum_i\\psi_{ji}^2+O(E) \\le (1+\\mu)\\sum_i\\psi_{ji}^2+O(E)");
    for (const ObservedSystem& of : systems_of_the_paper(0.1)) {
        std::string line = of.name + ": S_dj over the sum of squares at r = 0.1, 0.05, 0.02:";
        for (const double r : {0.1, 0.05, 0.02}) {
            const ModeSums<double> m = sums_at(of, r);
            line += " " + rounded(boundary(m, 1.0).S_exact / m.sum_of_squares);
        }
        outcome.steps.push_back({line, ""});
    }
    return outcome;
}

/// (67) for r -> 0 without damping: of second order, too, but over r^2 it has no limit.
Outcome undamped_at_low_frequency() {
    const ex r = symbols().r;
    const ex half = Pi / (2 * r), tangent = GiNaC::sin(half) / GiNaC::cos(half);
    const ex shown = GiNaC::pow(r, 4) / (GiNaC::pow(1 - r * r, 2) * (1 + r * r * tangent * tangent));
    Outcome outcome;
    add_statement(outcome, decide_zero_and_twin(squared_limit_of_single_mass(r, 0) - shown), "(67) of a single mass, mu = 1",
                  "\\beta_{\\lim} = \\frac{r^2}{(1-r^2)\\sqrt{1+r^2\\tan^2\\frac{\\pi}{2r}}}");
    add_argument(outcome,
                 "Along r = 1/(2n) the tangent is zero and the boundary over r^2 tends to 1; at r = 1/(2n+1) it "
                 "has a pole and the boundary is zero: over r^2 it has no limit for r -> 0",
                 "\\limsup\\frac{\\beta_{\\lim}}{r^2} = 1, \\qquad \\liminf\\frac{\\beta_{\\lim}}{r^2} = 0");
    return outcome;
}

const Register claims_of_section_4_2_low_high_frequency([] {
    const Symbolic mu(symbols().mu);
    std::vector<Claim> list{
        {.id = "86/printed",
         .equations = {"86"},
         .role = Role::printed,
         .title = "Square of the limit for j = l with 4 mu",
         .assumptions = {"r -> infinity", "j = l"},
         .kernel = [mu] { return Values{square(as_printed::friction_ratio_limit_at_high_frequency(mu))}; },
         .derived = [] { return std::vector<ex>{derived_squared_limit(1)}; },
         .departure = Departure::misprint,
         .correction = "\\beta_\\infty = \\begin{cases}\\frac{2}{\\sqrt{4\\mu^2+\\pi^2}}&\\text{if }j=l\\\\"
                       "0&\\text{if }j\\ne l\\end{cases}"},
        {.id = "86/velocity",
         .equations = {"86", "69"},
         .role = Role::step,
         .title = "For r -> infinity the condition on the velocity is never stricter than that of static friction",
         .assumptions = {"mu >= 1"},
         .check = velocity_at_high_frequency},
        {.id = "86/rates",
         .equations = {"86"},
         .role = Role::step,
         .title = "If j is not l, the limit is zero; the boundary falls like 1/r, without damping like r^(-2|j - l|)",
         .assumptions = {"r -> infinity", "j not l", "the rate without damping: a chain"},
         .check = rates_off_the_contact},
        {.id = "86/powers-of-chain",
         .equations = {"86"},
         .role = Role::step,
         .title = "In a chain the element (1, 1 + d) of a power n of stiffness over mass is zero for n < d and not for n = d",
         .assumptions = {"N = 4"},
         .check = powers_of_chain},
        {.id = "69/low-frequency/damped",
         .equations = {"69", "67"},
         .role = Role::step,
         .title = "For r -> 0 with damping (67) falls like the formula for low frequency ratios, gamma_j r^2 |V_dj| / (1 + mu)",
         .assumptions = {"zeta_i > 0"},
         .check = damped_at_low_frequency},
        {.id = "69/low-frequency/velocity",
         .equations = {"69", "57"},
         .role = Role::step,
         .title =
             "For r -> 0 with damping the condition on the velocity is never stricter than (67), but for exp(-pi zeta_i / R_i)",
         .assumptions = {"zeta_i > 0", "mu >= 1"},
         .check = velocity_at_low_frequency},
        {.id = "69/low-frequency/undamped",
         .equations = {"69", "67"},
         .role = Role::step,
         .title = "For r -> 0 without damping (67) is of the order of r^2 and has no limit over r^2",
         .assumptions = {"zeta = 0", "single mass", "mu = 1"},
         .check = undamped_at_low_frequency},
    };
    for (int N = 1; N <= 3; ++N)
        list.push_back({.id = "86/limit/N=" + std::to_string(N),
                        .equations = {"86"},
                        .role = Role::shipped,
                        .title = "Square of the limit of (67) for j = l",
                        .assumptions = {"r -> infinity", "j = l", "N = " + std::to_string(N) + " modes"},
                        .kernel = [mu] { return Values{square(paper::friction_ratio_limit_at_high_frequency(mu))}; },
                        .derived = [N] { return std::vector<ex>{derived_squared_limit(N)}; },
                        .refines = {"23", "28", "29"},
                        .steps = {{"For R_i -> infinity the parts of each mode have one limit",
                                   "R_i^2v_{di} \\to -1, \\quad R_i^2u_{di} \\to \\frac{\\pi}{2}, \\quad "
                                   "g_i+2\\zeta_iR_iu_{di} \\to 0"}}});
    return list;
});

} // namespace
} // namespace denhartog::derivation

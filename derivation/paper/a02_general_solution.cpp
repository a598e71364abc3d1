// (A.1), (A.2): the general solution of the equation of a modal coordinate.
//
// Equation (20) is linear with constant coefficients. Its solution is the sum of a free motion, a constant and a harmonic
// motion; each is found here from an ansatz by comparing coefficients.
#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/provenance.hpp"
#include "derivation/paper/derived.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::lst;

namespace {

/// Left side of (20) for a motion eta(tau).
ex left_side(const ex& eta) {
    const Symbols& s = symbols();
    return from_premise() * eta.diff(GiNaC::ex_to<GiNaC::symbol>(s.tau), 2) +
           2 * s.zeta / s.R * eta.diff(GiNaC::ex_to<GiNaC::symbol>(s.tau)) + eta / (s.R * s.R);
}

/// Decay rate and frequency of the free motion: e^(sigma tau) cos(nu tau) and sin(nu tau) both solve the homogeneous equation.
std::pair<ex, ex> derived_rates() {
    const Symbols& s = symbols();
    const GiNaC::symbol sigma("sigma"), nu("nu"), nu_squared("nu_squared");
    const ex ansatz = GiNaC::exp(sigma * s.tau) * GiNaC::cos(nu * s.tau);
    const ex residual = (left_side(ansatz) / GiNaC::exp(sigma * s.tau)).expand();
    const ex from_sine = residual.coeff(GiNaC::sin(nu * s.tau)) / nu;
    const ex decay = GiNaC::lsolve(from_sine.normal() == 0, sigma);
    const ex from_cosine = residual.coeff(GiNaC::cos(nu * s.tau)).subs(sigma == decay).expand().subs(nu * nu == nu_squared);
    // nu^2 R^2 has no R any more; R is positive
    const ex without_R = (GiNaC::lsolve(from_cosine == 0, nu_squared) * s.R * s.R).normal().expand();
    return {decay, GiNaC::sqrt(without_R) / s.R};
}

/// Factors of cos(tau) and sin(tau) in the answer to the load C cos(tau) + S sin(tau).
std::pair<ex, ex> derived_harmonic(const ex& C, const ex& S) {
    const Symbols& s = symbols();
    const GiNaC::symbol a("a"), b("b");
    const ex residual = left_side(a * GiNaC::cos(s.tau) + b * GiNaC::sin(s.tau)).expand();
    const ex solution =
        GiNaC::lsolve(lst{residual.coeff(GiNaC::cos(s.tau)) == C, residual.coeff(GiNaC::sin(s.tau)) == S}, lst{a, b});
    return {ex(a).subs(solution), ex(b).subs(solution)};
}

} // namespace

std::pair<ex, ex> derived_complex_response() {
    // the answer to cos(tau) is R^2 Re{v exp(i tau)} = R^2 (Re v cos(tau) - Im v sin(tau))
    const Symbols& s = symbols();
    const auto [a, b] = derived_harmonic(1, 0);
    return {(a / (s.R * s.R)).normal(), (-b / (s.R * s.R)).normal()};
}

ex derived_general_solution() {
    const Symbols& s = symbols();
    const auto [decay, frequency] = derived_rates();
    const GiNaC::symbol constant("constant");
    const ex static_part = GiNaC::lsolve(left_side(constant) == s.psi_ji * s.beta, constant);
    // the load psi_li cos(tau + phi_j) by its addition theorem
    const auto [a, b] = derived_harmonic(s.psi_li * s.c_phi, -s.psi_li * s.s_phi);
    return GiNaC::exp(decay * s.tau) * (s.A * GiNaC::cos(frequency * s.tau) + s.B * GiNaC::sin(frequency * s.tau)) + static_part +
           a * GiNaC::cos(s.tau) + b * GiNaC::sin(s.tau);
}

namespace {

std::vector<Step> steps_of_general_solution() {
    const Symbols& s = symbols();
    const auto [decay, frequency] = derived_rates();
    const auto [a, b] = derived_harmonic(s.psi_li * s.c_phi, -s.psi_li * s.s_phi);
    return {
        {"The equation of the modal coordinate, (20)", "\\eta_i'' + \\frac{2\\zeta_i}{R_i}\\eta_i' + \\frac{1}{R_i^2}\\eta_i = "
                                                       "\\psi_{ji}\\beta + \\psi_{li}\\cos(\\tau+\\phi_j)"},
        step("Without the right side, $e^{\\sigma\\tau}\\cos(\\nu\\tau)$ and $e^{\\sigma\\tau}\\sin(\\nu\\tau)$ solve it; the "
             "coefficient of the sine must vanish, which gives",
             "\\sigma", decay),
        step("and the coefficient of the cosine gives", "\\nu", frequency),
        {"A constant $c$ solves it with the friction alone on the right", "c = \\psi_{ji}R_i^2\\beta"},
        step("$a\\cos\\tau + b\\sin\\tau$ solves it with the load alone; comparing coefficients of the cosine", "a", a),
        step("and of the sine", "b", b),
        step("The sum of the three parts is the general solution", "\\eta_i", derived_general_solution())};
}

std::vector<Step> steps_of_complex_response() {
    const auto [re, im] = derived_complex_response();
    return {{"The answer to the load $\\cos\\tau$ is $R_i^2\\mathrm{Re}\\{v_{di}e^{i\\tau}\\}$",
             "R_i^2(\\mathrm{Re}v_{di}\\cos\\tau - \\mathrm{Im}v_{di}\\sin\\tau)"},
            step("Its cosine has the factor $R_i^2$ times", "\\mathrm{Re}v_{di}", re),
            step("its sine the factor $-R_i^2$ times", "\\mathrm{Im}v_{di}", im)};
}

} // namespace

ex in_phi_j(const ex& e) {
    const Symbols& s = symbols();
    return e.subs(lst{s.c_phi == GiNaC::cos(s.phi_j), s.s_phi == GiNaC::sin(s.phi_j)});
}

namespace {

const Register claims_of_a02_general_solution([] {
    const Symbols& s = symbols();
    const std::vector<std::string> domain{"R_i > 0", "0 <= zeta_i < 1", "0 <= tau <= pi"};
    return std::vector<Claim>{
        {.id = "A.2/solves-A.1",
         .equations = {"20", "A.1"},
         .title = "The derived general solution satisfies the equation of the modal coordinate for every A and B",
         .assumptions = domain,
         .kernel =
             [&s] {
                 const GiNaC::symbol& tau = GiNaC::ex_to<GiNaC::symbol>(s.tau);
                 const ex eta = in_phi_j(derived_general_solution());
                 return Values{paper::modal_equation_residual(Symbolic(eta), Symbolic(eta.diff(tau)), Symbolic(eta.diff(tau, 2)),
                                                              Symbolic(s.tau), symbolic_mode(), Symbolic(s.beta),
                                                              Symbolic(s.phi_j))};
             },
         .derived = [] { return std::vector<ex>{0}; },
         .steps = {{"The derived general solution is put into (A.1); what is left over has to vanish for every $A_i$ and $B_i$",
                    ""},
                   step("The solution", "\\eta_i", derived_general_solution())}},
        {.id = "A.2/general-solution",
         .equations = {"21", "A.2"},
         .title = "General solution of the modal equation, with v cos(tau + phi_j) read as Re{v exp(i(tau + phi_j))}",
         .assumptions = domain,
         .kernel =
             [&s] {
                 return Values{paper::general_solution(Symbolic(s.tau), symbolic_mode(),
                                                       IntegrationConstants<Symbolic>{Symbolic(s.A), Symbolic(s.B)},
                                                       Symbolic(s.beta), Symbolic(s.phi_j))};
             },
         .derived = [] { return std::vector<ex>{in_phi_j(derived_general_solution())}; },
         .departure = Departure::convention,
         .steps = steps_of_general_solution()},
        {.id = "23/complex-response",
         .equations = {"23"},
         .title = "Complex response function of a mode from the harmonic part of the general solution",
         .assumptions = {"R_i > 0", "0 <= zeta_i < 1", "zeta_i > 0 or R_i not 1"},
         .kernel =
             [&s] {
                 const Complex<Symbolic> v = paper::complex_response(Symbolic(s.R), Symbolic(s.zeta));
                 return Values{v.re, v.im};
             },
         .derived =
             [] {
                 const auto [re, im] = derived_complex_response();
                 return std::vector<ex>{re, im};
             },
         .steps = steps_of_complex_response()},
    };
});

} // namespace
} // namespace denhartog::derivation

// (A.12)-(A.14), (26)-(29): the phase, and the two damping functions.
#include <stdexcept>

#include "denhartog/formulas/as_printed.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/algebra/zero_test.hpp"
#include "derivation/claims/provenance.hpp"
#include "derivation/paper/derived.hpp"
#include "derivation/typeset/latex.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::lst;

std::pair<ex, ex> derived_phase() {
    const Symbols& s = symbols();
    const auto [displacement, velocity] = derived_final_conditions();
    const ex solution = GiNaC::lsolve(lst{displacement.expand() == 0, velocity.expand() == 0}, lst{s.v_cos, s.v_sin});
    return {s.v_cos.subs(solution), s.v_sin.subs(solution)};
}

namespace {

/// The part of friction alone in v cos(phi_j) or v sin(phi_j), over psi_ji beta / psi_li.
ex friction_part(const ex& v_times) {
    const Symbols& s = symbols();
    return v_times.subs(lst{s.eta_0 == 0, s.eta_prime_0 == 0}) * s.psi_li / (s.psi_ji * s.beta);
}

} // namespace

std::pair<ex, ex> derived_phase_by_functions() {
    // (A.13) and (A.14), from (25): the claims A.13/cosine and A.14/sine prove that `derived_phase` is this for the u and g below
    const Symbols& s = symbols();
    const ex unit = from_premise() * s.psi_li * s.R * s.R, friction = s.psi_ji * s.R * s.R * s.beta;
    return {(s.eta_0 + friction * s.g) / unit, -(s.eta_prime_0 + friction * s.u) / unit};
}

namespace {

/// The determinant of the two conditions, as they come and in closed form. The closed form is decided by the zero test here.
std::pair<ex, ex> determinant_of_conditions() {
    const Symbols& s = symbols();
    const auto [displacement, velocity] = derived_final_conditions();
    const ex first = displacement.expand(), second = velocity.expand();
    const ex found = first.coeff(s.v_cos) * second.coeff(s.v_sin) - first.coeff(s.v_sin) * second.coeff(s.v_cos);
    const ex delta = GiNaC::Pi * s.zeta / s.R, theta = GiNaC::Pi * GiNaC::sqrt(1 - s.zeta * s.zeta) / s.R;
    const ex closed =
        -2 * GiNaC::pow(s.psi_li, 2) * GiNaC::pow(s.R, 4) * GiNaC::exp(-delta) * (GiNaC::cosh(delta) + GiNaC::cos(theta));
    if (!remainder(found - closed, domain_of({found, closed})).is_zero())
        throw std::logic_error("the determinant of (A.10) is not the closed form that the steps show");
    return {found, closed};
}

/// The solution of the two conditions, before other steps: their determinant is the divisor of both damping functions.
std::vector<Step> after_elimination(const std::vector<Step>& more) {
    const auto [found, closed] = determinant_of_conditions();
    std::vector<Step> steps{
        {"The two conditions (A.10) have the determinant", "\\mathcal{AQ}-\\mathcal{BP} = " + latex_line(found)},
        {"With $\\cos^2+\\sin^2=1$ it is", "\\mathcal{AQ}-\\mathcal{BP} = " + latex_line(closed)},
        {"so that $\\cosh+\\cos$ stands under whatever (A.12) gives; it is not zero on the domain", ""}};
    steps.insert(steps.end(), more.begin(), more.end());
    return steps;
}

} // namespace

ex derived_first_damping_function() { return -friction_part(derived_phase().second); }

ex derived_second_damping_function() { return friction_part(derived_phase().first); }

namespace {

const Register claims_of_a12_phase([] {
    const Symbols& s = symbols();
    const std::vector<std::string> domain{"R_i > 0", "0 <= zeta_i < 1", "psi_li not zero",
                                          "zeta_i > 0 or 1/R_i not an odd integer"};
    const std::vector<std::string> mode_domain{"R_i > 0", "0 <= zeta_i < 1", "zeta_i > 0 or 1/R_i not an odd integer"};
    const auto system = [&s] {
        return PhaseSystem<Symbolic>{Symbolic(s.PA), Symbolic(s.PB), Symbolic(s.PC),
                                     Symbolic(s.PP), Symbolic(s.PQ), Symbolic(s.PR)};
    };
    const auto solved = [&s, system] {
        const Symbolic v_cos(s.v_cos), v_sin(s.v_sin);
        const ex displacement = paper::final_displacement_residual(system(), v_cos, v_sin).expression();
        const ex velocity = paper::final_velocity_residual(system(), v_cos, v_sin).expression();
        const ex solution = GiNaC::lsolve(lst{displacement == 0, velocity == 0}, lst{s.v_cos, s.v_sin});
        return std::vector<ex>{s.v_cos.subs(solution), s.v_sin.subs(solution)};
    };
    return std::vector<Claim>{
        {.id = "A.12/printed",
         .equations = {"A.12"},
         .role = Role::printed,
         .title = "The cosine with the natural frequency where the text at hand shows it",
         .assumptions = {"AQ - BP not zero"},
         .kernel = [system, &s] { return Values{as_printed::v_cosine_from_system(system(), Symbolic(1 / s.R))}; },
         .derived = [solved] { return std::vector<ex>{solved().front()}; },
         .departure = Departure::scan,
         .correction = "[v_{di}\\cos\\phi_j] = \\frac{\\mathcal{BR}-\\mathcal{CQ}}{\\mathcal{AQ}-\\mathcal{BP}}, \\quad "
                       "[v_{di}\\sin\\phi_j] = \\frac{\\mathcal{CP}-\\mathcal{AR}}{\\mathcal{AQ}-\\mathcal{BP}}"},
        {.id = "A.12/solution",
         .equations = {"A.12"},
         .role = Role::shipped,
         .title = "Solution of the two conditions for v cos(phi_j) and v sin(phi_j)",
         .assumptions = {"AQ - BP not zero"},
         .kernel =
             [system] {
                 return Values{paper::v_cosine_from_system(system()), paper::v_sine_from_system(system())};
             },
         .derived = solved,
         .refines = {"A.10"},
         .steps =
             {{"Two linear equations (A.10) with the coefficients (A.11), $v_{di}$ taken out of $\\mathcal{A}$, $\\mathcal{B}$, "
               "$\\mathcal{P}$ and $\\mathcal{Q}$; the unknowns by elimination",
               "\\mathcal{A}[v_{di}\\cos\\phi_j]+\\mathcal{B}[v_{di}\\sin\\phi_j]+\\mathcal{C}=0,\\quad "
               "\\mathcal{P}[v_{di}\\cos\\phi_j]+\\mathcal{Q}[v_{di}\\sin\\phi_j]+\\mathcal{R}=0"},
              step("The cosine", "[v_{di}\\cos\\phi_j]", solved().front()),
              step("The sine", "[v_{di}\\sin\\phi_j]", solved().back())}},
        {.id = "28/first-damping-function",
         .equations = {"28"},
         .title = "First damping function from the conditions at tau = pi",
         .assumptions = mode_domain,
         .kernel = [&s] { return Values{paper::first_damping_function(Symbolic(s.R), Symbolic(s.zeta))}; },
         .derived = [] { return std::vector<ex>{derived_first_damping_function()}; },
         .steps = after_elimination(
             {step("The part of $-[v_{di}\\sin\\phi_j]$ that friction makes, over $\\psi_{ji}\\beta/\\psi_{li}$", "u_{di}",
                   derived_first_damping_function())})},
        {.id = "29/second-damping-function",
         .equations = {"29"},
         .title = "Second damping function from the conditions at tau = pi",
         .assumptions = mode_domain,
         .kernel = [&s] { return Values{paper::second_damping_function(Symbolic(s.R), Symbolic(s.zeta))}; },
         .derived = [] { return std::vector<ex>{derived_second_damping_function()}; },
         .steps =
             after_elimination({step("The part of $[v_{di}\\cos\\phi_j]$ that friction makes, over $\\psi_{ji}\\beta/\\psi_{li}$",
                                     "g_i", derived_second_damping_function())})},
        {.id = "28/undamped",
         .equations = {"28", "29"},
         .role = Role::step,
         .title = "Without damping u is sin(pi/R) / (R (1 + cos(pi/R))) and g is zero",
         .assumptions = {"R_i > 0", "zeta_i = 0", "1/R_i not an odd integer"},
         .kernel =
             [&s] {
                 const Symbolic R(s.R);
                 return Values{paper::first_damping_function(R, Symbolic(0)), paper::second_damping_function(R, Symbolic(0))};
             },
         .derived =
             [&s] {
                 return std::vector<ex>{GiNaC::sin(GiNaC::Pi / s.R) / (s.R * (1 + GiNaC::cos(GiNaC::Pi / s.R))), 0};
             },
         .special_case = true},
        {.id = "A.13/cosine",
         .equations = {"26", "A.13"},
         .title = "v cos(phi_j) from the initial displacement: the initial velocity cancels",
         .assumptions = domain,
         .kernel =
             [&s] {
                 return Values{paper::v_cosine(symbolic_mode(), symbolic_start(),
                                               paper::second_damping_function(Symbolic(s.R), Symbolic(s.zeta)),
                                               Symbolic(s.beta))};
             },
         .derived = [] { return std::vector<ex>{derived_phase().first}; },
         .departure = Departure::convention,
         .steps = after_elimination({step("The cosine by (A.12)", "[v_{di}\\cos\\phi_j]", derived_phase().first),
                                     {"The initial velocity drops out, and friction has the factor $g_i$ of (29)", ""}})},
        {.id = "A.14/sine",
         .equations = {"27", "A.14"},
         .title = "v sin(phi_j) from the initial velocity: the initial displacement cancels",
         .assumptions = domain,
         .kernel =
             [&s] {
                 return Values{paper::v_sine(symbolic_mode(), symbolic_start(),
                                             paper::first_damping_function(Symbolic(s.R), Symbolic(s.zeta)), Symbolic(s.beta))};
             },
         .derived = [] { return std::vector<ex>{derived_phase().second}; },
         .departure = Departure::convention,
         .steps = after_elimination({step("The sine by (A.12)", "[v_{di}\\sin\\phi_j]", derived_phase().second),
                                     {"The initial displacement drops out, and friction has the factor $-u_{di}$ of (28)", ""}})},
    };
});

} // namespace
} // namespace denhartog::derivation

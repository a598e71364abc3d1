// (A.4), (A.10), (A.11): the conditions at the end of the half-period are linear in v cos(phi_j) and v sin(phi_j).
#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/provenance.hpp"
#include "derivation/paper/derived.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::lst;

std::pair<ex, ex> derived_final_conditions() {
    const Symbols& s = symbols();
    const ex eta = derived_displacement_by_v();
    const ex velocity = eta.diff(GiNaC::ex_to<GiNaC::symbol>(s.tau)), by_25 = from_premise();
    return {eta.subs(s.tau == GiNaC::Pi) + by_25 * s.eta_0, velocity.subs(s.tau == GiNaC::Pi) + by_25 * s.eta_prime_0};
}

namespace {

const Register claims_of_a10_final_conditions([] {
    const Symbols& s = symbols();
    const std::vector<std::string> domain{"R_i > 0", "0 <= zeta_i < 1", "the motion is symmetric, (25)"};
    return std::vector<Claim>{
        {.id = "A.10/conditions",
         .equations = {"A.10"},
         .title = "The conditions at tau = pi as linear equations for v cos(phi_j) and v sin(phi_j)",
         .assumptions = domain,
         .kernel =
             [&s] {
                 const PhaseSystem<Symbolic> p = paper::phase_system(symbolic_mode(), symbolic_start(), Symbolic(s.beta));
                 return Values{paper::final_displacement_residual(p, Symbolic(s.v_cos), Symbolic(s.v_sin)),
                               paper::final_velocity_residual(p, Symbolic(s.v_cos), Symbolic(s.v_sin))};
             },
         .derived =
             [] {
                 const auto [displacement, velocity] = derived_final_conditions();
                 return std::vector<ex>{displacement, velocity};
             },
         .departure = Departure::convention,
         .correction = "\\begin{cases}\\mathcal{A}[v_{di}\\cos\\phi_j]+\\mathcal{B}[v_{di}\\sin\\phi_j]+\\mathcal{C}=0\\\\"
                       "\\mathcal{P}[v_{di}\\cos\\phi_j]+\\mathcal{Q}[v_{di}\\sin\\phi_j]+\\mathcal{R}=0\\end{cases}",
         .steps = {{"Symmetry: half a period later the motion is its mirror image",
                    "\\eta_i(\\pi)+\\eta_{i0}=0,\\qquad \\eta_i'(\\pi)+\\eta_{i0}'=0"},
                   {"$\\cos\\phi_j$ and $\\sin\\phi_j$ are written through the real and imaginary part of $v_{di}e^{i\\phi_j}$, "
                    "in which both "
                    "conditions are linear",
                    "[v_{di}\\cos\\phi_j] = \\mathrm{Re}\\{v_{di}e^{i\\phi_j}\\},\\qquad [v_{di}\\sin\\phi_j] = "
                    "\\mathrm{Im}\\{v_{di}e^{i\\phi_j}\\}"},
                   step("(A.6) at $\\tau=\\pi$ gives the first condition, this to be zero", "\\eta_i(\\pi)+\\eta_{i0}",
                        derived_final_conditions().first),
                   step("and (A.7) the second, this to be zero", "\\eta_i'(\\pi)+\\eta_{i0}'",
                        derived_final_conditions().second)}},
        {.id = "A.11/coefficients",
         .equations = {"A.11"},
         .title = "The six coefficients, v_di taken out of the first four",
         .assumptions = domain,
         .kernel =
             [&s] {
                 const PhaseSystem<Symbolic> p = paper::phase_system(symbolic_mode(), symbolic_start(), Symbolic(s.beta));
                 return Values{p.A, p.B, p.C, p.P, p.Q, p.R};
             },
         .derived =
             [&s] {
                 const GiNaC::symbol& v_cos = GiNaC::ex_to<GiNaC::symbol>(s.v_cos);
                 const GiNaC::symbol& v_sin = GiNaC::ex_to<GiNaC::symbol>(s.v_sin);
                 const lst none{s.v_cos == 0, s.v_sin == 0};
                 const auto [displacement, velocity] = derived_final_conditions();
                 return std::vector<ex>{displacement.diff(v_cos), displacement.diff(v_sin), displacement.subs(none),
                                        velocity.diff(v_cos),     velocity.diff(v_sin),     velocity.subs(none)};
             },
         .departure = Departure::convention,
         .correction_left = {"\\mathcal{A}", "\\mathcal{B}", "\\mathcal{C}", "\\mathcal{P}", "\\mathcal{Q}", "\\mathcal{R}"},
         .steps = {{"The coefficients of $[v_{di}\\cos\\phi_j]$ and $[v_{di}\\sin\\phi_j]$ in the two conditions (A.10), and "
                    "what is left without "
                    "them, in the order A, B, C, P, Q, R",
                    ""}}},
    };
});

} // namespace
} // namespace denhartog::derivation

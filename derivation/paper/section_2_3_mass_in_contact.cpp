// Section 2.3, (30)-(39): amplitude and phase of the mass in contact.
//
// The modal relations (26) and (27), proved in the Appendix, are multiplied by the mode shapes and summed, for one and two
// modes here, for every number in `one_more_mode.cpp`. The response and damping functions of the modes stay symbols.
#include "denhartog/formulas/contact.hpp"
#include "denhartog/formulas/superposition.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/claim.hpp"
#include "derivation/paper/modal_sums.hpp"

namespace denhartog::derivation {

using GiNaC::ex;

namespace {

/// The amplitude from cos^2 + sin^2 = 1: the larger root of (X + beta G)^2 + (beta U)^2 = |V|^2.
ex derived_amplitude() {
    const Symbols& s = symbols();
    const GiNaC::symbol X("X");
    // (31) and (32) as linear equations for cosine and sine of the phase
    const auto [cosine, sine] = derived_phase_of_contact(s.V_jr, s.V_ji, X + s.beta * s.G_j, -s.beta * s.U_j);
    const ex equation = ((cosine * cosine + sine * sine - 1) * (s.V_jr * s.V_jr + s.V_ji * s.V_ji)).normal().expand();
    const ex a = equation.coeff(X, 2), b = equation.coeff(X, 1), c = equation.coeff(X, 0);
    return (-b + GiNaC::sqrt((b * b - 4 * a * c).expand())) / (2 * a);
}

/// Cosine and sine of phi_j plus the argument of V_dj in the steady state.
std::pair<ex, ex> derived_phase_sum() {
    const Symbols& s = symbols();
    const auto [c, sine] = derived_steady_phase(s.V_jr, s.V_ji, s.U_j);
    const ex angle = GiNaC::atan2(s.V_ji, s.V_jr);
    return {c * GiNaC::cos(angle) - sine * GiNaC::sin(angle), sine * GiNaC::cos(angle) + c * GiNaC::sin(angle)};
}

const Register claims_of_section_2_3_mass_in_contact([] {
    const Symbols& s = symbols();
    const ex angle = GiNaC::atan2(s.V_ji, s.V_jr);
    const std::vector<std::string> sliding{"sliding regime, beta |U_dj| <= |V_dj|", "V_dj not zero"};
    std::vector<Claim> list;
    for (int N = 1; N <= 2; ++N) { // for every N: one_more_mode.cpp
        const std::string of_N = "/N=" + std::to_string(N);
        const std::vector<std::string> modes{"N = " + std::to_string(N) + " modes"};
        list.push_back({.id = "33/response-function" + of_N,
                        .equations = {"33"},
                        .title = "V_dk is the complex amplitude of the harmonic part of the displacement",
                        .assumptions = modes,
                        .kernel =
                            [N, &s] {
                                const SymbolicModes m = symbolic_modes(N);
                                const Complex<Symbolic> V = paper::complex_response_of_mass<Symbolic>(m.psi_k, m.psi_l, m.R, m.v);
                                return Values{times_cosine(V, Symbolic(s.tau) + Symbolic(s.phi_j))};
                            },
                        .derived =
                            [N, &s] {
                                ex sum = 0;
                                for (const ModalStart& mode : derived_starts(N, GiNaC::cos(s.phi_j), GiNaC::sin(s.phi_j)))
                                    sum += mode.psi_k *
                                           (mode.harmonic_cosine * GiNaC::cos(s.tau) + mode.harmonic_sine * GiNaC::sin(s.tau));
                                return std::vector<ex>{sum};
                            },
                        .steps = {{"The harmonic part of (21), $\\psi_{li}R_i^2\\mathrm{Re}\\{v_{di}e^{i(\\tau+\\phi_j)}\\}$, of "
                                   "each mode is multiplied "
                                   "by $\\psi_{ki}$ and summed; it has to be $\\mathrm{Re}\\{V_{dk}e^{i(\\tau+\\phi_j)}\\}$",
                                   ""}}});
        list.push_back(
            {.id = "31/contact" + of_N,
             .equations = {"31", "32"},
             .by_component = {"31", "32"},
             .title = "The relations of the modes, multiplied by psi_ji and summed, give those of the mass in contact",
             .assumptions = modes,
             .kernel =
                 [N, &s] {
                     const SymbolicModes m = symbolic_modes(N);
                     const auto [X, rate] = derived_start_of_mass(N, Row::contact, GiNaC::cos(s.phi_j), GiNaC::sin(s.phi_j));
                     const Symbolic G = paper::damping_function_of_mass<Symbolic>(m.psi_j, m.psi_j, m.R, m.g);
                     const Symbolic U = paper::damping_function_of_mass<Symbolic>(m.psi_j, m.psi_j, m.R, m.u);
                     return Values{paper::V_cosine(Symbolic(X), G, Symbolic(s.beta)),
                                   paper::V_sine(U, Symbolic(s.beta)) - Symbolic(rate)};
                 },
             .derived =
                 [N, &s] {
                     const auto [re, im] = derived_response(N, Row::contact);
                     const ex c = GiNaC::cos(s.phi_j), sine = GiNaC::sin(s.phi_j);
                     return std::vector<ex>{re * c - im * sine, re * sine + im * c};
                 },
             .departure = Departure::convention,
             .steps = {{"(26) and (27), solved for the initial values, are multiplied by $\\psi_{ji}$ and summed: "
                        "(30). What friction adds is "
                        "$\\beta G_j$ and $\\beta U_{dj}$, (34) and (35)",
                        ""},
                       step("The amplitude", "\\overline{X}_j",
                            derived_start_of_mass(N, Row::contact, GiNaC::cos(s.phi_j), GiNaC::sin(s.phi_j)).first),
                       step("and the velocity at the maximum, which is to be zero", "\\bar{x}_j'(0)",
                            derived_start_of_mass(N, Row::contact, GiNaC::cos(s.phi_j), GiNaC::sin(s.phi_j)).second)}});
    }
    list.push_back({.id = "36/cosine",
                    .equations = {"36"},
                    .title = "Cosine of the phase with the argument of V_dj",
                    .assumptions = sliding,
                    .kernel =
                        [&s] {
                            return Values{paper::cosine_of_phase_sum(symbolic_V_j(), Symbolic(derived_amplitude()),
                                                                     Symbolic(s.G_j), Symbolic(s.beta))};
                        },
                    .derived = [] { return std::vector<ex>{derived_phase_sum().first}; },
                    .steps = {{"(31) says $\\mathrm{Re}\\{V_{dj}e^{i\\phi_j}\\} = \\overline{X}_j+\\beta G_j$; with modulus and "
                               "argument of $V_{dj}$ the left "
                               "side is $|V_{dj}|\\cos(\\phi_j+\\angle V_{dj})$",
                               ""}}});
    list.push_back(
        {.id = "37/sine",
         .equations = {"37"},
         .title = "Sine of the phase with the argument of V_dj",
         .assumptions = sliding,
         .kernel = [&s] { return Values{paper::sine_of_phase_sum(symbolic_V_j(), Symbolic(s.U_j), Symbolic(s.beta))}; },
         .derived = [] { return std::vector<ex>{derived_phase_sum().second}; },
         .steps = {{"(32) says $\\mathrm{Im}\\{V_{dj}e^{i\\phi_j}\\} = -\\beta U_{dj}$; the left side is "
                    "$|V_{dj}|\\sin(\\phi_j+\\angle V_{dj})$",
                    ""}}});
    list.push_back(
        {.id = "38/amplitude",
         .equations = {"38"},
         .title = "Amplitude of the mass in contact: the root for which X_j + beta G_j is not negative, as (54)a demands",
         .assumptions = sliding,
         .kernel =
             [&s] {
                 return Values{paper::displacement_transmissibility_of_contact(symbolic_V_j(), Symbolic(s.U_j), Symbolic(s.G_j),
                                                                               Symbolic(s.beta))};
             },
         .derived = [] { return std::vector<ex>{derived_amplitude()}; },
         .steps = {{"The squares of (36) and (37) add up to one", "(\\overline{X}_j+\\beta G_j)^2+(\\beta U_{dj})^2=|V_{dj}|^2"},
                   step("A quadratic equation; its larger root is", "\\overline{X}_j", derived_amplitude())}});
    list.push_back(
        {.id = "39/phase",
         .equations = {"39"},
         .title = "The phase has the cosine (36) and the sine (37)",
         .assumptions = sliding,
         .kernel =
             [&s, angle] {
                 const ex phi = paper::phase_of_contact(symbolic_V_j(), Symbolic(s.U_j), Symbolic(s.beta)).expression();
                 return Values{Symbolic(GiNaC::cos(phi + angle)), Symbolic(GiNaC::sin(phi + angle))};
             },
         .derived =
             [&s] {
                 const ex modulus = GiNaC::sqrt(s.V_jr * s.V_jr + s.V_ji * s.V_ji);
                 return std::vector<ex>{(derived_amplitude() + s.beta * s.G_j) / modulus, -s.beta * s.U_j / modulus};
             },
         .steps =
             {{"(38) is put into (36); cosine and sine of $\\phi_j+\\angle V_{dj}$ then fix the angle, its quadrant included",
               ""}}});
    return list;
});

} // namespace
} // namespace denhartog::derivation

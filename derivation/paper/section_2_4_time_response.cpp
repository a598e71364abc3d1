// Section 2.4, (41)-(46): the motion of every mass over the half-period.
#include "denhartog/evaluation/mass.hpp"
#include "denhartog/formulas/as_printed.hpp"
#include "denhartog/formulas/superposition.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/claim.hpp"
#include "derivation/paper/modal_sums.hpp"

namespace denhartog::derivation {

using GiNaC::ex;

namespace {

/// Displacement of a mass in the steady state: the harmonic parts of its modes add up to V_dk, (33), the rest is summed here.
ex derived_steady_displacement(int N) {
    const Symbols& s = symbols();
    const SymbolicModes m = symbolic_modes(N);
    const auto [c, sine] = derived_steady_phase(s.V_jr, s.V_ji, s.U_j);
    std::vector<std::pair<ex, ex>> friction_alone;
    for (const ModalStart& start : derived_starts(N, c, sine))
        friction_alone.emplace_back(start.eta_0 - start.harmonic_cosine, start.eta_prime_0 - start.harmonic_sine);
    return (s.V_kr * c - s.V_ki * sine) * GiNaC::cos(s.tau) - (s.V_kr * sine + s.V_ki * c) * GiNaC::sin(s.tau) +
           derived_displacement_of_mass(N, Row::mass, friction_alone);
}

/// (46) with its sum over the modes taken from the template given.
template <class FrictionMotionOfMass>
Values steady_displacement(int N, const FrictionMotionOfMass& friction_motion_of_mass) {
    const Symbols& s = symbols();
    const SymbolicModes m = symbolic_modes(N);
    const Symbolic F_k = friction_motion_of_mass(Symbolic(s.tau), m.psi_k, m.psi_j, m.R, m.zeta, m.u, m.g);
    return {paper::steady_displacement(Symbolic(s.tau), symbolic_V_k(), symbolic_V_j(), Symbolic(s.U_j), Symbolic(s.beta), F_k)};
}

/// One mode throughout: with a single mode every function of the masses is that of the mode.
ex derived_steady_displacement_of_one_mode() {
    const SymbolicModes m = symbolic_modes(1);
    const auto [re, im] = derived_response(1, Row::contact);
    const ex U = GiNaC::pow(m.psi_j[0].expression() * m.R[0].expression(), 2) * m.u[0].expression();
    const auto [c, sine] = derived_steady_phase(re, im, U);
    const ModalStart start = derived_starts(1, c, sine).front();
    return derived_displacement_of_mass(1, Row::mass, {{start.eta_0, start.eta_prime_0}});
}

/// (41) with its sum over the modes taken from the templates given.
template <class FrictionMotionOfMass>
Values displacement_from_start(int N, const FrictionMotionOfMass& friction_motion_of_mass) {
    const Symbols& s = symbols();
    const SymbolicModes m = symbolic_modes(N);
    const auto [x_k0, x_prime_k0] = derived_start_of_mass(N, Row::mass, GiNaC::cos(s.phi_j), GiNaC::sin(s.phi_j));
    const Symbolic tau(s.tau);
    const Symbolic G_k = paper::damping_function_of_mass<Symbolic>(m.psi_k, m.psi_j, m.R, m.g);
    const Symbolic U_dk = paper::damping_function_of_mass<Symbolic>(m.psi_k, m.psi_j, m.R, m.u);
    const Symbolic F_k = friction_motion_of_mass(tau, m.psi_k, m.psi_j, m.R, m.zeta, m.u, m.g);
    return {paper::displacement(tau, Symbolic(x_k0), Symbolic(x_prime_k0), G_k, U_dk, Symbolic(s.beta), F_k)};
}

const auto shipped_sum = [](auto&&... arguments) { return paper::friction_motion_of_mass<Symbolic>(arguments...); };
const auto printed_sum = [](auto&&... arguments) { return as_printed::friction_motion_of_mass<Symbolic>(arguments...); };

const Register claims_of_section_2_4_time_response([] {
    const Symbols& s = symbols();
    const std::vector<std::string> sliding{"sliding regime, beta |U_dj| <= |V_dj|", "V_dj not zero", "0 <= tau <= pi"};
    const char* const braces = "\\beta\\sum_{i=1}^N\\psi_{ki}\\psi_{ji}R_i^2\\{1-(1+g_i)d_i(\\tau)-u_{di}R_iq_i(\\tau)\\}";
    std::vector<Claim> list;
    for (int N = 1; N <= 2; ++N) { // for every N: one_more_mode.cpp
        const std::string of_N = "/N=" + std::to_string(N);
        std::vector<std::string> modes = sliding;
        modes.push_back("N = " + std::to_string(N) + " modes");
        const auto from_start = [N, &s] {
            std::vector<std::pair<ex, ex>> starts;
            for (const ModalStart& start : derived_starts(N, GiNaC::cos(s.phi_j), GiNaC::sin(s.phi_j)))
                starts.emplace_back(start.eta_0, start.eta_prime_0);
            return std::vector<ex>{derived_displacement_of_mass(N, Row::mass, starts)};
        };
        const auto steady = [N] { return std::vector<ex>{derived_steady_displacement(N)}; };
        if (N == 1) {
            list.push_back(
                {.id = "41/printed",
                 .equations = {"41"},
                 .role = Role::printed,
                 .title = "Displacement of a mass with the bracket as printed",
                 .assumptions = modes,
                 .kernel = [N] { return displacement_from_start(N, printed_sum); },
                 .derived = from_start,
                 .departure = Departure::misprint,
                 .correction = std::string("\\bar{x}_k = (\\bar{x}_{k0}+\\beta G_k)\\cos\\tau + (\\bar{x}_{k0}'+\\beta "
                                           "U_{dk})\\sin\\tau + ") +
                               braces});
            list.push_back({.id = "46/printed",
                            .equations = {"46"},
                            .role = Role::printed,
                            .title = "Steady displacement with the bracket as printed",
                            .assumptions = modes,
                            .kernel = [N] { return steady_displacement(N, printed_sum); },
                            .derived = steady,
                            .departure = Departure::misprint,
                            .correction = std::string("\\bar{x}_k = \\frac{|V_{dk}|}{|V_{dj}|}\\left[\\sqrt{|V_{dj}|^2-(\\beta "
                                                      "U_{dj})^2}\\cos(\\tau+\\angle V_{dk}-\\angle V_{dj}) + \\beta "
                                                      "U_{dj}\\sin(\\tau+\\angle V_{dk}-\\angle V_{dj})\\right] + ") +
                                          braces});
        }
        list.push_back(
            {.id = "41/displacement" + of_N,
             .equations = {"41"},
             .role = Role::shipped,
             .title = "Displacement of a mass from its initial values, the sum of its modes",
             .assumptions = modes,
             .kernel = [N] { return displacement_from_start(N, shipped_sum); },
             .derived = from_start,
             .steps = {{"(40) of each mode is multiplied by $\\psi_{ki}$ and summed; (33)-(35) give the sums their names", ""}}});
        list.push_back({.id = "46/steady-displacement" + of_N,
                        .equations = {"46"},
                        .role = Role::shipped,
                        .title = "Displacement of a mass in the steady state, the sum of its modes",
                        .assumptions = modes,
                        .kernel = [N] { return steady_displacement(N, shipped_sum); },
                        .derived = steady,
                        .steps = {{"(44) and (45) are put into (41): the harmonic parts of the modes add up to $V_{dk}$, the "
                                   "braces of (40) are summed "
                                   "with $\\psi_{ki}\\psi_{ji}R_i^2$",
                                   ""}}});
        list.push_back({.id = "42/mass" + of_N,
                        .equations = {"42", "43"},
                        .by_component = {"42", "43"},
                        .title = "The relations of the modes, multiplied by psi_ki and summed, give those of the mass k",
                        .assumptions = modes,
                        .kernel =
                            [N, &s] {
                                const SymbolicModes m = symbolic_modes(N);
                                const auto [x_k0, x_prime_k0] =
                                    derived_start_of_mass(N, Row::mass, GiNaC::cos(s.phi_j), GiNaC::sin(s.phi_j));
                                const Symbolic G = paper::damping_function_of_mass<Symbolic>(m.psi_k, m.psi_j, m.R, m.g);
                                const Symbolic U = paper::damping_function_of_mass<Symbolic>(m.psi_k, m.psi_j, m.R, m.u);
                                return Values{paper::V_k_cosine(Symbolic(x_k0), G, Symbolic(s.beta)),
                                              paper::V_k_sine(Symbolic(x_prime_k0), U, Symbolic(s.beta))};
                            },
                        .derived =
                            [N, &s] {
                                const auto [re, im] = derived_response(N, Row::mass);
                                const ex c = GiNaC::cos(s.phi_j), sine = GiNaC::sin(s.phi_j);
                                return std::vector<ex>{re * c - im * sine, re * sine + im * c};
                            },
                        .departure = Departure::convention,
                        .steps = {{"(26) and (27), solved for the initial values, are multiplied by $\\psi_{ki}$ and summed", ""},
                                  step("The displacement", "\\bar{x}_{k0}",
                                       derived_start_of_mass(N, Row::mass, GiNaC::cos(s.phi_j), GiNaC::sin(s.phi_j)).first),
                                  step("and the velocity", "\\bar{x}_{k0}'",
                                       derived_start_of_mass(N, Row::mass, GiNaC::cos(s.phi_j), GiNaC::sin(s.phi_j)).second)}});
    }
    list.push_back({.id = "46/one-mode",
                    .equations = {"46", "33", "34"},
                    .role = Role::step,
                    .title = "With one mode, (33), (34) and (46) together give the motion of the mode",
                    .assumptions = sliding,
                    .kernel =
                        [&s] {
                            const SymbolicModes m = symbolic_modes(1);
                            const Complex<Symbolic> V_dk = paper::complex_response_of_mass<Symbolic>(m.psi_k, m.psi_l, m.R, m.v);
                            const Complex<Symbolic> V_dj = paper::complex_response_of_mass<Symbolic>(m.psi_j, m.psi_l, m.R, m.v);
                            const Symbolic U_dj = paper::damping_function_of_mass<Symbolic>(m.psi_j, m.psi_j, m.R, m.u);
                            const Symbolic F_k = shipped_sum(Symbolic(s.tau), m.psi_k, m.psi_j, m.R, m.zeta, m.u, m.g);
                            return Values{paper::steady_displacement(Symbolic(s.tau), V_dk, V_dj, U_dj, Symbolic(s.beta), F_k)};
                        },
                    .derived = [] { return std::vector<ex>{derived_steady_displacement_of_one_mode()}; },
                    .special_case = true});
    list.push_back({.id = "44/printed",
                    .equations = {"44"},
                    .role = Role::printed,
                    .title = "Real part of the complex initial displacement",
                    .assumptions = sliding,
                    .kernel =
                        [&s] {
                            return Values{as_printed::initial_displacement(symbolic_V_k(), symbolic_V_j(), Symbolic(s.U_j),
                                                                           Symbolic(s.G_k), Symbolic(s.beta))};
                        },
                    .derived = [] { return std::vector<ex>{derived_initial_state().first}; },
                    .departure = Departure::misprint,
                    .correction = "\\bar{x}_{k0} = -\\beta G_k + \\frac{|V_{dk}|}{|V_{dj}|}\\left[\\sqrt{|V_{dj}|^2-(\\beta "
                                  "U_{dj})^2}\\cos\\Delta + \\beta U_{dj}\\sin\\Delta\\right],\\quad \\Delta=\\angle "
                                  "V_{dk}-\\angle V_{dj}"});
    list.push_back({.id = "44/initial-displacement",
                    .equations = {"44"},
                    .role = Role::shipped,
                    .title = "Displacement of a mass at the maximum of the mass in contact",
                    .assumptions = sliding,
                    .kernel =
                        [&s] {
                            return Values{paper::initial_displacement(symbolic_V_k(), symbolic_V_j(), Symbolic(s.U_j),
                                                                      Symbolic(s.G_k), Symbolic(s.beta))};
                        },
                    .derived = [] { return std::vector<ex>{derived_initial_state().first}; },
                    .steps = {{"The phase follows from the mass in contact, (36)-(38)",
                               "\\mathrm{Re}\\{V_{dj}e^{i\\phi_j}\\}=\\sqrt{|V_{dj}|^2-(\\beta U_{dj})^2},\\qquad "
                               "\\mathrm{Im}\\{V_{dj}e^{i\\phi_j}\\}=-\\beta U_{dj}"},
                              step("and goes into (42)", "\\bar{x}_{k0}", derived_initial_state().first)}});
    list.push_back({.id = "45/printed",
                    .equations = {"45"},
                    .role = Role::printed,
                    .title = "Real part of the complex initial velocity",
                    .assumptions = sliding,
                    .kernel =
                        [&s] {
                            return Values{as_printed::initial_velocity(symbolic_V_k(), symbolic_V_j(), Symbolic(s.U_j),
                                                                       Symbolic(s.U_k), Symbolic(s.beta))};
                        },
                    .derived = [] { return std::vector<ex>{derived_initial_state().second}; },
                    .departure = Departure::misprint,
                    .correction =
                        "\\bar{x}_{k0}' = -\\beta U_{dk} + \\frac{|V_{dk}|}{|V_{dj}|}\\left[\\beta U_{dj}\\cos\\Delta - "
                        "\\sqrt{|V_{dj}|^2-(\\beta U_{dj})^2}\\sin\\Delta\\right],\\quad \\Delta=\\angle "
                        "V_{dk}-\\angle V_{dj}"});
    list.push_back({.id = "45/initial-velocity",
                    .equations = {"45"},
                    .role = Role::shipped,
                    .title = "Velocity of a mass at the maximum of the mass in contact",
                    .assumptions = sliding,
                    .kernel =
                        [&s] {
                            return Values{paper::initial_velocity(symbolic_V_k(), symbolic_V_j(), Symbolic(s.U_j),
                                                                  Symbolic(s.U_k), Symbolic(s.beta))};
                        },
                    .derived = [] { return std::vector<ex>{derived_initial_state().second}; },
                    .steps = {step("The same phase goes into (43)", "\\bar{x}_{k0}'", derived_initial_state().second)}});
    list.push_back({.id = "44/evaluation",
                    .equations = {"44", "45"},
                    .role = Role::shipped,
                    .title = "The form without angles that callers get",
                    .assumptions = sliding,
                    .kernel =
                        [&s] {
                            const evaluation::InitialState<Symbolic> start =
                                evaluation::initial_state(symbolic_V_k(), symbolic_V_j(), Symbolic(s.U_j), Symbolic(s.U_k),
                                                          Symbolic(s.G_k), Symbolic(s.beta));
                            return Values{start.x_k0, start.x_prime_k0};
                        },
                    .derived =
                        [] {
                            const auto [x_k0, x_prime_k0] = derived_initial_state();
                            return std::vector<ex>{x_k0, x_prime_k0};
                        }});
    return list;
});

} // namespace
} // namespace denhartog::derivation

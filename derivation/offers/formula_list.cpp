#include "derivation/offers/formula_list.hpp"

#include <array>
#include <span>

#include "denhartog/formulas/as_printed.hpp"
#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/contact.hpp"
#include "denhartog/formulas/high_frequency.hpp"
#include "denhartog/formulas/modal_coordinate.hpp"
#include "denhartog/formulas/mode.hpp"
#include "denhartog/formulas/motion.hpp"
#include "denhartog/formulas/other_masses.hpp"
#include "denhartog/formulas/resonance.hpp"
#include "denhartog/formulas/stuck.hpp"
#include "denhartog/formulas/superposition.hpp"
#include "denhartog/formulas/system.hpp"

namespace denhartog::offers {

namespace {

using Number = Written;
using Complex = denhartog::Complex<Number>;
using Names = std::vector<std::string>;

Number s(const std::string& name) { return Number::of(name); }
Complex c(const std::string& name) { return {s(name + "_re"), s(name + "_im")}; }
std::vector<Number> parts(const Complex& z) { return {z.re, z.im}; }

/// One mode with symbols that have a value a mode, for a sum that the page writes as a loop.
struct OneMode {
    std::array<Number, 1> psi_k{s("psi_k")}, psi_j{s("psi_j")}, psi_l{s("psi_l")}, R{s("R")}, zeta{s("zeta")},
        u{paper::first_damping_function(s("R"), s("zeta"))}, g{paper::second_damping_function(s("R"), s("zeta"))};
    std::array<Complex, 1> v{paper::complex_response(s("R"), s("zeta"))};
};

std::span<const Number> all(const std::array<Number, 1>& values) { return values; }

const Number R = s("R"), zeta = s("zeta"), tau = s("tau"), beta = s("beta"), mu = s("mu"), phi_j = s("phi_j");
const Names mode{"R", "zeta"}, mode_at{"tau", "R", "zeta"};

Number u() { return paper::first_damping_function(R, zeta); }
Number g() { return paper::second_damping_function(R, zeta); }
ModeInScene<Number> in_scene() { return {R, zeta, s("psi_ji"), s("psi_li")}; }
InitialValues<Number> start() { return {s("eta_0"), s("eta_prime_0")}; }
PhaseSystem<Number> phase_system() { return {s("A"), s("B"), s("C"), s("P"), s("Q"), s("R")}; }

OfferedFormula one(const std::string& equation, const std::string& what, const std::string& name, const Names& arguments,
                   std::vector<Number> results, std::vector<Number> printed = {}, const Names& of_modes = {}) {
    return {equation, what, name, arguments, of_modes, std::move(results), std::move(printed)};
}

std::vector<OfferedFormula> of_section_2_1() {
    return {
        one("2", "F_f", "friction_force", {"F", "sgn_x_dot"}, {paper::friction_force(s("F"), s("sgn_x_dot"))}),
        one("5", "\\bar{x}", "non_dimensional_displacement", {"x", "k_1", "P"},
            {paper::non_dimensional_displacement(s("x"), s("k_1"), s("P"))}),
        one("8", "\\gamma_ir^2", "non_dimensional_mass_by_ratios", {"gamma", "r"},
            {paper::non_dimensional_mass_by_ratios(s("gamma"), s("r"))}),
        one("9", "\\gamma_i", "mass_ratio", {"m_i", "m_1"}, {paper::mass_ratio(s("m_i"), s("m_1"))}),
        one("10", "r", "frequency_ratio", {"omega", "m_1", "k_1"}, {paper::frequency_ratio(s("omega"), s("m_1"), s("k_1"))}),
        one("11", "\\beta", "friction_ratio", {"F", "P"}, {paper::friction_ratio(s("F"), s("P"))}),
        one("22", "R_i", "modal_frequency_ratio", {"Omega"}, {paper::modal_frequency_ratio(s("Omega"))}),
        one("23", "v_{di}", "complex_response", mode, parts(paper::complex_response(R, zeta))),
        one("28", "u_{di}", "first_damping_function", mode, {u()}),
        one("29", "g_i", "second_damping_function", mode, {g()}),
    };
}

std::vector<OfferedFormula> of_the_contact() {
    const OneMode m;
    const Complex V = c("V_dj");
    const Number U = s("U_dj"), G = s("G_j");
    const Names sum{"psi_k", "psi_j", "R", "zeta"};
    const Complex term = paper::complex_response_of_mass<Number>(m.psi_k, m.psi_l, m.R, m.v);
    return {
        one("33", "V_{dk}", "complex_response_of_mass", {"psi_k", "psi_l", "R", "zeta"},
            {over_modes(term.re), over_modes(term.im)}, {}, {"psi_k", "psi_l", "R", "zeta"}),
        one("34", "U_{dk}", "first_damping_function_of_mass", sum,
            {over_modes(paper::damping_function_of_mass(all(m.psi_k), all(m.psi_j), all(m.R), all(m.u)))}, {}, sum),
        one("35", "G_k", "second_damping_function_of_mass", sum,
            {over_modes(paper::damping_function_of_mass(all(m.psi_k), all(m.psi_j), all(m.R), all(m.g)))}, {}, sum),
        one("36", "\\cos(\\phi_j+\\angle V_{dj})", "cosine_of_phase_sum", {"V_dj_re", "V_dj_im", "X_j", "G_j", "beta"},
            {paper::cosine_of_phase_sum(V, s("X_j"), G, beta)}),
        one("37", "\\sin(\\phi_j+\\angle V_{dj})", "sine_of_phase_sum", {"V_dj_re", "V_dj_im", "U_dj", "beta"},
            {paper::sine_of_phase_sum(V, U, beta)}),
        one("38", "\\overline{X}_j", "displacement_transmissibility_of_contact", {"V_dj_re", "V_dj_im", "U_dj", "G_j", "beta"},
            {paper::displacement_transmissibility_of_contact(V, U, G, beta)}),
        one("39", "\\phi_j", "phase_of_contact", {"V_dj_re", "V_dj_im", "U_dj", "beta"}, {paper::phase_of_contact(V, U, beta)}),
    };
}

std::vector<OfferedFormula> of_the_motion() {
    const OneMode m;
    const Complex Vk = c("V_dk"), Vj = c("V_dj");
    const Number Uj = s("U_dj"), Uk = s("U_dk"), Gk = s("G_k");
    const Names modal{"tau", "R", "zeta", "psi_ji", "eta_0", "eta_prime_0", "beta"}, modes{"psi_k", "psi_j", "R", "zeta"};
    const Names motion{"tau", "V_dk_re", "V_dk_im", "V_dj_re", "V_dj_im", "U_dj", "beta", "psi_k", "psi_j", "R", "zeta"};
    const Names two{"V_dk_re", "V_dk_im", "V_dj_re", "V_dj_im", "U_dj"};
    const auto with = [&two](std::initializer_list<std::string> more) {
        Names names = two;
        names.insert(names.end(), more);
        return names;
    };
    const auto of_mass = [&](const auto& sum) {
        return paper::steady_displacement(
            tau, Vk, Vj, Uj, beta, over_modes(sum(tau, all(m.psi_k), all(m.psi_j), all(m.R), all(m.zeta), all(m.u), all(m.g))));
    };
    const auto right = [](auto&&... a) { return paper::friction_motion_of_mass<Number>(a...); };
    const auto wrong = [](auto&&... a) { return as_printed::friction_motion_of_mass<Number>(a...); };
    const auto modal_of = [&](const std::string& equation) {
        return one(equation, "\\eta_i(\\tau)", "modal_displacement", modal,
                   {paper::modal_displacement(tau, in_scene(), start(), u(), g(), beta)},
                   {as_printed::modal_displacement(tau, in_scene(), start(), u(), g(), beta)});
    };
    return {
        modal_of("40"),
        one("44", "\\bar{x}_{k0}", "initial_displacement", with({"G_k", "beta"}),
            {paper::initial_displacement(Vk, Vj, Uj, Gk, beta)}, {as_printed::initial_displacement(Vk, Vj, Uj, Gk, beta)}),
        one("45", "\\bar{x}_{k0}'", "initial_velocity", with({"U_dk", "beta"}), {paper::initial_velocity(Vk, Vj, Uj, Uk, beta)},
            {as_printed::initial_velocity(Vk, Vj, Uj, Uk, beta)}),
        one("46", "\\bar{x}_k(\\tau)", "steady_displacement", motion, {of_mass(right)}, {of_mass(wrong)}, modes),
        one("48", "\\bar{x}_k(\\tau)", "monoharmonic_displacement", {"tau", "x_k0", "x_prime_k0"},
            {paper::monoharmonic_displacement(tau, s("x_k0"), s("x_prime_k0"))}),
        one("50", "\\overline{X}_{k_C}", "monoharmonic_cosine", with({"G_k", "beta"}),
            {paper::monoharmonic_cosine(Vk, Vj, Uj, Gk, beta)}, {as_printed::monoharmonic_cosine(Vk, Vj, Uj, Gk, beta)}),
        one("51", "\\overline{X}_{k_S}", "monoharmonic_sine", with({"U_dk", "beta"}),
            {paper::monoharmonic_sine(Vk, Vj, Uj, Uk, beta)}),
        one("52", "\\overline{X}_k", "displacement_transmissibility", with({"U_dk", "G_k", "beta"}),
            {paper::displacement_transmissibility(Vk, Vj, Uj, Uk, Gk, beta)},
            {as_printed::displacement_transmissibility(Vk, Vj, Uj, Uk, Gk, beta)}),
        one("53", "\\phi_{kj}", "phase_behind_contact", {"X_kC", "X_kS"}, {paper::phase_behind_contact(s("X_kC"), s("X_kS"))}),
    };
}

std::vector<OfferedFormula> of_the_boundary() {
    const OneMode m;
    const Complex V = c("V_dj");
    const Number U = s("U_dj");
    const Names sum{"psi_j", "R", "zeta"}, limit{"V_dj_re", "V_dj_im", "U_dj"};
    return {
        one("55", "\\overline{X}_j+\\beta G_j-\\beta S_{dj}", "sliding_margin", {"X_j", "G_j", "S_dj", "beta"},
            {paper::sliding_margin(s("X_j"), s("G_j"), s("S_dj"), beta)}),
        one("57", "s_i(\\tau)", "s_d_integrand", mode_at, {paper::s_d_integrand(tau, R, zeta, u(), g())},
            {as_printed::s_d_integrand(tau, R, zeta, u(), g())}),
        one("58", "\\text{right side}", "friction_ratio_limit", {"V_dj_re", "V_dj_im", "U_dj", "S_dj"},
            {paper::friction_ratio_limit(V, U, s("S_dj"))}),
        one("64", "H_j", "H", sum, {over_modes(paper::H(all(m.psi_j), all(m.R), all(m.zeta), all(m.u), all(m.g)))}, {}, sum),
        one("65", "\\sum\\psi_{ji}^2", "sum_of_squares_at_contact", {"gamma_j", "r"},
            {paper::sum_of_squares_at_contact(s("gamma_j"), s("r"))}),
        one("67", "\\text{right side}", "friction_ratio_limit", {"V_dj_re", "V_dj_im", "U_dj", "H_j", "mu", "gamma_j", "r"},
            {paper::friction_ratio_limit(
                V, U, paper::static_friction_demand(s("H_j"), mu, paper::sum_of_squares_at_contact(s("gamma_j"), s("r"))))}),
        one("70", "s_{di}", "s_d_expansion", mode_at, {paper::s_d_expansion(tau, R, zeta, u(), g())},
            {as_printed::s_d_expansion(tau, R, zeta, u(), g())}),
        one("71", "s_{di}", "s_d_at_zero", mode, {paper::s_d_at_zero(R, zeta, u(), g())}),
    };
}

std::vector<OfferedFormula> of_section_4() {
    const Names shapes{"psi_ki", "psi_li", "zeta"};
    const Number psi_ki = s("psi_ki"), psi_li = s("psi_li"), psi_ji = s("psi_ji"), V = s("V_k_abs"), U_k = s("U_k"),
                 U_j = s("U_j"), G_k = s("G_k");
    return {
        one("77", "|V_{dk}|", "complex_response_amplitude_at_resonance", shapes,
            {paper::complex_response_amplitude_at_resonance(psi_ki, psi_li, zeta)}),
        one("79", "g_i", "second_damping_function_at_resonance", {"zeta"}, {paper::second_damping_function_at_resonance(zeta)}),
        one("80", "G_k", "second_damping_function_of_mass_at_resonance", {"psi_ki", "psi_ji", "zeta"},
            {paper::second_damping_function_at_resonance(psi_ki, psi_ji, zeta)}),
        one("81", "\\overline{X}_k", "transmissibility_at_resonance",
            {"V_k_abs", "U_k", "U_j", "G_k", "psi_ki", "psi_ji", "beta"},
            {paper::transmissibility_at_resonance(V, U_k, U_j, G_k, psi_ki, psi_ji, beta)},
            {as_printed::transmissibility_at_resonance(V, U_k, U_j, G_k, beta)}),
        one("82", "\\overline{X}_k", "transmissibility_at_resonance_without_U", {"V_k_abs", "G_k", "beta"},
            {paper::transmissibility_at_resonance_without_U(V, G_k, beta)},
            {as_printed::transmissibility_at_resonance_without_U(Complex{Number(0), -V}, G_k, beta)}),
        one("83", "\\overline{X}_k", "resonant_peak", {"psi_ki", "psi_li", "psi_ji", "zeta", "beta"},
            {paper::resonant_peak(psi_ki, psi_li, psi_ji, zeta, beta)}),
        one("84", "\\overline{X}", "resonant_peak_of_single_mass", {"zeta", "beta"},
            {paper::resonant_peak_of_single_mass(zeta, beta)}),
        one("85", "\\beta_{n,i}", "friction_ratio_limit_at_resonance", {"psi_li", "psi_ji", "zeta"},
            {paper::friction_ratio_limit_at_resonance(psi_li, psi_ji, zeta)}),
        one("86", "\\beta_\\infty", "friction_ratio_limit_at_high_frequency", {"mu"},
            {paper::friction_ratio_limit_at_high_frequency(mu)}, {as_printed::friction_ratio_limit_at_high_frequency(mu)}),
        one("87", "1-2V_kU_j/(V_jU_k)", "invariant_point_function", {"V_k", "V_j", "U_k", "U_j"},
            {paper::invariant_point_function(s("V_k"), s("V_j"), s("U_k"), s("U_j"))}),
    };
}

std::vector<OfferedFormula> of_the_appendix() {
    const Names from_start{"tau", "R", "zeta", "psi_ji", "psi_li", "eta_0", "eta_prime_0", "beta", "phi_j"};
    return {
        one("A.6", "\\eta_i(\\tau)", "modal_displacement_from_start", from_start,
            {paper::modal_displacement_from_start(tau, in_scene(), start(), beta, phi_j)}),
        one("A.7", "\\eta_i'(\\tau)", "modal_velocity_from_start", from_start,
            {paper::modal_velocity_from_start(tau, in_scene(), start(), beta, phi_j)},
            {as_printed::modal_velocity_from_start(tau, in_scene(), start(), beta, phi_j)}),
        one("A.8", "d_i(\\tau)", "d", mode_at, {paper::d(tau, R, zeta)}),
        one("A.9", "q_i'(\\tau)", "q_prime", mode_at, {paper::q_prime(tau, R, zeta)}),
        one("A.12", "v_{di}\\cos\\phi_j", "v_cosine_from_system", {"A", "B", "C", "P", "Q", "R"},
            {paper::v_cosine_from_system(phase_system())}),
        one("A.15", "\\eta_i(\\tau)", "modal_displacement", {"tau", "R", "zeta", "psi_ji", "eta_0", "eta_prime_0", "beta"},
            {paper::modal_displacement(tau, in_scene(), start(), u(), g(), beta)},
            {as_printed::modal_displacement(tau, in_scene(), start(), u(), g(), beta)}),
    };
}

} // namespace

const std::vector<OfferedFormula>& offered_formulas() {
    static const std::vector<OfferedFormula> formulas = [] {
        std::vector<OfferedFormula> list;
        for (const auto part : {of_section_2_1, of_the_contact, of_the_motion, of_the_boundary, of_section_4, of_the_appendix})
            for (OfferedFormula& each : part()) list.push_back(std::move(each));
        return list;
    }();
    return formulas;
}

} // namespace denhartog::offers

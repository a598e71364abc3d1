// Section 4.1, (76)-(85): each as the function that it is said to be, from (23), (29), (38), (52) at R_i = 1. The orders of the
// errors and the paths of the limits are in section_4_1_orders.cpp.
#include "denhartog/formulas/as_printed.hpp"
#include "denhartog/formulas/resonance.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/claim.hpp"
#include "derivation/paper/derived.hpp"
#include "derivation/paper/modal_sums.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::lst;

namespace {

/// Mode shapes of one mode at the mass, at the contact and at the load.
struct Shapes {
    ex k, j, l;
};

/// Sizes of the mode shapes with every choice of signs; that of the contact is positive, as a mode may be turned round.
const std::vector<Shapes>& shapes() {
    static const std::vector<Shapes> all = [] {
        const auto size = [](const char* name, const char* latex) { return new_symbol(name, latex, GiNaC::numeric(1, 5), 2); };
        const ex k = size("psi_k_abs", "|\\psi_{ki}|"), j = size("psi_j_abs", "|\\psi_{ji}|");
        const ex l = size("psi_l_abs", "|\\psi_{li}|");
        return std::vector<Shapes>{{k, j, l}, {-k, j, l}, {k, j, -l}, {-k, j, -l}};
    }();
    return all;
}

/// Components for every choice of signs, one after the other.
template <class Result, class Make>
std::vector<Result> for_all_signs(const Make& make) {
    std::vector<Result> all;
    for (const Shapes& psi : shapes())
        for (const Result& value : make(psi)) all.push_back(value);
    return all;
}

/// The term of (33) of the mode in resonance: Im V at R_i = 1; the real part is zero there.
std::pair<ex, ex> derived_term_of_response(const ex& psi, const ex& psi_l) {
    const Symbols& s = symbols();
    const auto [re, im] = derived_complex_response();
    return {psi * psi_l * re.subs(s.R == 1), psi * psi_l * im.subs(s.R == 1)};
}

/// (29) at R_i = 1 with theta = pi w rounded to pi.
ex derived_second_function_at_resonance() {
    const Symbols& s = symbols();
    return derived_second_damping_function().subs(s.R == 1).subs(
        lst{GiNaC::sin(GiNaC::Pi * s.w) == 0, GiNaC::cos(GiNaC::Pi * s.w) == -1});
}

/// Square of the monoharmonic amplitude at resonance, the root of (38) replaced by |V_dj| once the square is worked out; U_k, U_j
/// and the mode's g are symbols.
ex derived_square_at_resonance(const Shapes& psi) {
    const Symbols& s = symbols();
    static const ex root = new_symbol("root", "y", GiNaC::numeric(1, 5), 2);
    const ex V_k = derived_term_of_response(psi.k, psi.l).second, V_j = derived_term_of_response(psi.j, psi.l).second;
    const ex G_k = psi.k * psi.j * s.g;
    const auto [c, sine] = derived_phase_of_contact(0, V_j, root, -s.beta * s.U_j);
    const ex x = -V_k * sine - s.beta * G_k, rate = -V_k * c - s.beta * s.U_k;
    const ex square = (x * x + rate * rate).expand();
    const ex V_j_abs = GiNaC::sqrt((V_j * V_j).expand());
    return square.coeff(root, 0) + square.coeff(root, 1) * V_j_abs +
           square.coeff(root, 2) * (V_j * V_j - s.beta * s.beta * s.U_j * s.U_j);
}

Symbolic amplitude_of_term(const Shapes& psi) {
    return Symbolic(GiNaC::sqrt(GiNaC::pow(derived_term_of_response(psi.k, psi.l).second, 2).expand()));
}

Symbolic second_function_of_mass(const Shapes& psi) { return Symbolic(psi.k * psi.j * symbols().g); }

std::vector<ex> derived_squares(bool with_U) {
    return for_all_signs<ex>([with_U](const Shapes& psi) {
        const ex full = derived_square_at_resonance(psi);
        return std::vector<ex>{with_U ? full : full.subs(lst{symbols().U_k == 0, symbols().U_j == 0})};
    });
}

/// |V| less beta |G| from the resonant terms of (33) and (35).
ex derived_peak(const ex& psi_k, const ex& psi_j, const ex& psi_l) {
    const ex V = derived_term_of_response(psi_k, psi_l).second;
    const ex sizes = GiNaC::sqrt((psi_k * psi_k * psi_j * psi_j).expand());
    return GiNaC::sqrt((V * V).expand()) - symbols().beta * sizes * derived_second_function_at_resonance();
}

const Register claims_of_section_4_1_resonance([] {
    const Symbols& s = symbols();
    const std::vector<std::string> resonance{"R_i = 1, then zeta_i -> 0", "psi_ki, psi_ji, psi_li not zero"};
    const std::vector<Step> theta_step{{"At R_i = 1, theta = pi w differs from pi by pi zeta_i^2 / 2: its sine is put to 0, its "
                                        "cosine to -1",
                                        "g_i \\to \\frac{\\sinh\\pi\\zeta_i}{\\cosh\\pi\\zeta_i-1}"}};
    const Symbolic zeta(s.zeta), beta(s.beta);
    return std::vector<Claim>{
        {.id = "76/term",
         .equations = {"76"},
         .title = "The term of the resonant mode in (33), for R_i -> 1 at fixed zeta_i",
         .assumptions = resonance,
         .kernel =
             [zeta] {
                 return for_all_signs<Symbolic>([&](const Shapes& psi) {
                     const Complex<Symbolic> V = paper::complex_response_at_resonance(Symbolic(psi.k), Symbolic(psi.l), zeta);
                     return Values{V.re, V.im};
                 });
             },
         .derived =
             [] {
                 return for_all_signs<ex>([](const Shapes& psi) {
                     const auto [re, im] = derived_term_of_response(psi.k, psi.l);
                     return std::vector<ex>{re, im};
                 });
             },
         .approximation = true,
         .steps = {{"(23) is continuous at R_i = 1 where zeta_i > 0; the other terms of (33) are left out", ""}}},
        {.id = "77/amplitude",
         .equations = {"77"},
         .title = "The modulus of that term",
         .assumptions = resonance,
         .kernel =
             [zeta] {
                 return for_all_signs<Symbolic>([&](const Shapes& psi) {
                     return Values{paper::complex_response_amplitude_at_resonance(Symbolic(psi.k), Symbolic(psi.l), zeta)};
                 });
             },
         .derived =
             [] {
                 return for_all_signs<ex>([](const Shapes& psi) { return std::vector<ex>{amplitude_of_term(psi).expression()}; });
             },
         .approximation = true},
        {.id = "78/phase-difference",
         .equations = {"78"},
         .title = "Cosine and sine of the difference of the arguments of the resonant terms of masses k and j",
         .assumptions = resonance,
         .kernel =
             [] {
                 return for_all_signs<Symbolic>([](const Shapes& psi) {
                     const Symbolic cosine = paper::cosine_of_phase_difference_at_resonance(Symbolic(psi.k), Symbolic(psi.j));
                     return Values{cosine, Symbolic(ex(0))};
                 });
             },
         .derived =
             [] {
                 return for_all_signs<ex>([](const Shapes& psi) {
                     const auto argument = [&psi](const ex& shape) {
                         const Complex<Symbolic> V =
                             paper::complex_response_at_resonance(Symbolic(shape), Symbolic(psi.l), Symbolic(symbols().zeta));
                         return GiNaC::atan2(V.im.expression(), V.re.expression());
                     };
                     const ex Delta = argument(psi.k) - argument(psi.j);
                     return std::vector<ex>{GiNaC::cos(Delta), GiNaC::sin(Delta)};
                 });
             },
         .refines = {"76"},
         .approximation = true},
        {.id = "79/theta-pi",
         .equations = {"79"},
         .title = "(29) at R_i = 1 with sin(pi w) = 0 and cos(pi w) = -1",
         .assumptions = {"R_i = 1, then zeta_i -> 0"},
         .kernel = [zeta] { return Values{paper::second_damping_function_at_resonance(zeta)}; },
         .derived = [] { return std::vector<ex>{derived_second_function_at_resonance()}; },
         .approximation = true,
         .steps = theta_step},
        {.id = "80/term",
         .equations = {"80"},
         .title = "The term of the resonant mode in (35)",
         .assumptions = resonance,
         .kernel =
             [zeta] {
                 return for_all_signs<Symbolic>([&](const Shapes& psi) {
                     return Values{paper::second_damping_function_at_resonance(Symbolic(psi.k), Symbolic(psi.j), zeta)};
                 });
             },
         .derived =
             [] {
                 return for_all_signs<ex>(
                     [](const Shapes& psi) { return std::vector<ex>{psi.k * psi.j * derived_second_function_at_resonance()}; });
             },
         .approximation = true,
         .steps = theta_step},
        {.id = "81/printed",
         .equations = {"81"},
         .role = Role::printed,
         .title = "Square of the amplitude with + beta |U_dj| |U_dk|",
         .assumptions = resonance,
         .kernel =
             [&s, beta] {
                 return for_all_signs<Symbolic>([&](const Shapes& psi) {
                     return Values{square(as_printed::transmissibility_at_resonance(
                         amplitude_of_term(psi), Symbolic(s.U_k), Symbolic(s.U_j), second_function_of_mass(psi), beta))};
                 });
             },
         .derived = [] { return derived_squares(true); },
         .departure = Departure::misprint,
         .correction = "\\overline{X}_k \\cong \\left[|V_{dk}|^2 + \\beta^2(G_k^2+U_{dk}^2) - 2\\beta\\left(|V_{dk}||G_k| + "
                       "\\beta\\tfrac{\\psi_{ki}}{\\psi_{ji}}U_{dj}U_{dk}\\right)\\right]^{1/2}"},
        {.id = "81/transmissibility",
         .equations = {"81"},
         .role = Role::shipped,
         .title = "Square of the amplitude (52) with the resonant terms of V and G, the root of (38) replaced by |V_dj|",
         .assumptions = resonance,
         .kernel =
             [&s, beta] {
                 return for_all_signs<Symbolic>([&](const Shapes& psi) {
                     return Values{square(paper::transmissibility_at_resonance(amplitude_of_term(psi), Symbolic(s.U_k),
                                                                               Symbolic(s.U_j), second_function_of_mass(psi),
                                                                               Symbolic(psi.k), Symbolic(psi.j), beta))};
                 });
             },
         .derived = [] { return derived_squares(true); },
         .approximation = true,
         .steps = {{"The square of the motion's amplitude is worked out with the root as y; then y^2 is "
                    "|V_dj|^2 - (beta U_dj)^2, and y alone is |V_dj|",
                    ""},
                   {"|V_dk| / |V_dj| with the sign (78) is psi_ki / psi_ji by (77)", ""}}},
        {.id = "82/printed",
         .equations = {"82"},
         .role = Role::printed,
         .title = "Square of |V_dk - beta |G_k|| with the complex V_dk",
         .assumptions = resonance,
         .kernel =
             [beta] {
                 return for_all_signs<Symbolic>([&](const Shapes& psi) {
                     const auto [re, im] = derived_term_of_response(psi.k, psi.l);
                     return Values{square(as_printed::transmissibility_at_resonance_without_U(
                         Complex<Symbolic>{Symbolic(re), Symbolic(im)}, second_function_of_mass(psi), beta))};
                 });
             },
         .derived = [] { return derived_squares(false); },
         .departure = Departure::scan,
         .correction = "\\overline{X}_k \\cong \\big||V_{dk}|-\\beta|G_k|\\big|"},
        {.id = "82/without-U",
         .equations = {"82"},
         .role = Role::shipped,
         .title = "Square of the amplitude at resonance with the first damping functions left out",
         .assumptions = resonance,
         .kernel =
             [beta] {
                 return for_all_signs<Symbolic>([&](const Shapes& psi) {
                     return Values{square(paper::transmissibility_at_resonance_without_U(amplitude_of_term(psi),
                                                                                         second_function_of_mass(psi), beta))};
                 });
             },
         .derived = [] { return derived_squares(false); },
         .approximation = true},
        {.id = "83/peak",
         .equations = {"83"},
         .title = "|V_dk| - beta |G_k| with the resonant terms of (33) and (35)",
         .assumptions = {"R_i = 1, then zeta_i -> 0", "psi_ki, psi_ji, psi_li not zero", "beta below (85)"},
         .kernel =
             [zeta, beta] {
                 return for_all_signs<Symbolic>([&](const Shapes& psi) {
                     return Values{paper::resonant_peak(Symbolic(psi.k), Symbolic(psi.l), Symbolic(psi.j), zeta, beta)};
                 });
             },
         .derived =
             [] {
                 return for_all_signs<ex>([](const Shapes& psi) { return std::vector<ex>{derived_peak(psi.k, psi.j, psi.l)}; });
             },
         .approximation = true,
         .steps = theta_step},
        {.id = "84/peak",
         .equations = {"84"},
         .title = "The estimate of the peak of a single mass, whose mode shape at r = 1 is 1 by (17)",
         .assumptions = {"r = 1, then zeta -> 0", "beta below (85)"},
         .kernel = [zeta, beta] { return Values{paper::resonant_peak_of_single_mass(zeta, beta)}; },
         .derived = [] { return std::vector<ex>{derived_peak(1, 1, 1)}; },
         .approximation = true,
         .steps = theta_step},
        {.id = "85/limit",
         .equations = {"85"},
         .title = "(67) with the resonant terms alone: |V_dj| over psi_ji^2 g_i",
         .assumptions = {"R_i = 1, then zeta_i -> 0", "psi_ji, psi_li not zero"},
         .kernel =
             [zeta] {
                 return for_all_signs<Symbolic>([&](const Shapes& psi) {
                     return Values{paper::friction_ratio_limit_at_resonance(Symbolic(psi.l), Symbolic(psi.j), zeta)};
                 });
             },
         .derived =
             [] {
                 return for_all_signs<ex>([](const Shapes& psi) {
                     const ex V = derived_term_of_response(psi.j, psi.l).second;
                     return std::vector<ex>{GiNaC::sqrt((V * V).expand()) /
                                            (psi.j * psi.j * derived_second_function_at_resonance())};
                 });
             },
         .approximation = true,
         .steps = theta_step},
        {.id = "85/peak-vanishes",
         .equations = {"83", "85"},
         .role = Role::step,
         .title = "(83) is zero at the friction ratio (85)",
         .assumptions = {"psi_ki, psi_ji, psi_li not zero"},
         .kernel =
             [zeta] {
                 return for_all_signs<Symbolic>([&](const Shapes& psi) {
                     const Symbolic limit = paper::friction_ratio_limit_at_resonance(Symbolic(psi.l), Symbolic(psi.j), zeta);
                     return Values{paper::resonant_peak(Symbolic(psi.k), Symbolic(psi.l), Symbolic(psi.j), zeta, limit)};
                 });
             },
         .derived = [] { return std::vector<ex>(shapes().size(), ex(0)); }},
    };
});

} // namespace
} // namespace denhartog::derivation

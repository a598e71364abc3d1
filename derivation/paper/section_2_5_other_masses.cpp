// Section 2.5, (47)-(53): amplitude and phase of the masses not in contact.
#include "denhartog/formulas/as_printed.hpp"
#include "denhartog/formulas/other_masses.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/claim.hpp"
#include "derivation/paper/modal_sums.hpp"

namespace denhartog::derivation {

using GiNaC::ex;

namespace {

/// The motion from x_k0 and x'_k0 of a mass with one mode; psi is 1 so that x_k0 = eta_0.
ex derived_motion_from_start() {
    const Symbols& s = symbols();
    return derived_displacement_of_mass(1, Row::mass, {{s.x_k0, s.x_prime_k0}})
        .subs(symbolic_modes(1).psi_k[0].expression() == 1);
}

/// The real parts of (44) and (45) as printed.
std::pair<Symbolic, Symbolic> printed_real_parts() {
    const Symbols& s = symbols();
    return {as_printed::initial_displacement(symbolic_V_k(), symbolic_V_j(), Symbolic(s.U_j), Symbolic(s.G_k), Symbolic(s.beta)),
            as_printed::initial_velocity(symbolic_V_k(), symbolic_V_j(), Symbolic(s.U_j), Symbolic(s.U_k), Symbolic(s.beta))};
}

/// (44) and (45) as printed; exp(i Delta) is V_dk V_dj* over the product of the moduli.
/// @param root  a real symbol for the root of (38)
std::pair<ex, ex> printed_complex_start(const ex& root) {
    const Symbols& s = symbols();
    const ex V_j_squared = s.V_jr * s.V_jr + s.V_ji * s.V_ji;
    const ex turned = (s.V_kr + GiNaC::I * s.V_ki) * (s.V_jr - GiNaC::I * s.V_ji) / V_j_squared;
    return {-s.beta * s.G_k + root * turned, s.beta * (s.U_j * turned - s.U_k)};
}

/// (48) with the displacement and the velocity at tau = 0.
ex derived_monoharmonic_motion() {
    const auto [x, rate] = derived_initial_state();
    return x * GiNaC::cos(symbols().tau) + rate * GiNaC::sin(symbols().tau);
}

const Register claims_of_section_2_5_other_masses([] {
    const Symbols& s = symbols();
    const std::vector<std::string> sliding{"sliding regime, beta |U_dj| <= |V_dj|", "V_dj not zero"};
    return std::vector<Claim>{
        {.id = "47/phase",
         .equations = {"47"},
         .title = "A displacement that is largest, or smallest, at tau_k,max lags the force by phi_k",
         .kernel =
             [&s] {
                 const ex at = s.tau + s.phi_j; // the force is cos(at); the displacement is X cos(at - phi_k)
                 const Symbolic phi_j(s.phi_j), tau_k_max(s.t);
                 return Values{Symbolic(GiNaC::cos(at - paper::phase_of_mass(phi_j, tau_k_max, 0).expression())),
                               Symbolic(GiNaC::cos(at - paper::phase_of_mass(phi_j, tau_k_max, 1).expression()))};
             },
         .derived =
             [&s] {
                 return std::vector<ex>{GiNaC::cos(s.tau - s.t), -GiNaC::cos(s.tau - s.t)};
             },
         .special_case = true},
        {.id = "48/first-order",
         .equations = {"48"},
         .title = "The monoharmonic motion equals the motion without friction, and the motion itself at tau = 0: the error is of "
                  "first order in beta",
         .assumptions = sliding,
         .kernel =
             [&s] {
                 const Symbolic x(s.x_k0), rate(s.x_prime_k0);
                 return Values{paper::monoharmonic_displacement(Symbolic(s.tau), x, rate),
                               paper::monoharmonic_displacement(Symbolic(0), x, rate)};
             },
         .derived =
             [&s] {
                 const ex motion = derived_motion_from_start();
                 if (motion.diff(GiNaC::ex_to<GiNaC::symbol>(s.beta)).subs(s.beta == 0).normal().is_zero())
                     throw std::logic_error("the error of (48) has no term of first order");
                 return std::vector<ex>{motion.subs(s.beta == 0), motion.subs(s.tau == 0)};
             },
         .approximation = true,
         .special_case = true,
         .steps = {{"(41) without its braces, which are of first order in $\\beta$ and vanish at $\\tau=0$", ""}}},
        {.id = "49/printed",
         .equations = {"49"},
         .role = Role::printed,
         .title = "First equality: the real parts of (44) and (45) as printed, complex, as factors of cos(tau) and sin(tau)",
         .assumptions = sliding,
         .kernel =
             [&s] {
                 const auto [x_k0, x_prime_k0] = printed_real_parts();
                 return Values{paper::monoharmonic_displacement(Symbolic(s.tau), x_k0, x_prime_k0)};
             },
         .derived = [] { return std::vector<ex>{derived_monoharmonic_motion()}; },
         .departure = Departure::misprint,
         .correction = "\\bar{x}_k \\cong \\mathrm{Re}\\{(\\bar{x}_{k0}-i\\bar{x}_{k0}')(\\cos\\tau+i\\sin\\tau)\\} = "
                       "\\overline{X}_{k_C}\\cos\\tau+\\overline{X}_{k_S}\\sin\\tau"},
        {.id = "49/real-part",
         .equations = {"49"},
         .role = Role::shipped,
         .title = "Second equality: the real part of (x_k0 - i x'_k0) exp(i tau) with (44) and (45) as printed, complex",
         .assumptions = sliding,
         .kernel =
             [] {
                 const GiNaC::realsymbol y("y");
                 const auto [x_k0, x_prime_k0] = printed_complex_start(y);
                 const ex rotation = GiNaC::cos(symbols().tau) + GiNaC::I * GiNaC::sin(symbols().tau);
                 const ex real = ((x_k0 - GiNaC::I * x_prime_k0) * rotation).expand().real_part();
                 const Symbolic root = paper::contact_root(symbolic_V_j(), Symbolic(symbols().U_j), Symbolic(symbols().beta));
                 return Values{Symbolic(real.subs(y == root.expression()))};
             },
         .derived = [] { return std::vector<ex>{derived_monoharmonic_motion()}; },
         .approximation = true,
         .special_case = true},
        {.id = "49/monoharmonic",
         .equations = {"49"},
         .role = Role::shipped,
         .title = "The motion with the factors (50) and (51)",
         .assumptions = sliding,
         .kernel =
             [&s] {
                 const Symbolic cosine = paper::monoharmonic_cosine(symbolic_V_k(), symbolic_V_j(), Symbolic(s.U_j),
                                                                    Symbolic(s.G_k), Symbolic(s.beta));
                 const Symbolic sine =
                     paper::monoharmonic_sine(symbolic_V_k(), symbolic_V_j(), Symbolic(s.U_j), Symbolic(s.U_k), Symbolic(s.beta));
                 return Values{paper::monoharmonic_displacement(Symbolic(s.tau), cosine, sine)};
             },
         .derived = [] { return std::vector<ex>{derived_monoharmonic_motion()}; },
         .approximation = true},
        {.id = "50/printed",
         .equations = {"50"},
         .role = Role::printed,
         .title = "Factor of the cosine with the ratio of moduli before the first term only",
         .assumptions = sliding,
         .kernel =
             [&s] {
                 return Values{as_printed::monoharmonic_cosine(symbolic_V_k(), symbolic_V_j(), Symbolic(s.U_j), Symbolic(s.G_k),
                                                               Symbolic(s.beta))};
             },
         .derived = [] { return std::vector<ex>{derived_initial_state().first}; },
         .departure = Departure::misprint,
         .correction =
             "\\overline{X}_{k_C} = \\frac{|V_{dk}|}{|V_{dj}|}\\left[\\sqrt{|V_{dj}|^2-(\\beta U_{dj})^2}\\cos\\Delta + "
             "\\beta U_{dj}\\sin\\Delta\\right] - \\beta G_k,\\quad \\Delta=\\angle V_{dk}-\\angle V_{dj}"},
        {.id = "50/cosine",
         .equations = {"50"},
         .role = Role::shipped,
         .title = "Factor of the cosine is the displacement at tau = 0",
         .assumptions = sliding,
         .kernel =
             [&s] {
                 return Values{paper::monoharmonic_cosine(symbolic_V_k(), symbolic_V_j(), Symbolic(s.U_j), Symbolic(s.G_k),
                                                          Symbolic(s.beta))};
             },
         .derived = [] { return std::vector<ex>{derived_initial_state().first}; },
         .steps = {{"The factor of $\\cos\\tau$ in (48) is (44)", ""}}},
        {.id = "51/sine",
         .equations = {"51"},
         .title = "Factor of the sine is the velocity at tau = 0",
         .assumptions = sliding,
         .kernel =
             [&s] {
                 return Values{paper::monoharmonic_sine(symbolic_V_k(), symbolic_V_j(), Symbolic(s.U_j), Symbolic(s.U_k),
                                                        Symbolic(s.beta))};
             },
         .derived = [] { return std::vector<ex>{derived_initial_state().second}; },
         .steps = {{"The factor of $\\sin\\tau$ in (48) is (45)", ""}}},
        {.id = "52/printed",
         .equations = {"52"},
         .role = Role::printed,
         .title = "Square of the monoharmonic amplitude with + U_dk sin(Delta)",
         .assumptions = sliding,
         .kernel =
             [&s] {
                 return Values{square(as_printed::displacement_transmissibility(
                     symbolic_V_k(), symbolic_V_j(), Symbolic(s.U_j), Symbolic(s.U_k), Symbolic(s.G_k), Symbolic(s.beta)))};
             },
         .derived =
             [] {
                 const auto [x, rate] = derived_initial_state();
                 return std::vector<ex>{x * x + rate * rate};
             },
         .departure = Departure::misprint,
         .correction = "\\overline{X}_k \\cong \\Big\\{|V_{dk}|^2 + \\beta^2(G_k^2+U_{dk}^2) - 2\\beta\\tfrac{|V_{dk}|}{|V_{dj}|}"
                       "\\Big[\\sqrt{|V_{dj}|^2-(\\beta U_{dj})^2}(G_k\\cos\\Delta - U_{dk}\\sin\\Delta) + \\beta "
                       "U_{dj}(G_k\\sin\\Delta + U_{dk}\\cos\\Delta)\\Big]\\Big\\}^{1/2}"},
        {.id = "52/amplitude",
         .equations = {"52"},
         .role = Role::shipped,
         .title = "Square of the amplitude of the monoharmonic motion, with - U_dk sin(Delta)",
         .assumptions = sliding,
         .kernel =
             [&s] {
                 return Values{square(paper::displacement_transmissibility(symbolic_V_k(), symbolic_V_j(), Symbolic(s.U_j),
                                                                           Symbolic(s.U_k), Symbolic(s.G_k), Symbolic(s.beta)))};
             },
         .derived =
             [] {
                 const auto [x, rate] = derived_initial_state();
                 return std::vector<ex>{x * x + rate * rate};
             },
         .approximation = true,
         .steps = {{"The squares of (50) and (51) are added; $\\cos^2\\Delta+\\sin^2\\Delta=1$ with $\\Delta=\\angle "
                    "V_{dk}-\\angle V_{dj}$",
                    ""}}},
        {.id = "52/contact",
         .equations = {"52", "38"},
         .role = Role::step,
         .title = "For k = j the square of (52) is the square of (38)",
         .assumptions = sliding,
         .kernel =
             [&s] {
                 return Values{square(paper::displacement_transmissibility(symbolic_V_j(), symbolic_V_j(), Symbolic(s.U_j),
                                                                           Symbolic(s.U_j), Symbolic(s.G_j), Symbolic(s.beta)))};
             },
         .derived =
             [&s] {
                 const ex root = GiNaC::sqrt(s.V_jr * s.V_jr + s.V_ji * s.V_ji - s.beta * s.beta * s.U_j * s.U_j);
                 return std::vector<ex>{GiNaC::pow(root - s.beta * s.G_j, 2)};
             },
         .special_case = true},
        {.id = "53/phase",
         .equations = {"53"},
         .title = "The angle with cosine X_kC / X_k and sine X_kS / X_k is the instant of the monoharmonic maximum",
         .assumptions = {"X_kC and X_kS not both zero"},
         .kernel =
             [&s] {
                 const ex phi_kj = paper::phase_behind_contact(Symbolic(s.x_k0), Symbolic(s.x_prime_k0)).expression();
                 const ex X = GiNaC::sqrt(s.x_k0 * s.x_k0 + s.x_prime_k0 * s.x_prime_k0);
                 return Values{Symbolic(X * GiNaC::cos(s.tau - phi_kj))};
             },
         .derived = [&s] { return std::vector<ex>{derived_motion_from_start().subs(s.beta == 0)}; },
         .approximation = true,
         .steps = {{"$\\overline{X}_{k_C}\\cos\\tau+\\overline{X}_{k_S}\\sin\\tau$ is $\\overline{X}_k\\cos(\\tau-\\phi_{kj})$ "
                    "for the angle with this cosine and sine",
                    ""}}},
    };
});

} // namespace
} // namespace denhartog::derivation

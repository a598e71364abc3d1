// The forms that callers get, each equal to the paper's formula as a function of its symbols.
#include "denhartog/evaluation/contact.hpp"
#include "denhartog/evaluation/friction_motion.hpp"
#include "denhartog/evaluation/resonance.hpp"

#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/claim.hpp"

namespace denhartog::derivation {

using GiNaC::ex;

namespace {

const Register claims_of_evaluation_forms([] {
    const Symbols& s = symbols();
    const std::vector<std::string> domain{"R_i > 0", "0 <= zeta_i < 1"};
    const auto response = [&s] {
        const Complex<Symbolic> v = paper::complex_response(Symbolic(s.R), Symbolic(s.zeta));
        return std::vector<ex>{v.re.expression(), v.im.expression()};
    };
    const auto damping = [&s] {
        return std::vector<ex>{paper::first_damping_function(Symbolic(s.R), Symbolic(s.zeta)).expression(),
                               paper::second_damping_function(Symbolic(s.R), Symbolic(s.zeta)).expression()};
    };
    const auto parts = [](const Complex<Symbolic>& v) { return Values{v.re, v.im}; };
    const auto values = [](const evaluation::DampingFunctions<Symbolic>& f) { return Values{f.u, f.g}; };
    const std::vector<std::string> sliding{"sliding regime, beta |U_dj| <= |V_dj|", "V_dj not zero"};
    const Symbolic U_j(s.U_j), beta(s.beta);
    const auto root = [&s] {
        return std::vector<ex>{GiNaC::sqrt(s.V_jr * s.V_jr + s.V_ji * s.V_ji - s.beta * s.beta * s.U_j * s.U_j)};
    };
    const auto any = [](const char* name, const char* latex) { return Symbolic(new_symbol(name, latex, -1, 1)); };
    const evaluation::RootParts<Symbolic> as_rounded{any("b", "b"),     any("re_2", "a_1"), any("im_2", "a_2"),
                                                     any("b_2", "a_3"), any("d", "a_4"),    any("all", "a_5")};
    const Symbolic R(s.R), zeta(s.zeta), scale(new_symbol("scale", "\\lambda", GiNaC::numeric(2), GiNaC::numeric(64)));
    return std::vector<Claim>{
        {.id = "evaluation/response-off-resonance",
         .equations = {"23"},
         .role = Role::shipped,
         .title = "The response function divided by its real part, with any scale",
         .assumptions = {"R_i > 0", "0 <= zeta_i < 1", "R_i not 1"},
         .kernel = [=] { return parts(evaluation::complex_response_off_resonance(R, zeta, scale)); },
         .derived = response},
        {.id = "evaluation/response-near-resonance",
         .equations = {"23"},
         .role = Role::shipped,
         .title = "The response function divided by its imaginary part",
         .assumptions = {"R_i > 0", "0 < zeta_i < 1"},
         .kernel = [=] { return parts(evaluation::complex_response_near_resonance(R, zeta)); },
         .derived = response},
        {.id = "evaluation/response-high-frequency",
         .equations = {"23"},
         .role = Role::shipped,
         .title = "The response function in 1 / R",
         .assumptions = domain,
         .kernel = [=] { return parts(evaluation::complex_response_high_frequency(R, zeta)); },
         .derived = response},
        {.id = "evaluation/half-angle",
         .equations = {"28", "29"},
         .role = Role::shipped,
         .title = "Damping functions in decaying exponentials and half angles",
         .assumptions = domain,
         .kernel = [=] { return values(evaluation::damping_functions_half_angle(R, zeta, evaluation::half_angle(R, zeta))); },
         .derived = damping},
        {.id = "evaluation/half-angle-of-heavy-damping",
         .equations = {"28", "29"},
         .role = Role::shipped,
         .title = "Damping functions, the half angle as a product",
         .assumptions = domain,
         .kernel =
             [=] {
                 return values(
                     evaluation::damping_functions_half_angle(R, zeta, evaluation::half_angle_of_heavy_damping(R, zeta)));
             },
         .derived = damping},
        {.id = "evaluation/slight-damping",
         .equations = {"28", "29"},
         .role = Role::shipped,
         .title = "Damping functions with delta taken out of the numerator of (29), with any scale",
         .assumptions = {"R_i > 0", "0 < zeta_i < 1"},
         .kernel =
             [=] {
                 return values(evaluation::damping_functions_slight_damping(R, zeta, evaluation::half_angle(R, zeta), scale));
             },
         .derived = damping},
        {.id = "evaluation/small-argument",
         .equations = {"28", "29"},
         .role = Role::shipped,
         .title = "Damping functions with the difference in (29) as one function, with any scale",
         .assumptions = {"R_i > 0", "0 < zeta_i < 1"},
         .kernel =
             [=] {
                 return values(evaluation::damping_functions_small_argument(R, zeta, evaluation::half_angle(R, zeta), scale));
             },
         .derived = damping},
        {.id = "evaluation/without-damping",
         .equations = {"28", "29"},
         .role = Role::shipped,
         .title = "Both forms that the selection takes at zeta = 0: the limits of (28) and (29) there",
         .assumptions = {"R_i > 0, not 1/n, n odd", "zeta_i = 0"},
         .kernel =
             [=] {
                 const Symbolic none(ex(0));
                 const evaluation::HalfAngle<Symbolic> h = evaluation::half_angle(R, none);
                 Values both = values(evaluation::damping_functions_slight_damping(R, none, h, scale));
                 for (const Symbolic& value : values(evaluation::damping_functions_small_argument(R, none, h, scale)))
                     both.push_back(value);
                 return both;
             },
         .derived =
             [&s] {
                 const ex theta = GiNaC::Pi / s.R, u = GiNaC::sin(theta) / (s.R * (1 + GiNaC::cos(theta)));
                 return std::vector<ex>{u, 0, u, 0};
             },
         .special_case = true},
        {.id = "evaluation/at-resonance",
         .equations = {"28", "29"},
         .role = Role::shipped,
         .title = "Damping functions at R = 1 with the powers of zeta taken out",
         .assumptions = {"R_i = 1", "0 < zeta_i < 1"},
         .kernel = [=] { return values(evaluation::damping_functions_at_resonance(zeta)); },
         .derived =
             [&s] {
                 return std::vector<ex>{paper::first_damping_function(Symbolic(1), Symbolic(s.zeta)).expression(),
                                        paper::second_damping_function(Symbolic(1), Symbolic(s.zeta)).expression()};
             }},
        {.id = "evaluation/one-minus-w",
         .equations = {"28", "29"},
         .role = Role::shipped,
         .title = "1 - sqrt(1 - zeta^2) without cancellation, as the half angle takes it",
         .assumptions = {"0 <= zeta_i < 1"},
         .kernel = [&s] { return Values{evaluation::one_minus_w<Symbolic>(Symbolic(s.zeta))}; },
         .derived = [&s] { return std::vector<ex>{1 - s.w}; }},
        {.id = "evaluation/friction-motion",
         .equations = {"40", "A.8", "A.9"},
         .role = Role::shipped,
         .title = "The braces of (40) with two derivatives, 1 - d without its cancellation",
         .assumptions = {"R_i > 0", "0 <= zeta_i < 1", "0 <= tau <= pi"},
         .kernel =
             [&s] {
                 const Symbolic x(s.tau / s.R), zeta(s.zeta), w = evaluation::oscillating_w(zeta);
                 const evaluation::FreeMotion<Symbolic> free =
                     evaluation::oscillating_free_motion(Symbolic(s.tau), Symbolic(s.R), zeta, w);
                 const evaluation::FrictionMotion<Symbolic> f = evaluation::friction_motion_of(
                     free, evaluation::one_minus_d_half_angle(x, zeta, w, free.q), Symbolic(s.R), Symbolic(s.u), Symbolic(s.g));
                 return Values{f.value, f.prime, f.double_prime};
             },
         .derived =
             [&s] {
                 const ex value =
                     paper::friction_motion(Symbolic(s.tau), Symbolic(s.R), Symbolic(s.zeta), Symbolic(s.u), Symbolic(s.g))
                         .expression();
                 const GiNaC::symbol& tau = GiNaC::ex_to<GiNaC::symbol>(s.tau);
                 return std::vector<ex>{value, value.diff(tau), value.diff(tau, 2)};
             }},
        {.id = "evaluation/square-of-root",
         .equations = {"36", "38"},
         .role = Role::shipped,
         .title = "The square of the root of (38) from products and sums with any rounding, what each took given back",
         .assumptions = sliding,
         .kernel = [=] { return Values{evaluation::square_of_root<true>(symbolic_V_j(), U_j, beta, as_rounded)}; },
         .derived = [&s] { return std::vector<ex>{s.V_jr * s.V_jr + s.V_ji * s.V_ji - s.beta * s.beta * s.U_j * s.U_j}; }},
        {.id = "evaluation/rest-of-a-sum",
         .equations = {"36", "38"},
         .role = Role::shipped,
         .title = "The rounding error of a sum, in exact arithmetic: the sum less its rounded value",
         .kernel = [=] { return Values{evaluation::sum_error<Symbolic>(as_rounded.b, as_rounded.re_2, as_rounded.im_2)}; },
         .derived =
             [=] {
                 return std::vector<ex>{as_rounded.b.expression() + as_rounded.re_2.expression() - as_rounded.im_2.expression()};
             },
         .special_case = true}, // an operation may be exchanged there and the rest stays: it matters to roundings alone
        {.id = "evaluation/sum-with-rests",
         .equations = {"73"},
         .role = Role::shipped,
         .title = "The sum of a row of the stiffness matrix, each addition with any rounding, what it took given back",
         .kernel =
             [=] {
                 const evaluation::SumWithRest<Symbolic> s =
                     evaluation::with_term<Symbolic>({as_rounded.b, as_rounded.re_2}, as_rounded.im_2, as_rounded.all);
                 return Values{s.sum + s.rest};
             },
         .derived =
             [=] {
                 return std::vector<ex>{as_rounded.b.expression() + as_rounded.re_2.expression() + as_rounded.im_2.expression()};
             },
         .special_case = true}, // as with the rest of a sum
        {.id = "evaluation/root-with-rests",
         .equations = {"36", "38"},
         .role = Role::shipped,
         .title = "The root of (38) in number types that have the rests of their roundings",
         .assumptions = sliding,
         .kernel = [=] { return Values{evaluation::contact_root<Symbolic, true>(symbolic_V_j(), U_j, beta)}; },
         .derived = root,
         .special_case = true}, // the parts may be anything: what they lack is given back
        {.id = "evaluation/root-without-rests",
         .equations = {"36", "38"},
         .role = Role::shipped,
         .title = "The root of (38) in number types without",
         .assumptions = sliding,
         .kernel = [=] { return Values{evaluation::contact_root<Symbolic, false>(symbolic_V_j(), U_j, beta)}; },
         .derived = root},
        {.id = "evaluation/amplitude-of-contact",
         .equations = {"38"},
         .role = Role::shipped,
         .title = "(38) from the root whose square that is",
         .assumptions = sliding,
         .kernel =
             [=, &s] {
                 return Values{evaluation::displacement_transmissibility_of_contact(symbolic_V_j(), U_j, Symbolic(s.G_j), beta)};
             },
         .derived =
             [=, &s] {
                 const Symbolic X = paper::displacement_transmissibility_of_contact(symbolic_V_j(), U_j, Symbolic(s.G_j), beta);
                 return std::vector<ex>{X.expression()};
             }},
        {.id = "evaluation/phase-of-contact",
         .equations = {"39"},
         .role = Role::shipped,
         .title = "The phase with the root in place of the cosine: sine and cosine of its sum with the argument of V_dj",
         .assumptions = sliding,
         .kernel =
             [=, &s] {
                 const ex phi = evaluation::phase_of_contact(symbolic_V_j(), U_j, beta).expression();
                 const ex angle = GiNaC::atan2(s.V_ji, s.V_jr);
                 return Values{Symbolic(GiNaC::cos(phi + angle)), Symbolic(GiNaC::sin(phi + angle))};
             },
         .derived =
             [&s] {
                 const ex modulus = GiNaC::sqrt(s.V_jr * s.V_jr + s.V_ji * s.V_ji), sine = s.beta * s.U_j / modulus;
                 return std::vector<ex>{GiNaC::sqrt(1 - sine * sine), -sine};
             }},
        {.id = "evaluation/second-function-at-resonance",
         .equations = {"79", "80"},
         .role = Role::shipped,
         .title = "(79) and (80) as hyperbolic cotangents of half the argument",
         .assumptions = {"zeta_i > 0"},
         .kernel =
             [&s] {
                 return Values{
                     evaluation::second_damping_function_at_resonance(Symbolic(s.zeta)),
                     evaluation::second_damping_function_at_resonance(Symbolic(s.psi_ki), Symbolic(s.psi_ji), Symbolic(s.zeta))};
             },
         .derived =
             [&s] {
                 return std::vector<ex>{
                     paper::second_damping_function_at_resonance(Symbolic(s.zeta)).expression(),
                     paper::second_damping_function_at_resonance(Symbolic(s.psi_ki), Symbolic(s.psi_ji), Symbolic(s.zeta))
                         .expression()};
             }},
        {.id = "evaluation/peak",
         .equations = {"83", "84"},
         .role = Role::shipped,
         .title = "The resonant peak as a cotangent times the distance from (85)",
         .assumptions = {"zeta_i > 0"},
         .kernel =
             [&s] {
                 return Values{evaluation::resonant_peak(Symbolic(s.psi_ki), Symbolic(s.psi_li), Symbolic(s.psi_ji),
                                                         Symbolic(s.zeta), Symbolic(s.beta)),
                               evaluation::resonant_peak_of_single_mass(Symbolic(s.zeta), Symbolic(s.beta))};
             },
         .derived =
             [&s] {
                 return std::vector<ex>{paper::resonant_peak(Symbolic(s.psi_ki), Symbolic(s.psi_li), Symbolic(s.psi_ji),
                                                             Symbolic(s.zeta), Symbolic(s.beta))
                                            .expression(),
                                        paper::resonant_peak_of_single_mass(Symbolic(s.zeta), Symbolic(s.beta)).expression()};
             }},
        {.id = "evaluation/limit-at-resonance",
         .equations = {"85"},
         .role = Role::shipped,
         .title = "(85) with sinh(x) / x, which has a value at zeta = 0",
         .assumptions = {"zeta_i > 0", "psi_ji not zero"},
         .kernel =
             [&s] {
                 return Values{
                     evaluation::friction_ratio_limit_at_resonance(Symbolic(s.psi_li), Symbolic(s.psi_ji), Symbolic(s.zeta))};
             },
         .derived =
             [&s] {
                 const Symbolic psi_li(s.psi_li), psi_ji(s.psi_ji);
                 return std::vector<ex>{paper::friction_ratio_limit_at_resonance(psi_li, psi_ji, Symbolic(s.zeta)).expression()};
             }},
    };
});

} // namespace
} // namespace denhartog::derivation

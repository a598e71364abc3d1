// Section 2.6, (54)-(66), (70)-(72): what the sliding solution asks for. The limits are in section_2_6_limits.cpp, the bounds and
// observations of the text in observations/.
#include "denhartog/formulas/as_printed.hpp"
#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/contact.hpp"
#include "denhartog/formulas/superposition.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/claim.hpp"
#include "derivation/paper/derived.hpp"
#include "derivation/paper/modal_sums.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::lst;

namespace {

ex rate(const ex& e) { return e.diff(GiNaC::ex_to<GiNaC::symbol>(symbols().tau)); }

/// Initial values of N modes as symbols of their own; the last velocity makes x_j'(0) = 0, (30).
std::vector<std::pair<ex, ex>> starts_at_rest(int N) {
    static const std::vector<std::pair<ex, ex>> free = [] {
        std::vector<std::pair<ex, ex>> f;
        for (int i = 1; i <= 3; ++i)
            f.emplace_back(new_symbol("eta_0" + std::to_string(i), "\\eta_{" + std::to_string(i) + "0}", -1, 1),
                           new_symbol("eta_prime_0" + std::to_string(i), "\\eta'_{" + std::to_string(i) + "0}", -1, 1));
        return f;
    }();
    const SymbolicModes m = symbolic_modes(N);
    std::vector<std::pair<ex, ex>> starts(free.begin(), free.begin() + N);
    ex others = 0;
    for (int i = 0; i + 1 < N; ++i) others += m.psi_j[i].expression() * starts[i].second;
    starts.back().second = -others / m.psi_j.back().expression();
    return starts;
}

ex derived_amplitude(int N) {
    const SymbolicModes m = symbolic_modes(N);
    ex X = 0;
    for (int i = 0; i < N; ++i) X += m.psi_j[i].expression() * starts_at_rest(N)[i].first;
    return X;
}

/// -x_j'(tau) / sin(tau) from the sum of the modes' motions.
ex derived_margin(int N) {
    return -rate(derived_displacement_of_mass(N, Row::contact, starts_at_rest(N))) / GiNaC::sin(symbols().tau);
}

/// The contribution of one mode to the condition, from the velocity of a system with that mode alone.
ex derived_s_d() {
    const Symbols& s = symbols();
    const ex alone = derived_modal_displacement().subs(s.eta_prime_0 == 0);
    return (s.eta_0 + s.psi_ji * s.R * s.R * s.g * s.beta + rate(alone) / GiNaC::sin(s.tau)) / (s.beta * s.psi_ji);
}

/// Its limit for tau -> 0: numerator and sin(tau) both vanish there, so that the limit is the quotient of their rates.
ex derived_s_d_at_zero() {
    const Symbols& s = symbols();
    const ex numerator = (derived_s_d() * GiNaC::sin(s.tau)).expand();
    if (!remainder(numerator.subs(s.tau == 0), domain_of({numerator})).is_zero())
        throw std::logic_error("the numerator of (57) does not vanish at tau = 0");
    return rate(numerator).subs(s.tau == 0);
}

const auto shipped_integrand = [](auto&&... arguments) { return paper::s_d_integrand(arguments...); };
const auto printed_integrand = [](auto&&... arguments) { return as_printed::s_d_integrand(arguments...); };

/// The expression of (57) for N modes, from the template given.
template <class Integrand>
std::vector<Symbolic> integrands(int N, const Integrand& s_d_integrand) {
    const SymbolicModes m = symbolic_modes(N);
    std::vector<Symbolic> values;
    for (int i = 0; i < N; ++i) values.push_back(s_d_integrand(Symbolic(symbols().tau), m.R[i], m.zeta[i], m.u[i], m.g[i]));
    return values;
}

Values margin(int N) {
    const SymbolicModes m = symbolic_modes(N);
    return {paper::sliding_margin(
        Symbolic(derived_amplitude(N)), paper::damping_function_of_mass<Symbolic>(m.psi_j, m.psi_j, m.R, m.g),
        paper::sum_over_contact<Symbolic>(m.psi_j, integrands(N, shipped_integrand)), Symbolic(symbols().beta))};
}

const Register claims_of_section_2_6_domain_of_validity([] {
    const Symbols& s = symbols();
    const std::vector<std::string> domain{"R_i > 0", "0 <= zeta_i < 1", "0 < tau < pi"};
    const std::vector<std::string> mode_domain{"R_i > 0", "0 <= zeta_i < 1"};
    const auto s_d = [] { return std::vector<ex>{derived_s_d()}; };
    const auto s_d_0 = [] { return std::vector<ex>{derived_s_d_at_zero()}; };
    const auto kernel_arguments = [&s](const auto& kernel) {
        return Values{kernel(Symbolic(s.tau), Symbolic(s.R), Symbolic(s.zeta), Symbolic(s.u), Symbolic(s.g))};
    };
    const auto at_start = [](const Values& values) {
        return Values{Symbolic(values.front().expression().normal().subs(symbols().tau == 0))};
    };
    std::vector<Claim> list{
        {.id = "57/printed",
         .equations = {"57"},
         .role = Role::printed,
         .title = "The expression under the maximum as printed, for a system with one mode",
         .assumptions = domain,
         .kernel = [kernel_arguments] { return kernel_arguments(printed_integrand); },
         .derived = s_d,
         .departure = Departure::misprint,
         .correction_left = {"s_{di} = \\sup_{0<\\tau<\\pi} s_i(\\tau), \\quad s_i(\\tau)"}},
        {.id = "57/integrand",
         .equations = {"57"},
         .role = Role::shipped,
         .title = "The expression under the maximum, for a system with one mode",
         .assumptions = domain,
         .kernel = [kernel_arguments] { return kernel_arguments(shipped_integrand); },
         .derived = s_d,
         .steps = {{"With one mode the velocity of the contact is that of the mode, started with no velocity; it is divided by "
                    "-sin(tau) and "
                    "solved for what friction adds",
                    "-\\frac{\\bar{x}_j'}{\\sin\\tau} = \\overline{X}_j + \\beta G_j - \\beta\\psi_{ji}^2s_i(\\tau)"},
                   step("which is", "s_i(\\tau)", derived_s_d())}},
        {.id = "70/printed",
         .equations = {"70"},
         .role = Role::printed,
         .title = "The expansion as printed, in the limit tau -> 0",
         .assumptions = mode_domain,
         .kernel = [kernel_arguments,
                    at_start] { return at_start(kernel_arguments([](auto&&... a) { return as_printed::s_d_expansion(a...); })); },
         .derived = s_d_0,
         .departure = Departure::misprint,
         .correction = "s_{di} \\simeq \\frac{1}{\\tau}\\left\\{(1+g_i)\\left(1-\\frac{\\zeta_i\\tau}{R_i}\\right)\\tau - "
                       "u_{di}R_i^2\\left[\\left(1-\\frac{\\zeta_i\\tau}{R_i}\\right)^2-1\\right]\\right\\}"},
        {.id = "70/expansion",
         .equations = {"70"},
         .role = Role::shipped,
         .title = "The expansion has the limit of (57) for tau -> 0; the error is of first order in tau",
         .assumptions = mode_domain,
         .kernel = [kernel_arguments,
                    at_start] { return at_start(kernel_arguments([](auto&&... a) { return paper::s_d_expansion(a...); })); },
         .derived = s_d_0,
         .approximation = true,
         .special_case = true},
        {.id = "71/limit",
         .equations = {"71"},
         .title = "Value of (57)'s expression for tau -> 0",
         .assumptions = mode_domain,
         .kernel = [&s] { return Values{paper::s_d_at_zero(Symbolic(s.R), Symbolic(s.zeta), Symbolic(s.u), Symbolic(s.g))}; },
         .derived = s_d_0,
         .approximation = true,
         .steps = {{"Numerator and sin(tau) both vanish at tau = 0; the limit is the quotient of their rates", ""},
                   step("The rate of the numerator at tau = 0", "\\lim_{\\tau\\to0}s_i", derived_s_d_at_zero())}},
        {.id = "60/phase-of-mode",
         .equations = {"60"},
         .title = "Cosine and sine of the phase with the argument of v_di",
         .assumptions = {"psi_li not zero", "v_di not zero"},
         .kernel =
             [&s] {
                 const Complex<Symbolic> v{Symbolic(s.V_jr), Symbolic(s.V_ji)};
                 const auto [eta_0, rate_0] = derived_start(s.V_jr, s.V_ji, GiNaC::cos(s.phi_j), GiNaC::sin(s.phi_j));
                 const InitialValues<Symbolic> start{Symbolic(eta_0), Symbolic(rate_0)};
                 return Values{paper::v_cosine(symbolic_mode(), start, Symbolic(s.g), Symbolic(s.beta)) / modulus(v),
                               paper::v_sine(symbolic_mode(), start, Symbolic(s.u), Symbolic(s.beta)) / modulus(v)};
             },
         .derived =
             [&s] {
                 const ex angle = s.phi_j + GiNaC::atan2(s.V_ji, s.V_jr);
                 return std::vector<ex>{GiNaC::cos(angle), GiNaC::sin(angle)};
             },
         .steps = {{"(26) and (27) with modulus and argument of $v_{di}$, as (36) and (37) for the mass", ""}}},
        {.id = "61/argument",
         .equations = {"61"},
         .title = "Cosine and sine of the argument of v_di",
         .assumptions = mode_domain,
         .kernel =
             [&s] {
                 const auto [re, im] = derived_complex_response();
                 const Complex<Symbolic> v{Symbolic(re), Symbolic(im)};
                 return Values{paper::cosine_of_response_argument(v, Symbolic(s.R)),
                               paper::sine_of_response_argument(v, Symbolic(s.R), Symbolic(s.zeta))};
             },
         .derived =
             [] {
                 const auto [re, im] = derived_complex_response();
                 const ex angle = GiNaC::atan2(im, re);
                 return std::vector<ex>{GiNaC::cos(angle), GiNaC::sin(angle)};
             },
         .steps = {{"The argument of (23): cosine and sine are real and imaginary part over the modulus", ""}}},
        {.id = "62/cosine-of-phase",
         .equations = {"62"},
         .title = "cos(phi_j) from the initial values of a mode",
         .assumptions = {"R_i > 0", "0 <= zeta_i < 1", "psi_li not zero"},
         .kernel =
             [&s] {
                 const auto [re, im] = derived_complex_response();
                 const auto [eta_0, rate_0] = derived_start(re, im, GiNaC::cos(s.phi_j), GiNaC::sin(s.phi_j));
                 return Values{paper::cosine_of_phase(symbolic_mode(), InitialValues<Symbolic>{Symbolic(eta_0), Symbolic(rate_0)},
                                                      Symbolic(s.u), Symbolic(s.g), Symbolic(s.beta))};
             },
         .derived = [&s] { return std::vector<ex>{GiNaC::cos(s.phi_j)}; },
         .steps = {{"(26) and (27) are solved for $\\cos\\phi_j$: $[v_{di}\\cos\\phi_j]$ and $[v_{di}\\sin\\phi_j]$ are "
                    "multiplied by $1-R_i^2$ and "
                    "$-2\\zeta_iR_i$ and added",
                    ""}}},
        {.id = "63/load-of-mode",
         .equations = {"63", "59"},
         .role = Role::shipped,
         .title = "The contribution of a mode to the load on the contact at tau = 0, with (62) put in",
         .assumptions = {"R_i > 0", "0 <= zeta_i < 1", "psi_li not zero"},
         .kernel =
             [&s] {
                 return Values{paper::modal_contact_load_by_functions(symbolic_mode(), Symbolic(s.eta_0), Symbolic(s.u),
                                                                      Symbolic(s.g), Symbolic(s.beta))};
             },
         .derived =
             [&s] {
                 // inertia and friction carry what the load does not: psi_ji beta - eta''(0) by (20)
                 const ex motion = derived_modal_displacement();
                 return std::vector<ex>{s.psi_ji * s.beta - rate(rate(motion)).subs(s.tau == 0)};
             },
         .steps = {{"By (20) damping, stiffness and load of a mode together are $\\psi_{ji}\\beta-\\eta_i''(0)$; $\\eta_i''$ is "
                    "taken from (40)",
                    ""}}},
        {.id = "59/load-of-mode",
         .equations = {"59"},
         .role = Role::shipped,
         .title = "The contribution of a mode to the load on the contact at tau = 0, from (20)",
         .assumptions = mode_domain,
         .kernel =
             [&s] {
                 const auto c = Symbolic(GiNaC::cos(s.phi_j));
                 return Values{paper::modal_contact_load(symbolic_mode(), symbolic_start(), c)};
             },
         .derived =
             [&s] {
                 const ex motion = in_phi_j(derived_displacement());
                 return std::vector<ex>{s.psi_ji * s.beta - rate(rate(motion)).subs(s.tau == 0)};
             },
         .steps = {{"By (20) damping, stiffness and load of a mode together are $\\psi_{ji}\\beta-\\eta_i''(0)$; $\\eta_i''$ is "
                    "taken from (A.6)",
                    ""}}},
    };
    for (int N = 1; N <= 2; ++N) { // for every N: one_more_mode.cpp
        const std::string of_N = "/N=" + std::to_string(N);
        std::vector<std::string> modes = domain;
        modes.push_back("N = " + std::to_string(N) + " modes");
        list.push_back({.id = "56/sum" + of_N,
                        .equations = {"56"},
                        .role = Role::shipped,
                        .title = "X_j + beta G_j has to exceed, at one tau, beta times the sum over the modes at that tau",
                        .assumptions = modes,
                        .kernel =
                            [N] {
                                const SymbolicModes m = symbolic_modes(N);
                                return Values{paper::sum_over_contact<Symbolic>(m.psi_j, integrands(N, shipped_integrand))};
                            },
                        .derived =
                            [N, &s] {
                                const SymbolicModes m = symbolic_modes(N);
                                ex G = 0;
                                for (int i = 0; i < N; ++i)
                                    G += GiNaC::pow(m.psi_j[i].expression() * m.R[i].expression(), 2) * m.g[i].expression();
                                return std::vector<ex>{(derived_amplitude(N) + s.beta * G - derived_margin(N)) / s.beta};
                            },
                        .steps = {{"$-\\bar{x}_j'/\\sin\\tau$ is a sum over the modes; what is not $\\overline{X}_j+\\beta G_j$ "
                                   "in it is $\\beta$ times the sum of (57)",
                                   ""}}});
        list.push_back({.id = "54/velocity" + of_N,
                        .equations = {"54", "55"},
                        .title = "-x_j' / sin(tau) is X_j + beta G_j - beta S with the sum over the modes at the same tau",
                        .assumptions = modes,
                        .kernel = [N] { return margin(N); },
                        .derived = [N] { return std::vector<ex>{derived_margin(N)}; },
                        .steps = {{"The velocity of the contact is the sum of the rates of (40), with $\\bar{x}_j'(0)=0$, (30); "
                                   "it is divided by $-\\sin\\tau$",
                                   ""}}});
        list.push_back(
            {.id = "66/load" + of_N,
             .equations = {"64", "66"},
             .title = "The load on the contact at tau = 0, over gamma_j r^2: sum of the modes' contributions",
             .assumptions = modes,
             .kernel =
                 [N, &s] {
                     const SymbolicModes m = symbolic_modes(N);
                     return Values{paper::contact_load_at_start(
                         Symbolic(derived_amplitude(N)), paper::damping_function_of_mass<Symbolic>(m.psi_j, m.psi_j, m.R, m.g),
                         paper::H<Symbolic>(m.psi_j, m.R, m.zeta, m.u, m.g), Symbolic(s.beta))};
                 },
             .derived =
                 [N, &s] {
                     const SymbolicModes m = symbolic_modes(N);
                     ex load = -rate(rate(derived_displacement_of_mass(N, Row::contact, starts_at_rest(N)))).subs(s.tau == 0);
                     for (const Symbolic& psi : m.psi_j) load += psi.expression() * psi.expression() * s.beta;
                     return std::vector<ex>{load};
                 },
             .steps = {{"$\\psi_{ji}$ times the loads (63) of the modes are summed, with (64) and $\\overline{X}_j$, "
                        "$G_j$ of (30) and (35)",
                        ""}}});
        list.push_back({.id = "72/sum-at-zero" + of_N,
                        .equations = {"72"},
                        .title = "The sum of (71) over the modes is H_j plus the sum of squares (65)",
                        .assumptions = modes,
                        .kernel =
                            [N] {
                                const SymbolicModes m = symbolic_modes(N);
                                ex squares = 0;
                                for (const Symbolic& psi : m.psi_j) squares += psi.expression() * psi.expression();
                                return Values{paper::static_friction_demand(paper::H<Symbolic>(m.psi_j, m.R, m.zeta, m.u, m.g),
                                                                            Symbolic(1), Symbolic(squares))};
                            },
                        .derived =
                            [N, &s] {
                                const SymbolicModes m = symbolic_modes(N);
                                ex sum = 0;
                                for (int i = 0; i < N; ++i)
                                    sum += GiNaC::pow(m.psi_j[i].expression(), 2) *
                                           derived_s_d_at_zero().subs(
                                               lst{s.R == m.R[i].expression(), s.zeta == m.zeta[i].expression(),
                                                   s.u == m.u[i].expression(), s.g == m.g[i].expression()});
                                return std::vector<ex>{sum};
                            },
                        .approximation = true,
                        .special_case = true,
                        .steps = {{"(71) is multiplied by $\\psi_{ji}^2$ and summed; (64) and (65) name the sums", ""}}});
    }
    return list;
});

} // namespace
} // namespace denhartog::derivation

// Section 4.3, (87), (88): invariant points and permanent sticking. What the text has observed is in stuck_observations.cpp.
#include "denhartog/evaluation/contact.hpp"
#include "denhartog/formulas/mode.hpp"
#include "denhartog/formulas/other_masses.hpp"
#include "denhartog/formulas/stuck.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/claim.hpp"
#include "derivation/claims/provenance.hpp"
#include "derivation/paper/modal_sums.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::lst;
using GiNaC::matrix;

namespace {

/// The square of the monoharmonic amplitude (48) from the initial values, without damping: V real, G = 0.
ex undamped_square() {
    const Symbols& s = symbols();
    const auto [x, rate] = derived_initial_state();
    return (x * x + rate * rate).subs(lst{s.V_ji == 0, s.V_ki == 0, s.G_k == 0});
}

/// A chain of three with its contact on the second mass, as (6) has it: rows of M, C and K, each entry a symbol.
struct HeldChain {
    ex kappa_2, kappa_3;        ///< springs on both sides of the contact
    std::vector<ex> X_re, X_im; ///< complex amplitudes of the first and the third mass
    ex C_21, C_23;              ///< row of the damping matrix
};

const HeldChain& held_chain() {
    static const HeldChain chain = [] {
        const SymbolicModes m = symbolic_modes(3);
        return HeldChain{symbols().k_1,
                         symbols().k_i,
                         {m.u[0].expression(), m.u[1].expression()},
                         {m.psi_k[0].expression(), m.psi_k[1].expression()},
                         m.g[0].expression(),
                         m.g[1].expression()};
    }();
    return chain;
}

/// Load on the held contact as a function of tau, by row 2 of (6): x_2 = 0, x_k = Re{X_k exp(i tau)}. The stiffnesses come from
/// the energy of the chain's springs.
ex derived_load(const ex& direct, bool damping_force, const ex& ahead = 0) {
    const HeldChain& c = held_chain();
    const ex tau = symbols().tau;
    const GiNaC::symbol x_1("x1"), x_2("x2"), x_3("x3");
    const ex energy = c.kappa_2 * GiNaC::pow(x_2 - x_1, 2) / 2 + c.kappa_3 * GiNaC::pow(x_3 - x_2, 2) / 2;
    const auto motion = [&](int k) { return c.X_re[k] * GiNaC::cos(tau) - c.X_im[k] * GiNaC::sin(tau); };
    ex load = energy.diff(x_2).subs(lst{x_1 == motion(0), x_2 == 0, x_3 == motion(1)});
    const GiNaC::symbol t = GiNaC::ex_to<GiNaC::symbol>(tau);
    if (damping_force) load += c.C_21 * motion(0).diff(t) + c.C_23 * motion(1).diff(t);
    return from_premise() * load - direct * GiNaC::cos(tau) + ahead * GiNaC::sin(tau);
}

/// Factors of cos(tau) and -sin(tau).
std::pair<ex, ex> complex_amplitude(const ex& load) {
    return {load.subs(symbols().tau == 0), -load.subs(symbols().tau == GiNaC::Pi / 2)};
}

/// The amplitude over mu.
ex limit_of(const ex& load) {
    const auto [re, im] = complex_amplitude(load);
    return GiNaC::sqrt(re * re + im * im) / symbols().mu;
}

Complex<Symbolic> shipped_held_load(const ex& direct, const ex& ahead) {
    const HeldChain& c = held_chain();
    const std::vector<Symbolic> C_j{Symbolic(c.C_21), Symbolic(c.C_23)}, K_j{Symbolic(-c.kappa_2), Symbolic(-c.kappa_3)};
    std::vector<Complex<Symbolic>> X;
    for (int k = 0; k < 2; ++k) X.push_back({Symbolic(c.X_re[k]), Symbolic(c.X_im[k])});
    return paper::load_on_held_contact<Symbolic>(C_j, K_j, X, Complex<Symbolic>{Symbolic(direct), Symbolic(ahead)});
}

/// The three lines of (88); the masses on the other side of the contact at rest, and all of them where it bears the load itself.
Values lines_of_88() {
    const HeldChain& c = held_chain();
    const Symbolic mu(symbols().mu);
    const auto amplitude = [&c](int k) { return Symbolic(GiNaC::sqrt(c.X_re[k] * c.X_re[k] + c.X_im[k] * c.X_im[k])); };
    return {paper::sticking_limit_by_spring(Symbolic(c.kappa_2), amplitude(0), mu),
            paper::sticking_limit_by_spring(Symbolic(c.kappa_3), amplitude(1), mu), paper::sticking_limit_under_load(mu)};
}

std::vector<ex> derived_lines_of_88(bool damping_force) {
    const HeldChain& c = held_chain();
    const lst first_rests{c.X_re[0] == 0, c.X_im[0] == 0}, last_rests{c.X_re[1] == 0, c.X_im[1] == 0};
    const ex load = derived_load(0, damping_force);
    return {limit_of(load.subs(last_rests)), limit_of(load.subs(first_rests)),
            limit_of(derived_load(1, damping_force).subs(first_rests).subs(last_rests))};
}

const Register claims_of_section_4_3_stuck([] {
    const Symbols& s = symbols();
    const std::vector<std::string> undamped{"all zeta_i = 0: V real, G_k = 0", "V_j, U_k not zero", "beta |U_j| <= |V_j|"};
    const std::vector<std::string> held{"chain, M diagonal", "x_j = 0"};
    return std::vector<Claim>{
        {.id = "87/undamped",
         .equations = {"87", "29", "23"},
         .role = Role::step,
         .title = "Without damping g_i and the imaginary part of v_di vanish: G_k = 0, and V is real",
         .assumptions = {"R_i not 1/n with n odd"},
         .kernel =
             [&s] {
                 return Values{paper::second_damping_function(Symbolic(s.R), Symbolic(0)),
                               paper::complex_response(Symbolic(s.R), Symbolic(0)).im};
             },
         .derived =
             [] {
                 return std::vector<ex>{0, 0};
             },
         .special_case = true},
        {.id = "87/factor",
         .equations = {"87"},
         .title = "Without damping the square of the monoharmonic amplitude is V_k^2 + beta^2 U_k^2 times the left side",
         .assumptions = undamped,
         .kernel =
             [&s] {
                 return Values{
                     paper::invariant_point_function(Symbolic(s.V_kr), Symbolic(s.V_jr), Symbolic(s.U_k), Symbolic(s.U_j))};
             },
         .derived = [&s] { return std::vector<ex>{(undamped_square() - s.V_kr * s.V_kr) / (s.beta * s.beta * s.U_k * s.U_k)}; },
         .steps = {step("The amplitude (48) from the initial values, squared, with G_k = 0 and real V", "\\overline{X}_k^2",
                        undamped_square().expand())}},
        {.id = "87/other-factor",
         .equations = {"87", "52"},
         .role = Role::step,
         .title = "If U_k = 0, the monoharmonic amplitude is |V_k| at every beta as well: (87) divides this factor out",
         .assumptions = {"all zeta_i = 0: V real, G_k = 0", "V_j not zero", "U_k = 0"},
         .kernel =
             [&s] {
                 const Symbolic amplitude = paper::displacement_transmissibility<Symbolic>(
                     {Symbolic(s.V_kr), Symbolic(0)}, {Symbolic(s.V_jr), Symbolic(0)}, Symbolic(s.U_j), Symbolic(0), Symbolic(0),
                     Symbolic(s.beta));
                 return Values{Symbolic(amplitude.expression() * amplitude.expression())};
             },
         .derived = [&s] { return std::vector<ex>{undamped_square().subs(s.U_k == 0)}; },
         .special_case = true},
        {.id = "88/printed",
         .equations = {"88"},
         .role = Role::printed,
         .title =
             "The three lines are the amplitude of the load on the held contact over mu, the masses beyond the contact at rest",
         .assumptions = held,
         .kernel = lines_of_88,
         .derived = [] { return derived_lines_of_88(true); },
         .departure = Departure::substance,
         .correction =
             "\\beta^*_{\\lim} = \\frac{1}{\\mu}\\left|\\sum_{k\\ne j}\\left(\\overline{K}_{jk}+i\\,\\overline{C}_{jk}\\right)"
             "\\overline{X}_k^* - \\delta_{lj}\\right|"},
        {.id = "88/load",
         .equations = {"88"},
         .role = Role::shipped,
         .title = "Complex amplitude of the load on the held contact, and the least friction ratio that balances it for ever",
         .assumptions = held,
         .kernel =
             [&s] {
                 const Complex<Symbolic> load = shipped_held_load(s.p_j, s.q_j);
                 return Values{load.re, load.im, paper::sticking_limit(load, Symbolic(s.mu))};
             },
         .derived =
             [&s] {
                 const ex load = derived_load(s.p_j, true, s.q_j);
                 const auto [re, im] = complex_amplitude(load);
                 return std::vector<ex>{re, im, limit_of(load)};
             },
         .slow = true,
         .steps = {step("Row j of (6) with the contact held at zero: what friction has to balance", "\\Sigma_j(\\tau)",
                        derived_load(1, true)),
                   {"Friction of at most mu beta balances it at every tau where its amplitude is not larger",
                    "\\max_\\tau|\\Sigma_j(\\tau)| \\le \\mu\\beta"}}},
        {.id = "88/side",
         .equations = {"88"},
         .role = Role::step,
         .title = "Friction balances the load at every tau where beta is not below the limit: below it, as printed, the contact "
                  "slides",
         .assumptions = held,
         .kernel =
             [&s] {
                 const ex limit = square(paper::sticking_limit(shipped_held_load(1, s.q_j), Symbolic(s.mu))).expression();
                 return Values{Symbolic(s.mu * s.mu * (s.beta * s.beta - limit))};
             },
         .derived =
             [&s] {
                 const auto [re, im] = complex_amplitude(derived_load(1, true, s.q_j));
                 return std::vector<ex>{GiNaC::pow(s.mu * s.beta, 2) - re * re - im * im};
             },
         .steps =
             {{"What friction can carry, squared, less the square of the load's amplitude: not negative where the contact rests",
               ""}}},
        {.id = "88/by-responses",
         .equations = {"88"},
         .role = Role::shipped,
         .title = "The least friction ratio that holds the contact for ever, from two responses of the system without friction",
         .assumptions = {"Y_jj not zero"},
         .kernel =
             [&s] {
                 return Values{evaluation::sticking_limit_by_responses<Symbolic>(
                     {Symbolic(s.V_kr), Symbolic(s.V_ki)}, {Symbolic(s.V_jr), Symbolic(s.V_ji)}, Symbolic(s.mu))};
             },
         .derived =
             [&s] {
                 // A harmonic force f on the contact, complex as the load is, makes its displacement V - f Y: it is zero for
                 const ex size = s.V_jr * s.V_jr + s.V_ji * s.V_ji;
                 const ex re = (s.V_kr * s.V_jr + s.V_ki * s.V_ji) / size, im = (s.V_ki * s.V_jr - s.V_kr * s.V_ji) / size;
                 return std::vector<ex>{GiNaC::sqrt(re * re + im * im) / s.mu};
             },
         .steps = {{"A force f on the contact that makes its displacement zero carries its load: $V_{dj} - f\\,Y_{jj} = 0$", ""},
                   {"Static friction supplies it at every instant where its amplitude is at most mu beta",
                    "|V_{dj}/Y_{jj}| \\le \\mu\\beta"}}},
        {.id = "88/no-damping-force",
         .equations = {"88"},
         .role = Role::step,
         .title =
             "The three lines hold where row j of the damping matrix is zero off its diagonal: without damping, or with damping "
             "proportional to the masses",
         .assumptions = {"chain, M diagonal", "C_jk = 0 for k not j", "no coupling across the contact"},
         .kernel = lines_of_88,
         .derived = [] { return derived_lines_of_88(false); }},
    };
});

} // namespace
} // namespace denhartog::derivation

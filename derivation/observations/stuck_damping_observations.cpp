// Section 4.3: what the text says damping does at the ends of the frequency range while the contact sticks.
#include <algorithm>
#include <cmath>

#include "denhartog/model/stuck_configuration.hpp"
#include "denhartog/stick_slip/stuck_response.hpp"
#include "derivation/algebra/limits.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/observations/observed_systems.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::pow;

namespace {

/// A stuck configuration of one mass: stiffness, damping over r, and its spring and damper to the contact.
struct StuckMassOfTwo {
    ex r, K, c, kappa, c_j;
};

const StuckMassOfTwo& stuck_mass_of_two() {
    static const StuckMassOfTwo s{new_symbol("x_r", "x", numeric(1, 1000), numeric(1, 100)), new_symbol("K_11", "K_{11}", 1, 3),
                                  new_symbol("c_11", "c_{11}", numeric(1, 100), 1),
                                  new_symbol("kappa_2", "\\kappa_2", numeric(1, 2), 2),
                                  new_symbol("c_21", "c_{21}", numeric(1, 100), 1)};
    return s;
}

/// |X*_1|^2 by (6) with the contact held, one mass of unit mass ratio.
ex amplitude_squared(const ex& r, const ex& c) {
    const StuckMassOfTwo& s = stuck_mass_of_two();
    return 1 / (pow(s.K - r * r, 2) + pow(c * r, 2));
}

void add_limit(Outcome& outcome, const ex& e, const LeadingTerm& expected, const std::string& what, const std::string& latex) {
    add_statement(outcome, decide_leading_term(e, stuck_mass_of_two().r, expected), what, latex);
}

Outcome amplitude_while_stuck() {
    const StuckMassOfTwo& s = stuck_mass_of_two();
    Outcome outcome;
    const auto ratio = [&](const ex& r) { return amplitude_squared(r, s.c) / amplitude_squared(r, 0); };
    add_limit(outcome, ratio(s.r) - 1, {-s.c * s.c / (s.K * s.K), 2}, "Damped over undamped, squared, less 1, for r = x -> 0",
              "-\\frac{c_{11}^2}{K_{11}^2}x^2");
    add_limit(outcome, ratio(1 / s.r) - 1, {-s.c * s.c, 2}, "The same for r = 1/x -> infinity", "-c_{11}^2x^2");
    return outcome;
}

/// Entry of C over r that couples the contact to the other mass.
double coupling(const System<double>& system) { return non_dimensional_matrices(system, modal_basis(system), 1.0).C(1, 0); }

/// Largest change of the boundary (88), exact, over r = 0.05 to 3, more than a fifth from its resonance.
Worst change_of_boundary(const std::string& name, const System<double>& system) {
    System<double> without = system;
    std::ranges::fill(without.damping_ratios, 0.0);
    const StuckConfiguration stuck = stuck_configuration(system, modal_basis(system)),
                             stuck_0 = stuck_configuration(without, modal_basis(without));
    Worst worst;
    for (int n = 10; n <= 600; ++n) {
        const double r = n / 200.0;
        if (std::abs(r / stuck.r_n[0] - 1) < 0.2) continue;
        const double load = modulus(stuck_response(stuck, system.load, r).contact_load),
                     load_0 = modulus(stuck_response(stuck_0, system.load, r).contact_load);
        worst.take(std::abs(load / load_0 - 1), [&] {
            return Witness{{"system", name}, {"r", text(r)}, {"beta*_lim", text(load)}, {"without damping", text(load_0)}};
        });
    }
    return worst;
}

/// Damped boundary over undamped, squared.
ex ratio_of_boundaries(const ex& r, const ex& c_j) {
    const StuckMassOfTwo& s = stuck_mass_of_two();
    return (pow(s.kappa, 2) + pow(c_j * r, 2)) * amplitude_squared(r, s.c) / (pow(s.kappa, 2) * amplitude_squared(r, 0));
}

/// zeta_i r_n,i is the same for all modes in Fig. 10, so that C is a multiple of M and its row j has the diagonal alone.
Outcome boundary_of_figure() {
    const ex x = stuck_mass_of_two().r;
    Outcome outcome;
    add_limit(outcome, ratio_of_boundaries(x, 0), {1, 0},
              "zeta_i r_n,i the same for all modes makes C a multiple of M; damped over undamped, squared, r = x -> 0", "\\to 1");
    add_limit(outcome, ratio_of_boundaries(1 / x, 0), {1, 0}, "The same for r = 1/x -> infinity", "\\to 1");
    for (const double zeta : damping_ratios_of_figures()) {
        const Worst change = change_of_boundary("2DOF j=2 l=1 zeta=" + rounded(zeta), two_masses(zeta));
        outcome.steps.push_back(
            {change.place[0].second + ": C_21 / r = " + rounded(coupling(two_masses(zeta))) +
                 "; largest change of beta*_lim a fifth or more from its resonance, r = 0.05 to 3: " + rounded(change.error),
             ""});
    }
    return outcome;
}

double limit_of(const System<double>& system, double r) {
    return modulus(stuck_response(stuck_configuration(system, modal_basis(system)), system.load, r).contact_load);
}

/// Other damping ratios couple the contact to the mass that moves: its damping force on the contact outgrows the spring's.
Outcome boundary_of_others() {
    const StuckMassOfTwo& s = stuck_mass_of_two();
    const double zeta = 0.1;
    const System<double> equal = equal_chain<double>(2, 2, 1, {zeta, zeta});
    System<double> without = equal;
    std::ranges::fill(without.damping_ratios, 0.0);
    Outcome outcome;
    const Verdict law = decide_leading_term(ratio_of_boundaries(1 / s.r, s.c_j), s.r, {pow(s.c_j / s.kappa, 2), -2});
    outcome.steps.push_back({"Damped over undamped, squared, r = 1/x -> infinity, " + to_string(law),
                             "\\frac{\\beta^{*2}}{\\beta_0^{*2}}\\sim\\frac{c_{21}^2}{\\kappa_2^2}r^2,\\quad "
                             "c_{21}=2\\sum_i\\zeta_ir_{n,i}\\phi_{1i}\\phi_{2i}"});
    const double r = 100, ratio = limit_of(equal, r) / limit_of(without, r);
    if (law == Verdict::proved && ratio > 1.1) outcome.verdict = Verdict::refuted;
    outcome.witness = {{"system", "2DOF j=2 l=1, zeta_1 = zeta_2 = 0.1"},
                       {"r", text(r)},
                       {"C_21 / r", text(coupling(equal))},
                       {"beta*_lim over that without damping", text(ratio)}};
    return outcome;
}

const Register claims_of_stuck_damping_observations([] {
    return std::vector<Claim>{
        observation("88/amplitude-at-both-ends/text", {"88"},
                    "Observation in the text: damping does not change the amplitude of the stuck configuration for r -> 0 and r "
                    "-> infinity",
                    {"N = 2", "j = 2, l = 1"}, amplitude_while_stuck),
        observation("88/boundary-at-both-ends/text", {"88"},
                    "Observation in the text: damping changes the boundary of permanent sticking of Fig. 10 neither for r -> 0 "
                    "nor for r -> infinity",
                    {"2DOF j=2 l=1", "zeta_i = zeta / r_n,i"}, boundary_of_figure),
        observation("88/boundary-at-high-frequency/text", {"88"},
                    "Observation in the text, taken for other damping ratios: damping does not change the boundary of permanent "
                    "sticking for r -> infinity",
                    {"N = 2", "j = 2, l = 1"}, boundary_of_others),
    };
});

} // namespace
} // namespace denhartog::derivation

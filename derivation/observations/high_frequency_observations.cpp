// Section 4.2: what the text says of high frequency ratios, beside (86).
#include <algorithm>
#include <cmath>

#include "denhartog/formulas/high_frequency.hpp"
#include "derivation/algebra/limits.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/observations/contact_motions.hpp"
#include "derivation/observations/observed_systems.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::Pi;
using GiNaC::pow;

namespace {

/// Both systems at r = 3 to 10.
std::vector<GridPoint> high_frequencies() {
    std::vector<double> frequencies;
    for (int n = 6; n <= 20; ++n) frequencies.push_back(n / 2.0);
    return contact_over_grid(frequencies);
}

/// The small quantity 1 / r, and the functions of a mode there.
const ex& small() {
    static const ex x = new_symbol("x_inf", "x", numeric(1, 1000), numeric(1, 100));
    return x;
}

void add_limit(Outcome& outcome, const ex& e, const LeadingTerm& expected, const std::string& what, const std::string& latex) {
    add_statement(outcome, decide_leading_term(e, small(), expected), what, latex);
}

Outcome amplitude_at_high_frequency() {
    const ex zeta = symbols().zeta, beta = symbols().beta;
    Outcome outcome;
    add_limit(outcome, squared_response(1 / small(), zeta), {1, 4}, "For R_i -> infinity", "|v_{di}|^2\\sim R_i^{-4}");
    add_limit(outcome, first_function(1 / small(), zeta), {Pi / 2, 2}, "For R_i -> infinity",
              "u_{di}\\sim\\frac{\\pi}{2}R_i^{-2}");
    add_limit(outcome, second_function(1 / small(), zeta), {pow(Pi, 3) * zeta / 12, 3}, "For R_i -> infinity",
              "g_i\\sim\\frac{\\pi^3\\zeta_i}{12}R_i^{-3}");
    outcome.steps.push_back(
        {"psi_ki psi_li R_i^2 does not depend on r: the sums (33) to (35), and with them (38) and (52), tend to zero", ""});
    add_limit(outcome,
              squared_response(1 / small(), zeta) -
                  beta * beta * first_function(1 / small(), zeta) * first_function(1 / small(), zeta),
              {1 - Pi * Pi * beta * beta / 4, 4}, "A single mass: the root in (38), squared",
              "\\overline{X}^2\\sim r^{-4}\\left(1-\\frac{\\pi^2\\beta^2}{4}\\right)");
    outcome.steps.push_back({"Damping enters by -beta g, in the next order", "-\\frac{\\pi^3\\beta\\zeta}{12}r^{-3}"});
    for (const double zeta_of_mass : damping_ratios_of_figures()) {
        std::string line =
            "Stick-slip, SDOF, zeta = " + rounded(zeta_of_mass) + ", beta = 0.8: amplitude times r^2 at r = 5, 10, 20:";
        const ContactSystem system = contact_system(single_mass(zeta_of_mass));
        ExactSolver solver(system, {1, 1, 1});
        for (const double r : {5.0, 10.0, 20.0}) line += " " + rounded(motion_of_contact(solver, r, 0.8).X * r * r);
        outcome.steps.push_back({line, ""});
    }
    return outcome;
}

Outcome value_at_high_frequency() {
    Outcome outcome;
    const ex limit = paper::friction_ratio_limit_at_high_frequency(Symbolic(1)).expression();
    const numeric value = evaluate(limit, {});
    add_statement(outcome, abs(value - numeric(537, 1000)) < numeric(1, 2000) ? Verdict::proved : Verdict::refuted,
                  "(86) with mu = 1 is 0.537 to three digits", "\\frac{2}{\\sqrt{4+\\pi^2}}");
    outcome.witness = {{"(86), mu = 1", text(value.to_double())}};
    return outcome;
}

Outcome all_curves_tend_to_it() {
    const ex zeta = symbols().zeta, limit = 4 / (4 + Pi * Pi);
    Outcome outcome;
    add_limit(outcome, squared_limit_of_single_mass(1 / small(), zeta), {limit, 0},
              "The boundary of a single mass, squared, mu = 1", "\\beta_{\\lim}^2\\to\\frac{4}{4+\\pi^2}");
    add_limit(outcome, squared_limit_of_single_mass(1 / small(), zeta) - limit, {-2 * Pi * zeta * limit * limit, 1},
              "With damping it is below the limit by a term in zeta / r",
              "\\beta_{\\lim}\\sim\\beta_\\infty\\left(1-\\frac{\\pi\\zeta\\beta_\\infty^2}{r}\\right)");
    add_limit(
        outcome, squared_limit_of_single_mass(1 / small(), 0) - limit, {limit * (2 - pow(Pi, 4) * limit / 24), 2},
        "Without damping above it, by a term in 1 / r^2",
        "\\beta_{\\lim}\\sim\\beta_\\infty\\left(1+\\frac{1}{r^2}\\left[1-\\frac{\\pi^4\\beta_\\infty^2}{48}\\right]\\right)");
    for (const double damping : damping_ratios_of_figures()) {
        const ObservedSystem s = observed_system("SDOF", damping, single_mass(damping));
        const auto departure = [&](double r) {
            return boundary(sums_at(s, r), 1.0).exact / paper::friction_ratio_limit_at_high_frequency(1.0) - 1;
        };
        double from = 2, least = 0;
        for (int n = 200; n <= 5000; ++n) {
            const double d = departure(n / 100.0);
            if (std::abs(d) > 0.01) from = (n + 1) / 100.0;
            least = std::min(least, d);
        }
        outcome.steps.push_back({s.name + ": " + rounded(departure(2.5)) + " above at r = 2.5, within 1 percent from r = " +
                                     rounded(from) + " on, lowest " + rounded(least),
                                 ""});
        outcome.witness.emplace_back("within 1 percent from r, zeta = " + rounded(damping), text(from));
    }
    return outcome;
}

/// Load and contact on different masses: both boundaries tend to zero, and beyond the upper one the contact rests.
Outcome rests_at_high_frequency() {
    Outcome outcome;
    std::vector<ObservedSystem> systems;
    for (const double zeta : damping_ratios_of_figures()) {
        systems.push_back(observed_system("2DOF j=2 l=1", zeta, two_masses(zeta)));
        systems.push_back(
            observed_system("2DOF j=2 l=1, one zeta for both modes,", zeta, equal_chain<double>(2, 2, 1, {zeta, zeta})));
    }
    for (const ObservedSystem& s : systems) {
        std::string line = s.name + ": beta_lim, beta*_lim and their ratio at r = 3, 10, 100:";
        for (const double r : {3.0, 10.0, 100.0}) {
            const Boundary<double> b = boundary(sums_at(s, r), 1.0);
            line += " " + rounded(b.exact) + " " + rounded(*b.sticking) + " " + rounded(b.exact / *b.sticking) + ";";
        }
        outcome.steps.push_back({line, ""});
    }
    const double r = 4, beta = 0.1;
    const ContactSystem system = contact_system(systems.front().system);
    ExactSolver solver(system, {r, beta, 1});
    const ContactMotion motion = motion_of_contact(solver, r, beta);
    if (motion.rests) outcome.verdict = Verdict::refuted;
    outcome.witness = {{"system", systems.front().name},
                       {"r", text(r)},
                       {"beta", text(beta)},
                       {"beta*_lim", text(*boundary(sums_at(systems.front(), r), 1.0).sticking)},
                       {"regime from rest", motion.rests ? "permanent sticking" : "it moves"}};
    return outcome;
}

const Register claims_of_high_frequency_observations([] {
    const std::vector<std::string> high{"SDOF and 2DOF j=2 l=1", "r = 3 to 10 in steps of 0.5", "beta = 0.02 to 0.8", "mu = 1",
                                        "sliding"};
    const auto slides = [](const ContactMotion& m) { return m.stops == 0; };
    return std::vector<Claim>{
        observation("38/high-frequency/text", {"38", "52"},
                    "Observation in the text: the transmissibilities tend to zero for r -> infinity", {"sliding regime"},
                    amplitude_at_high_frequency),
        observation("38/high-frequency-damping/text", {"38"},
                    "Observation in the text: damping hardly changes the amplitude at high frequencies; here: that of the "
                    "contact by less than a tenth",
                    high, [slides] { return change_with_damping(high_frequencies(), slides, 0.1); }),
        observation("86/value/text", {"86"}, "Observation in the text: the boundary at high frequencies is 0.537",
                    {"j = l", "mu = 1"}, value_at_high_frequency),
        observation("86/all-curves/text", {"86"},
                    "Observation in the text: the boundary of a single mass tends to the same value for every damping ratio",
                    {"N = 1", "mu = 1", "the series: (67)"}, all_curves_tend_to_it),
        observation("86/always-stick-slip/text", {"86", "88"},
                    "Observation in the text: with the load not on the contact there is always stick-slip at high frequencies",
                    {"mu = 1"}, rests_at_high_frequency),
    };
});

} // namespace
} // namespace denhartog::derivation

// Section 4.1: what the text says of the boundary at resonance, (85).
#include <cmath>

#include "denhartog/formulas/mode.hpp"
#include "denhartog/formulas/resonance.hpp"
#include "derivation/algebra/limits.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/observations/observation.hpp"
#include "derivation/observations/observed_systems.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::Pi;
using GiNaC::pow;

namespace {

const ex& small() {
    static const ex x = new_symbol("x_85", "x", numeric(1, 1000), numeric(1, 100));
    return x;
}

ex limit_at_resonance(const ex& psi_li, const ex& psi_ji, const ex& zeta) {
    return paper::friction_ratio_limit_at_resonance(Symbolic(psi_li), Symbolic(psi_ji), Symbolic(zeta)).expression();
}

/// (85) for zeta -> 0, squared because of its modulus.
Verdict quarter_of_pi() {
    const ex x = small(), l = symbols().psi_li, j = symbols().psi_ji;
    return decide_leading_term(pow(limit_at_resonance(l, j, x), 2), x, {pow(Pi * l / (4 * j), 2), 0});
}

Outcome value_without_damping() {
    Outcome outcome;
    const Verdict limit = quarter_of_pi();
    outcome.steps.push_back({"(85) for zeta_i -> 0, " + to_string(limit),
                             "\\beta_{n,i}\\to\\frac{\\pi}{4}\\left|\\frac{\\psi_{li}}{\\psi_{ji}}\\right|"});
    const numeric zeta("1/1000000");
    const numeric value = evaluate(limit_at_resonance(1, 1, small()), {{small(), zeta}});
    if (limit == Verdict::proved && abs(value - 1) > numeric(1, 10)) outcome.verdict = Verdict::refuted;
    outcome.witness = {{"psi_li / psi_ji", "1"}, {"zeta_i", text(zeta)}, {"(85)", text(value)}, {"value in the text", "1"}};
    return outcome;
}

/// Fall of (85) and of the boundary itself, per unit of the value without damping.
struct Fall {
    double approximate, exact;
};

Fall fall(double zeta) {
    const double without = pi<double>() / 4;
    const double u = paper::first_damping_function(1.0, zeta), g = paper::second_damping_function(1.0, zeta);
    const double demand = paper::s_d_at_zero(1.0, zeta, u, g);
    const double limit = 1 / (2 * zeta) / std::sqrt(u * u + demand * demand);
    return {1 - paper::friction_ratio_limit_at_resonance(1.0, 1.0, zeta) / without, 1 - limit / without};
}

/// (85) falls with zeta: its rate is that of tanh(y)/y, y = pi zeta / 2.
Verdict falls() {
    const ex z = symbols().zeta;
    const ex derived = (Pi * z - GiNaC::sinh(Pi * z)) / (4 * z * z * pow(GiNaC::cosh(Pi * z / 2), 2));
    return decide_equal(limit_at_resonance(1, 1, z).diff(GiNaC::ex_to<GiNaC::symbol>(z)), derived, domain_of({z})).verdict;
}

Outcome nearly_constant() {
    Outcome outcome;
    add_statement(outcome, falls(), "(85) falls with zeta_i, because sinh(pi zeta_i) > pi zeta_i",
                  "\\frac{d\\beta_{n,i}}{d\\zeta_i}=\\left|\\frac{\\psi_{li}}{\\psi_{ji}}\\right|\\frac{\\pi\\zeta_i-"
                  "\\sinh\\pi\\zeta_i}{4\\zeta_i^2\\cosh^2(\\pi\\zeta_i/2)}");
    add_statement(outcome, fall(0.01).approximate < 0.01 ? Verdict::proved : Verdict::refuted,
                  "The largest fall up to zeta_i = 0.01 is there", "");
    refute_above(outcome, fall(0.01).approximate, {.what = "fall of (85) up to zeta_i = 0.01", .taken = 0.01, .empty = 1});
    outcome.witness = {{"fall of (85) at zeta_i = 0.01", text(fall(0.01).approximate)},
                       {"fall of (67), single mass, at zeta = 0.01", text(fall(0.01).exact)}};
    return outcome;
}

/// The damping ratio at which (85) has fallen by 1 percent.
double fallen_by_one_percent() {
    double low = 0.01, high = 0.5;
    for (int n = 0; n < 50; ++n) {
        const double middle = (low + high) / 2;
        (fall(middle).approximate < 0.01 ? low : high) = middle;
    }
    return low;
}

Outcome falls_significantly() {
    Outcome outcome;
    const Fall at = fall(0.1);
    const Verdict monotone = falls();
    outcome.steps.push_back(
        {"(85) falls with zeta_i, " + to_string(monotone) + ": its largest fall for zeta_i <= 0.1 is at 0.1", ""});
    outcome.steps.push_back(
        {"(85) leaves out 1 / (gamma_j r^2) of (67), which is of first order in zeta_i: (67) itself falls further", ""});
    outcome.witness = {{"zeta_i", "0.1"},
                       {"fall of (85)", text(at.approximate)},
                       {"fall of (67), single mass", text(at.exact)},
                       {"(85) has fallen by 1 percent at zeta_i", text(fallen_by_one_percent())}};
    if (monotone != Verdict::proved) return outcome;
    outcome.verdict = Verdict::proved;
    refute_below(outcome, at.approximate, {.what = "fall of (85) up to zeta_i = 0.1", .taken = 0.01, .empty = 0});
    refute_above(outcome, fallen_by_one_percent(),
                 {.what = "largest damping ratio that is looked at, with a fall of 1 percent", .taken = 0.1, .empty = 1});
    return outcome;
}

/// The value without damping, (85) for zeta -> 0, against the boundary at the natural frequency ratio of lightly damped systems.
Outcome estimate_of_the_boundary() {
    Outcome outcome;
    Worst worst;
    for (const double zeta : {1e-6, 0.001, 0.01}) {
        Worst here;
        for (const ObservedSystem& s : systems_of_the_paper(zeta))
            for (std::size_t i = 0; i < s.basis.r_n.size(); ++i) {
                const double without = pi<double>() / 4 * ratio_of_shapes(s, i), limit = limit_at(s, i);
                here.take(std::abs(without / limit - 1), [&] {
                    return Witness{{"system", s.name},
                                   {"mode", std::to_string(i + 1)},
                                   {"r", text(s.basis.r_n[i])},
                                   {"(85) for zeta_i -> 0", text(without)},
                                   {"boundary", text(limit)}};
                });
            }
        outcome.steps.push_back({"zeta = " + rounded(zeta) + ": largest relative error " + rounded(here.error) + ", " +
                                     here.place[0].second + ", mode " + here.place[1].second,
                                 ""});
        worst.take(here.error, [&] { return here.place; });
    }
    const double bound = 0.05;
    refute_above(outcome, worst.error,
                 {.what = "relative error of the value without damping, zeta up to 0.01", .taken = bound, .empty = 1});
    const auto largest = [](double zeta) {
        double most = 0;
        for (const ObservedSystem& s : systems_of_the_paper(zeta))
            for (std::size_t i = 0; i < s.basis.r_n.size(); ++i)
                most = std::max(most, std::abs(pi<double>() / 4 * ratio_of_shapes(s, i) / limit_at(s, i) - 1));
        return most;
    };
    refute_below(outcome, damping_ratio_up_to(largest, bound),
                 {.what = "damping ratio that is light", .taken = 0.01, .empty = 0});
    outcome.witness = with(worst.place, {{"relative error", text(worst.error)}});
    return outcome;
}

const Register claims_of_resonant_boundary_observations([] {
    const std::vector<std::string> range{"0 < zeta_i < 1"};
    return std::vector<Claim>{
        observation("85/without-damping/text", {"85"},
                    "Observation in the text: (85) agrees with |psi_li / psi_ji| for zeta_i = 0", range, value_without_damping),
        observation("85/nearly-constant/text", {"85"},
                    "Observation in the text: (85) hardly changes for zeta_i <= 0.01; here: by less than 1 percent",
                    {"0 < zeta_i <= 0.01"}, nearly_constant),
        observation(
            "85/falls-beyond/text", {"85"},
            "Observation in the text: (85) falls significantly for larger damping ratios; here: by more than 1 percent up to 0.1",
            {"0.01 < zeta_i <= 0.1"}, falls_significantly),
        observation("85/estimate/text", {"85"},
                    "Observation in the text: the value of (85) without damping estimates well where stick-slip begins at "
                    "resonance; here: to 5 percent, zeta_i <= 0.01",
                    {}, estimate_of_the_boundary),
    };
});

} // namespace
} // namespace denhartog::derivation

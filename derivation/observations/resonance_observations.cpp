// Section 4.1: what the text says beside (76)-(84) and algebra decides. Limits have their path; what is measured is in
// resonant_peak_observations.cpp, the boundary (85) in resonant_boundary_observations.cpp.
#include "denhartog/formulas/contact.hpp"
#include "denhartog/formulas/mode.hpp"
#include "denhartog/formulas/resonance.hpp"
#include "derivation/algebra/limits.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/observations/observation.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::Pi;
using GiNaC::pow;

namespace {

/// A path: the small quantity and a speed.
struct Path {
    ex x, c;
};

const Path& path() {
    static const Path p{new_symbol("x_res", "x", numeric(1, 1000), numeric(1, 100)), new_symbol("c_res", "c", numeric(1, 4), 4)};
    return p;
}

ex slope(const ex& zeta) { return paper::second_damping_function_at_resonance(Symbolic(zeta)).expression(); }

void add_limit(Outcome& outcome, const ex& e, const LeadingTerm& expected, const std::string& what, const std::string& latex) {
    add_statement(outcome, decide_leading_term(e, path().x, expected), what, latex);
}

/// u_di near R_i = 1 along several paths; the text has zero.
Outcome first_damping_function_at_resonance() {
    const ex x = path().x, c = path().c;
    Outcome limits;
    add_limit(limits, first_function(1, x), {1 / Pi, 0}, "R_i = 1, then zeta_i = x -> 0", "u_{di}\\to\\frac{1}{\\pi}");
    add_limit(limits, first_function(1 + x, 0), {2 / Pi, -1}, "zeta_i = 0, then R_i = 1 + x -> 1",
              "u_{di}\\sim\\frac{2}{\\pi x}");
    add_limit(limits, first_function(1 - x, 0), {-2 / Pi, -1}, "zeta_i = 0, then R_i = 1 - x -> 1",
              "u_{di}\\sim-\\frac{2}{\\pi x}");
    add_limit(limits, first_function(1 + x, c * x), {2 / (Pi * (1 + c * c)), -1}, "R_i = 1 + x, zeta_i = c x",
              "u_{di}\\sim\\frac{2}{\\pi(1+c^2)x}");
    add_limit(limits, first_function(1 + x * x, c * x), {(1 + 2 / (c * c)) / Pi, 0}, "R_i = 1 + x^2, zeta_i = c x",
              "u_{di}\\to\\frac{1}{\\pi}\\left(1+\\frac{2}{c^2}\\right)");
    add_limit(limits, first_function(1 + pow(x, 4), c * x), {1 / Pi, 0}, "R_i = 1 + x^4, zeta_i = c x",
              "u_{di}\\to\\frac{1}{\\pi}");
    add_statement(limits, decide_equal(first_function(symbols().w, symbols().zeta), 0, domain_of({symbols().zeta})).verdict,
                  "It vanishes at R_i = sqrt(1 - zeta_i^2), the damped natural frequency", "u_{di}=0");
    Outcome outcome;
    outcome.steps = limits.steps;
    outcome.steps.push_back({"At R_i = 1 and 0 < zeta_i < 1 the angle pi w is between 0 and pi, so that u_di is positive", ""});
    const numeric zeta(1, 100), value = evaluate(first_function(1, path().x), {{path().x, zeta}});
    if (limits.verdict == Verdict::proved && value > numeric(1, 10)) outcome.verdict = Verdict::refuted;
    outcome.witness = {{"R_i", "1"},
                       {"zeta_i", text(zeta)},
                       {"u_di", text(value)},
                       {"limit for zeta_i -> 0", text(GiNaC::ex_to<numeric>((1 / Pi).evalf()))}};
    return outcome;
}

/// U at the edge of the resonance is as large as G, and |V| of the same order.
Outcome no_peculiar_behaviour() {
    const ex x = path().x;
    Outcome limits;
    add_limit(limits, first_function(1 + x, x), {1 / Pi, -1}, "R_i = 1 + zeta_i, zeta_i = x", "u_{di}\\sim\\frac{1}{\\pi x}");
    add_limit(limits, second_function(1 + x, x), {1 / Pi, -1}, "The second damping function there", "g_i\\sim\\frac{1}{\\pi x}");
    add_limit(limits, squared_response(1 + x, x), {numeric(1, 8), -2}, "The response there", "|v_{di}|^2\\sim\\frac{1}{8x^2}");
    add_limit(limits, first_function(1 - x, x), {-1 / Pi, -1}, "R_i = 1 - zeta_i", "u_{di}\\sim-\\frac{1}{\\pi x}");
    Outcome outcome;
    outcome.steps = limits.steps;
    const numeric zeta(1, 100);
    const numeric above = evaluate(first_function(1 + x, x), {{x, zeta}}),
                  below = evaluate(first_function(1 - x, x), {{x, zeta}});
    if (limits.verdict == Verdict::proved && above > 1) outcome.verdict = Verdict::refuted;
    outcome.witness = {
        {"zeta_i", text(zeta)}, {"u_di at R_i = 1 + zeta_i", text(above)}, {"u_di at R_i = 1 - zeta_i", text(below)}};
    return outcome;
}

Outcome second_damping_function_grows() {
    Outcome outcome;
    const ex x = path().x;
    add_limit(outcome, slope(x), {2 / Pi, -1}, "(79) for zeta_i = x -> 0", "g_i\\sim\\frac{2}{\\pi x}");
    add_limit(outcome, second_function(1, x), {2 / Pi, -1}, "(29) at R_i = 1 for zeta_i = x -> 0", "g_i\\sim\\frac{2}{\\pi x}");
    return outcome;
}

/// Without damping the amplitude of the contact is unbounded next to a resonance wherever it slides there, for every N: the other
/// modes add something finite to V_dj and to U_dj.
Outcome infinite_without_damping() {
    static const ex a = new_symbol("V_others", "a", -1, 1), b = new_symbol("U_others", "b", -1, 1);
    const Symbols& s = symbols();
    const ex x = path().x, R = 1 + x;
    const ex v = paper::complex_response(Symbolic(R), Symbolic(ex(0))).re.expression();
    const ex V = s.psi_ji * s.psi_li * R * R * v + a, U = s.psi_ji * s.psi_ji * R * R * first_function(R, 0) + b;
    Outcome outcome;
    add_statement(outcome, decide_equal(second_function(s.R, 0), 0, domain_of({s.R})).verdict, "Without damping", "g_i = 0");
    add_limit(outcome, V * V - s.beta * s.beta * U * U,
              {pow(s.psi_ji * s.psi_li, 2) / 4 - 4 * pow(s.beta * s.psi_ji * s.psi_ji / Pi, 2), -2},
              "R_i = 1 + x, the other modes any finite numbers a and b: the square of (38)",
              "\\overline{X}_j^2\\sim\\frac{\\psi_{ji}^2}{x^2}\\left(\\frac{\\psi_{li}^2}{4}-\\frac{4\\beta^2\\psi_{ji}^2}{\\pi^"
              "2}\\right)");
    add_limit(outcome, V * V / (U * U), {pow(Pi * s.psi_li / (4 * s.psi_ji), 2), 0},
              "What beta^2 has to be below for (38) to be real",
              "\\frac{|V_{dj}|^2}{U_{dj}^2}\\to\\left(\\frac{\\pi\\psi_{li}}{4\\psi_{ji}}\\right)^2");
    add_argument(
        outcome,
        "Where the contact slides all along, (38) is real and beta is at most that limit; below it the factor of 1/x^2 is "
        "positive and the peak is infinite",
        "\\beta<\\frac{\\pi}{4}\\left|\\frac{\\psi_{li}}{\\psi_{ji}}\\right|");
    return outcome;
}

/// |v|^2 over all R: its denominator is a square and a constant.
Outcome finite_with_damping() {
    const Symbols& s = symbols();
    Outcome outcome;
    add_statement(outcome,
                  decide_equal(1 / squared_response(s.R, s.zeta),
                               pow(s.R * s.R - 1 + 2 * s.zeta * s.zeta, 2) + pow(2 * s.zeta * s.w, 2), domain_of({s.R, s.zeta}))
                      .verdict,
                  "Denominator of the response", "|v_{di}|^{-2} = (R_i^2-1+2\\zeta_i^2)^2+(2\\zeta_iw)^2");
    add_claim(outcome, "64/not-negative", "g_i is not negative");
    add_argument(outcome, "(38) is at most |V_dj|, because G_j sums g_i with squares; every |v_di| is at most 1 / (2 zeta_i w)",
                 "\\overline{X}_j \\le |V_{dj}| \\le \\sum_i\\frac{|\\psi_{ji}\\psi_{li}|R_i^2}{2\\zeta_iw}");
    return outcome;
}

/// The functions of a mode over all R: none has a denominator that vanishes.
Outcome finite_with_damping_elsewhere() {
    const Symbols& s = symbols();
    const ex theta = Pi * s.w / s.R, denominator = GiNaC::cosh(Pi * s.zeta / s.R) + GiNaC::cos(theta);
    const ex left = first_function(s.R, s.zeta) * denominator, right = GiNaC::sin(theta) / (s.R * s.w);
    Outcome outcome;
    add_statement(outcome, decide_equal(left, right, domain_of({left, right})).verdict,
                  "The first damping function and its denominator", latex(denominator));
    add_claim(outcome, "64/not-negative", "the second has the same denominator");
    add_claim(outcome, "38/finite-damped/text", "every |v_di| is finite, and so is the amplitude of the contact");
    add_argument(
        outcome,
        "the denominator is at least 1 where R_i >= 2 w, and elsewhere at least cosh(pi zeta_i / (2 w)) - 1; the motion "
        "(46) of every mass is a finite sum of these functions, of sines, cosines and decaying exponentials, each with a "
        "bounded factor, as long as beta is below beta_lim",
        "\\cosh\\frac{\\pi\\zeta_i}{R_i}+\\cos\\theta\\ge\\cosh\\frac{\\pi\\zeta_i}{R_i}-1");
    return outcome;
}

/// The size of the slope of (84) over beta, its first and second rate over zeta.
Outcome slope_over_damping() {
    const ex z = symbols().zeta;
    const auto symbol = GiNaC::ex_to<GiNaC::symbol>(z);
    const ex half = Pi * z / 2, S = GiNaC::sinh(half), C = GiNaC::cosh(half);
    Outcome outcome;
    add_statement(outcome, decide_equal(slope(z), C / S, domain_of({z})).verdict, "The slope",
                  "g_i=\\coth\\frac{\\pi\\zeta_i}{2}");
    add_statement(outcome, decide_equal(slope(z).diff(symbol), -Pi / (2 * S * S), domain_of({z})).verdict, "Its rate is negative",
                  "-\\frac{\\pi}{2\\sinh^2(\\pi\\zeta_i/2)}");
    add_statement(outcome, decide_equal(slope(z).diff(symbol, 2), Pi * Pi * C / (2 * S * S * S), domain_of({z})).verdict,
                  "The rate of its rate is positive", "\\frac{\\pi^2\\cosh(\\pi\\zeta_i/2)}{2\\sinh^3(\\pi\\zeta_i/2)}");
    return outcome;
}

/// dX_j / dbeta of (38).
Outcome friction_reduces_the_contact() {
    const Symbols& s = symbols();
    Outcome outcome;
    const Complex<Symbolic> V = symbolic_V_j();
    const Symbolic U(s.U_j), G(s.G_j), beta(s.beta);
    const ex X = paper::displacement_transmissibility_of_contact(V, U, G, beta).expression();
    const ex root = paper::contact_root(V, U, beta).expression();
    add_statement(
        outcome,
        decide_equal(X.diff(GiNaC::ex_to<GiNaC::symbol>(s.beta)), -s.G_j - s.beta * s.U_j * s.U_j / root,
                     domain_of({s.V_jr, s.V_ji, s.U_j, s.G_j, s.beta}))
            .verdict,
        "The rate of (38)",
        "\\frac{\\partial\\overline{X}_j}{\\partial\\beta}=-G_j-\\frac{\\beta U_{dj}^2}{\\sqrt{|V_{dj}|^2-(\\beta U_{dj})^2}}");
    add_claim(outcome, "64/not-negative", "g_i is not negative, nor is G_j, which sums it with squares");
    return outcome;
}

const Register claims_of_resonance_observations([] {
    const std::vector<std::string> range{"0 < zeta_i < 1"};
    return std::vector<Claim>{
        observation("28/at-resonance/text", {"28", "80"}, "Observation in the text: u_di tends to zero for R_i -> 1",
                    {"0 <= zeta_i < 1"}, first_damping_function_at_resonance),
        observation("28/no-peculiarity/text", {"28", "81"},
                    "Observation in the text: the first damping function does nothing special at resonance; here: it stays below "
                    "1 within R_i = 1 +- zeta_i",
                    {"zeta_i = 0.01"}, no_peculiar_behaviour),
        observation("79/infinite/text", {"79"}, "Observation in the text: (79) tends to infinity for zeta_i -> 0", {"R_i = 1"},
                    second_damping_function_grows),
        observation(
            "38/infinite-undamped/text", {"38"},
            "Observation in the text: without damping, friction leaves the resonant peak infinite unless the contact sticks",
            {"all zeta_i = 0", "psi_ji, psi_li not zero", "natural frequencies that differ"}, infinite_without_damping),
        observation("38/finite-damped/text", {"38", "23"},
                    "Observation in the text: with damping, the peaks of the contact are finite while it slides",
                    {"sliding regime", "0 < zeta_i < 1"}, finite_with_damping),
        observation(
            "52/finite-damped/text", {"46", "52"},
            "Observation in the text: with damping, the peaks of all other masses are finite too while the contact slides",
            {"sliding regime", "0 < zeta_i < 1"}, finite_with_damping_elsewhere),
        observation("38/friction-reduces/text", {"38", "83"},
                    "Observation in the text: friction lowers the amplitude of the contact without a stop", {"sliding regime"},
                    friction_reduces_the_contact),
        observation("84/slope/text", {"83", "84"},
                    "Observation in the text: the slope of (83) over beta falls with zeta_i, and ever more slowly", range,
                    slope_over_damping),
    };
});

} // namespace
} // namespace denhartog::derivation

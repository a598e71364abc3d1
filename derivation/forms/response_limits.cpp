// Limits of the response: natural frequencies that merge, a mass ratio without bound, the boundary of the sliding regime, and
// chains without end.
#include "denhartog/formulas/response_limits.hpp"

#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/limit_twins.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::Pi;

namespace {

/// The small quantity.
const ex& small() {
    static const ex t = new_symbol("t_modes", "t", numeric(1, 1000), numeric(1, 10));
    return t;
}

/// A frequency ratio away from the natural ones and from the poles of (28).
const ex& frequency() {
    static const ex r = new_symbol("r_above", "r", 2, 3);
    return r;
}

/// A mode's part of (33)-(35): v, u, g over lambda, with R = r over the root of lambda.
struct Part {
    ex v_re, v_im, u, g;
};

Part part_of_mode(const ex& root_of_lambda) {
    const ex zeta = symbols().zeta, R = frequency() / root_of_lambda, lambda = root_of_lambda * root_of_lambda;
    const Complex<Symbolic> v = paper::complex_response(Symbolic(R), Symbolic(zeta));
    return {v.re.expression() / lambda, v.im.expression() / lambda, first_function(R, zeta) / lambda,
            second_function(R, zeta) / lambda};
}

/// Masses 1, x and springs 1, x: with x = 4 sinh^2(t/2) the squared natural frequencies are e^t and e^-t.
Outcome merging_frequencies() {
    const ex t = small(), x = GiNaC::pow(GiNaC::exp(t / 2) - GiNaC::exp(-t / 2), 2),
             coupling = GiNaC::exp(t / 2) - GiNaC::exp(-t / 2);
    Outcome outcome;
    for (const int sign : {1, -1}) {
        const ex lambda = GiNaC::exp(sign * t), q_1 = 1 - lambda, q_2 = coupling, square = q_1 * q_1 + q_2 * q_2;
        const std::string which = sign > 0 ? "lambda = e^t" : "lambda = e^-t";
        add_statement(outcome, decide_zero_and_twin((1 + x) * q_1 - coupling * q_2 - lambda * q_1), which + ": first row of A q",
                      "");
        add_statement(outcome, decide_zero_and_twin(-coupling * q_1 + q_2 - lambda * q_2), which + ": second row of A q", "");
        add_statement(outcome, decide_zero_and_twin(q_1 * q_1 / square - lambda / (1 + lambda)), which + ": weight in (34), (35)",
                      "\\phi_1^2 = \\frac{\\lambda}{1+\\lambda}");
        add_statement(outcome, decide_zero_and_twin(q_1 * q_2 / square / coupling + sign / (GiNaC::exp(t) - GiNaC::exp(-t))),
                      which + ": weight in (33)", "\\phi_1\\phi_2 = \\mp\\frac{1}{2\\sinh t}");
    }
    outcome.steps.push_back({"gamma_2 = kappa_2 = x = 4 sinh^2(t/2); masses scaled by their roots",
                             "A = \\begin{pmatrix}1+x&-\\sqrt{x}\\\\-\\sqrt{x}&1\\end{pmatrix}"});
    const Part up = part_of_mode(GiNaC::exp(t / 2)), down = part_of_mode(GiNaC::exp(-t / 2));
    const ex difference = GiNaC::exp(t) - GiNaC::exp(-t), heavy = GiNaC::exp(t) / (1 + GiNaC::exp(t)), light = 1 - heavy;
    const Complex<Symbolic> V = limits::response_of_merged_modes(Symbolic(frequency()), Symbolic(symbols().zeta));
    const auto add = [&](const ex& e, const ex& value, const char* what, const char* formula) {
        add_statement(outcome, decide_term_and_twins(e, t, {value, 0}), what, formula);
    };
    add((down.v_re - up.v_re) / difference, V.re.expression(), "Re V_d1, minus a divided difference",
        "V_{d1} \\to \\frac{1+i\\zeta r}{(1-r^2+2i\\zeta r)^2}");
    add((down.v_im - up.v_im) / difference, V.im.expression(), "Im V_d1", "");
    add(heavy * up.u + light * down.u, first_function(frequency(), symbols().zeta), "U_d1", "U_{d1} \\to u_d(r)");
    add(heavy * up.g + light * down.g, second_function(frequency(), symbols().zeta), "G_1", "G_1 \\to g(r)");
    return outcome;
}

/// Masses 1, 1/x and two equal springs: the heavy mass becomes a wall.
Outcome heavy_mass() {
    const ex t = small(), epsilon = t * t, high = 2 + epsilon, low = epsilon / (1 + epsilon), x = high * low;
    Outcome outcome;
    add_statement(outcome, decide_zero_and_twin(high + low - 2 - x), "The squared natural frequencies have the trace of A",
                  "\\lambda_1 = \\frac{t^2}{1+t^2}, \\quad \\lambda_2 = 2+t^2");
    add_statement(outcome, decide_zero_and_twin(high * low - (2 * x - x)), "and its determinant", "");
    outcome.steps.push_back({"gamma_2 = 1/x, kappa_2 = 1, x = t^2 (2 + t^2) / (1 + t^2)",
                             "A = \\begin{pmatrix}2&-\\sqrt{x}\\\\-\\sqrt{x}&x\\end{pmatrix}"});
    const ex weight = (2 - low) / (high - low);
    add_statement(outcome, decide_zero_and_twin(weight * high + (1 - weight) * low - 2),
                  "The weights of the modes have the element (1, 1) of A",
                  "\\phi_{12}^2 = \\frac{2-\\lambda_1}{\\lambda_2-\\lambda_1} = 1-\\phi_{11}^2");
    const Part fixed = part_of_mode(GiNaC::sqrt(ex(2))), slow = part_of_mode(t / GiNaC::sqrt(1 + epsilon)),
               fast = part_of_mode(GiNaC::sqrt(2 + epsilon));
    const auto add = [&](const ex& of_slow, const ex& of_fast, const ex& value, const char* what) {
        add_statement(outcome, decide_term_and_twins((1 - weight) * of_slow + weight * of_fast, t, {value, 0}),
                      std::string(what) + " with load and contact on mass 1 tends to that of a mass on two springs", "");
    };
    add(slow.v_re, fast.v_re, fixed.v_re, "Re V_d1");
    add(slow.v_im, fast.v_im, fixed.v_im, "Im V_d1");
    add(slow.u, fast.u, fixed.u, "U_d1");
    add(slow.g, fast.g, fixed.g, "G_1");
    return outcome;
}

/// Masses 1, x and two equal springs, the load on mass 2: the light mass passes it on.
Outcome light_mass() {
    const ex t = small(), low = 1 - t, x = t / (1 - t * t), high = 1 / (x * low);
    Outcome outcome;
    add_statement(outcome, decide_zero_and_twin(high + low - 2 - 1 / x), "The squared natural frequencies have the trace of A",
                  "\\lambda_1 = 1-t, \\quad \\lambda_2 = \\frac{1+t}{t}");
    add_statement(outcome, decide_zero_and_twin(high * low - 1 / x), "and its determinant", "");
    outcome.steps.push_back(
        {"gamma_2 = x = t / (1 - t^2), kappa_2 = 1", "A = \\begin{pmatrix}2&-1/\\sqrt{x}\\\\-1/\\sqrt{x}&1/x\\end{pmatrix}"});
    const ex weight = (high - 2) / (high - low), product = 1 / (x * (high - low));
    add_statement(outcome, decide_zero_and_twin(weight * low + (1 - weight) * high - 2),
                  "The weights of the modes have the element (1, 1) of A", "");
    add_statement(outcome, decide_zero_and_twin(product * product * x - weight * (1 - weight)),
                  "Components of the shapes, masses scaled by their roots, with a norm of 1",
                  "\\phi_{11}^2 = \\frac{\\lambda_2-2}{\\lambda_2-\\lambda_1}, \\quad "
                  "\\phi_{11}\\phi_{21} = -\\phi_{12}\\phi_{22} = \\frac{1}{x(\\lambda_2-\\lambda_1)}");
    add_statement(outcome, decide_term_and_twins(product / low, t, {1, 0}), "Weight of mode 1 in (33)", "\\to 1");
    add_statement(outcome, decide_term_and_twins(weight / low, t, {1, 0}), "and in (34), (35)", "\\to 1");
    add_statement(outcome, decide_term_and_twins(product / high, t, {1, 1}), "Weight of mode 2 in (33)", "\\sim t");
    add_statement(outcome, decide_term_and_twins((1 - weight) / high, t, {1, 2}), "and in (34), (35)", "\\sim t^2");
    add_claim(outcome, "limits/R-to-0", "v, u and g of mode 2 tend to 1, 0 and 1: mode 1 alone is left, the mass 1 alone");
    return outcome;
}

/// (38) on its way to the boundary (67).
Outcome to_boundary() {
    const ex x = small(), beta = symbols().beta, zeta = symbols().zeta;
    const ex S = new_symbol("S_demand", "S", 1, 3), U = new_symbol("U_contact", "U_{dj}", numeric(1, 5), 1),
             G = new_symbol("G_contact", "G_j", numeric(1, 10), numeric(9, 10));
    Outcome outcome;
    const ex V_squared = beta * beta * (U * U + S * S);
    add_statement(outcome, decide_zero_and_twin(V_squared - beta * beta * U * U - beta * beta * S * S),
                  "By (67) the root in (38)", "\\sqrt{|V_{dj}|^2-\\beta^2U_{dj}^2} = \\beta S");
    const ex friction = beta * (1 - x);
    const ex X = GiNaC::sqrt(V_squared - friction * friction * U * U) - friction * G;
    const Symbolic there = limits::displacement_transmissibility_at_boundary(Symbolic(beta), Symbolic(S), Symbolic(G));
    const Symbolic slope = limits::slope_at_boundary(Symbolic(beta), Symbolic(S), Symbolic(U), Symbolic(G));
    add_statement(outcome, decide_term_and_twins(X, x, {there.expression(), 0}), "(38) for beta = beta_lim (1 - x)",
                  "\\overline{X}_j \\to \\beta_{\\lim}(S-G_j)");
    add_statement(outcome, decide_term_and_twins(X - there.expression(), x, {slope.expression(), 1}), "and how",
                  "\\sim \\beta_{\\lim}\\left(\\frac{U_{dj}^2}{S}+G_j\\right)x");
    const ex u = first_function(1, zeta), g = second_function(1, zeta);
    add_statement(outcome,
                  decide_term_and_twins(squared_limit_of_single_mass(1, zeta) * GiNaC::pow(1 + 2 * zeta * u, 2), zeta,
                                        {GiNaC::pow(Pi / 4, 2), 0}),
                  "A single mass at r = 1, mu = 1, for zeta -> 0: terms of the size of 1 / zeta cancel",
                  "\\overline{X} \\to \\frac{\\pi}{4}");
    const ex near = Pi / 4 * (1 - 2 * zeta);
    add_statement(outcome,
                  decide_term_and_twins(GiNaC::sqrt(1 / (4 * zeta * zeta) - near * near * u * u) - near * g, zeta, {1, 0}),
                  "and at beta = (pi/4)(1 - 2 zeta), below (67)", "\\overline{X} \\to 1");
    return outcome;
}

/// The modes of N equal masses and springs, and what their sums are for N -> infinity.
Outcome long_chain() {
    const ex theta = new_symbol("theta_chain", "\\theta", numeric(1, 10), 3), A = new_symbol("A_chain", "A", numeric(1, 10), 3);
    Outcome outcome;
    const ex lambda = 2 - 2 * GiNaC::cos(theta);
    add_statement(
        outcome, decide_zero_and_twin(2 * GiNaC::sin(A) - GiNaC::sin(A - theta) - GiNaC::sin(A + theta) - lambda * GiNaC::sin(A)),
        "Displacements sin(k theta) fulfil the equation of every mass k but the last, A = k theta; they are zero at the ground",
        "\\lambda = r_n^2 = 2-2\\cos\\theta");
    add_statement(
        outcome,
        decide_zero_and_twin(GiNaC::sin(A + theta / 2) - GiNaC::sin(A - theta / 2) - 2 * GiNaC::cos(A) * GiNaC::sin(theta / 2)),
        "The last mass, A = (N + 1/2) theta: the spring beyond it has no elongation where cos A is zero",
        "\\theta_i = \\frac{(2i-1)\\pi}{2N+1}");
    add_statement(outcome,
                  decide_zero_and_twin(GiNaC::sin(A + theta) - GiNaC::sin(A - theta) - 2 * GiNaC::cos(A) * GiNaC::sin(theta)),
                  "The sum of their squares telescopes, A = 2 k theta", "\\sum_k\\sin^2k\\theta_i = \\frac{2N+1}{4}");
    add_argument(
        outcome,
        "(33)-(35) with load and contact on mass 1 are sums by the midpoint rule, with 2 pi / (2N+1) from point to point",
        "\\sum_i\\frac{4\\sin^2\\theta_i}{2N+1}f(\\lambda_i) \\to \\frac{2}{\\pi}\\int_0^\\pi\\sin^2\\theta\\,f(2-2\\cos\\theta)"
        "\\,\\mathrm{d}\\theta");
    return outcome;
}

const Register claims_of_response_limits([] {
    return std::vector<Claim>{
        claim_on_limit("limits/merging-frequencies", {"33", "34", "35"},
                       "A mass with a tuned absorber that carries the load, for a light absorber: two natural frequencies merge",
                       {"zeta_1 = zeta_2", "j = 1, l = 2"}, merging_frequencies),
        claim_on_limit("limits/heavy-mass", {"33", "34", "35"},
                       "A mass between two springs, the second held by a mass without bound", {"zeta_1 = zeta_2", "j = l = 1"},
                       heavy_mass),
        claim_on_limit("limits/light-mass", {"33", "34", "35"}, "A mass loaded through a spring and a mass that vanishes",
                       {"zeta_1 = zeta_2 > 0", "j = 1, l = 2"}, light_mass),
        claim_on_limit("limits/beta-to-boundary", {"38", "67"}, "The amplitude (38) for beta -> beta_lim", {"beta below (67)"},
                       to_boundary),
        claim_on_limit("limits/long-chain", {"33", "34", "35"}, "A chain of equal masses and springs for N -> infinity",
                       {"j = l = 1", "zeta_i > 0, the same for all modes"}, long_chain),
    };
});

} // namespace
} // namespace denhartog::derivation

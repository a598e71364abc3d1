// Section 4.1: the orders of the errors of (76)-(85), and what the limits R_i -> 1 and zeta_i -> 0 are along which path.
#include "denhartog/formulas/resonance.hpp"

#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/limit_twins.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::lst;
using GiNaC::numeric;
using GiNaC::Pi;

namespace {

/// The slope c of the path R = 1 + c zeta to the resonance.
const ex& slope() {
    static const ex c = new_symbol("c", "c", -2, 2);
    return c;
}

/// A small quantity where zeta = 0 is put in first: R = 1 + epsilon.
const ex& distance() {
    static const ex epsilon = new_symbol("epsilon", "\\epsilon", numeric(1, 1000), numeric(1, 10));
    return epsilon;
}

ex coth_at_resonance() { return paper::second_damping_function_at_resonance(Symbolic(symbols().zeta)).expression(); }

/// |v|^2 along three paths.
Outcome paths_of_response() {
    const ex zeta = symbols().zeta, c = slope(), e = distance();
    Outcome outcome;
    add_statement(outcome, decide_term_and_twins(squared_response(1, zeta), zeta, {numeric(1, 4), -2}),
                  "R_i = 1, then zeta_i -> 0", "|v_{di}|^2 \\sim \\frac{1}{4\\zeta_i^2}");
    add_statement(outcome, decide_term_and_twins(squared_response(1 + e, 0), e, {numeric(1, 4), -2}),
                  "zeta_i = 0, then R_i = 1 + epsilon -> 1: no zeta_i is left to limit the response",
                  "|v_{di}|^2 \\sim \\frac{1}{4\\epsilon^2}");
    add_statement(outcome, decide_term_and_twins(squared_response(1 + c * zeta, zeta), zeta, {1 / (4 * (1 + c * c)), -2}),
                  "R_i = 1 + c zeta_i: the first path is c = 0, the second c -> infinity",
                  "|v_{di}|^2 \\sim \\frac{1}{4(1+c^2)\\zeta_i^2}");
    return outcome;
}

/// g along three paths.
Outcome paths_of_second_function() {
    const ex zeta = symbols().zeta, R = symbols().R, c = slope();
    Outcome outcome;
    add_statement(outcome, decide_term_and_twins(second_function(1, zeta), zeta, {2 / Pi, -1}), "R_i = 1, then zeta_i -> 0",
                  "g_i \\sim \\frac{2}{\\pi\\zeta_i}");
    add_statement(outcome, decide_zero_and_twin(second_function(R, 0)), "zeta_i = 0, then R_i -> 1", "g_i = 0");
    add_statement(outcome, decide_term_and_twins(second_function(1 + c * zeta, zeta), zeta, {2 / (Pi * (1 + c * c)), -1}),
                  "R_i = 1 + c zeta_i", "g_i \\sim \\frac{2}{\\pi(1+c^2)\\zeta_i}");
    return outcome;
}

/// u along three paths.
Outcome paths_of_first_function() {
    const ex zeta = symbols().zeta, c = slope(), e = distance();
    Outcome outcome;
    add_statement(outcome, decide_term_and_twins(first_function(1, zeta), zeta, {1 / Pi, 0}), "R_i = 1, then zeta_i -> 0",
                  "u_{di} \\to \\frac{1}{\\pi}");
    add_statement(outcome, decide_term_and_twins(first_function(1 + e, 0), e, {2 / Pi, -1}),
                  "zeta_i = 0, then R_i = 1 + epsilon -> 1", "u_{di} \\sim \\frac{2}{\\pi\\epsilon}");
    add_statement(outcome, decide_term_and_twins(first_function(1 + c * zeta, zeta), zeta, {2 * c / (Pi * (1 + c * c)), -1}),
                  "R_i = 1 + c zeta_i, c not 0", "u_{di} \\sim \\frac{2c}{\\pi(1+c^2)\\zeta_i}");
    return outcome;
}

/// The contributions of the other modes at R_i = 1, with damping ratios that fall in proportion: symbols without small quantity.
struct OtherModes {
    ex p_k, q_k, h_k, w_k, p_j, q_j, w_j; ///< Re V_k, Im V_k / zeta, G_k / zeta, U_k and the same of the contact
};

const OtherModes& other_modes() {
    static const OtherModes m = [] {
        const auto any = [](const char* name, const char* latex) { return new_symbol(name, latex, -1, 1); };
        return OtherModes{any("p_k", "p_k"), any("q_k", "q_k"), any("h_k", "h_k"), any("w_k", "w_k"),
                          any("p_j", "p_j"), any("q_j", "q_j"), any("w_j", "w_j")};
    }();
    return m;
}

/// Positive mode shapes of the resonant mode.
struct PositiveShapes {
    ex k, j, l;
};

const PositiveShapes& positive_shapes() {
    static const PositiveShapes psi = [] {
        const auto size = [](const char* name, const char* latex) { return new_symbol(name, latex, numeric(1, 2), 2); };
        return PositiveShapes{size("a_k", "|\\psi_{ki}|"), size("a_j", "|\\psi_{ji}|"), size("a_l", "|\\psi_{li}|")};
    }();
    return psi;
}

/// The boundary (67) along every straight path to R_i = 1, zeta_i = 0; t is the tangent of half the path's angle.
Outcome paths_of_boundary() {
    const ex rho = distance(), t = new_symbol("t_path", "t", numeric(1, 10), 10), all = GiNaC::pow(1 + t * t, 2);
    const ex R = 1 + rho * (1 - t * t), zeta = 2 * t * rho;
    const Complex<Symbolic> v = paper::complex_response(Symbolic(R), Symbolic(zeta));
    const ex u = first_function(R, zeta), g = second_function(R, zeta);
    const auto& [a_k, a_j, a_l] = positive_shapes();
    const OtherModes& m = other_modes();
    const ex V_r = a_j * a_l * R * R * v.re.expression() + m.p_j, V_i = a_j * a_l * R * R * v.im.expression() + m.q_j;
    const ex U = a_j * a_j * R * R * u + m.w_j, demand = a_j * a_j * (g + 2 * zeta * R * u) + m.h_k;
    Outcome outcome;
    add_statement(
        outcome,
        decide_term_and_twins((V_r * V_r + V_i * V_i) / (U * U + demand * demand), rho, {GiNaC::pow(Pi * a_l / (4 * a_j), 2), 0}),
        "R_i = 1 + rho (1 - t^2), zeta_i = 2 rho t, t the tangent of half the angle; the other modes and static friction add "
        "p + i q to V_dj, w to U_dj and h to the demand",
        "\\beta_{\\lim} \\to \\frac{\\pi}{4}\\left|\\frac{\\psi_{li}}{\\psi_{ji}}\\right|");
    const ex denominator = GiNaC::cosh(Pi * zeta / R) + GiNaC::cos(Pi * GiNaC::sqrt(1 - zeta * zeta) / R);
    add_statement(outcome, decide_term_and_twins(denominator, rho, {Pi * Pi / 2 * all, 2}),
                  "The denominator of u_di and g_i is of second order in every direction",
                  "\\cosh\\delta+\\cos\\theta \\sim \\frac{\\pi^2}{2}(1+t^2)^2\\rho^2");
    add_statement(outcome, decide_term_and_twins(1 / squared_response(R, zeta), rho, {4 * all, 2}),
                  "and so is that of the response", "|v_{di}|^{-2} \\sim 4(1+t^2)^2\\rho^2");
    add_argument(
        outcome,
        "(67) is analytic in distance and angle, its limit the same for all angles alike, and a path may turn as it likes", "");
    return outcome;
}

/// |V_dk|^2 over the square of (77), less one.
Outcome order_of_response() {
    const ex zeta = symbols().zeta;
    const auto& [a_k, a_j, a_l] = positive_shapes();
    const OtherModes& m = other_modes();
    const ex a = a_k * a_l, single = a / (2 * zeta);
    Outcome outcome;
    const auto error = [&](const ex& q) {
        return ((m.p_k * m.p_k + (q - single) * (q - single)) / (single * single)).expand() - 1;
    };
    add_statement(outcome, decide_term_and_twins(error(zeta * m.q_k), zeta, {4 * (m.p_k * m.p_k - a * m.q_k) / (a * a), 2}),
                  "The other modes add p + i zeta_i q to (33), their damping ratios in proportion to zeta_i",
                  "\\frac{|V_{dk}|^2}{(77)^2}-1 \\sim \\frac{4(p^2-q\\psi_{ki}\\psi_{li})}{(\\psi_{ki}\\psi_{li})^2}\\zeta_i^2");
    add_statement(outcome, decide_term_and_twins(error(m.q_k), zeta, {-4 * m.q_k / a, 1}),
                  "With damping ratios of the other modes that stay, they add p + i q",
                  "\\frac{|V_{dk}|^2}{(77)^2}-1 \\sim -\\frac{4q}{\\psi_{ki}\\psi_{li}}\\zeta_i");
    return outcome;
}

/// sin(angle V_k - angle V_j) = Im(V_k V_j*) / |V_k V_j|, with what the other modes add.
Outcome order_of_phase_difference() {
    const ex zeta = symbols().zeta;
    const auto& [a_k, a_j, a_l] = positive_shapes();
    const OtherModes& m = other_modes();
    const ex V_ki = zeta * zeta * m.q_k - a_k * a_l / 2, V_ji = zeta * zeta * m.q_j - a_j * a_l / 2;
    const ex V_kr = zeta * m.p_k, V_jr = zeta * m.p_j;
    const ex sine = (V_ki * V_jr - V_kr * V_ji) / GiNaC::sqrt((V_kr * V_kr + V_ki * V_ki) * (V_jr * V_jr + V_ji * V_ji));
    Outcome outcome;
    add_statement(outcome, decide_term_and_twins(sine, zeta, {2 / a_l * (m.p_k / a_k - m.p_j / a_j), 1}),
                  "The other modes add p + i zeta_i q to (33), their damping ratios in proportion to zeta_i",
                  "\\sin(\\angle V_{dk}-\\angle V_{dj}) \\sim \\frac{2}{\\psi_{li}}\\left(\\frac{p_k}{\\psi_{ki}}-"
                  "\\frac{p_j}{\\psi_{ji}}\\right)\\zeta_i");
    return outcome;
}

/// g at R = 1 over (79), and G_k over (80), less one.
Outcome order_of_second_function() {
    const ex zeta = symbols().zeta;
    const auto& [a_k, a_j, a_l] = positive_shapes();
    const ex h = other_modes().h_k, single = coth_at_resonance();
    Outcome outcome;
    add_statement(outcome, decide_term_and_twins(second_function(1, zeta) / single - 1, zeta, {-numeric(3, 4), 2}),
                  "(29) at R_i = 1 over (79)", "\\frac{g_i}{(79)}-1 \\sim -\\frac{3}{4}\\zeta_i^2");
    add_statement(outcome,
                  decide_term_and_twins((second_function(1, zeta) + h * zeta / (a_k * a_j)) / single - 1, zeta,
                                        {-numeric(3, 4) + Pi * h / (2 * a_k * a_j), 2}),
                  "The other modes add h zeta_i to (35), their damping ratios in proportion to zeta_i",
                  "\\frac{G_k}{(80)}-1 \\sim \\left(\\frac{\\pi h}{2\\psi_{ki}\\psi_{ji}}-\\frac34\\right)\\zeta_i^2");
    return outcome;
}

/// The square of (52) against the square of (83), both times zeta^2: V, G and U enter (52) as a form of first degree.
Outcome order_of_peak_of_mass() {
    const Symbols& s = symbols();
    const ex zeta = s.zeta;
    const auto& [a_k, a_j, a_l] = positive_shapes();
    const OtherModes& m = other_modes();
    const ex V_kr = zeta * m.p_k, V_ki = -a_k * a_l / 2 + zeta * zeta * m.q_k, V_jr = zeta * m.p_j,
             V_ji = -a_j * a_l / 2 + zeta * zeta * m.q_j;
    const ex G_k = 2 * a_k * a_j / Pi + zeta * zeta * m.h_k, U_k = zeta * m.w_k, U_j = zeta * m.w_j;
    const ex V_j_squared = V_jr * V_jr + V_ji * V_ji, root = GiNaC::sqrt(V_j_squared - s.beta * s.beta * U_j * U_j);
    const ex c = (V_jr * root - V_ji * s.beta * U_j) / V_j_squared, sine = (-V_jr * s.beta * U_j - V_ji * root) / V_j_squared;
    const ex x = V_kr * c - V_ki * sine - s.beta * G_k, rate = -(V_kr * sine + V_ki * c) - s.beta * U_k;
    const ex peak = a_k * a_l / 2 - s.beta * 2 * a_k * a_j / Pi;
    const ex error = x * x + rate * rate - peak * peak;
    const LeadingTerm term = leading_term(error, zeta);
    Outcome outcome;
    add_statement(outcome, term.power == 2 ? Verdict::proved : Verdict::refuted,
                  "The leading term of the square of zeta_i times (52) is that of (83)",
                  "\\overline{X}_k\\zeta_i \\to \\frac{|\\psi_{ki}\\psi_{li}|}{2}-\\frac{2|\\psi_{ki}\\psi_{ji}|}{\\pi}\\beta");
    add_statement(outcome, decide_term_and_twins(error, zeta, term),
                  "The next is of second order, the damping ratios of the other modes in proportion to zeta_i",
                  "\\frac{\\overline{X}_k}{(83)}-1 = O(\\zeta_i^2)");
    return outcome;
}

/// (38) of a single mass at r = 1 less (84).
Outcome order_of_peak_of_single_mass() {
    const ex zeta = symbols().zeta, beta = symbols().beta;
    const ex u = first_function(1, zeta), g = second_function(1, zeta);
    const ex root = GiNaC::sqrt(numeric(1, 4) - GiNaC::pow(beta * zeta * u, 2)) / zeta;
    const ex peak = paper::resonant_peak_of_single_mass(Symbolic(zeta), Symbolic(beta)).expression();
    Outcome outcome;
    add_statement(outcome,
                  decide_term_and_twins(root - beta * g - peak, zeta, {3 * beta / (2 * Pi) - beta * beta / (Pi * Pi), 1}),
                  "(38) at r = 1 less (84): positive, as beta is below pi/4",
                  "\\overline{X}-(84) \\sim \\left(\\frac{3\\beta}{2\\pi}-\\frac{\\beta^2}{\\pi^2}\\right)\\zeta");
    return outcome;
}

/// To leading order the amplitude (38) of a single mass along r = 1 + c zeta is largest at c = 0.
Outcome place_of_peak() {
    const ex y = new_symbol("y_peak", "y", numeric(1, 10), 1), b = new_symbol("b_peak", "b", numeric(1, 10), numeric(9, 10));
    Outcome outcome;
    add_claim(outcome, "76/paths", "v along r = 1 + c zeta");
    add_claim(outcome, "80/paths", "g along r = 1 + c zeta");
    add_claim(outcome, "28/paths-to-resonance", "u along r = 1 + c zeta");
    outcome.steps.push_back({"With y = 1 / (1 + c^2) and b = 4 beta / pi, below 1 where beta is below (85)",
                             "2\\zeta\\overline{X} \\to f(y) = \\sqrt{(1-b^2)y+b^2y^2} - by"});
    const ex radicand = (1 - b * b) * y + b * b * y * y, slope_of_radicand = radicand.diff(GiNaC::ex_to<GiNaC::symbol>(y));
    const ex c_squared = 1 / y - 1, square = y - GiNaC::pow(4 * symbols().beta / Pi, 2) * y * y * c_squared;
    add_statement(outcome, decide_zero_and_twin(square - radicand.subs(b == 4 * symbols().beta / Pi)),
                  "4 zeta^2 (|v|^2 - beta^2 u^2) in y is the radicand", "");
    const ex difference = slope_of_radicand * slope_of_radicand - 4 * b * b * radicand;
    add_statement(
        outcome, decide_zero_and_twin(difference - GiNaC::pow(1 - b * b, 2)),
        "f' > 0 says that the slope of the radicand exceeds 2 b times the root; the squares differ by a positive number",
        "(1-b^2+2b^2y)^2 - 4b^2[(1-b^2)y+b^2y^2] = (1-b^2)^2");
    add_statement(outcome, decide_zero_and_twin(radicand.subs(y == 1) - 1), "The root is 1 at y = 1",
                  "\\zeta\\overline{X} \\to \\frac{1}{2}-\\frac{2\\beta}{\\pi}");
    add_argument(outcome, "f grows up to y = 1: the peak lies at r = 1 but for a shift of higher order than zeta", "");
    return outcome;
}

/// (67) against (85), both squared.
Outcome order_of_boundary() {
    const Symbols& s = symbols();
    const ex zeta = s.zeta, mu = s.mu;
    const auto& [a_k, a_j, a_l] = positive_shapes();
    const OtherModes& m = other_modes();
    Outcome outcome;
    const ex V_squared = GiNaC::pow(zeta * m.p_j, 2) + GiNaC::pow(zeta * zeta * m.q_j - a_j * a_l / 2, 2);
    const ex demand = 2 * a_j * a_j / Pi + zeta * m.h_k, U = zeta * m.w_j;
    const ex limit = Pi * a_l / (4 * a_j);
    add_statement(
        outcome,
        decide_term_and_twins(V_squared / (U * U + demand * demand) / (limit * limit) - 1, zeta, {-Pi * m.h_k / (a_j * a_j), 1}),
        "H_j + mu / (gamma_j r^2) is psi_ji^2 g_i + h, h > 0 from static friction and the other modes",
        "\\frac{(67)}{(85)}-1 \\sim -\\frac{\\pi h}{2\\psi_{ji}^2}\\zeta_i");
    const ex u = first_function(1, zeta), g = second_function(1, zeta);
    const ex single = squared_response(1, zeta) / (u * u + GiNaC::pow(mu + g + 2 * zeta * u, 2));
    const ex printed = paper::friction_ratio_limit_at_resonance(Symbolic(1), Symbolic(1), Symbolic(zeta)).expression();
    add_statement(outcome, decide_term_and_twins(single / (printed * printed) - 1, zeta, {-Pi * mu, 1}), "For a single mass",
                  "\\frac{(67)}{(85)}-1 \\sim -\\frac{\\pi\\mu}{2}\\zeta");
    const ex tau = s.tau;
    const ex s_d = paper::s_d_integrand(Symbolic(tau), Symbolic(1), Symbolic(zeta), Symbolic(u), Symbolic(g)).expression();
    add_statement(outcome, decide_term_and_twins(s_d - g, zeta, {1 - 2 * tau / Pi, 0}),
                  "Its condition on the velocity is strictest for tau -> 0, so that (69) is (67) to this order",
                  "s(\\tau) - g \\to 1-\\frac{2\\tau}{\\pi}");
    return outcome;
}

const Register claims_of_section_4_1_orders([] {
    const std::vector<std::string> fall{"R_i = 1, then zeta_i -> 0", "damping ratios of the other modes in proportion to zeta_i",
                                        "no other R_m is 1/n, n odd"};
    return std::vector<Claim>{
        claim_on_limit("28/paths-to-resonance", {"28"}, "u_di at R_i -> 1 and zeta_i -> 0 depends on the path", {},
                       paths_of_first_function),
        claim_on_limit("76/paths", {"76"}, "v_di at R_i -> 1 and zeta_i -> 0 depends on the path", {}, paths_of_response),
        claim_on_limit("77/order", {"76", "77"}, "The amplitude (77) has a relative error of second order", fall,
                       order_of_response),
        claim_on_limit("78/order", {"78"}, "The sine in (78) is zero but for a term of first order", fall,
                       order_of_phase_difference),
        claim_on_limit("80/paths", {"79", "80"}, "g_i at R_i -> 1 and zeta_i -> 0 depends on the path", {},
                       paths_of_second_function),
        claim_on_limit("80/order", {"79", "80"}, "(79) and (80) have relative errors of second order", fall,
                       order_of_second_function),
        claim_on_limit("83/order", {"81", "82", "83"}, "(83) is (52) at resonance with a relative error of second order", fall,
                       order_of_peak_of_mass),
        claim_on_limit("84/order", {"84"}, "(84) is below (38) at r = 1 by a term of first order, relative error of second order",
                       {"r = 1, then zeta -> 0", "beta below (85)"}, order_of_peak_of_single_mass),
        claim_on_limit("84/place", {"83", "84"}, "To leading order the peak of a single mass lies at r = 1 and is linear in beta",
                       {"zeta -> 0", "beta below (85)"}, place_of_peak),
        claim_on_limit("85/paths", {"67", "85"}, "The boundary (67) has one limit along every path R_i -> 1, zeta_i -> 0",
                       {"psi_ji, psi_li not zero", "no other R_m is 1/n, n odd"}, paths_of_boundary),
        claim_on_limit("85/order", {"85"}, "(85) lies above (67) by a relative error of first order", fall, order_of_boundary),
    };
});

} // namespace
} // namespace denhartog::derivation

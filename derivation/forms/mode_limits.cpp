// The limits of the functions of one mode at the ends of their domain, path by path: leading terms of formulas/mode_limits.hpp.
#include "denhartog/formulas/mode_limits.hpp"

#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/limit_twins.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::Pi;

namespace {

/// The small quantity of a path.
const ex& small() {
    static const ex x = new_symbol("x_path", "x", numeric(1, 1000), numeric(1, 10));
    return x;
}

/// The factor of a path zeta = c x^b.
const ex& factor() {
    static const ex c = new_symbol("c_path", "c", numeric(1, 5), 3);
    return c;
}

/// A fixed frequency ratio away from 1/n, n odd.
const ex& off_poles() {
    static const ex R = new_symbol("R_fixed", "R", numeric(5, 4), 3);
    return R;
}

/// |v|^2, u and g along a path.
struct OnPath {
    ex squared_v, u, g;
};

OnPath functions_at(const ex& R, const ex& zeta) {
    return {squared_response(R, zeta), first_function(R, zeta), second_function(R, zeta)};
}

/// The three functions on a path against their leading terms, each with its twins.
void add_path(Outcome& outcome, const std::string& path, const OnPath& functions, const limits::ModeTerms<Symbolic>& terms) {
    const auto add = [&](const char* name, const ex& e, const limits::Term<Symbolic>& term) {
        const LeadingTerm expected{term.coefficient.expression(), term.power};
        const std::string power = expected.power == 0 ? "" : "\\,x^{" + std::to_string(expected.power) + "}";
        add_statement(outcome, decide_term_and_twins(e, small(), expected), path + ": " + name,
                      latex(expected.coefficient) + power);
    };
    add("|v|^2", functions.squared_v, terms.squared_v);
    add("u", functions.u, terms.u);
    add("g", functions.g, terms.g);
}

Outcome fixed_frequency() {
    Outcome outcome;
    add_path(outcome, "zeta = x -> 0, R fixed", functions_at(off_poles(), small()),
             limits::without_damping(Symbolic(off_poles())));
    return outcome;
}

Outcome fixed_damping() {
    Outcome outcome;
    for (const int side : {1, -1})
        add_path(outcome, side > 0 ? "R = 1 + x, zeta fixed" : "R = 1 - x, zeta fixed",
                 functions_at(1 + side * small(), symbols().zeta), limits::at_resonance(Symbolic(symbols().zeta)));
    return outcome;
}

Outcome both_to_resonance() {
    Outcome outcome;
    struct Powers {
        int a, b;
        const char* p;
    };
    for (const Powers& path : {Powers{4, 1, "1/4"}, {2, 1, "1/2"}, {1, 1, "1"}, {1, 2, "2"}, {1, 3, "3"}})
        for (const int side : {1, -1})
            add_path(outcome, std::string("zeta = c |R - 1|^p, p = ") + path.p + (side > 0 ? ", R above 1" : ", R below 1"),
                     functions_at(1 + side * GiNaC::pow(small(), path.a), factor() * GiNaC::pow(small(), path.b)),
                     limits::to_resonance(path.a, path.b, side, Symbolic(factor())));
    return outcome;
}

Outcome to_harmonics() {
    Outcome outcome;
    for (const int n : {1, 2, 3, 4, 5})
        add_path(outcome, "R = 1/" + std::to_string(n) + ", zeta = x", functions_at(numeric(1, n), small()),
                 limits::at_harmonic<Symbolic>(n));
    for (const int n : {2, 3, 4, 5})
        for (const int side : {1, -1})
            add_path(outcome, "R = (1 " + std::string(side > 0 ? "+" : "-") + " x)/" + std::to_string(n) + ", zeta = c x",
                     functions_at((1 + side * small()) / n, factor() * small()),
                     limits::to_harmonic(n, side, Symbolic(factor())));
    return outcome;
}

Outcome high_frequency() {
    Outcome outcome;
    add_path(outcome, "R = 1/x, zeta fixed", functions_at(1 / small(), symbols().zeta),
             limits::at_high_frequency(Symbolic(symbols().zeta)));
    return outcome;
}

/// With the root w = sqrt(1 - zeta^2) as the small quantity.
Outcome critical_damping() {
    const ex x = small(), zeta = symbols().zeta, square = 1 - zeta * zeta;
    const auto in_x = [&](const ex& e) {
        const ex with_x = e.subs(GiNaC::lst{GiNaC::sqrt(square) == x, 1 / GiNaC::sqrt(square) == 1 / x});
        return with_x.subs(zeta == GiNaC::sqrt(1 - x * x));
    };
    const auto [squared_v, u, g] = functions_at(symbols().R, zeta);
    Outcome outcome;
    add_path(outcome, "zeta = sqrt(1 - x^2) -> 1, R fixed", {in_x(squared_v), in_x(u), in_x(g)},
             limits::at_critical_damping(Symbolic(symbols().R)));
    return outcome;
}

/// With e^-delta as a small quantity of its own: theta turns ever faster, but its sine and cosine stay bounded.
Outcome low_frequency() {
    const ex x = small(), R = symbols().R, zeta = symbols().zeta, delta = Pi * zeta / R;
    const auto in_x = [&](const ex& e) {
        return e.subs(
            GiNaC::lst{GiNaC::cosh(delta) == (1 / x + x) / 2, GiNaC::sinh(delta) == (1 / x - x) / 2, GiNaC::exp(-delta) == x});
    };
    const auto factor_of = [&](const Symbolic& e) { return in_x(e.expression()).coeff(x, 1); };
    const ex u = in_x(first_function(R, zeta)), g = in_x(second_function(R, zeta));
    const Symbolic symbolic_R(R), symbolic_zeta(zeta);
    Outcome outcome;
    add_statement(outcome,
                  decide_term_and_twins(u, x, {factor_of(limits::first_function_at_low_frequency(symbolic_R, symbolic_zeta)), 1}),
                  "R -> 0, zeta fixed, x = exp(-pi zeta / R), which is below every power of R: u",
                  "u \\sim \\frac{2e^{-\\delta}\\sin\\theta}{Rw}");
    add_statement(outcome, decide_term_and_twins(g, x, {1, 0}), "R -> 0, zeta fixed: g", "g \\to 1");
    add_statement(outcome,
                  decide_term_and_twins(
                      g - 1, x, {factor_of(limits::second_function_less_one_at_low_frequency(symbolic_R, symbolic_zeta)), 1}),
                  "and how", "g-1 \\sim -2e^{-\\delta}\\left(\\cos\\theta+\\frac{\\zeta}{w}\\sin\\theta\\right)");
    add_statement(outcome, decide_term_and_twins(squared_response(x, zeta), x, {1, 0}), "R = x -> 0: |v|^2", "|v|^2 \\to 1");
    return outcome;
}

/// At R = x = 1/n the angle is n half-turns less epsilon, which falls to zero.
Outcome low_frequency_in_proportion() {
    const ex x = small(), c = factor(), zeta = c * x, w = GiNaC::sqrt(1 - zeta * zeta), theta = Pi * w / x,
             epsilon = Pi * c * c * x / (1 + w);
    Outcome outcome;
    add_statement(outcome, decide_zero_and_twin(theta + epsilon - Pi / x), "What the angle lacks to n half-turns",
                  "\\theta = n\\pi - \\epsilon, \\quad \\epsilon = \\frac{\\pi c^2x}{1+w}");
    for (const bool odd : {false, true}) {
        const int sign = odd ? -1 : 1;
        const auto at_harmonics = [&](const ex& e) {
            return e.subs(
                GiNaC::lst{GiNaC::cos(theta) == sign * GiNaC::cos(epsilon), GiNaC::sin(theta) == -sign * GiNaC::sin(epsilon)});
        };
        const auto [squared_v, u, g] = functions_at(x, zeta);
        add_path(outcome, odd ? "zeta = c R, R = 1/n, n odd" : "zeta = c R, R = 1/n, n even",
                 {squared_v, at_harmonics(u), at_harmonics(g)}, limits::at_low_frequency_in_proportion(odd, Symbolic(c)));
    }
    add_argument(outcome, "tanh and coth differ: along zeta = c R neither u nor g has a limit", "");
    return outcome;
}

Claim limit(std::string id, std::string title, std::vector<std::string> assumptions, std::function<Outcome()> check) {
    return claim_on_limit(std::move(id), {"23", "28", "29"}, std::move(title), std::move(assumptions), std::move(check));
}

const Register claims_of_mode_limits([] {
    return std::vector<Claim>{
        limit("limits/zeta-to-0", "The functions of a mode for zeta -> 0", {"R_i fixed, not 1/n, n odd"}, fixed_frequency),
        limit("limits/R-to-1", "The functions of a mode for R -> 1 with damping", {"0 < zeta_i < 1 fixed"}, fixed_damping),
        limit("limits/both", "The functions of a mode along zeta = c |R - 1|^p", {"c > 0", "p = 1/4, 1/2, 1, 2, 3"},
              both_to_resonance),
        limit("limits/R-to-1-over-n", "The functions of a mode for R -> 1/n and zeta -> 0", {"n = 1 to 5", "c > 0"},
              to_harmonics),
        limit("limits/R-to-infinity", "The functions of a mode for R -> infinity", {"0 < zeta_i < 1 fixed"}, high_frequency),
        limit("limits/R-to-0", "The functions of a mode for R -> 0", {"0 < zeta_i < 1 fixed"}, low_frequency),
        limit("limits/R-to-0-in-proportion", "Along zeta = c R -> 0 the damping functions of a mode have no limit",
              {"c > 0", "R_i = 1/n"}, low_frequency_in_proportion),
        limit("limits/zeta-to-1", "The functions of a mode for zeta -> 1", {"R_i fixed"}, critical_damping),
    };
});

} // namespace
} // namespace denhartog::derivation

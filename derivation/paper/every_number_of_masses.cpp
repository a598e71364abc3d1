// (16)-(20) for systems of every number of masses, by the step of the sums: with opaque sums over the masses before, one more
// mass adds its part, and with an opaque sum over the modes before, one more mode. The matrices are any symmetric ones.
#include "denhartog/formulas/modal_coordinate.hpp"
#include "denhartog/formulas/system.hpp"
#include "derivation/algebra/limits.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/claim.hpp"
#include "derivation/claims/provenance.hpp"

namespace denhartog::derivation {

using GiNaC::ex;

namespace {

using Entries = std::vector<Symbolic>;

/// The sums over the masses before, and the numbers of one more mass, n.
struct OneMoreMass {
    ex form;                    ///< psi_a^T M psi_b over the masses before
    ex row_a, row_b;            ///< row n of M times psi_a and psi_b, over the masses before
    ex psi_a, psi_b;            ///< the mode shapes at the mass n
    ex M_nn;                    ///< entry of M
    ex eta, rate, acceleration; ///< psi_i^T M x over the masses before, and its rates
    ex damping;                 ///< psi_i^T C x' over the masses before
    ex psi_ji, psi_li;          ///< the mode shape at contact and load, where these are among the masses before, else zero
    ex M_psi, C_psi;            ///< entry n of M psi_i and of C psi_i
    ex x, x_prime, x_second;    ///< motion of the mass n
    ex is_contact, is_load;     ///< 1 where the mass n is in contact, or loaded, else 0
};

const OneMoreMass& one_more_mass() {
    static const auto any = [](const char* name, const char* latex) { return new_symbol(name, latex, -1, 1); };
    static const OneMoreMass m{
        any("form_N", "m_{ab}"),         any("row_a_N", "m_{na}"),          any("row_b_N", "m_{nb}"),
        any("psi_na", "\\psi_{na}"),     any("psi_nb", "\\psi_{nb}"),       any("M_nn", "\\overline{M}_{nn}"),
        any("eta_N", "\\eta_i"),         any("eta_prime_N", "\\eta'_i"),    any("eta_second_N", "\\eta''_i"),
        any("damping_N", "c_i"),         any("psi_ji_N", "\\psi_{ji}"),     any("psi_li_N", "\\psi_{li}"),
        any("M_psi_n", "\\mu_{ni}"),     any("C_psi_n", "c_{ni}"),          any("x_n", "\\bar{x}_n"),
        any("x_prime_n", "\\bar{x}'_n"), any("x_second_n", "\\bar{x}''_n"), any("delta_nj", "\\delta_{nj}"),
        any("delta_nl", "\\delta_{nl}")};
    return m;
}

/// psi_a^T M psi_b with one more mass, by the sum of products that runs.
Symbolic form_with_one_more(const ex& form, const ex& row_a, const ex& row_b, const ex& psi_a, const ex& psi_b, const ex& M_nn) {
    const auto product = [](const ex& a, const ex& b, const ex& so_far) {
        return paper::entry_of_product<Symbolic>(Entries{Symbolic(a)}, Entries{Symbolic(b)}, Symbolic(so_far));
    };
    const Symbolic row_of_n = product(M_nn, psi_b, row_b); // row n of M times psi_b
    return product(psi_a, row_of_n.expression(), product(row_a, psi_b, form).expression());
}

/// Mode i with its shapes at contact and load over the masses before and the mass n.
ModeInScene<Symbolic> mode_with_one_more(const ex& zeta) {
    const Symbols& s = symbols();
    const OneMoreMass& m = one_more_mass();
    return {Symbolic(s.R), Symbolic(zeta), Symbolic(m.psi_ji + m.psi_a * m.is_contact), Symbolic(m.psi_li + m.psi_a * m.is_load)};
}

/// The residual of (20) for psi_i^T M x with one more mass.
Symbolic modal_residual_with_one_more(const ex& zeta) {
    const Symbols& s = symbols();
    const OneMoreMass& m = one_more_mass();
    return paper::modal_equation_residual(Symbolic(m.eta + m.M_psi * m.x), Symbolic(m.rate + m.M_psi * m.x_prime),
                                          Symbolic(m.acceleration + m.M_psi * m.x_second), Symbolic(s.tau),
                                          mode_with_one_more(zeta), Symbolic(s.beta), Symbolic(s.phi_j));
}

/// psi_i^T times what (12) leaves over: so far, and the row of one more mass. (15) makes (K psi_i)_n of (M psi_i)_n.
ex projected_residual(const ex& damping_before, const ex& damping_of_n) {
    const Symbols& s = symbols();
    const OneMoreMass& m = one_more_mass();
    const ex load = GiNaC::cos(s.tau + s.phi_j), stiffness = 1 / (s.R * s.R);
    const ex before = m.acceleration + damping_before + stiffness * m.eta - m.psi_ji * s.beta - m.psi_li * load;
    const ex of_n = from_premise() * m.M_psi * m.x_second + damping_of_n + stiffness * m.M_psi * m.x -
                    m.psi_a * (s.beta * m.is_contact + load * m.is_load);
    return before + of_n;
}

Outcome orthogonal() {
    const ex m = new_symbol("mass_form", "\\psi_a^T\\overline{M}\\psi_b", -1, 1),
             k = new_symbol("stiffness_form", "\\psi_a^T\\overline{K}\\psi_b", -1, 1);
    const ex a = new_symbol("Omega_a", "\\Omega_a", 1, 2), b = new_symbol("Omega_b", "\\Omega_b", 3, 4);
    const ex solved = GiNaC::lsolve(GiNaC::lst{k == b * b * m, k == a * a * m}, GiNaC::lst{m, k});
    Outcome outcome;
    for (const ex& equation : solved)
        add_statement(outcome, decide_equal(equation.rhs(), 0, domain_of({a, b})).verdict,
                      "(15) of mode b times psi_a, and of mode a times psi_b, leave for the forms, which are symmetric",
                      latex(equation.lhs()) + " = 0");
    if (differs_at_samples(k - b * b * m, k - a * a * m, domain_of({k, m, a, b}))) ++altered_statements_refuted();
    add_claim(outcome, "17/symmetric-form", "the forms are symmetric for every number of masses");
    return outcome;
}

Outcome sum_of_squares() {
    Outcome outcome;
    add_claim(outcome, "17/orthogonal", "the modal matrix diagonalises M for every number of masses");
    add_argument(
        outcome,
        "With (17) the inverse of the modal matrix is its transpose times M, and an inverse from the left is one from the "
        "right; (65) is the entry of the contact",
        "\\boldsymbol\\Psi^T\\overline{\\mathbf{M}}\\boldsymbol\\Psi=\\mathbf{I} \\Rightarrow "
        "\\boldsymbol\\Psi\\boldsymbol\\Psi^T=\\overline{\\mathbf{M}}^{-1}");
    outcome.why_no_twin = "an argument from claims that have twins";
    return outcome;
}

const Register claims_of_every_number_of_masses([] {
    const Symbols& s = symbols();
    const OneMoreMass& m = one_more_mass();
    const std::string any_number = "any number of masses before";
    return std::vector<Claim>{
        {.id = "17/symmetric-form",
         .equations = {"17"},
         .role = Role::step,
         .title = "With one more mass psi_a^T M psi_b is still psi_b^T M psi_a",
         .assumptions = {any_number, "M symmetric"},
         .kernel = [&m] { return Values{form_with_one_more(m.form, m.row_a, m.row_b, m.psi_a, m.psi_b, m.M_nn)}; },
         .derived =
             [&m] {
                 const GiNaC::matrix M{{0, 1}, {1, m.M_nn}}; // border of the form so far
                 const ex border = GiNaC::matrix{{m.row_b, m.psi_b}}.mul(M).mul(GiNaC::matrix{{m.row_a}, {m.psi_a}})(0, 0);
                 return std::vector<ex>{m.form + border};
             }},
        {.id = "17/orthogonal",
         .equations = {"15", "17"},
         .role = Role::step,
         .title = "Modes of different natural frequencies are orthogonal in M and in K",
         .assumptions = {any_number, "M, K symmetric", "Omega_a not Omega_b"},
         .check = orthogonal},
        {.id = "18/one-more-mode",
         .equations = {"18", "19"},
         .role = Role::step,
         .title = "psi_a^T C psi_b by (19): with one more mode 2 zeta Omega more where it is mode a and b, else nothing",
         .assumptions = {"any number of modes before", "(17)"},
         .kernel =
             [&s, &m] {
                 const Entries Omega{Symbolic(1 / s.R)}, zeta{Symbolic(s.zeta)}, one{Symbolic(1)}, none{Symbolic(ex(0))};
                 return Values{paper::entry_of_damping<Symbolic>(Omega, zeta, one, one, Symbolic(m.form)),
                               paper::entry_of_damping<Symbolic>(Omega, zeta, none, one, Symbolic(m.form))};
             },
         .derived =
             [&s, &m] {
                 return std::vector<ex>{m.form + 2 * from_premise() * s.zeta / s.R, m.form};
             },
         .special_case = true},
        {.id = "16/one-more-mass",
         .equations = {"16"},
         .role = Role::step,
         .title = "psi_i^T times (12) with one more mass: its row adds to every term of (16), any damping matrix",
         .assumptions = {any_number, "M, K, C symmetric", "(15)"},
         .kernel =
             [&m] {
                 const ex damping = m.damping + m.C_psi * m.x_prime;
                 return Values{Symbolic(modal_residual_with_one_more(0).expression() + damping)};
             },
         .derived = [&m] { return std::vector<ex>{projected_residual(m.damping, m.C_psi * m.x_prime)}; },
         .special_case = true},
        {.id = "20/one-more-mass",
         .equations = {"20"},
         .role = Role::step,
         .title = "psi_i^T times (12) with one more mass is still (20), eta_i being psi_i^T M x",
         .assumptions = {any_number, "M, K symmetric", "(15)", "(18)"},
         .kernel = [&s] { return Values{modal_residual_with_one_more(s.zeta)}; },
         .derived =
             [&s, &m] {
                 const ex rate = 2 * s.zeta / s.R; // (C psi_i)_n is it times (M psi_i)_n
                 return std::vector<ex>{projected_residual(rate * m.rate, rate * m.M_psi * m.x_prime)};
             }},
        {.id = "65/every-number",
         .equations = {"65"},
         .role = Role::step,
         .title = "The squares of the mode shapes at the contact add up to the entry of the inverse of M",
         .assumptions = {"every number of masses", "(17)"},
         .check = sum_of_squares},
    };
});

} // namespace

} // namespace denhartog::derivation

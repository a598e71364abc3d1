// Section 2.1, (1)-(20): the equation of motion, its non-dimensional form, and its modal coordinates.
#include "claim.hpp"
#include "denhartog/formulas/as_printed.hpp"
#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/superposition.hpp"
#include "symbols.hpp"
#include "system_matrices.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::matrix;

namespace {

std::vector<Symbolic> entries(const matrix& m) {
    std::vector<Symbolic> values;
    for (unsigned k = 0; k < m.rows(); ++k)
        for (unsigned i = 0; i < m.cols(); ++i) values.emplace_back(m(k, i));
    return values;
}

std::vector<Symbolic> symbolic(const std::vector<ex>& values) { return {values.begin(), values.end()}; }

std::vector<ex> expressions(const matrix& m) {
    std::vector<ex> values;
    for (unsigned k = 0; k < m.rows(); ++k)
        for (unsigned i = 0; i < m.cols(); ++i) values.push_back(m(k, i));
    return values;
}

matrix shipped_damping_matrix(int N) {
    const SymbolicSystem& s = symbolic_system(N);
    const std::vector<Symbolic> M = entries(s.M), Psi = entries(s.Psi), Omega = symbolic(s.Omega), zeta = symbolic(s.zeta);
    const std::vector<Symbolic> C = paper::damping_matrix<Symbolic>(M, Psi, Omega, zeta);
    matrix result(N, N);
    for (int k = 0; k < N; ++k)
        for (int n = 0; n < N; ++n) result(k, n) = C[k * N + n].expression();
    return result;
}

Values all_values(const matrix& m) { return entries(m); }

/// Stiffness matrix of the chain as second derivatives of the energy of its springs.
std::vector<ex> hessian_of_chain(const std::vector<ex>& k) {
    std::vector<GiNaC::symbol> x;
    for (std::size_t i = 0; i < k.size(); ++i) x.emplace_back("x" + std::to_string(i + 1));
    ex energy = 0;
    for (std::size_t i = 0; i < k.size(); ++i) energy += k[i] * GiNaC::pow(i == 0 ? ex(x[0]) : ex(x[i] - x[i - 1]), 2) / 2;
    std::vector<ex> K;
    for (const GiNaC::symbol& a : x)
        for (const GiNaC::symbol& b : x) K.push_back(energy.diff(a).diff(b));
    return K;
}

/// Terms of the equation of motion of one mass, as they stand in (4) and (6), in the order inertia, damping, stiffness, friction,
/// load; the derivatives in tau are symbols of their own.
struct Motion {
    ex inertia, damping, stiffness, sgn, load;
};

const Motion& motion() {
    static const Motion m{new_symbol("x_double_prime", "\\bar{x}''", -1, 1), new_symbol("x_prime", "\\bar{x}'", -1, 1),
                          new_symbol("x_bar", "\\bar{x}", -1, 1), new_symbol("sgn", "\\mathrm{sgn}", -1, 1),
                          new_symbol("cos_tau", "\\cos\\tau", -1, 1)};
    return m;
}

ex damping_constant() {
    static const ex c = new_symbol("c", "c", GiNaC::numeric(1, 5), 2);
    return c;
}

/// One row of (6) and the non-dimensional time, through the shipped functions.
Values non_dimensional_residual() {
    const Symbols& s = symbols();
    const Motion& m = motion();
    const Symbolic omega(s.omega), k_1(s.k_1);
    const Symbolic displacement = paper::non_dimensional_displacement(Symbolic(s.x), k_1, Symbolic(s.P));
    return {paper::non_dimensional_mass(Symbolic(s.m_i), omega, k_1) * Symbolic(m.inertia) +
                paper::non_dimensional_damping(Symbolic(damping_constant()), omega, k_1) * Symbolic(m.damping) +
                paper::stiffness_ratio(Symbolic(s.k_i), k_1) * displacement +
                paper::friction_ratio(Symbolic(s.F), Symbolic(s.P)) * Symbolic(m.sgn) - Symbolic(m.load),
            paper::non_dimensional_time(omega, Symbolic(s.t))};
}

/// One row of (4), divided by P. d/dt = omega d/dtau; the rates in tau belong to the non-dimensional displacement.
std::vector<ex> residual_of_4_over_P() {
    const Symbols& s = symbols();
    const Motion& m = motion();
    const ex unit = s.P / s.k_1;
    const ex x_double_dot = unit * s.omega * s.omega * m.inertia, x_dot = unit * s.omega * m.damping;
    const ex residual = s.m_i * x_double_dot + damping_constant() * x_dot + s.k_i * s.x + s.F * m.sgn - s.P * m.load;
    return {residual / s.P, s.omega * s.t};
}

/// (20) for every mode of a symbolic system; eta, eta', eta'' are the symbols u, g, Re v. Contact on the first mass, load on the last.
Values modal_equations(int N) {
    const SymbolicSystem& s = symbolic_system(N);
    const SymbolicModes m = symbolic_modes(N);
    Values values;
    for (int i = 0; i < N; ++i) {
        const ModeInScene<Symbolic> mode{Symbolic(1) / Symbolic(s.Omega[i]), Symbolic(s.zeta[i]), Symbolic(s.Psi(0, i)),
                                         Symbolic(s.Psi(N - 1, i))};
        values.push_back(paper::modal_equation_residual(m.u[i], m.g[i], m.v[i].re, Symbolic(symbols().tau), mode,
                                                        Symbolic(symbols().beta), Symbolic(symbols().phi_j)));
    }
    return values;
}

/// The transposed modal matrix times what (12) leaves over for x = Psi eta.
std::vector<ex> derived_modal_equations(int N) {
    const SymbolicSystem& s = symbolic_system(N);
    const SymbolicModes m = symbolic_modes(N);
    matrix eta(N, 1), velocity(N, 1), second(N, 1), load(N, 1);
    for (int i = 0; i < N; ++i) {
        eta(i, 0) = m.u[i].expression();
        velocity(i, 0) = m.g[i].expression();
        second(i, 0) = m.v[i].re.expression();
    }
    load(0, 0) = symbols().beta;
    load(N - 1, 0) = load(N - 1, 0) + GiNaC::cos(symbols().tau + symbols().phi_j);
    const matrix residual = s.M.mul(s.Psi).mul(second).add(s.C.mul(s.Psi).mul(velocity)).add(s.K.mul(s.Psi).mul(eta)).sub(load);
    return expressions(s.Psi.transpose().mul(residual));
}

const Register claims_of_section_2_1_formulation([] {
    const Symbols& s = symbols();
    static const ex sgn_x = new_symbol("sgn_x", "\\mathrm{sgn}\\,x_j", -1, 1);
    std::vector<Claim> list{
        {.id = "1/chain",
         .equations = {"1"},
         .title = "Stiffness matrix of the chain from the energy of its springs, N = 1 to 4",
         .assumptions = {"k_i > 0"},
         .kernel =
             [] {
                 Values values;
                 for (int N = 1; N <= 4; ++N) {
                     const std::vector<Symbolic> k = symbolic({symbols().k_1, symbols().k_i, symbols().m_1, symbols().m_i});
                     for (const Symbolic& entry : paper::chain_stiffness_matrix<Symbolic>(std::span(k).first(N)))
                         values.push_back(entry);
                 }
                 return values;
             },
         .derived =
             [] {
                 std::vector<ex> values;
                 const std::vector<ex> k{symbols().k_1, symbols().k_i, symbols().m_1, symbols().m_i};
                 for (int N = 1; N <= 4; ++N)
                     for (const ex& entry : hessian_of_chain({k.begin(), k.begin() + N})) values.push_back(entry);
                 return values;
             }},
        {.id = "2/printed",
         .equations = {"2"},
         .role = Role::printed,
         .title = "Friction force with the sign of the displacement",
         .kernel = [&s] { return Values{as_printed::friction_force(Symbolic(s.F), Symbolic(sgn_x))}; },
         .derived = [&s] { return std::vector<ex>{-s.F * motion().sgn}; },
         .departure = Departure::scan,
         .correction = "F_f = -F\\,\\mathrm{sgn}(\\dot{x}_j)"},
        {.id = "2/friction-force",
         .equations = {"2"},
         .role = Role::shipped,
         .title = "Friction force: what (4) has on its left, with the opposite sign",
         .kernel = [&s] { return Values{paper::friction_force(Symbolic(s.F), Symbolic(motion().sgn))}; },
         .derived = [&s] { return std::vector<ex>{-s.F * motion().sgn}; }},
        {.id = "4/printed",
         .equations = {"4"},
         .role = Role::printed,
         .title = "One unit vector for friction and load, looked at on the mass in contact while the load acts on another",
         .assumptions = {"j not l"},
         .kernel =
             [&s] {
                 return Values{as_printed::equation_of_motion_residual(Symbolic(s.x), Symbolic(1), Symbolic(s.F),
                                                                       Symbolic(motion().sgn), Symbolic(s.P * motion().load))};
             },
         .derived = [&s] { return std::vector<ex>{s.x + s.F * motion().sgn}; },
         .departure = Departure::scan,
         .correction = "\\mathbf{M}\\ddot{\\mathbf{x}} + \\mathbf{C}\\dot{\\mathbf{x}} + \\mathbf{K}\\mathbf{x} + "
                       "F\\mathbf{e}_j\\mathrm{sgn}(\\dot{x}_j) = P\\mathbf{e}_l\\cos(\\omega t)"},
        {.id = "5/printed",
         .equations = {"5"},
         .role = Role::printed,
         .title = "Displacement made non-dimensional with the stiffness ratio kappa_1 = 1",
         .kernel = [&s] { return Values{as_printed::non_dimensional_displacement(Symbolic(s.x), Symbolic(1), Symbolic(s.P))}; },
         .derived = [&s] { return std::vector<ex>{s.k_1 * s.x / s.P}; },
         .departure = Departure::scan,
         .correction = "\\tau = \\omega t, \\qquad \\bar{\\mathbf{x}} = \\frac{k_1}{P}\\mathbf{x}"},
        {.id = "4/dimensional",
         .equations = {"4", "5"},
         .role = Role::shipped,
         .title = "The equation of motion (4), divided by P, in tau and the displacement over P / k_1, is (6)",
         .assumptions = {"omega, k_1, P > 0"},
         .kernel = non_dimensional_residual,
         .derived = residual_of_4_over_P},
        {.id = "6/non-dimensional",
         .equations = {"6", "7", "11"},
         .title = "The non-dimensional equation with the matrices (7) and the friction ratio (11)",
         .assumptions = {"omega, k_1, P > 0"},
         .kernel = non_dimensional_residual,
         .derived = residual_of_4_over_P,
         .steps = {{"(4) is divided by $P$; with $\\tau=\\omega t$ every dot is $\\omega$ times a prime, and "
                    "$\\mathbf{x}=P\\bar{\\mathbf{x}}/k_1$",
                    ""}}},
        {.id = "12/half-period",
         .equations = {"12"},
         .title = "Where the contact moves from its maximum to its minimum, sgn is -1 and friction acts with + beta on the right",
         .assumptions = {"x_j' < 0 for 0 < tau < pi"},
         .kernel = [&s] { return Values{paper::friction_force(Symbolic(s.beta), Symbolic(-1))}; },
         .derived = [&s] { return std::vector<ex>{s.beta}; },
         .special_case = true,
         .steps = {{"In (6) the sign of $\\bar{x}_j'$ is $-1$ over the half-period, and friction goes to the right side", ""}}},
        {.id = "8/mass-by-ratios",
         .equations = {"8", "9", "10"},
         .title = "Mass ratio and frequency ratio give the non-dimensional mass",
         .assumptions = {"m_1, k_1 > 0"},
         .kernel =
             [&s] {
                 const Symbolic gamma = paper::mass_ratio(Symbolic(s.m_i), Symbolic(s.m_1));
                 const Symbolic r = paper::frequency_ratio(Symbolic(s.omega), Symbolic(s.m_1), Symbolic(s.k_1));
                 return Values{paper::non_dimensional_mass_by_ratios(gamma, r)};
             },
         .derived = [&s] { return std::vector<ex>{s.omega * s.omega / s.k_1 * s.m_i}; },
         .steps = {{"(9) and (10) are put into $\\gamma_ir^2$; this has to be the entry $\\omega^2m_i/k_1$ of (7)", ""}}},
        {.id = "16/printed",
         .equations = {"16"},
         .role = Role::printed,
         .title = "Modal load with one row of the modal matrix for friction and load",
         .assumptions = {"j not l"},
         .kernel = [&s] { return Values{as_printed::modal_load(Symbolic(s.psi_ji), Symbolic(s.beta), Symbolic(motion().load))}; },
         .derived = [&s] { return std::vector<ex>{s.psi_ji * s.beta + s.psi_li * motion().load}; },
         .departure = Departure::scan,
         .correction = "\\hat{\\mathbf{M}}\\boldsymbol\\eta'' + \\hat{\\mathbf{C}}\\boldsymbol\\eta' + "
                       "\\hat{\\mathbf{K}}\\boldsymbol\\eta = \\boldsymbol\\Psi^T\\mathbf{e}_j\\beta + "
                       "\\boldsymbol\\Psi^T\\mathbf{e}_l\\cos(\\tau+\\phi_j)"},
    };
    list.push_back(
        {.id = "19/formula",
         .equations = {"19"},
         .title = "The sum over the modes, for any mass matrix and any modal matrix, N = 2",
         .kernel =
             [] {
                 const SymbolicModes m = symbolic_modes(3);
                 const std::vector<Symbolic> M{m.u[0], m.u[1], m.u[2], m.g[0]},
                     Psi{m.psi_k[0], m.psi_k[1], m.psi_j[0], m.psi_j[1]};
                 return paper::damping_matrix<Symbolic>(M, Psi, std::span(m.R).first(2), std::span(m.zeta).first(2));
             },
         .derived =
             [] {
                 const SymbolicModes m = symbolic_modes(3);
                 const matrix M{{m.u[0].expression(), m.u[1].expression()}, {m.u[2].expression(), m.g[0].expression()}};
                 matrix C(2, 2);
                 for (int i = 0; i < 2; ++i) {
                     const matrix psi{{m.psi_k[i].expression()}, {m.psi_j[i].expression()}};
                     const matrix M_psi = M.mul(psi);
                     C = C.add(M_psi.mul(M_psi.transpose()).mul_scalar(2 * m.zeta[i].expression() * m.R[i].expression()));
                 }
                 return expressions(C);
             },
         .steps = {{"(18) is multiplied from both sides with the inverse of $\\boldsymbol\\Psi$, which by (17) is "
                    "$\\boldsymbol\\Psi^T\\overline{\\mathbf{M}}$; a diagonal matrix "
                    "in the middle makes a sum over the modes",
                    ""}}});
    for (int N = 1; N <= 3; ++N) {
        const std::string of_N = "/N=" + std::to_string(N);
        const std::vector<std::string> system{"M diagonal, positive", "Omega_i > 0", "0 <= zeta_i < 1",
                                              "N = " + std::to_string(N)};
        list.push_back(
            {.id = "17/orthonormal" + of_N,
             .equations = {"13", "14", "15", "17"},
             .title = "Mode shapes solve the eigenproblem and diagonalise mass and stiffness",
             .assumptions = system,
             .kernel =
                 [N] {
                     const SymbolicSystem& s = symbolic_system(N);
                     matrix Omega2(N, N);
                     for (int i = 0; i < N; ++i) Omega2(i, i) = s.Omega[i] * s.Omega[i];
                     Values values = all_values(s.K.mul(s.Psi).sub(s.M.mul(s.Psi).mul(Omega2)));
                     for (const matrix& m : {s.Psi.transpose().mul(s.M).mul(s.Psi), s.Psi.transpose().mul(s.K).mul(s.Psi)})
                         for (const Symbolic& entry : all_values(m)) values.push_back(entry);
                     return values;
                 },
             .derived =
                 [N] {
                     const SymbolicSystem& s = symbolic_system(N);
                     matrix zero(N, N), one(N, N), Omega2(N, N);
                     for (int i = 0; i < N; ++i) {
                         one(i, i) = 1;
                         Omega2(i, i) = s.Omega[i] * s.Omega[i];
                     }
                     std::vector<ex> values;
                     for (const matrix& m : {zero, one, Omega2})
                         for (const ex& entry : expressions(m)) values.push_back(entry);
                     return values;
                 },
             .special_case = true});
        list.push_back(
            {.id = "19/damping-matrix" + of_N,
             .equations = {"18", "19"},
             .title = "The damping matrix made from the modal damping ratios gives them back, and meets K M^-1 C = C M^-1 K",
             .assumptions = system,
             .kernel =
                 [N] {
                     const SymbolicSystem& s = symbolic_system(N);
                     const matrix C = shipped_damping_matrix(N), inverse = s.M.inverse();
                     Values values = all_values(s.Psi.transpose().mul(C).mul(s.Psi));
                     for (const Symbolic& entry : all_values(s.K.mul(inverse).mul(C).sub(C.mul(inverse).mul(s.K))))
                         values.push_back(entry);
                     return values;
                 },
             .derived =
                 [N] {
                     const SymbolicSystem& s = symbolic_system(N);
                     matrix C(N, N), zero(N, N);
                     for (int i = 0; i < N; ++i) C(i, i) = 2 * s.zeta[i] * s.Omega[i];
                     std::vector<ex> values = expressions(C);
                     for (const ex& entry : expressions(zero)) values.push_back(entry);
                     return values;
                 },
             .special_case = true});
        list.push_back(
            {.id = "16/modal-coordinates" + of_N,
             .equations = {"16"},
             .role = Role::shipped,
             .title =
                 "Multiplying (12) by the transposed modal matrix uncouples it, with row j for friction and row l for the load",
             .assumptions = system,
             .kernel = [N] { return modal_equations(N); },
             .derived = [N] { return derived_modal_equations(N); },
             .special_case = true,
             .steps = {{"(13) is put into (12), which is multiplied by $\\boldsymbol\\Psi^T$; (17) and (18) make all matrices "
                        "diagonal",
                        ""}}});
        list.push_back({.id = "20/modal-equation" + of_N,
                        .equations = {"20"},
                        .title = "Every row of the uncoupled equations is (20)",
                        .assumptions = system,
                        .kernel = [N] { return modal_equations(N); },
                        .derived = [N] { return derived_modal_equations(N); },
                        .steps = {{"Row $i$ of (16), with (17) and (18)", ""}}});
        list.push_back({.id = "65/sum-of-squares" + of_N,
                        .equations = {"65"},
                        .title = "The squares of the mode shapes at a mass add up to 1 / (gamma r^2)",
                        .assumptions = system,
                        .kernel =
                            [N] {
                                const SymbolicSystem& s = symbolic_system(N);
                                return Values{paper::sum_of_squares_at_contact(Symbolic(s.gamma[0]), Symbolic(s.r))};
                            },
                        .derived =
                            [N] {
                                const SymbolicSystem& s = symbolic_system(N);
                                ex sum = 0;
                                for (int i = 0; i < N; ++i) sum += s.Psi(0, i) * s.Psi(0, i);
                                return std::vector<ex>{sum};
                            },
                        .steps = {{"(17) says $\\boldsymbol\\Psi\\boldsymbol\\Psi^T=\\overline{\\mathbf{M}}^{-1}$; this is its "
                                   "diagonal entry at the contact, with (8)",
                                   ""}}});
    }
    return list;
});

} // namespace
} // namespace denhartog::derivation

// Section 2.1, (13)-(20): the modes, the equation of motion in modal coordinates, the damping matrix; (65), by (17).
#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/superposition.hpp"
#include "denhartog/formulas/system.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/claim.hpp"
#include "derivation/claims/provenance.hpp"
#include "derivation/paper/system_matrices.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::matrix;

namespace {

Values all_values(const matrix& m) {
    std::vector<Symbolic> values;
    for (unsigned k = 0; k < m.rows(); ++k)
        for (unsigned i = 0; i < m.cols(); ++i) values.emplace_back(m(k, i));
    return values;
}

std::vector<ex> expressions(const matrix& m) {
    std::vector<ex> values;
    for (unsigned k = 0; k < m.rows(); ++k)
        for (unsigned i = 0; i < m.cols(); ++i) values.push_back(m(k, i));
    return values;
}

matrix shipped_damping_matrix(int N) {
    const SymbolicSystem& s = symbolic_system(N);
    const std::vector<Symbolic> M = all_values(s.M), Psi = all_values(s.Psi), Omega = Values(s.Omega.begin(), s.Omega.end()),
                                zeta = Values(s.zeta.begin(), s.zeta.end());
    const std::vector<Symbolic> C = paper::damping_matrix<Symbolic>(M, Psi, Omega, zeta);
    matrix result(N, N);
    for (int k = 0; k < N; ++k)
        for (int n = 0; n < N; ++n) result(k, n) = C[k * N + n].expression();
    return result;
}

/// (20) for every mode of a symbolic system; u, g, Re v stand for eta, eta', eta''. Contact on mass 1, load on the last.
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

/// A damping matrix that need not be diagonal in the modes.
const matrix& any_damping_matrix(int N) {
    static const matrix all = [] {
        matrix C(3, 3);
        for (int k = 0; k < 3; ++k)
            for (int n = 0; n < 3; ++n) {
                const std::string kn = std::to_string(k + 1) + std::to_string(n + 1);
                C(k, n) = new_symbol("C_" + kn, "\\overline{C}_{" + kn + "}", -1, 1);
            }
        return C;
    }();
    static const matrix parts[]{GiNaC::ex_to<matrix>(GiNaC::sub_matrix(all, 0, 1, 0, 1)),
                                GiNaC::ex_to<matrix>(GiNaC::sub_matrix(all, 0, 2, 0, 2)), all};
    return parts[N - 1];
}

/// The rows of (16), coupled by the damping: (20) without damping, and the modal damping matrix on the velocities.
Values coupled_modal_equations(int N) {
    const SymbolicSystem& s = symbolic_system(N);
    const SymbolicModes m = symbolic_modes(N);
    const matrix C = s.Psi.transpose().mul(any_damping_matrix(N)).mul(s.Psi);
    Values values;
    for (int i = 0; i < N; ++i) {
        const ModeInScene<Symbolic> undamped{Symbolic(1 / s.Omega[i]), Symbolic(ex(0)), Symbolic(s.Psi(0, i)),
                                             Symbolic(s.Psi(N - 1, i))};
        ex damping = 0;
        for (int n = 0; n < N; ++n) damping += C(i, n) * m.g[n].expression();
        const Symbolic row = paper::modal_equation_residual(m.u[i], m.g[i], m.v[i].re, Symbolic(symbols().tau), undamped,
                                                            Symbolic(symbols().beta), Symbolic(symbols().phi_j));
        values.emplace_back(row.expression() + damping);
    }
    return values;
}

/// The transposed modal matrix times what (12) leaves over for x = Psi eta.
std::vector<ex> derived_modal_equations(int N, const matrix& C) {
    const SymbolicSystem& s = symbolic_system(N);
    const SymbolicModes m = symbolic_modes(N);
    matrix eta(N, 1), velocity(N, 1), second(N, 1), load(N, 1);
    for (int i = 0; i < N; ++i) {
        eta(i, 0) = m.u[i].expression();
        velocity(i, 0) = m.g[i].expression();
        second(i, 0) = m.v[i].re.expression();
    }
    load(0, 0) = from_premise() * symbols().beta;
    load(N - 1, 0) = load(N - 1, 0) + GiNaC::cos(symbols().tau + symbols().phi_j);
    const matrix residual = s.M.mul(s.Psi).mul(second).add(C.mul(s.Psi).mul(velocity)).add(s.K.mul(s.Psi).mul(eta)).sub(load);
    return expressions(s.Psi.transpose().mul(residual));
}

const Register claims_of_section_2_1_modes([] {
    std::vector<Claim> list;
    list.push_back(
        {.id = "19/formula",
         .equations = {"19"},
         .title = "The sum over the modes, for any mass matrix and any modal matrix",
         .assumptions = {"N = 2"},
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
             .equations = {"19"},
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
                     for (int i = 0; i < N; ++i) C(i, i) = 2 * from_premise() * s.zeta[i] * s.Omega[i];
                     std::vector<ex> values = expressions(C);
                     for (const ex& entry : expressions(zero)) values.push_back(entry);
                     return values;
                 },
             .special_case = true});
        list.push_back(
            {.id = "16/modal-coordinates" + of_N,
             .equations = {"16"},
             .role = Role::shipped,
             .title = "Multiplying (12) by the transposed modal matrix: row j of it for friction, row l for the load, for any "
                      "damping matrix",
             .assumptions = {"M diagonal, positive", "Omega_i > 0", "any damping matrix", "N = " + std::to_string(N)},
             .kernel = [N] { return coupled_modal_equations(N); },
             .derived = [N] { return derived_modal_equations(N, any_damping_matrix(N)); },
             .special_case = true,
             .steps = {{"(13) is put into (12), which is multiplied by $\\boldsymbol\\Psi^T$; (17) makes two matrices diagonal",
                        ""}}});
        list.push_back({.id = "20/modal-equation" + of_N,
                        .equations = {"20"},
                        .title = "Every row of the uncoupled equations is (20)",
                        .assumptions = system,
                        .kernel = [N] { return modal_equations(N); },
                        .derived = [N] { return derived_modal_equations(N, symbolic_system(N).C); },
                        .steps = {{"Row $i$ of (16), with (17) and (18)", ""}}});
        list.push_back(
            {.id = "65/sum-of-squares" + of_N,
             .equations = {"65"},
             .title = "The squares of the mode shapes at a mass add up to 1 / (gamma r^2), where the mass matrix is diagonal",
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
                     for (int i = 0; i < N; ++i) sum += from_premise() * s.Psi(0, i) * s.Psi(0, i);
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

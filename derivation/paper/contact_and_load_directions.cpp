// A contact on w^T x and a load along p, in place of one mass each: (20) and (65) for them. All that the paper derives from (20)
// has psi_ji and psi_li as symbols, and so holds with w^T psi_i and p^T psi_i in their places.
#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/superposition.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/claim.hpp"
#include "derivation/claims/provenance.hpp"
#include "derivation/paper/system_matrices.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::matrix;

namespace {

constexpr int most_masses_of_directions = 3;

matrix new_direction(const std::string& letter) {
    matrix entries(most_masses_of_directions, 1);
    for (int k = 0; k < most_masses_of_directions; ++k) {
        const std::string place = std::to_string(k + 1);
        entries(k, 0) = new_symbol(letter + "_" + place, letter + "_{" + place + "}", -1, 1);
    }
    return entries;
}

matrix first_of(const matrix& direction, int N) { return GiNaC::ex_to<matrix>(GiNaC::sub_matrix(direction, 0, N, 0, 1)); }

matrix contact_direction(int N) {
    static const matrix w = new_direction("w");
    return first_of(w, N);
}

matrix load_direction(int N) {
    static const matrix p = new_direction("p");
    return first_of(p, N);
}

Symbolic along(const matrix& direction, const SymbolicSystem& s, int i) {
    ex sum = 0;
    for (unsigned k = 0; k < direction.rows(); ++k) sum += direction(k, 0) * s.Psi(k, i);
    return Symbolic(sum);
}

// (20) for every mode; eta, eta', eta'' are the symbols u, g, Re v.
Values modal_equations(int N) {
    const SymbolicSystem& s = symbolic_system(N);
    const SymbolicModes m = symbolic_modes(N);
    Values values;
    for (int i = 0; i < N; ++i) {
        const ModeInScene<Symbolic> mode{Symbolic(1) / Symbolic(s.Omega[i]), Symbolic(s.zeta[i]),
                                         along(contact_direction(N), s, i), along(load_direction(N), s, i)};
        values.push_back(paper::modal_equation_residual(m.u[i], m.g[i], m.v[i].re, Symbolic(symbols().tau), mode,
                                                        Symbolic(symbols().beta), Symbolic(symbols().phi_j)));
    }
    return values;
}

// The transposed modal matrix times what the equations of motion leave over for x = Psi eta, friction beta along w.
std::vector<ex> derived_modal_equations(int N) {
    from_premise();
    const SymbolicSystem& s = symbolic_system(N);
    const SymbolicModes m = symbolic_modes(N);
    matrix eta(N, 1), velocity(N, 1), second(N, 1);
    for (int i = 0; i < N; ++i) {
        eta(i, 0) = m.u[i].expression();
        velocity(i, 0) = m.g[i].expression();
        second(i, 0) = m.v[i].re.expression();
    }
    const matrix friction = contact_direction(N).mul_scalar(symbols().beta),
                 load = load_direction(N).mul_scalar(GiNaC::cos(symbols().tau + symbols().phi_j));
    const matrix residual =
        s.M.mul(s.Psi).mul(second).add(s.C.mul(s.Psi).mul(velocity)).add(s.K.mul(s.Psi).mul(eta)).sub(friction).sub(load);
    const matrix of_modes = s.Psi.transpose().mul(residual);
    std::vector<ex> values;
    for (int i = 0; i < N; ++i) values.push_back(of_modes(i, 0));
    return values;
}

const Register claims_of_directions([] {
    std::vector<Claim> list;
    for (int N = 1; N <= most_masses_of_directions; ++N) {
        const std::string of_N = "/N=" + std::to_string(N);
        const std::vector<std::string> system{"M diagonal, positive", "Omega_i > 0", "0 <= zeta_i < 1",
                                              "N = " + std::to_string(N)};
        list.push_back(
            {.id = "20/directions" + of_N,
             .equations = {"20"},
             .role = Role::step,
             .title = "A contact on w^T x under a load along p: (20) with w^T psi_i for psi_ji and p^T psi_i for psi_li",
             .assumptions = system,
             .kernel = [N] { return modal_equations(N); },
             .derived = [N] { return derived_modal_equations(N); },
             .special_case = true,
             .steps = {{"Friction is $\\beta\\mathbf w$, the load $\\mathbf p\\cos(\\tau+\\phi)$; the equations of motion are "
                        "multiplied by $\\boldsymbol\\Psi^T$",
                        ""}}});
        list.push_back({.id = "65/directions" + of_N,
                        .equations = {"65"},
                        .role = Role::step,
                        .title = "The squares of w^T psi_i add up to w^T M^-1 w",
                        .assumptions = system,
                        .kernel =
                            [N] {
                                Values shapes;
                                for (int i = 0; i < N; ++i) shapes.push_back(along(contact_direction(N), symbolic_system(N), i));
                                const Values ones(static_cast<std::size_t>(N), Symbolic(ex(1)));
                                return Values{paper::sum_over_contact<Symbolic>(shapes, ones)};
                            },
                        .derived =
                            [N] {
                                const matrix w = contact_direction(N);
                                from_premise(); // (17)
                                return std::vector<ex>{w.transpose().mul(symbolic_system(N).M.inverse()).mul(w)(0, 0)};
                            },
                        .special_case = true});
    }
    return list;
});

} // namespace
} // namespace denhartog::derivation

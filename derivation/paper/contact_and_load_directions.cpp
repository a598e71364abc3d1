// A contact on w^T x and a load along p, in place of one mass each: (20) and (65) for them. All that the paper derives from (20)
// has psi_ji and psi_li as symbols, and so holds with w^T psi_i and p^T psi_i in their places. Where forces are out of phase p is
// complex: (33) for it. Friction takes no part in (33), and (36) to (88) have V_d as symbols.
#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/mode.hpp"
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
    const SymbolicSystem& s = symbolic_system(N);
    const SymbolicModes m = symbolic_modes(N);
    matrix eta(N, 1), velocity(N, 1), second(N, 1);
    for (int i = 0; i < N; ++i) {
        eta(i, 0) = m.u[i].expression();
        velocity(i, 0) = m.g[i].expression();
        second(i, 0) = m.v[i].re.expression();
    }
    const matrix friction = contact_direction(N).mul_scalar(from_premise() * symbols().beta),
                 load = load_direction(N).mul_scalar(GiNaC::cos(symbols().tau + symbols().phi_j));
    const matrix residual =
        s.M.mul(s.Psi).mul(second).add(s.C.mul(s.Psi).mul(velocity)).add(s.K.mul(s.Psi).mul(eta)).sub(friction).sub(load);
    const matrix of_modes = s.Psi.transpose().mul(residual);
    std::vector<ex> values;
    for (int i = 0; i < N; ++i) values.push_back(of_modes(i, 0));
    return values;
}

matrix leading_direction(int N) {
    static const matrix p = new_direction("q");
    return first_of(p, N);
}

// (33) of every mass under the force p cos - q sin, real and imaginary parts.
Values responses_to_phases(int N) {
    const SymbolicSystem& s = symbolic_system(N);
    Values R, of_p, of_q, all;
    std::vector<Complex<Symbolic>> v;
    for (int i = 0; i < N; ++i) {
        R.push_back(Symbolic(1) / Symbolic(s.Omega[i]));
        v.push_back(paper::complex_response(R.back(), Symbolic(s.zeta[i])));
        of_p.push_back(along(load_direction(N), s, i));
        of_q.push_back(along(leading_direction(N), s, i));
    }
    for (int k = 0; k < N; ++k) {
        Values psi_k;
        for (int i = 0; i < N; ++i) psi_k.push_back(Symbolic(s.Psi(k, i)));
        const Complex<Symbolic> V =
            paper::complex_response_to_phases(paper::complex_response_of_mass<Symbolic>(psi_k, of_p, R, v),
                                              paper::complex_response_of_mass<Symbolic>(psi_k, of_q, R, v));
        all.push_back(V.re);
        all.push_back(V.im);
    }
    return all;
}

// x = Psi (a cos - b sin) in (12) without friction, multiplied by Psi^T: what stands before cosine and sine is zero.
std::vector<ex> derived_responses_to_phases(int N) {
    const SymbolicSystem& s = symbolic_system(N);
    const matrix across = s.Psi.transpose();
    const matrix inertia = across.mul(s.M).mul(s.Psi).mul_scalar(from_premise()), damping = across.mul(s.C).mul(s.Psi),
                 stiffness = across.mul(s.K).mul(s.Psi);
    const matrix p = across.mul(load_direction(N)), q = across.mul(leading_direction(N));
    std::vector<ex> a, b;
    for (int i = 0; i < N; ++i) { // (16) to (18): each mode by itself
        const GiNaC::symbol a_i, b_i;
        const ex rest = (stiffness(i, i) - inertia(i, i)).normal(), c = damping(i, i).normal();
        const ex found =
            GiNaC::lsolve(GiNaC::lst{rest * a_i - c * b_i == p(i, 0), rest * b_i + c * a_i == q(i, 0)}, GiNaC::lst{a_i, b_i});
        a.push_back(found.op(0).rhs());
        b.push_back(found.op(1).rhs());
    }
    std::vector<ex> values;
    for (int k = 0; k < N; ++k) {
        ex re = 0, im = 0;
        for (int i = 0; i < N; ++i) {
            re += s.Psi(k, i) * a[static_cast<std::size_t>(i)];
            im += s.Psi(k, i) * b[static_cast<std::size_t>(i)];
        }
        values.push_back(re);
        values.push_back(im);
    }
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
        if (N < most_masses_of_directions)
            list.push_back(
                {.id = "33/phases" + of_N,
                 .equations = {"33"},
                 .role = Role::step,
                 .title = "Forces out of phase, p cos - q sin: (33) with the complex (p + i q)^T psi_i for psi_li",
                 .assumptions = system,
                 .kernel = [N] { return responses_to_phases(N); },
                 .derived = [N] { return derived_responses_to_phases(N); },
                 .special_case = true,
                 .steps = {{"A harmonic motion $\\boldsymbol\\Psi(\\mathbf a\\cos\\tau-\\mathbf b\\sin\\tau)$ in (12), "
                            "multiplied by $\\boldsymbol\\Psi^T$: cosine and sine by themselves are linear equations for a and b",
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
                                return std::vector<ex>{from_premise() *
                                                       w.transpose().mul(symbolic_system(N).M.inverse()).mul(w)(0, 0)};
                            },
                        .special_case = true});
    }
    return list;
});

} // namespace
} // namespace denhartog::derivation

// Sections 2.1 to 2.3 and 3.1: what the text says of damping matrices, of a single mass, and of the number of parameters.
#include <Eigen/LU>
#include <cmath>

#include "denhartog/formulas/contact.hpp"
#include "denhartog/formulas/superposition.hpp"
#include "derivation/algebra/limits.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/provenance.hpp"
#include "derivation/observations/observed_systems.hpp"
#include "derivation/paper/derived.hpp"
#include "derivation/paper/system_matrices.hpp"
#include "tests/support/paper_systems.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::lst;
using GiNaC::matrix;
using GiNaC::numeric;

namespace {

/// A statement that two expressions are equal, and that they are not with something added to the second.
void add_equality(Outcome& outcome, const ex& left, const ex& right, const ex& altered, const std::string& what,
                  const std::string& latex) {
    add_statement(outcome, decide_equal(left, right, domain_of({left, right})).verdict, what, latex);
    if (differs_at_samples(left, altered, domain_of({left, altered}))) ++altered_statements_refuted();
}

/// A damping matrix with an entry of its own in each place.
matrix matrix_of_dampers(int N) {
    static const matrix all = [] {
        matrix D(3, 3);
        for (int k = 0; k < 3; ++k)
            for (int n = 0; n < 3; ++n) {
                const std::string kn = std::to_string(k + 1) + std::to_string(n + 1);
                D(k, n) = new_symbol("D_" + kn, "\\overline{C}_{" + kn + "}", -1, 1);
            }
        return D;
    }();
    return GiNaC::ex_to<matrix>(GiNaC::sub_matrix(all, 0, N, 0, N));
}

/// K M^-1 C = C M^-1 K in modal coordinates: each entry of the modal damping matrix times a difference of squares.
Outcome commuting_matrices() {
    Outcome outcome;
    for (int N = 2; N <= 3; ++N) {
        const SymbolicSystem& s = symbolic_system(N);
        const matrix C = matrix_of_dampers(N), inverse = s.M.inverse(), modal = s.Psi.transpose().mul(C).mul(s.Psi);
        const matrix D = s.K.mul(inverse).mul(C).sub(C.mul(inverse).mul(s.K));
        const matrix left = s.Psi.transpose().mul(D).mul(s.Psi);
        for (int i = 0; i < N; ++i)
            for (int k = 0; k < N; ++k) {
                const ex squares = s.Omega[i] * s.Omega[i] - s.Omega[k] * s.Omega[k], entry = modal(i, k);
                add_equality(outcome, left(i, k), squares * entry, (squares + 1) * entry,
                             "N = " + std::to_string(N) + ", row " + std::to_string(i + 1) + ", column " + std::to_string(k + 1),
                             "[\\boldsymbol\\Psi^T(\\mathbf{K}\\mathbf{M}^{-1}\\mathbf{C}-\\mathbf{C}\\mathbf{M}^{-1}\\mathbf{K})"
                             "\\boldsymbol\\Psi]_{ik}=(\\Omega_i^2-\\Omega_k^2)\\hat{C}_{ik}");
            }
    }
    outcome.steps.push_back({"Where the condition holds the left sides are zero: so is every entry outside the diagonal, as the "
                             "natural frequencies of a chain differ",
                             ""});
    outcome.steps.push_back({"Two equal masses that nothing but a damper couples have K = M and meet the condition with any C: "
                             "where two natural frequencies are equal, the modes have to be chosen with C",
                             ""});
    return outcome;
}

/// C = a M + b K.
Outcome proportional_damping() {
    Outcome outcome;
    const ex a = new_symbol("a_M", "a", numeric(1, 10), 1), b = new_symbol("b_K", "b", numeric(1, 10), 1);
    for (int N = 2; N <= 3; ++N) {
        const SymbolicSystem& s = symbolic_system(N);
        const matrix C = s.M.mul_scalar(a).add(s.K.mul_scalar(b)), modal = s.Psi.transpose().mul(C).mul(s.Psi);
        for (int i = 0; i < N; ++i)
            for (int k = 0; k < N; ++k) {
                const ex right = i == k ? a + b * s.Omega[i] * s.Omega[i] : ex(0);
                add_equality(outcome, modal(i, k), right, right + 1,
                             "N = " + std::to_string(N) + ", row " + std::to_string(i + 1) + ", column " + std::to_string(k + 1),
                             "\\hat{C}_{ik}=(a+b\\Omega_i^2)\\delta_{ik}");
            }
    }
    return outcome;
}

/// One damper beside the first spring of two equal masses.
Outcome local_damper() {
    const SymbolicSystem& s = symbolic_system(2);
    matrix C(2, 2);
    C(0, 0) = 1;
    const matrix modal = s.Psi.transpose().mul(C).mul(s.Psi);
    Outcome outcome;
    add_equality(outcome, modal(0, 1), s.Psi(0, 0) * s.Psi(0, 1), s.Psi(0, 0) * s.Psi(0, 1) + 1,
                 "A damper between the first mass and the wall", "\\hat{C}_{12}\\propto\\psi_{11}\\psi_{12}");
    const ModalBasis<double> basis = modal_basis(denhartog::equal_chain<double>(2, 1, 1, {0.01, 0.01}));
    const double coupled = basis.phi(0, 0) * basis.phi(0, 1);
    if (std::abs(coupled) < 0.1) outcome.verdict = Verdict::unknown;
    outcome.witness = {{"system", "two equal masses and springs"}, {"psi_11 psi_12", text(coupled)}};
    return outcome;
}

/// The single mass by itself: r^2 x'' + 2 zeta r x' + x = beta + cos(tau + phi), which mirrors itself after half a period. The
/// displacement and velocity at tau = 0 that friction makes, over beta.
std::pair<ex, ex> friction_part_of_single_mass() {
    const Symbols& s = symbols();
    const GiNaC::symbol& tau = GiNaC::ex_to<GiNaC::symbol>(s.tau);
    const ex angle = s.w * s.tau / s.R;
    const ex x = GiNaC::exp(-s.zeta * s.tau / s.R) * (s.A * GiNaC::cos(angle) + s.B * GiNaC::sin(angle)) + 1;
    const ex v = x.diff(tau);
    const ex constants = GiNaC::lsolve(lst{(x.subs(s.tau == GiNaC::Pi) + from_premise() * x.subs(s.tau == 0)).expand() == 0,
                                           (v.subs(s.tau == GiNaC::Pi) + v.subs(s.tau == 0)).expand() == 0},
                                       lst{s.A, s.B});
    return {x.subs(s.tau == 0).subs(constants), v.subs(s.tau == 0).subs(constants)};
}

/// The sums over one mode, gamma = kappa = 1, with psi_11 = 1 / r by (17).
Values sums_of_single_mass() {
    const SymbolicModes m = symbolic_modes(1);
    const std::vector<Symbolic> psi{Symbolic(1) / m.R[0]};
    const Complex<Symbolic> V = paper::complex_response_of_mass<Symbolic>(psi, psi, m.R, m.v);
    return {V.re, V.im, paper::damping_function_of_mass<Symbolic>(psi, psi, m.R, m.u),
            paper::damping_function_of_mass<Symbolic>(psi, psi, m.R, m.g)};
}

/// The rank of the derivative of the matrices of (6), beta and mu by the parameters of a chain.
Outcome number_of_parameters() {
    Outcome outcome;
    const ex N = new_symbol("N_masses", "N", 1, 9);
    add_equality(outcome, 3 + N + 2 * (N - 1), 3 * N + 1, 3 * N + 2,
                 "r, beta and mu, N damping ratios, N - 1 mass and N - 1 stiffness ratios", "3+N+2(N-1)=3N+1");
    for (const std::size_t masses : {1, 2, 3, 5}) {
        const auto matrices = [masses](const Eigen::VectorXd& p) {
            System<double> s = denhartog::equal_chain<double>(masses, 1, 1, std::vector<double>(masses, 0));
            const auto n = static_cast<Eigen::Index>(masses);
            for (Eigen::Index i = 0; i < n; ++i) s.damping_ratios[i] = p(3 + i);
            for (Eigen::Index i = 1; i < n; ++i) s.mass_ratios[i] = p(2 + n + i), s.stiffness_ratios[i] = p(1 + 2 * n + i);
            const auto m = non_dimensional_matrices(s, modal_basis(s), p(0));
            Eigen::VectorXd all(3 * n * n + 2);
            all << m.M.reshaped(), m.C.reshaped(), m.K.reshaped(), p(1), p(2);
            return all;
        };
        const auto parameters = static_cast<Eigen::Index>(3 * masses + 1);
        Eigen::VectorXd p(parameters);
        for (Eigen::Index i = 0; i < parameters; ++i) p(i) = 1 + 0.07 * static_cast<double>(i);
        for (std::size_t i = 0; i < masses; ++i) p(static_cast<Eigen::Index>(3 + i)) = 0.02 + 0.01 * static_cast<double>(i);
        Eigen::MatrixXd derivative(matrices(p).size(), parameters);
        const double h = 1e-5;
        for (Eigen::Index i = 0; i < parameters; ++i) {
            Eigen::VectorXd above = p, below = p;
            above(i) += h, below(i) -= h;
            derivative.col(i) = (matrices(above) - matrices(below)) / (2 * h);
        }
        Eigen::FullPivLU<Eigen::MatrixXd> lu(derivative);
        lu.setThreshold(1e-7);
        if (lu.rank() != parameters && outcome.verdict == Verdict::proved) outcome.verdict = Verdict::refuted;
        outcome.steps.push_back({"N = " + std::to_string(masses) + ": " + std::to_string(parameters) + " parameters, of which " +
                                     std::to_string(lu.rank()) + " can be told apart in the matrices of (6), beta and mu",
                                 ""});
    }
    return outcome;
}

/// The factor of the velocity of a mode in (20), with zeta_i = zeta / r_n,i.
Values damping_of_a_mode() {
    const Symbols& s = symbols();
    static const ex r_n = new_symbol("r_n_i", "r_{n,i}", numeric(1, 4), 2);
    const ModeInScene<Symbolic> mode{Symbolic(s.r / r_n), Symbolic(s.zeta / r_n), Symbolic(s.psi_ji), Symbolic(s.psi_li)};
    const auto residual = [&](int velocity) {
        return paper::modal_equation_residual(Symbolic(ex(0)), Symbolic(ex(velocity)), Symbolic(ex(0)), Symbolic(s.tau), mode,
                                              Symbolic(s.beta), Symbolic(s.phi_j));
    };
    return {residual(1) - residual(0)};
}

/// The largest |v_di| of the modes of the paper's two masses, one over the other: 1 / (2 zeta_i w_i) each.
Outcome similar_peaks() {
    Outcome outcome;
    Worst worst;
    for (const ObservedSystem& s : systems_of_the_paper()) {
        if (s.basis.r_n.size() != 2) continue;
        const auto peak = [&s](std::size_t i) {
            const double zeta = s.basis.zeta[i];
            return 1 / (2 * zeta * std::sqrt(1 - zeta * zeta));
        };
        worst.take(peak(1) / peak(0), [&] {
            return Witness{{"system", s.name}, {"r_n,2 / r_n,1", text(s.basis.r_n[1] / s.basis.r_n[0])}};
        });
    }
    refute_above(outcome, worst.error, {.what = "ratio of the modes' largest |v_di|", .taken = 2});
    outcome.witness = with(worst.place, {{"ratio of the largest |v_di|", text(worst.error)}});
    return outcome;
}

Claim by_both_sides(Claim claim) {
    claim.role = Role::observation;
    return claim;
}

const Register claims_of_formulation_observations([] {
    const std::vector<std::string> symbolic{"M diagonal, positive", "N = 2 and 3"};
    return std::vector<Claim>{
        observation("18/commuting/text", {"18"},
                    "Observation in the text: a damping matrix with K M^-1 C = C M^-1 K makes the modal damping matrix diagonal",
                    {"M diagonal, positive", "N = 2 and 3", "natural frequencies that differ"}, commuting_matrices),
        observation("18/proportional/text", {"18"},
                    "Observation in the text: a linear combination of M and K as damping matrix makes the modal one diagonal",
                    symbolic, proportional_damping),
        observation("18/local-damper/text", {"16", "18"},
                    "Observation in the text: in general the modal damping matrix is not diagonal; here: with a single damper",
                    {"N = 2"}, local_damper),
        by_both_sides(
            {.id = "28/single-mass/text",
             .equations = {"28", "29"},
             .by_component = {"28", "29"},
             .title = "Observation in the text: for N = 1 the damping functions are those of a single mass with friction "
                      "and viscous damping; here: by its own equation of motion",
             .assumptions = {"N = 1", "R > 0", "0 <= zeta < 1"},
             .kernel =
                 [] {
                     const Symbolic R(symbols().R), zeta(symbols().zeta);
                     return Values{paper::first_damping_function(R, zeta), paper::second_damping_function(R, zeta)};
                 },
             .derived =
                 [] {
                     const auto [x, v] = friction_part_of_single_mass();
                     return std::vector<ex>{-v, -x};
                 },
             .steps = {{"The motion of a single mass is a free motion, the static displacement $\\beta$ under friction, "
                        "and a harmonic one. The first two together mirror themselves after half a period",
                        "x_f(\\pi)=-x_f(0),\\qquad x_f'(\\pi)=-x_f'(0)"},
                       {"With $x'(0)=0$ and $x(0)=\\overline{X}$ the harmonic part has the cosine "
                        "$\\overline{X}-x_f(0)$ and the sine $x_f'(0)$, which (36) and (37) call "
                        "$\\overline{X}+\\beta G$ and $-\\beta U$. Den Hartog's own text is not at hand",
                        ""}}}),
        by_both_sides({.id = "38/single-mass/text",
                       .equations = {"38"},
                       .title =
                           "Observation in the text: for N = 1 the amplitude (38) is that of a single mass; here: its sums are "
                           "the functions of the one mode",
                       .assumptions = {"N = 1", "psi_11 = 1 / r, by (17)"},
                       .kernel = sums_of_single_mass,
                       .derived =
                           [] {
                               const SymbolicModes m = symbolic_modes(1);
                               return std::vector<ex>{m.v[0].re.expression(), m.v[0].im.expression(), m.u[0].expression(),
                                                      m.g[0].expression()};
                           },
                       .steps = {{"(33) to (35) with one mode, of which $\\psi_{11}^2R_1^2=1$", ""}}}),
        observation("73/parameters/text", {"73"},
                    "Observation in the text: a chain needs 3N + 1 parameters at the least; here: none of them is superfluous",
                    {"N = 1, 2, 3, 5"}, number_of_parameters),
        by_both_sides({.id = "18/similar-damping/text",
                       .equations = {"18", "20"},
                       .title =
                           "Observation in the text: zeta_i = zeta / r_n,i has a similar damping effect on every mode; here: "
                           "free motions of all modes decay at one rate in time",
                       .assumptions = {"zeta_i = zeta / r_n,i"},
                       .kernel = damping_of_a_mode,
                       .derived = [] { return std::vector<ex>{2 * symbols().zeta / symbols().r}; },
                       .special_case = true,
                       .steps = {{"What the velocity is multiplied by in (20), $2\\zeta_i\\Omega_i$, with $\\Omega_i=r_{n,i}/r$: "
                                  "the natural frequency drops out",
                                  ""}}}),
        observation(
            "18/similar-peaks/text", {"18", "23"},
            "Observation in the text: zeta_i = zeta / r_n,i has a similar damping effect on both modes; here: their largest "
            "|v_di| differ by less than a factor of two",
            {"the two masses of Figs. 8 to 10", "zeta = 0.001, 0.01, 0.1"}, similar_peaks),
    };
});

} // namespace
} // namespace denhartog::derivation

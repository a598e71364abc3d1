// Damping that couples the modes, which the paper leaves out: its energy coordinates, friction's share of the motion, and that
// both are the paper's where the modes are not coupled.
#include "denhartog/evaluation/coupled_damping.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/claim.hpp"
#include "derivation/claims/provenance.hpp"
#include "derivation/paper/derived.hpp"
#include "derivation/paper/system_matrices.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::matrix;

namespace {

constexpr unsigned most_masses_of_factors = 2;

// Factors of the mass and the stiffness matrix, in units of m_1 and k_1, a symmetric damping matrix, and a state.
struct FactoredSystem {
    matrix L, G, C;
    std::vector<ex> state; // energy coordinates, 2N
};

matrix lower_factor(const std::string& letter, unsigned N) {
    matrix factor(N, N);
    for (unsigned i = 0; i < N; ++i)
        for (unsigned k = 0; k <= i; ++k) {
            const std::string place = std::to_string(i + 1) + std::to_string(k + 1);
            factor(i, k) = i == k ? new_symbol(letter + "_" + place, letter + "_{" + place + "}", GiNaC::numeric(1, 2), 2)
                                  : new_symbol(letter + "_" + place, letter + "_{" + place + "}", -1, 1);
        }
    return factor;
}

FactoredSystem new_system(unsigned N) {
    FactoredSystem s{lower_factor("L", N), lower_factor("G", N), matrix(N, N), {}};
    const matrix half = lower_factor("C", N);
    for (unsigned i = 0; i < N; ++i)
        for (unsigned k = 0; k < N; ++k) s.C(i, k) = i < k ? half(k, i) : half(i, k);
    for (unsigned n = 0; n < 2 * N; ++n) {
        const std::string place = std::to_string(n + 1);
        s.state.push_back(new_symbol("s_" + place, "s_{" + place + "}", -1, 1));
    }
    return s;
}

const FactoredSystem& factored_system(unsigned N) {
    static const std::vector<FactoredSystem> systems = [] {
        std::vector<FactoredSystem> all;
        for (unsigned n = 1; n <= most_masses_of_factors; ++n) all.push_back(new_system(n));
        return all;
    }();
    return systems[N - 1];
}

Values symbolic(const matrix& A) {
    Values entries;
    for (unsigned i = 0; i < A.rows(); ++i)
        for (unsigned k = 0; k < A.cols(); ++k) entries.emplace_back(A(i, k));
    return entries;
}

matrix column_of(const std::vector<ex>& entries, unsigned from, unsigned count) {
    matrix column(count, 1);
    for (unsigned n = 0; n < count; ++n) column(n, 0) = entries[from + n];
    return column;
}

Values shipped_rates(const matrix& P, const matrix& B) {
    return evaluation::energy_rates<Symbolic>(symbolic(P), symbolic(B), P.rows(), Symbolic(symbols().r));
}

Values shipped_rates(const FactoredSystem& s) {
    const matrix inverse = s.L.inverse();
    return shipped_rates(inverse.mul(s.G), inverse.mul(s.C).mul(inverse.transpose()));
}

// (12) without its forces, M = r^2 L L^T, C = r C, K = G G^T, for s = (G^T x / r, L^T x').
std::vector<ex> derived_rates(unsigned N) {
    const FactoredSystem& s = factored_system(N);
    const ex r = symbols().r;
    const matrix first = column_of(s.state, 0, N), second = column_of(s.state, N, N);
    const matrix x = s.G.transpose().inverse().mul(first).mul_scalar(r), velocity = s.L.transpose().inverse().mul(second);
    const matrix M = s.L.mul(s.L.transpose()).mul_scalar(r * r), K = s.G.mul(s.G.transpose());
    const matrix acceleration = M.inverse().mul(s.C.mul(velocity).mul_scalar(r).add(K.mul(x))).mul_scalar(-from_premise());
    const matrix of_first = s.G.transpose().mul(velocity).mul_scalar(1 / r), of_second = s.L.transpose().mul(acceleration);
    std::vector<ex> rates;
    for (unsigned n = 0; n < 2 * N; ++n)
        for (const ex& of : s.state)
            rates.push_back((n < N ? of_first(n, 0) : of_second(n - N, 0)).expand().diff(GiNaC::ex_to<GiNaC::symbol>(of)));
    return rates;
}

Values first_half(const Values& all) { return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2)}; }
Values second_half(const Values& all) { return {all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2), all.end()}; }

// The residuals of the equations of motion for the motion under a unit friction force on the last mass, its free part the state.
Values equations_under_friction(unsigned N) {
    const FactoredSystem& s = factored_system(N);
    const Symbolic r(symbols().r);
    const matrix of_G = s.G.inverse(), of_L = s.L.inverse();
    const Values A = shipped_rates(s);
    Values f, rest;
    for (const ex& each : s.state) f.emplace_back(each);
    Values rate(2 * N, Symbolic(0));
    for (unsigned n = 0; n < 2 * N; ++n)
        for (unsigned m = 0; m < 2 * N; ++m) rate[n] = rate[n] + A[n * 2 * N + m] * f[m];
    for (unsigned i = 0; i < N; ++i) rest.push_back(Symbolic(of_G(i, N - 1)) / r);
    Values x, velocity, acceleration;
    for (unsigned k = 0; k < N; ++k) {
        Values a, b;
        for (unsigned i = 0; i < N; ++i) {
            a.push_back(Symbolic(of_G(i, k)) * r);
            b.emplace_back(of_L(i, k));
        }
        x.push_back(evaluation::displacement_under_friction<Symbolic>(a, rest, first_half(f)));
        velocity.push_back(evaluation::derivative_under_friction<Symbolic>(b, second_half(f)));
        acceleration.push_back(evaluation::derivative_under_friction<Symbolic>(b, second_half(rate)));
    }
    const matrix M = s.L.mul(s.L.transpose()), K = s.G.mul(s.G.transpose());
    Values residual;
    for (unsigned k = 0; k < N; ++k) {
        Symbolic sum(0);
        for (unsigned n = 0; n < N; ++n)
            sum = sum + Symbolic(M(k, n)) * r * r * acceleration[n] + Symbolic(s.C(k, n)) * r * velocity[n] +
                  Symbolic(K(k, n)) * x[n];
        residual.push_back(sum);
    }
    return residual;
}

// With L = M phi and G = M phi r_n for the factors, phi = r Psi: the modes themselves.
Values rates_of_modes(int N) {
    const SymbolicSystem& s = symbolic_system(N);
    matrix natural(static_cast<unsigned>(N), static_cast<unsigned>(N));
    for (int i = 0; i < N; ++i)
        natural(static_cast<unsigned>(i), static_cast<unsigned>(i)) = s.Omega[static_cast<std::size_t>(i)] * s.r;
    const matrix phi = s.Psi.mul_scalar(s.r), M = s.M.mul_scalar(1 / (s.r * s.r)), C = s.C.mul_scalar(1 / s.r);
    const matrix inverse = phi.transpose(); // of M phi, by (17)
    return evaluation::energy_rates<Symbolic>(symbolic(inverse.mul(M).mul(phi).mul(natural)), symbolic(inverse.mul(C).mul(phi)),
                                              static_cast<std::size_t>(N), Symbolic(s.r));
}

// (20) without its forces for s = (Omega eta, eta').
std::vector<ex> derived_rates_of_modes(int N) {
    const SymbolicSystem& s = symbolic_system(N);
    std::vector<ex> rates(static_cast<std::size_t>(4 * N * N), 0);
    for (int i = 0; i < N; ++i) {
        const ex Omega = s.Omega[static_cast<std::size_t>(i)], zeta = s.zeta[static_cast<std::size_t>(i)];
        rates[static_cast<std::size_t>(i * 2 * N + N + i)] = Omega;
        rates[static_cast<std::size_t>((N + i) * 2 * N + i)] = -from_premise() * Omega;
        rates[static_cast<std::size_t>((N + i) * 2 * N + N + i)] = -2 * zeta * Omega;
    }
    return rates;
}

// c of one mode, (1 + exp(A pi)) c = 2 s_0, s_0 = (R, 0): the exponential is the free motion (A.6), s = (eta / R, eta').
std::pair<ex, ex> start_of_one_mode() {
    const Symbols& s = symbols();
    const GiNaC::symbol &eta_0 = GiNaC::ex_to<GiNaC::symbol>(s.eta_0), &velocity_0 = GiNaC::ex_to<GiNaC::symbol>(s.eta_prime_0),
                        &tau = GiNaC::ex_to<GiNaC::symbol>(s.tau);
    const ex eta = derived_displacement(), velocity = eta.diff(tau);
    const auto at_end = [&](const ex& e) { return e.subs(s.tau == GiNaC::Pi); };
    const ex from_x = at_end(eta.diff(eta_0)), from_v = at_end(eta.diff(velocity_0)), to_x = at_end(velocity.diff(eta_0)),
             to_v = at_end(velocity.diff(velocity_0));
    const ex solution = GiNaC::lsolve(
        GiNaC::lst{(1 + from_x) * s.PA + from_v / s.R * s.PB == 2 * s.R, s.R * to_x * s.PA + (1 + to_v) * s.PB == 0},
        GiNaC::lst{s.PA, s.PB});
    return {s.PA.subs(solution), s.PB.subs(solution)};
}

const Register claims_of_coupled_damping([] {
    std::vector<Claim> list;
    for (unsigned N = 1; N <= most_masses_of_factors; ++N) {
        const std::string of_N = "/N=" + std::to_string(N);
        const std::vector<std::string> system{"M and K positive definite", "C symmetric", "N = " + std::to_string(N)};
        list.push_back(
            {.id = "12/energy-coordinates" + of_N,
             .equations = {"12"},
             .role = Role::step,
             .title = "Damping that couples the modes: (12) without its forces in energy coordinates",
             .assumptions = system,
             .kernel = [N] { return shipped_rates(factored_system(N)); },
             .derived = [N] { return derived_rates(N); },
             .special_case = true,
             .steps = {{"The coordinates are $\\mathbf s=(\\mathbf G^T\\mathbf x/r,\\mathbf L^T\\mathbf x')$, with "
                        "$\\mathbf M=\\mathbf L\\mathbf L^T$ and $\\mathbf K=\\mathbf G\\mathbf G^T$; (12) gives $\\mathbf s'$",
                        ""}}});
        list.push_back(
            {.id = "12/under-friction" + of_N,
             .equations = {"12"},
             .role = Role::step,
             .title = "Rest under a constant friction force less a free motion solves (12) under that force",
             .assumptions = system,
             .kernel = [N] { return equations_under_friction(N); },
             .derived =
                 [N] {
                     std::vector<ex> force(N, 0);
                     force.back() = from_premise();
                     return force;
                 },
             .special_case = true,
             .steps = {{"The friction force is 1 on the last mass; the free motion is any state of the energy coordinates",
                        ""}}});
        list.push_back({.id = "20/energy-coordinates" + of_N,
                        .equations = {"20"},
                        .role = Role::step,
                        .title = "If damping does not couple the modes, the energy coordinates can be those of the modes, (20)",
                        .assumptions = {"M diagonal, positive", "Omega_i > 0", "C by (19)", "N = " + std::to_string(N)},
                        .kernel = [N] { return rates_of_modes(static_cast<int>(N)); },
                        .derived = [N] { return derived_rates_of_modes(static_cast<int>(N)); },
                        .special_case = true,
                        .steps = {{"The factors are $\\mathbf L=\\mathbf M\\boldsymbol\\phi$ and "
                                   "$\\mathbf G=\\mathbf M\\boldsymbol\\phi\\,\\mathrm{diag}(r_{n,i})$, whose inverse (17) gives",
                                   ""}}});
    }
    const Symbols& s = symbols();
    list.push_back({.id = "28/mirrored",
                    .equations = {"28", "29"},
                    .by_component = {"28", "29"},
                    .role = Role::step,
                    .title = "For one mode the motion under friction that mirrors itself starts with (28) and (29)",
                    .assumptions = {"R_i > 0", "0 <= zeta_i < 1", "zeta_i > 0 or 1/R_i not an odd integer"},
                    .kernel =
                        [&s] {
                            const auto [c_1, c_2] = start_of_one_mode();
                            const Values R{Symbolic(s.R)}, one{Symbolic(1)}, first{Symbolic(c_1)}, second{Symbolic(c_2)};
                            return Values{-evaluation::derivative_under_friction<Symbolic>(one, second),
                                          -evaluation::displacement_under_friction<Symbolic>(R, R, first)};
                        },
                    .derived =
                        [&s] {
                            return std::vector<ex>{s.R * s.R * derived_first_damping_function(),
                                                   s.R * s.R * derived_second_damping_function()};
                        },
                    .special_case = true,
                    .steps = {{"The exponential over half a period is the free motion (A.6); the start solves "
                               "$(\\mathbf 1+e^{\\mathbf A\\pi})\\mathbf c=2\\mathbf s_0$",
                               ""}}});
    return list;
});

} // namespace
} // namespace denhartog::derivation

#include "derivation/paper/modal_sums.hpp"

#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/provenance.hpp"
#include "derivation/paper/derived.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::lst;

namespace {

ex shape(const SymbolicModes& m, Row row, int i) { return (row == Row::contact ? m.psi_j : m.psi_k)[i].expression(); }

} // namespace

std::pair<ex, ex> derived_start(const ex& re, const ex& im, const ex& c, const ex& s) {
    const Symbols& n = symbols();
    const auto [v_cos, v_sin] = derived_phase_by_functions();
    const ex solution = GiNaC::lsolve(lst{v_cos == n.v_cos, v_sin == n.v_sin}, lst{n.eta_0, n.eta_prime_0});
    const auto of_phase = [&](const ex& e) {
        return e.subs(solution).expand().subs(lst{n.v_cos == re * c - im * s, n.v_sin == re * s + im * c});
    };
    return {of_phase(n.eta_0), of_phase(n.eta_prime_0)};
}

std::vector<ModalStart> derived_starts(int N, const ex& c, const ex& s) {
    const SymbolicModes m = symbolic_modes(N);
    const Symbols& n = symbols();
    std::vector<ModalStart> starts;
    for (int i = 0; i < N; ++i) {
        const ex re = m.v[i].re.expression(), im = m.v[i].im.expression();
        const auto [eta_0, eta_prime_0] = derived_start(re, im, c, s);
        const auto [eta_f, eta_prime_f] = derived_start(re, im, 0, 0); // what friction alone makes of them
        const auto of_mode = [&](const ex& e) {
            return e.subs(lst{n.R == m.R[i].expression(), n.psi_ji == m.psi_j[i].expression(),
                              n.psi_li == m.psi_l[i].expression(), n.u == m.u[i].expression(), n.g == m.g[i].expression()});
        };
        starts.push_back({m.psi_k[i].expression(), m.psi_j[i].expression(), of_mode(eta_0 - eta_f),
                          of_mode(eta_prime_0 - eta_prime_f), of_mode(eta_0), of_mode(eta_prime_0)});
    }
    return starts;
}

std::pair<ex, ex> derived_response(int N, Row row) {
    const SymbolicModes m = symbolic_modes(N);
    ex re = 0, im = 0;
    for (int i = 0; i < N; ++i) {
        const ex factor = shape(m, row, i) * m.psi_l[i].expression() * GiNaC::pow(m.R[i].expression(), 2);
        re += factor * m.v[i].re.expression();
        im += factor * m.v[i].im.expression();
    }
    return {re, im};
}

std::pair<ex, ex> derived_start_of_mass(int N, Row row, const ex& c, const ex& s) {
    const SymbolicModes m = symbolic_modes(N);
    const std::vector<ModalStart> starts = derived_starts(N, c, s);
    ex displacement = 0, velocity = 0;
    for (int i = 0; i < N; ++i) {
        displacement += shape(m, row, i) * starts[i].eta_0;
        velocity += shape(m, row, i) * starts[i].eta_prime_0;
    }
    return {displacement, velocity};
}

ex derived_displacement_of_mass(int N, Row row, const std::vector<std::pair<ex, ex>>& starts) {
    const Symbols& s = symbols();
    const SymbolicModes m = symbolic_modes(N);
    ex sum = 0;
    for (int i = 0; i < N; ++i)
        sum += shape(m, row, i) *
               derived_modal_displacement().subs(lst{s.R == m.R[i].expression(), s.zeta == m.zeta[i].expression(),
                                                     s.u == m.u[i].expression(), s.g == m.g[i].expression(),
                                                     s.psi_ji == m.psi_j[i].expression(), s.psi_li == m.psi_l[i].expression(),
                                                     s.eta_0 == starts[i].first, s.eta_prime_0 == starts[i].second});
    return sum;
}

std::pair<ex, ex> derived_phase_of_contact(const ex& re, const ex& im, const ex& c, const ex& s) {
    const ex by_30 = from_premise();
    const GiNaC::symbol cosine("cosine"), sine("sine");
    const ex solution =
        GiNaC::lsolve(lst{by_30 * (re * cosine - im * sine) == c, by_30 * (re * sine + im * cosine) == s}, lst{cosine, sine});
    return {ex(cosine).subs(solution), ex(sine).subs(solution)};
}

std::pair<ex, ex> derived_steady_phase(const ex& re, const ex& im, const ex& U) {
    const GiNaC::symbol root("root");
    const ex beta = symbols().beta;
    // Im{V exp(i phi)} = -beta U, as the contact has no velocity at tau = 0, (30); then cos^2 + sin^2 = 1 gives Re{V exp(i phi)}
    const auto [c, s] = derived_phase_of_contact(re, im, root, -beta * U);
    const ex unit = ((c * c + s * s - 1) * (re * re + im * im)).normal().expand();
    const ex square = (-unit.coeff(root, 0) / unit.coeff(root, 2)).normal();
    return {c.subs(root == GiNaC::sqrt(square)), s.subs(root == GiNaC::sqrt(square))};
}

std::pair<ex, ex> derived_initial_state() {
    const Symbols& s = symbols();
    const auto [c, sine] = derived_steady_phase(s.V_jr, s.V_ji, s.U_j);
    return {s.V_kr * c - s.V_ki * sine - s.beta * s.G_k, -(s.V_kr * sine + s.V_ki * c) - s.beta * s.U_k};
}

} // namespace denhartog::derivation

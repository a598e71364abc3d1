#include "modal_sums.hpp"

#include "derived.hpp"
#include "symbols.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::lst;

namespace {

ex shape(const SymbolicModes& m, Row row, int i) { return (row == Row::contact ? m.psi_j : m.psi_k)[i].expression(); }

} // namespace

std::vector<ModalStart> derived_starts(int N, const ex& c, const ex& s) {
    const SymbolicModes m = symbolic_modes(N);
    const ex beta = symbols().beta;
    std::vector<ModalStart> starts;
    for (int i = 0; i < N; ++i) {
        const ex R = m.R[i].expression(), psi_l = m.psi_l[i].expression(), psi_j = m.psi_j[i].expression();
        const ex re = m.v[i].re.expression(), im = m.v[i].im.expression();
        const ex cosine = psi_l * R * R * (re * c - im * s), sine = -psi_l * R * R * (re * s + im * c);
        starts.push_back({m.psi_k[i].expression(), psi_j, cosine, sine, cosine - psi_j * R * R * m.g[i].expression() * beta,
                          sine - psi_j * R * R * m.u[i].expression() * beta});
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
    const GiNaC::symbol cosine("cosine"), sine("sine");
    const ex solution = GiNaC::lsolve(lst{re * cosine - im * sine == c, re * sine + im * cosine == s}, lst{cosine, sine});
    return {ex(cosine).subs(solution), ex(sine).subs(solution)};
}

std::pair<ex, ex> derived_steady_phase(const ex& re, const ex& im, const ex& U) {
    const ex beta = symbols().beta;
    const ex root = GiNaC::sqrt(re * re + im * im - beta * beta * U * U);
    return derived_phase_of_contact(re, im, root, -beta * U);
}

std::pair<ex, ex> derived_initial_state() {
    const Symbols& s = symbols();
    const auto [c, sine] = derived_steady_phase(s.V_jr, s.V_ji, s.U_j);
    return {s.V_kr * c - s.V_ki * sine - s.beta * s.G_k, -(s.V_kr * sine + s.V_ki * c) - s.beta * s.U_k};
}

} // namespace denhartog::derivation

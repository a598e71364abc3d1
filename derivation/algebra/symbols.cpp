#include "derivation/algebra/symbols.hpp"

#include <map>
#include <sstream>
#include <stdexcept>

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::numeric;

namespace {

std::map<ex, Range, GiNaC::ex_is_less>& known_ranges() {
    static std::map<ex, Range, GiNaC::ex_is_less> ranges;
    return ranges;
}

void collect(const ex& e, std::map<ex, Range, GiNaC::ex_is_less>& found) {
    if (GiNaC::is_a<GiNaC::symbol>(e)) found.emplace(e, known_ranges().at(e));
    for (const ex& part : e) collect(part, found);
}

} // namespace

ex new_symbol(const std::string& name, const std::string& latex, const numeric& low, const numeric& high) {
    return new_symbol(name, latex, low, high, low >= 0 ? Bounds{numeric(0), {}} : Bounds{});
}

ex new_symbol(const std::string& name, const std::string& latex, const numeric& low, const numeric& high, const Bounds& bounds) {
    if ((bounds.lower && low < *bounds.lower) || (bounds.upper && high > *bounds.upper))
        throw std::logic_error("the samples of " + name + " leave its bounds");
    const ex s = bounds.lower && *bounds.lower >= 0 ? ex(GiNaC::possymbol(name, latex)) : ex(GiNaC::realsymbol(name, latex));
    known_ranges().emplace(s, Range{s, low, high, bounds, low.is_negative() && high.is_positive() ? 2 : 1});
    return s;
}

std::string latex_of_name(const std::string& name) {
    for (const auto& [symbol, range] : known_ranges()) {
        if (GiNaC::ex_to<GiNaC::symbol>(symbol).get_name() != name) continue;
        std::ostringstream out;
        out << GiNaC::latex << symbol;
        return out.str();
    }
    return "";
}

std::vector<Range> domain_of(const std::vector<ex>& expressions) {
    std::map<ex, Range, GiNaC::ex_is_less> found;
    for (const ex& e : expressions) collect(e, found);
    std::vector<Range> domain;
    for (const auto& [symbol, range] : found) domain.push_back(range);
    return domain;
}

const Symbols& symbols() {
    static const Symbols s = [] {
        const auto positive = [](const char* name, const char* latex) { return new_symbol(name, latex, numeric(1, 5), 2); };
        const auto any = [](const char* name, const char* latex) { return new_symbol(name, latex, -1, 1); };
        const numeric nearly_pi(333, 106); // less than pi
        Symbols n;
        n.tau = new_symbol("tau", "\\tau", numeric(1, 100), nearly_pi);
        n.R = new_symbol("R", "R_i", numeric(1, 5), 8);
        n.zeta = new_symbol("zeta", "\\zeta_i", numeric(1, 100), numeric(99, 100), {numeric(0), numeric(1)});
        n.w = GiNaC::sqrt(1 - n.zeta * n.zeta);
        n.beta = new_symbol("beta", "\\beta", numeric(1, 20), numeric(1, 2));
        n.mu = new_symbol("mu", "\\mu", 1, 3);
        n.psi_ki = any("psi_ki", "\\psi_{ki}");
        n.psi_ji = any("psi_ji", "\\psi_{ji}");
        n.psi_li = any("psi_li", "\\psi_{li}");
        n.eta_0 = any("eta_0", "\\eta_{i0}");
        n.eta_prime_0 = any("eta_prime_0", "\\eta'_{i0}");
        n.phi_j = new_symbol("phi_j", "\\phi_j", -nearly_pi, nearly_pi);
        known_ranges().at(n.phi_j).parts = 4; // the quadrants
        n.u = any("u", "u_{di}");
        n.g = positive("g", "g_i");
        n.A = any("A", "A_i");
        n.B = any("B", "B_i");
        n.c_phi = any("c_phi", "\\cos\\phi_j");
        n.s_phi = any("s_phi", "\\sin\\phi_j");
        n.v_cos = any("v_cos", "[v_{di}\\cos\\phi_j]");
        n.v_sin = any("v_sin", "[v_{di}\\sin\\phi_j]");
        n.V_kr = any("V_kr", "V_{kr}");
        n.V_ki = any("V_ki", "V_{ki}");
        n.V_jr = new_symbol("V_jr", "V_{jr}", -2, 2);
        n.V_ji = new_symbol("V_ji", "V_{ji}", -2, 2);
        n.U_k = any("U_k", "U_{dk}");
        n.U_j = any("U_j", "U_{dj}");
        n.G_k = any("G_k", "G_k");
        n.G_j = positive("G_j", "G_j");
        n.F_k = any("F_k", "F_k");
        n.S = positive("S", "S_{dj}");
        n.H = positive("H", "H_j");
        n.X = positive("X", "\\overline{X}_j");
        n.x_k0 = any("x_k0", "\\bar{x}_{k0}");
        n.x_prime_k0 = any("x_prime_k0", "\\bar{x}'_{k0}");
        n.r = positive("r", "r");
        n.gamma = positive("gamma", "\\gamma_j");
        n.omega = positive("omega", "\\omega");
        n.t = positive("t", "t");
        n.m_1 = positive("m_1", "m_1");
        n.m_i = positive("m_i", "m_i");
        n.k_1 = positive("k_1", "k_1");
        n.k_i = positive("k_i", "k_i");
        n.P = positive("P", "P");
        n.F = positive("F", "F");
        n.x = any("x", "x");
        n.p_j = any("p_j", "p_j");
        n.q_j = any("q_j", "q_j");
        n.PA = any("PA", "\\mathcal{A}");
        n.PB = any("PB", "\\mathcal{B}");
        n.PC = any("PC", "\\mathcal{C}");
        n.PP = any("PP", "\\mathcal{P}");
        n.PQ = any("PQ", "\\mathcal{Q}");
        n.PR = any("PR", "\\mathcal{R}");
        return n;
    }();
    return s;
}

ModeInScene<Symbolic> symbolic_mode() {
    const Symbols& s = symbols();
    return {Symbolic(s.R), Symbolic(s.zeta), Symbolic(s.psi_ji), Symbolic(s.psi_li)};
}

InitialValues<Symbolic> symbolic_start() { return {Symbolic(symbols().eta_0), Symbolic(symbols().eta_prime_0)}; }

Complex<Symbolic> symbolic_V_j() { return {Symbolic(symbols().V_jr), Symbolic(symbols().V_ji)}; }

Complex<Symbolic> symbolic_V_k() { return {Symbolic(symbols().V_kr), Symbolic(symbols().V_ki)}; }

SymbolicModes symbolic_modes(int N) {
    static const SymbolicModes all = [] {
        SymbolicModes m;
        for (int i = 1; i <= 3; ++i) {
            const std::string n = std::to_string(i);
            const auto make = [&n](const char* name, const char* latex, const char* index, const numeric& low,
                                   const numeric& high) {
                return Symbolic(new_symbol(name + n, std::string(latex) + "_{" + index + n + "}", low, high));
            };
            m.R.push_back(make("R", "R", "", numeric(1, 5), 8));
            m.zeta.push_back(Symbolic(
                new_symbol("zeta" + n, "\\zeta_{" + n + "}", numeric(1, 100), numeric(99, 100), {numeric(0), numeric(1)})));
            m.psi_k.push_back(make("psi_k", "\\psi", "k", -1, 1));
            m.psi_j.push_back(make("psi_j", "\\psi", "j", -1, 1));
            m.psi_l.push_back(make("psi_l", "\\psi", "l", -1, 1));
            m.u.push_back(make("u", "u", "d", -1, 1));
            m.g.push_back(make("g", "g", "", numeric(1, 10), 2));
            m.v.push_back({make("v_r", "\\mathrm{Re}v", "d", -2, 2), make("v_i", "\\mathrm{Im}v", "d", -2, 2)});
        }
        return m;
    }();
    SymbolicModes m = all;
    for (auto* values : {&m.R, &m.zeta, &m.psi_k, &m.psi_j, &m.psi_l, &m.u, &m.g}) values->resize(N);
    m.v.resize(N);
    return m;
}

const PartialSums& partial_sums() {
    static const PartialSums all = [] {
        const auto sum = [](const char* name, const std::string& latex) {
            return new_symbol(std::string(name) + "_so_far", latex + "^{(N)}", -1, 1);
        };
        return PartialSums{sum("V_r", "V_{dkr}"),    sum("V_i", "V_{dki}"),     sum("U", "U_{dk}"), sum("G", "G_k"),
                           sum("x", "x_{k0}"),       sum("x_prime", "x'_{k0}"), sum("F", "F_k"),    sum("F_prime", "F'_k"),
                           sum("F_second", "F''_k"), sum("S", "S_{dj}"),        sum("H", "H_j"),    sum("squares", "s"),
                           sum("entry", "c")};
    }();
    return all;
}

} // namespace denhartog::derivation

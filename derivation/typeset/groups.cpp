// The paper's groups with their meanings.
#include <set>

#include "derivation/algebra/symbols.hpp"
#include "derivation/typeset/latex.hpp"
#include "derivation/typeset/readable.hpp"

namespace denhartog::derivation {

using GiNaC::ex;

namespace {

Group group(const std::string& name, const std::string& latex, const ex& in_groups, const ex& meaning) {
    return {GiNaC::realsymbol(name, latex), meaning, latex, latex + " = " + latex_line(in_groups)};
}

ModeGroups groups_of_mode(const std::string& index, const ex& R, const ex& zeta) {
    const ex root = GiNaC::sqrt(1 - zeta * zeta);
    ModeGroups m{R, zeta, group("w" + index, "w_" + index, root, root), {}, {}, {}, {symbols().tau, GiNaC::Pi}};
    const ex w = m.w.symbol;
    for (const ex& tau : m.tau) {
        const std::string at = tau.is_equal(GiNaC::Pi) ? "(\\pi)" : "(\\tau)";
        const auto add = [&](std::vector<Group>& list, const std::string& name, const ex& in_groups) {
            list.push_back(
                group(name + index, name.substr(0, 1) + "_" + index + name.substr(1) + at, in_groups, in_groups.subs(w == root)));
        };
        const ex decay = GiNaC::exp(-zeta * tau / R), angle = w * tau / R;
        add(m.d, "d", decay * (GiNaC::cos(angle) + zeta / w * GiNaC::sin(angle)));
        add(m.q, "q", decay * GiNaC::sin(angle) / w);
        add(m.q_prime, "q'", decay * (GiNaC::cos(angle) - zeta / w * GiNaC::sin(angle)) / R);
    }
    return m;
}

/// v cos(phi_j) and v sin(phi_j), for cosine and sine of phi_j.
std::vector<Group> groups_of_phase(const ex& c, const ex& sine) {
    const Symbols& s = symbols();
    const ex size = GiNaC::pow(1 - s.R * s.R, 2) + 4 * s.zeta * s.zeta * s.R * s.R;
    const ex re = (1 - s.R * s.R) / size, im = -2 * s.zeta * s.R / size;
    const std::string v_cos = "[v_{di}\\cos\\phi_j]", v_sin = "[v_{di}\\sin\\phi_j]";
    const ex of_cos = re * c - im * sine, of_sin = re * sine + im * c;
    return {{GiNaC::realsymbol("v_cos", v_cos), of_cos, v_cos, v_cos + " = \\mathrm{Re}\\{v_{di}e^{i\\phi_j}\\}"},
            {GiNaC::realsymbol("v_sin", v_sin), of_sin, v_sin, v_sin + " = \\mathrm{Im}\\{v_{di}e^{i\\phi_j}\\}"}};
}

} // namespace

const std::vector<ModeGroups>& groups_of_modes() {
    static const std::vector<ModeGroups> all = [] {
        const Symbols& s = symbols();
        const SymbolicModes m = symbolic_modes(3);
        std::vector<ModeGroups> list{groups_of_mode("i", s.R, s.zeta)};
        for (int i = 0; i < 3; ++i)
            list.push_back(groups_of_mode(std::to_string(i + 1), m.R[i].expression(), m.zeta[i].expression()));
        return list;
    }();
    return all;
}

const std::vector<Group>& groups() {
    static const std::vector<Group> all = [] {
        std::vector<Group> list;
        const Symbols& s = symbols();
        for (const ModeGroups& mode : groups_of_modes()) {
            list.push_back(mode.w);
            for (const auto* pair : {&mode.d, &mode.q, &mode.q_prime}) list.insert(list.end(), pair->begin(), pair->end());
        }
        for (const auto& pair : {groups_of_phase(s.c_phi, s.s_phi), groups_of_phase(GiNaC::cos(s.phi_j), GiNaC::sin(s.phi_j))})
            list.insert(list.end(), pair.begin(), pair.end());
        return list;
    }();
    return all;
}

const std::vector<std::pair<ex, ex>>& paper_shapes() {
    static const std::vector<std::pair<ex, ex>> all = [] {
        std::vector<std::pair<ex, ex>> list;
        for (const ModeGroups& m : groups_of_modes()) {
            const ex size = GiNaC::pow(1 - m.R * m.R, 2) + 4 * m.zeta * m.zeta * m.R * m.R;
            list.emplace_back(size.expand(), size);
            list.emplace_back((1 - m.zeta * m.zeta).expand(), m.w.symbol * m.w.symbol);
        }
        return list;
    }();
    return all;
}

ex without_groups(const ex& form) {
    GiNaC::exmap meanings;
    for (const Group& g : groups()) meanings[g.symbol] = g.meaning;
    return form.subs(meanings);
}

std::string legend_of(const std::string& latex) {
    std::string legend, seen = latex;
    std::vector<std::string> definitions;
    std::set<std::string> told;
    const std::vector<Group>& all = groups();
    for (auto g = all.rbegin(); g != all.rend(); ++g) { // a definition may use a group that comes before it
        if (seen.find(g->latex) == std::string::npos || !told.insert(g->latex).second) continue;
        definitions.insert(definitions.begin(), g->definition);
        seen += g->definition;
    }
    if (definitions.size() == 1) return definitions.front();
    for (const std::string& d : definitions) {
        std::string aligned = d;
        aligned.replace(aligned.find(" = "), 3, " &= ");
        legend += (legend.empty() ? "" : " \\\\ ") + aligned;
    }
    return legend.empty() ? "" : "\\begin{aligned} " + legend + " \\end{aligned}";
}

} // namespace denhartog::derivation

#include "derivation/typeset/readable.hpp"

#include <map>
#include <set>

#include "derivation/algebra/function_ring.hpp"
#include "derivation/algebra/kept_identities.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/typeset/latex.hpp"
#include "derivation/typeset/typeset.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::symbol;

namespace {

/// Expressions with more parts or symbols than this are shown as they are.
constexpr std::size_t largest = 6000, most_symbols = 12;

std::size_t size_of(const ex& e) {
    std::size_t size = 1;
    for (const ex& part : e) size += size_of(part);
    return size;
}

void collect_names(const ex& e, std::set<std::string>& names) {
    if (GiNaC::is_a<symbol>(e)) names.insert(GiNaC::ex_to<symbol>(e).get_name());
    for (const ex& part : e) collect_names(part, names);
}

bool has_name(const ex& e, const std::set<std::string>& names) {
    return GiNaC::is_a<symbol>(e) && names.contains(GiNaC::ex_to<symbol>(e).get_name());
}

std::set<std::string> with_indices(const std::set<std::string>& names) {
    std::set<std::string> all = names;
    for (const std::string& name : names)
        for (int i = 1; i <= 3; ++i) all.insert(name + std::to_string(i));
    return all;
}

/// Symbols in which the paper's expressions are linear; an expression is sorted by them.
const std::set<std::string>& linear_names() {
    static const std::set<std::string> names =
        with_indices({"psi_ki", "psi_ji",     "psi_li", "psi_k", "psi_j", "psi_l", "beta", "eta_0", "eta_prime_0",
                      "x_k0",   "x_prime_k0", "c_phi",  "s_phi", "v_cos", "v_sin", "u",    "g",     "V_kr",
                      "V_ki",   "V_jr",       "V_ji",   "U_k",   "U_j",   "G_k",   "G_j",  "A",     "B"});
    return names;
}

/// Symbols that may stand before a bracket.
const std::set<std::string>& outer_names() {
    static const std::set<std::string> names =
        with_indices({"psi_ki", "psi_ji", "psi_li", "psi_k", "psi_j", "psi_l", "beta", "V_jr", "V_ji"});
    return names;
}

/// Factors of a term.
std::vector<ex> factors_of(const ex& term) {
    std::vector<ex> factors;
    if (GiNaC::is_a<GiNaC::mul>(term))
        for (const ex& part : term) factors.push_back(part);
    else
        factors.push_back(term);
    return factors;
}

/// The part of a term in some symbols.
ex part_in(const ex& term, const std::set<std::string>& names) {
    ex part = 1;
    for (const ex& factor : factors_of(term))
        if (has_name(GiNaC::is_a<GiNaC::power>(factor) ? factor.op(0) : factor, names)) part *= factor;
    return part;
}

std::vector<ex> terms_of(const ex& sum) {
    if (GiNaC::is_a<GiNaC::add>(sum)) return {sum.begin(), sum.end()};
    return {sum};
}

double width_of(const ex& e) { return visible_width(latex_line(e)); }

/// The factors that all terms of a sum have, in front of a bracket.
ex with_common_factors_in_front(const ex& sum) {
    if (!GiNaC::is_a<GiNaC::add>(sum)) return sum;
    std::map<ex, numeric, GiNaC::ex_is_less> common;
    bool first = true;
    for (const ex& term : sum) {
        std::map<ex, numeric, GiNaC::ex_is_less> powers;
        for (const ex& factor : factors_of(term)) {
            const bool plain = GiNaC::is_a<GiNaC::power>(factor) && GiNaC::is_a<numeric>(factor.op(1));
            if (!GiNaC::is_a<numeric>(factor))
                powers[plain ? factor.op(0) : factor] = plain ? GiNaC::ex_to<numeric>(factor.op(1)) : numeric(1);
        }
        if (first) common = powers;
        for (auto& [base, exponent] : common) {
            const auto place = powers.find(base);
            const numeric here = place == powers.end() ? numeric(0) : place->second;
            if ((here * exponent).is_negative() || here.is_zero())
                exponent = 0;
            else if (abs(here) < abs(exponent))
                exponent = here;
        }
        first = false;
    }
    ex factor = 1, bracket = 0;
    for (const auto& [base, exponent] : common) factor *= GiNaC::pow(base, exponent);
    for (const ex& term : sum) bracket += term / factor;
    return factor * bracket;
}

/// Sorted by the linear symbols, each coefficient simplified; terms with the same outer symbols in one bracket.
ex sorted(const FunctionRing& ring, const ex& rational) {
    const auto [over, under] = ring.fraction(rational);
    std::set<std::string> names = linear_names(), divisors;
    collect_names(under, divisors);
    for (const std::string& name : divisors) names.erase(name);
    std::map<ex, ex, GiNaC::ex_is_less> coefficients, brackets;
    for (const ex& term : terms_of(over.expand())) {
        const ex monomial = part_in(term, names);
        coefficients[monomial] += term / monomial;
    }
    for (const auto& [monomial, coefficient] : coefficients) {
        const ex outer = part_in(monomial, outer_names());
        const ex factored = ring.named(ring.simplified(coefficient / under)), by_halves = ring.hyperbolic(coefficient / under);
        const bool narrower = !by_halves.is_zero() && width_of(by_halves) < width_of(factored);
        brackets[outer] += monomial / outer * (narrower ? by_halves : factored);
    }
    ex sum = 0;
    for (const auto& [outer, bracket] : brackets) sum += outer * with_common_factors_in_front(bracket);
    return sum;
}

/// The free motions of each mode and time in place of its decaying cosine and sine, and back.
struct FreeMotions {
    GiNaC::exmap by_d, by_rate, back; ///< through d and q; through q and q'; d and q by the functions again
};

FreeMotions free_motions(const FunctionRing& ring) {
    FreeMotions found;
    for (const ModeGroups& mode : groups_of_modes())
        for (std::size_t i = 0; i < mode.tau.size(); ++i) {
            const ex angle = mode.w.meaning * mode.tau[i] / mode.R;
            const ex c = ring.known(GiNaC::cos(angle)), s = ring.known(GiNaC::sin(angle));
            const ex decay = ring.known(GiNaC::exp(-mode.zeta * mode.tau[i] / mode.R));
            if (decay.is_zero() || s.is_zero()) continue;
            const ex w = mode.w.symbol, d = mode.d[i].symbol, q = mode.q[i].symbol;
            found.by_d[s] = found.by_rate[s] = w * q / decay;
            found.by_d[c] = (d - mode.zeta * q) / decay;
            found.by_rate[c] = (mode.R * mode.q_prime[i].symbol + mode.zeta * q) / decay;
            found.back[d] = decay * (c + mode.zeta / w * s);
            found.back[q] = decay * s / w;
        }
    return found;
}

/// cos(phi_j) and sin(phi_j) through v cos(phi_j) and v sin(phi_j).
GiNaC::exmap through_v(const FunctionRing& ring) {
    const Symbols& s = symbols();
    GiNaC::exmap replacements;
    const std::vector<Group>& all = groups();
    const auto add = [&](const ex& c, const ex& sine, std::size_t first) {
        const ex vc = all[first].symbol, vs = all[first + 1].symbol;
        replacements[c] = (1 - s.R * s.R) * vc - 2 * s.zeta * s.R * vs;
        replacements[sine] = (1 - s.R * s.R) * vs + 2 * s.zeta * s.R * vc;
    };
    add(s.c_phi, s.s_phi, all.size() - 4);
    const ex c = ring.known(GiNaC::cos(s.phi_j)), sine = ring.known(GiNaC::sin(s.phi_j));
    if (!c.is_zero() && !sine.is_zero()) add(c, sine, all.size() - 2);
    return replacements;
}

/// Forms that an expression of one mode may take.
std::vector<ex> forms_of(const ex& e) {
    FunctionRing ring;
    const ex rational = ring.rewrite(e);
    std::vector<ex> forms{ring.named(ring.simplified(rational)), sorted(ring, rational)};
    const auto add_hyperbolic = [&](const ex& quotient) {
        const ex form = ring.hyperbolic(quotient);
        if (!form.is_zero()) forms.push_back(form);
    };
    const auto add = [&](const GiNaC::exmap& first, const GiNaC::exmap& second) {
        const ex replaced = rational.subs(first).subs(second);
        if (replaced.is_equal(rational)) return;
        forms.push_back(ring.named(ring.simplified(replaced)));
        forms.push_back(sorted(ring, replaced));
    };
    add_hyperbolic(rational);
    const FreeMotions motions = free_motions(ring);
    const GiNaC::exmap by_v = through_v(ring), none;
    add(none, by_v);
    if (!motions.by_d.empty()) {
        const ex back = ring.simplified(rational.subs(motions.by_d)).subs(motions.back);
        add_hyperbolic(back);
        forms.push_back(sorted(ring, back));
        for (const GiNaC::exmap& motion : {motions.by_d, motions.by_rate}) {
            add(motion, none);
            if (!rational.subs(by_v).is_equal(rational)) add(motion, by_v);
        }
    }
    for (ex& form : forms) form = with_names(form);
    return forms;
}

/// The narrowest proved form of an expression of one mode.
ex readable_part(const ex& e) {
    const ex plain = with_names(e);
    std::set<std::string> names;
    collect_names(e, names);
    if (size_of(e) > largest || names.size() > most_symbols) return plain;
    std::vector<std::pair<double, ex>> ranked;
    const double width = width_of(plain);
    for (const ex& form : forms_of(e))
        if (const double w = width_of(form); w < 0.95 * width) ranked.emplace_back(w, form);
    std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [w, form] : ranked)
        if (stands_for(form, e)) return form;
    return plain;
}

/// The index of the mode whose symbols a term has; empty for none, or for more than one.
std::string mode_of(const ex& term) {
    std::set<std::string> names, found;
    collect_names(term, names);
    for (const std::string& name : names)
        for (const std::string of_mode : {"R", "zeta", "psi_k", "psi_j", "psi_l", "u", "g", "v_r", "v_i"})
            if (name.size() == of_mode.size() + 1 && name.starts_with(of_mode) &&
                std::isdigit(static_cast<unsigned char>(name.back())))
                found.insert(name.substr(of_mode.size()));
    return found.size() == 1 ? *found.begin() : "";
}

} // namespace

ex with_names(const ex& e) {
    GiNaC::exmap names;
    for (const Group& g : groups())
        if (GiNaC::is_a<GiNaC::power>(g.meaning)) {
            names[g.meaning] = g.symbol;
            names[1 / g.meaning] = 1 / g.symbol;
        }
    for (const auto& [sum, shape] : paper_shapes())
        if (sum.nops() > 2) names[sum] = shape;
    return e.subs(names);
}

bool stands_for(const ex& form, const ex& e) {
    const ex without = without_groups(form);
    if (without.is_equal(e)) return true;
    const KeepNothing of_print;
    return decide_equal(without, e, domain_of({without, e})).verdict == Verdict::proved;
}

namespace {

ex readable_form(const ex& e) {
    try {
        std::map<std::string, ex> of_mode;
        if (GiNaC::is_a<GiNaC::add>(e))
            for (const ex& term : e) of_mode[mode_of(term)] += term;
        if (of_mode.size() < 2) return readable_part(e);
        ex sum = 0;
        for (const auto& [index, part] : of_mode) sum += readable_part(part);
        return sum;
    } catch (const std::exception&) {
        return with_names(e); // a function that the ring or the zero test does not know
    }
}

} // namespace

ex readable(const ex& e) {
    static std::map<ex, ex, GiNaC::ex_is_less> known; // the same expression is derived for several claims
    const auto place = known.find(e);
    return place != known.end() ? place->second : known.emplace(e, readable_form(e)).first->second;
}

} // namespace denhartog::derivation

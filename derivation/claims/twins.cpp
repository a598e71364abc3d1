// The mutated twins of a claim: what is proved of a formula must be refuted of the formula altered.
#include <algorithm>

#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/claim.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::lst;

namespace {

/// True if some component has another value than the derived one.
bool differs(const Values& kernel, const std::vector<ex>& derived, const std::vector<ex>& real) {
    for (std::size_t i = 0; i < kernel.size(); ++i)
        if (component_differs(kernel[i], derived[i], real)) return true;
    return false;
}

/// Puts one twin through the zero test, `by_values` only if no value refutes it before.
void try_twin(const Claim& claim, const std::string& twin, const Values& kernel, const std::vector<ex>& derived,
              MutantCount& count, bool by_values = false) {
    Verdict verdict = Verdict::proved;
    std::string reason;
    const std::vector<ex> real = roots_in(derived);
    if (by_values && differs(kernel, derived, real)) {
        ++count.refuted;
        return;
    }
    for (std::size_t i = 0; i < kernel.size() && verdict != Verdict::refuted; ++i) {
        const Decision decision = decide_component(kernel[i], derived[i], real);
        if (decision.verdict == Verdict::proved) continue;
        verdict = decision.verdict;
        reason = decision.reason;
    }
    if (verdict == Verdict::refuted) {
        ++count.refuted;
        return;
    }
    if (verdict == Verdict::proved && by_values && claim.special_case) { // an operation met a zero
        ++count.idle;
        return;
    }
    ++(verdict == Verdict::proved ? count.proved : count.unknown);
    count.holes.push_back(claim.id + ": " + twin + ", " + to_string(verdict) + (reason.empty() ? "" : ": " + reason));
}

/// One operation of the kernel replaced, or its second operand dropped.
void try_operations(const Claim& claim, const std::vector<ex>& derived, MutantCount& count) {
    long operations = 0;
    {
        const Mutation none(-1);
        const Values kernel = claim.kernel();
        operations = none.operations();
    }
    for (long position = 0; position < operations; ++position) {
        Values kernel;
        std::string replaced;
        try {
            const Mutation mutation(position);
            kernel = claim.kernel();
            replaced = mutation.replaced();
        } catch (const std::exception&) {
            ++count.without_value;
            continue;
        }
        try_twin(claim, "operation " + std::to_string(position) + ", " + replaced, kernel, derived, count,
                 claim.special_case || claim.slow);
    }
}

struct Exchange {
    std::string what;
    lst symbols;
};

void exchange(lst& symbols, const ex& a, const ex& b) { symbols.append(a == b).append(b == a); }

/// Quantities easily taken for one another, of one mode, of the masses, and of every mode of a sum; modes left out of a sum.
const std::vector<Exchange>& exchanges() {
    static const std::vector<Exchange> all = [] {
        const Symbols& s = symbols();
        const SymbolicModes m = symbolic_modes(3);
        lst load, mass, functions, response;
        exchange(load, s.psi_ji, s.psi_li);
        exchange(mass, s.psi_ki, s.psi_ji);
        exchange(functions, s.u, s.g);
        exchange(functions, s.U_j, s.G_j);
        exchange(functions, s.U_k, s.G_k);
        exchange(mass, s.U_k, s.U_j);
        exchange(mass, s.G_k, s.G_j);
        exchange(response, s.V_kr, s.V_jr);
        exchange(response, s.V_ki, s.V_ji);
        for (std::size_t i = 0; i < m.R.size(); ++i) {
            exchange(load, m.psi_j[i].expression(), m.psi_l[i].expression());
            exchange(mass, m.psi_k[i].expression(), m.psi_j[i].expression());
            exchange(functions, m.u[i].expression(), m.g[i].expression());
        }
        return std::vector<Exchange>{
            {"psi_j for psi_l", load}, {"k for j", mass}, {"u for g", functions}, {"V_k for V_j", response}};
    }();
    return all;
}

/// A mode left out of the sums, as a loop with a wrong bound does: its mode shapes are zero.
lst without_mode(std::size_t i) {
    const SymbolicModes m = symbolic_modes(3);
    return {m.psi_k[i].expression() == 0, m.psi_j[i].expression() == 0, m.psi_l[i].expression() == 0};
}

/// The kernel with symbols put for others. Where either side stays as it is there is no such twin.
void try_substitution(const Claim& claim, const std::string& what, const lst& symbols, const Values& kernel,
                      const std::vector<ex>& derived, MutantCount& count) {
    const auto stays = [&symbols](const ex& e) {
        try {
            return e.subs(symbols).is_equal(e);
        } catch (const GiNaC::pole_error&) {
            return false;
        }
    };
    if (std::all_of(derived.begin(), derived.end(), stays)) return; // the statement with other names, or a case of it
    Values twin;
    bool same = true;
    try {
        for (const Symbolic& component : kernel) {
            twin.emplace_back(component.expression().subs(symbols));
            same = same && (twin.back().expression() - component.expression()).expand().is_zero();
        }
    } catch (const std::exception&) {
        ++count.without_value;
        return;
    }
    if (!same) try_twin(claim, what, twin, derived, count);
}

/// The derived side altered, component by component.
void try_derived(const Claim& claim, const Values& kernel, const std::vector<ex>& derived, MutantCount& count) {
    constexpr std::size_t most_terms = 4;
    for (std::size_t i = 0; i < derived.size(); ++i) {
        const auto try_altered = [&](const std::string& what, const ex& component) {
            if (component_differs(kernel[i], component)) {
                ++count.refuted;
                return;
            }
            std::vector<ex> altered = derived;
            altered[i] = component;
            try_twin(claim, "derived side, " + what, kernel, altered, count);
        };
        try_altered("one added", derived[i] + 1);
        if (derived[i].is_zero()) continue;
        try_altered("sign changed", -derived[i]);
        try_altered("doubled", 2 * derived[i]);
        if (!GiNaC::is_a<GiNaC::add>(derived[i])) continue;
        for (std::size_t term = 0; term < std::min(most_terms, derived[i].nops()); ++term)
            if (!derived[i].op(term).normal().is_zero()) try_altered("a term dropped", derived[i] - derived[i].op(term));
    }
}

} // namespace

MutantCount mutate(const Claim& claim) {
    MutantCount count;
    if (!claim.kernel) return count;
    const std::vector<ex> derived = claim.derived();
    const Values kernel = claim.kernel();
    try_operations(claim, derived, count);
    for (const Exchange& e : exchanges()) try_substitution(claim, e.what, e.symbols, kernel, derived, count);
    for (std::size_t i = 0; i < 3; ++i)
        try_substitution(claim, "mode " + std::to_string(i + 1) + " left out", without_mode(i), kernel, derived, count);
    try_derived(claim, kernel, derived, count);
    return count;
}

} // namespace denhartog::derivation

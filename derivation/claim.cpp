#include "claim.hpp"

#include <algorithm>
#include <chrono>
#include <sstream>

#include "comparison_steps.hpp"
#include "equation_order.hpp"
#include "readable.hpp"
#include "symbols.hpp"

namespace denhartog::derivation {

namespace {

std::vector<std::function<std::vector<Claim>()>>& makers() {
    static std::vector<std::function<std::vector<Claim>()>> m;
    return m;
}

std::string text(const GiNaC::numeric& n) {
    std::ostringstream out;
    out << n;
    return out.str();
}

Decision decide_component(const Symbolic& kernel, const GiNaC::ex& derived) {
    return decide_equal(kernel.expression(), derived, domain_of({kernel.expression(), derived}));
}

} // namespace

Register::Register(std::function<std::vector<Claim>()> made) { makers().push_back(std::move(made)); }

const std::vector<Claim>& claims() {
    static const std::vector<Claim> all = [] {
        std::vector<Claim> list;
        for (const auto& make : makers())
            for (Claim& claim : make()) list.push_back(std::move(claim));
        std::stable_sort(list.begin(), list.end(), [](const Claim& a, const Claim& b) {
            return position_of_equation(a.equations.front()) < position_of_equation(b.equations.front());
        });
        for (std::size_t i = 0; i < list.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                if (list[i].id == list[k].id) throw std::logic_error("two claims named " + list[i].id);
        return list;
    }();
    return all;
}

Result decide(const Claim& claim) {
    const auto start = std::chrono::steady_clock::now();
    Result result;
    result.steps = claim.steps;
    if (claim.check) {
        Outcome outcome = claim.check();
        result.verdict = outcome.verdict;
        result.witness = std::move(outcome.witness);
        for (Step& step : outcome.steps) result.steps.push_back(std::move(step));
    } else {
        const Values kernel = claim.kernel();
        const std::vector<GiNaC::ex> derived = claim.derived();
        if (kernel.size() != derived.size() || kernel.empty())
            throw std::logic_error("claim " + claim.id + " compares " + std::to_string(kernel.size()) + " values with " +
                                   std::to_string(derived.size()));
        result.verdict = Verdict::proved;
        std::vector<Decision> decisions;
        for (std::size_t i = 0; i < kernel.size(); ++i) {
            const Decision decision = decide_component(kernel[i], derived[i]);
            decisions.push_back(decision);
            if (i == 0 || decision.verdict != Verdict::proved) result.decision = decision;
            if (decision.verdict == Verdict::proved) continue;
            if (result.verdict == Verdict::refuted) continue;
            result.verdict = decision.verdict;
            for (const auto& [symbol, value] : decision.witness) {
                std::ostringstream name;
                name << symbol;
                result.witness.emplace_back(name.str(), text(value));
            }
            if (decision.verdict == Verdict::refuted) {
                result.witness.emplace_back("under test", decision.left);
                result.witness.emplace_back("derived", decision.right);
            }
        }
        for (Step& step : steps_of_comparison(claim.steps, kernel, derived, decisions)) result.steps.push_back(std::move(step));
    }
    std::string formulas;
    for (const Step& step : result.steps) formulas += step.latex + "\n";
    if (const std::string legend = legend_of(formulas); !legend.empty())
        result.steps.insert(result.steps.begin(), {"Abbreviations", legend});
    result.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return result;
}

namespace {

/// Puts one twin through the zero test.
void try_twin(const Claim& claim, const std::string& twin, const Values& kernel, const std::vector<GiNaC::ex>& derived,
              MutantCount& count) {
    Verdict verdict = Verdict::proved;
    std::string reason;
    for (std::size_t i = 0; i < kernel.size() && verdict != Verdict::refuted; ++i) {
        const Decision decision = decide_component(kernel[i], derived[i]);
        if (decision.verdict == Verdict::proved) continue;
        verdict = decision.verdict;
        reason = decision.reason;
    }
    if (verdict == Verdict::refuted) {
        ++count.refuted;
        return;
    }
    ++(verdict == Verdict::proved ? count.proved : count.unknown);
    count.holes.push_back(claim.id + ": " + twin + ", " + to_string(verdict) + (reason.empty() ? "" : ": " + reason));
}

} // namespace

MutantCount mutate(const Claim& claim) {
    MutantCount count;
    if (!claim.kernel) return count;
    const std::vector<GiNaC::ex> derived = claim.derived();
    if (claim.special_case) {
        const Values kernel = claim.kernel();
        for (std::size_t i = 0; i < derived.size(); ++i) {
            std::vector<GiNaC::ex> altered = derived;
            altered[i] = derived[i] + 1;
            try_twin(claim, "one added", kernel, altered, count);
            if (derived[i].is_zero()) continue;
            altered[i] = -derived[i];
            try_twin(claim, "sign changed", kernel, altered, count);
            altered[i] = 2 * derived[i];
            try_twin(claim, "doubled", kernel, altered, count);
        }
        return count;
    }
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
        try_twin(claim, "operation " + std::to_string(position) + ", " + replaced, kernel, derived, count);
    }
    return count;
}

} // namespace denhartog::derivation

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

} // namespace

Decision decide_component(const Symbolic& kernel, const GiNaC::ex& derived, const std::vector<GiNaC::ex>& real) {
    std::vector<GiNaC::ex> all = real;
    all.insert(all.end(), {kernel.expression(), derived});
    return decide_equal(kernel.expression(), derived, domain_of(all), real);
}

long& altered_statements_refuted() {
    static long count = 0;
    return count;
}

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
        altered_statements_refuted() = 0;
        Outcome outcome = claim.check();
        result.altered = altered_statements_refuted();
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
        const std::vector<GiNaC::ex> real = roots_in(derived);
        std::vector<Decision> decisions;
        for (std::size_t i = 0; i < kernel.size(); ++i) {
            const Decision decision = decide_component(kernel[i], derived[i], real);
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

} // namespace denhartog::derivation

#include "derivation/claims/claim.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <utility>

#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/comparison_steps.hpp"
#include "derivation/claims/provenance.hpp"
#include "derivation/ledger/equation_order.hpp"
#include "derivation/typeset/readable.hpp"

namespace denhartog::derivation {

namespace {

struct Maker {
    std::string file;
    std::function<std::vector<Claim>()> made;
};

std::vector<Maker>& makers() {
    static std::vector<Maker> m;
    return m;
}

std::vector<Range> domain_of_component(const Symbolic& kernel, const GiNaC::ex& derived, std::vector<GiNaC::ex> real) {
    real.insert(real.end(), {kernel.expression(), derived});
    return domain_of(real);
}

bool is_named_after_its_equation(const Claim& claim) { return claim.id.starts_with(claim.equations.front() + "/"); }

std::string text(const GiNaC::numeric& n) {
    std::ostringstream out;
    out << n;
    return out.str();
}

/// Both sides at a point, in digits, and the number of symbols in them: for more masses there are more, also where the values are
/// the same. Empty where nothing can be told from them.
std::string fingerprint_of(const Symbolic& kernel, const GiNaC::ex& derived) {
    std::string found;
    try {
        const std::vector<Range> domain = domain_of({kernel.expression(), derived});
        const Point point = sample_points(domain, 1).front();
        found = std::to_string(domain.size()) + " symbols;";
        for (const GiNaC::ex& side : {kernel.expression(), derived}) {
            const double value = evaluate(side, point).to_double();
            if (std::abs(value) < 1e-30) return {}; // every zero looks like every other
            std::ostringstream out;
            out << std::setprecision(30) << value;
            found += out.str() + ";";
        }
    } catch (const std::exception&) {
        return {}; // no value there, and nothing to compare by
    }
    return found;
}

/// True if a claim needs the premise that it states: with the premise made false its sides differ, or cannot be made.
bool fails_on_a_false_premise(const Claim& claim) {
    const FalsePremise false_premise;
    const long before = altered_statements_refuted();
    bool fails = false;
    try {
        if (claim.check) {
            fails = claim.check().verdict != Verdict::proved;
        } else {
            const Values kernel = claim.kernel();
            const std::vector<GiNaC::ex> derived = claim.derived();
            for (std::size_t i = 0; i < kernel.size() && !fails; ++i)
                fails = component_differs(kernel[i], derived[i], roots_in(derived));
        }
    } catch (const std::exception&) {
        fails = true;
    }
    altered_statements_refuted() = before;
    return fails;
}

/// Both sides of a claim, and its kind: what was called to make them says how the claim bears on its equations. Only formula
/// templates carry out operations of the symbolic scalar.
std::pair<Values, std::vector<GiNaC::ex>> sides(const Claim& claim, Result& result) {
    const Watch watch;
    const auto operations = [](const auto& make, auto& made) {
        const Mutation none(-1);
        made = make();
        return none.operations();
    };
    std::pair<Values, std::vector<GiNaC::ex>> both;
    const long of_kernel = operations(claim.kernel, both.first), of_derived = operations(claim.derived, both.second);
    const bool derived = watch.premise_called() && fails_on_a_false_premise(claim);
    result.kind = derived ? "derived" : of_derived > 0 ? "refinement" : "restated";
    // two formulas of equal value are told apart by how they are written
    for (std::size_t i = 0; i < std::min(both.first.size(), both.second.size()); ++i)
        result.fingerprint += fingerprint_of(both.first[i], both.second[i]);
    if (!result.fingerprint.empty()) result.fingerprint += std::to_string(of_kernel) + " operations";
    return both;
}

/// The equation that holds, printed from the derived side.
std::string correction_of(const Claim& claim, const std::vector<GiNaC::ex>& derived) {
    std::string lines;
    for (std::size_t i = 0; i < claim.correction_left.size(); ++i)
        lines += (i == 0 ? "" : " \\\\ ") + claim.correction_left[i] + " &= " + latex(derived.at(i));
    return lines.empty() ? "" : "\\begin{aligned} " + lines + " \\end{aligned}";
}

std::string kind_of_check(const Claim& claim, const Outcome& outcome, const Watch& watch) {
    if (outcome.argued) return "argument";
    if (claim.role == Role::observation) return "observation";
    return watch.premise_called() && fails_on_a_false_premise(claim) ? "derived" : "consequence";
}

} // namespace

Decision decide_component(const Symbolic& kernel, const GiNaC::ex& derived, const std::vector<GiNaC::ex>& real) {
    return decide_equal(kernel.expression(), derived, domain_of_component(kernel, derived, real), real);
}

bool component_differs(const Symbolic& kernel, const GiNaC::ex& derived, const std::vector<GiNaC::ex>& real) {
    return differs_at_samples(kernel.expression(), derived, domain_of_component(kernel, derived, real), real);
}

long& altered_statements_refuted() {
    static long count = 0;
    return count;
}

Register::Register(std::function<std::vector<Claim>()> made, std::source_location where) {
    makers().push_back({where.file_name(), std::move(made)});
}

const std::vector<Claim>& claims() {
    static const std::vector<Claim> all = [] {
        std::vector<Claim> list;
        // Constructors of several sources run in the linker's order.
        std::ranges::stable_sort(makers(), {}, &Maker::file);
        for (const Maker& maker : makers())
            for (Claim& claim : maker.made()) list.push_back(std::move(claim));
        std::ranges::stable_sort(list, {}, [](const Claim& claim) {
            return std::pair(position_of_equation(claim.equations.front()), !is_named_after_its_equation(claim));
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
        const long before = std::exchange(altered_statements_refuted(), 0); // a check may decide other claims
        const Watch watch;
        Outcome outcome = claim.check();
        result.altered = std::exchange(altered_statements_refuted(), before);
        result.why_no_twin = outcome.why_no_twin;
        result.verdict = outcome.verdict;
        result.kind = kind_of_check(claim, outcome, watch);
        result.witness = std::move(outcome.witness);
        result.thresholds = std::move(outcome.thresholds);
        for (Step& step : outcome.steps) result.steps.push_back(std::move(step));
    } else {
        const auto [kernel, derived] = sides(claim, result);
        if (kernel.size() != derived.size() || kernel.empty())
            throw std::logic_error("claim " + claim.id + " compares " + std::to_string(kernel.size()) + " values with " +
                                   std::to_string(derived.size()));
        result.verdict = Verdict::proved;
        const std::vector<GiNaC::ex> real = roots_in(derived);
        result.correction = correction_of(claim, derived);
        std::vector<Decision> decisions;
        for (std::size_t i = 0; i < kernel.size(); ++i) {
            const Decision decision = decide_component(kernel[i], derived[i], real);
            decisions.push_back(decision);
            if (!claim.by_component.empty()) {
                Verdict& verdict = result.by_equation.try_emplace(claim.by_component.at(i), Verdict::proved).first->second;
                if (verdict != Verdict::refuted && decision.verdict != Verdict::proved) verdict = decision.verdict;
            }
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

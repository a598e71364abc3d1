#include "derivation/claims/comparison_steps.hpp"

#include <algorithm>
#include <set>

#include "derivation/typeset/latex.hpp"
#include "derivation/typeset/readable.hpp"
#include "derivation/typeset/typeset.hpp"

namespace denhartog::derivation {

using GiNaC::ex;

namespace {

constexpr std::size_t components_shown = 4;
constexpr double widest = 420;              // characters of typeset LaTeX
constexpr std::size_t longest_divisor = 60; // terms of a divisor that is factored

/// A side of a comparison: broken into lines where it is wide; what no page holds is counted.
Step shown(const std::string& what, const ex& form) {
    if (visible_width(latex_line(form)) > widest) return {what + " a sum that is too long for a page", ""};
    std::string equation = latex_equation("", form);
    if (equation.starts_with(" = ")) equation = equation.substr(3);
    const std::string empty_left = "\\begin{aligned}  ={}& ";
    if (equation.starts_with(empty_left)) equation = "\\begin{aligned} & " + equation.substr(empty_left.size());
    return {what, equation};
}

/// The relation that a generator of the zero test obeys; empty for an exponential, which obeys none.
std::string relation_of(const ex& meaning) {
    if (GiNaC::is_a<GiNaC::power>(meaning)) {
        const ex name = with_names(meaning);
        const std::string root = latex_line(name);
        return (GiNaC::is_a<GiNaC::symbol>(name) ? root + "^2" : "\\left(" + root + "\\right)^2") + " = " +
               latex_line(with_names(meaning.op(0)));
    }
    if (GiNaC::is_the_function<GiNaC::sin_SERIAL>(meaning)) {
        const ex angle = with_names(meaning.op(0));
        return latex_line(GiNaC::pow(GiNaC::sin(angle), 2)) + " = " + latex_line(1 - GiNaC::pow(GiNaC::cos(angle), 2));
    }
    if (GiNaC::is_the_function<GiNaC::atan2_SERIAL>(meaning)) {
        const ex y = meaning.op(0), x = meaning.op(1);
        return "\\tan\\," + latex_line(with_names(meaning)) + " = " + latex_line(with_names(y / x));
    }
    return "";
}

/// A divisor as a product; GiNaC does not factor polynomials with pi among their numbers.
ex factors_of_divisor(const ex& divisor) {
    if (divisor.nops() > longest_divisor || divisor.has(GiNaC::Pi)) return divisor;
    return GiNaC::factor(divisor);
}

/// The factors of what is divided by, without numbers and exponentials.
void collect_divisors(const Decision& decision, std::set<std::pair<double, std::string>>& divisors) {
    GiNaC::exmap meanings;
    for (const auto& [generator, meaning] : decision.generators) meanings[generator] = meaning;
    const auto take = [&](const ex& factor) {
        const ex base = GiNaC::is_a<GiNaC::power>(factor) ? factor.op(0) : factor;
        if (GiNaC::is_a<GiNaC::numeric>(base)) return;
        const ex in_functions = base.expand().subs(meanings);
        if (GiNaC::is_the_function<GiNaC::exp_SERIAL>(in_functions) || in_functions.is_equal(GiNaC::Pi)) return;
        const auto [positive, sign] = std::pair(latex_line(with_names(in_functions)), latex_line(with_names(-in_functions)));
        const std::string latex = std::min(std::pair(positive.size(), positive), std::pair(sign.size(), sign)).second;
        divisors.emplace(visible_width(latex), latex);
    };
    for (const ex& d : decision.denominators) {
        const ex product = factors_of_divisor(d);
        if (GiNaC::is_a<GiNaC::mul>(product))
            for (const ex& factor : product) take(factor);
        else
            take(product);
    }
}

std::string lines_of(const std::vector<std::string>& formulas, const std::string& separator) {
    std::string text, line;
    bool broken = false;
    for (const std::string& formula : formulas) {
        if (!line.empty() && visible_width(line) + visible_width(formula) > 80) {
            text += line + separator + " \\\\ ";
            line.clear();
            broken = true;
        }
        line += (line.empty() ? "" : separator + "\\quad ") + formula;
    }
    return broken ? "\\begin{gathered} " + text + line + " \\end{gathered}" : line;
}

/// A formula without what only arranges it on the page.
std::string without_layout(std::string latex) {
    for (const std::string mark : {"\\begin{aligned}", "\\end{aligned}", "{}", "\\\\", "&", " "})
        for (std::size_t at = latex.find(mark); at != std::string::npos; at = latex.find(mark, at)) latex.erase(at, mark.size());
    return latex;
}

} // namespace

std::vector<Step> steps_of_comparison(const std::vector<Step>& before, const Values& kernel, const std::vector<ex>& derived,
                                      const std::vector<Decision>& decisions) {
    std::vector<Step> steps;
    std::set<std::pair<std::string, std::string>> told;
    const auto tell = [&](const Step& step) {
        if (told.emplace(step.latex, step.latex.empty() ? step.text : "").second) steps.push_back(step);
    };
    std::set<std::string> relations;
    std::set<std::pair<double, std::string>> divisors;
    bool proved = true;
    for (std::size_t i = 0; i < decisions.size(); ++i) {
        const Decision& decision = decisions[i];
        const std::string which = decisions.size() == 1 ? "" : "For component " + std::to_string(i + 1) + " ";
        if (i < components_shown || decision.verdict != Verdict::proved) {
            const ex given = with_names(kernel[i].expression()), regrouped = readable(kernel[i].expression());
            const bool as_given = visible_width(latex_line(given)) < 1.25 * visible_width(latex_line(regrouped));
            const Step gives = shown(which + (which.empty() ? "The" : "the") + " derivation gives", readable(derived[i]));
            const Step tested =
                shown(which + (which.empty() ? "The" : "the") + " formula under test is", as_given ? given : regrouped);
            const bool told_before = !gives.latex.empty() && std::any_of(before.begin(), before.end(), [&](const Step& step) {
                return without_layout(step.latex).ends_with("=" + without_layout(gives.latex));
            });
            if (told_before) {
                const bool same = gives.latex == tested.latex;
                tell(same ? Step{tested.text + " the same", ""} : tested);
            } else if (!gives.latex.empty() && gives.latex == tested.latex) {
                tell({gives.text + ", and so does the formula under test", gives.latex});
            } else {
                tell(gives);
                tell(tested);
            }
        }
        if (decision.verdict == Verdict::unknown) steps.push_back({"Neither proved nor refuted: " + decision.reason, ""});
        proved = proved && decision.verdict == Verdict::proved;
        if (decision.verdict != Verdict::proved) continue;
        for (const auto& [generator, meaning] : decision.generators)
            if (std::string relation = relation_of(meaning); !relation.empty()) relations.insert(std::move(relation));
        collect_divisors(decision, divisors);
    }
    if (!proved) return steps;
    if (decisions.size() > components_shown)
        steps.push_back({"All " + std::to_string(decisions.size()) + " components are compared in this way", ""});
    const std::string difference = decisions.size() == 1 ? "The difference" : "Each difference";
    steps.push_back({difference + " reduces to zero" + (relations.empty() ? "" : " by the relations"),
                     lines_of({relations.begin(), relations.end()}, ",")});
    std::vector<std::string> nonzero;
    double width = 0;
    for (const auto& [w, divisor] : divisors) {
        width += w;
        if (width < widest) nonzero.push_back(divisor + " \\ne 0");
    }
    if (nonzero.empty()) return steps;
    const std::size_t hidden = divisors.size() - nonzero.size();
    steps.push_back({"where no divisor is zero" + (hidden == 0 ? "" : "; " + std::to_string(hidden) + " long ones are not shown"),
                     lines_of(nonzero, ",")});
    return steps;
}

} // namespace denhartog::derivation

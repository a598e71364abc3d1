#include "derivation/claims/limit_twins.hpp"

#include "derivation/algebra/symbols.hpp"

namespace denhartog::derivation {

using GiNaC::ex;

Verdict decide_term_and_twins(const ex& e, const ex& x, const LeadingTerm& expected) {
    const Verdict verdict = decide_leading_term(e, x, expected);
    if (verdict != Verdict::proved) return verdict;
    const auto& [c, n] = expected;
    for (const LeadingTerm& twin : {LeadingTerm{2 * c, n}, LeadingTerm{-c, n}, LeadingTerm{c, n + 1}, LeadingTerm{c, n - 1}}) {
        if (decide_leading_term(e, x, twin) != Verdict::refuted) return Verdict::unknown;
        ++altered_statements_refuted();
    }
    return Verdict::proved;
}

Verdict decide_zero_and_twin(const ex& e) {
    const std::vector<Range> domain = domain_of({e});
    const Verdict verdict = decide_equal(0, e, domain).verdict; // where e is real
    if (verdict != Verdict::proved) return verdict;
    if (decide_equal(1, e, domain).verdict != Verdict::refuted) return Verdict::unknown;
    ++altered_statements_refuted();
    return Verdict::proved;
}

Claim claim_on_limit(std::string id, std::vector<std::string> equations, std::string title, std::vector<std::string> assumptions,
                     std::function<Outcome()> check) {
    return {.id = std::move(id),
            .equations = std::move(equations),
            .role = Role::step,
            .title = std::move(title),
            .assumptions = std::move(assumptions),
            .check = std::move(check)};
}

} // namespace denhartog::derivation

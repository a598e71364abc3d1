#include "derivation/algebra/limits.hpp"

#include <map>
#include <optional>
#include <stdexcept>

#include "denhartog/formulas/mode.hpp"
#include "derivation/algebra/kept_identities.hpp"
#include "derivation/algebra/symbols.hpp"

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::numeric;

namespace {

std::optional<LeadingTerm> first_term(const ex& e, const ex& x, int highest) {
    keep(Ground::series);
    static std::map<ex, LeadingTerm, GiNaC::ex_is_less> found; // the twins of a statement ask for the same series
    const ex question = GiNaC::lst{e, x};
    if (const auto place = found.find(question); place != found.end())
        return place->second.power <= highest ? std::optional(place->second) : std::nullopt;
    const int spare = 3; // the last terms of a quotient of series can come out as orders of magnitude
    const ex series = GiNaC::series_to_poly(e.series(x == 0, highest + 1 + spare)).expand();
    for (int power = series.ldegree(x); power <= highest; ++power) {
        const ex coefficient = series.coeff(x, power);
        if (!remainder(coefficient, domain_of({coefficient})).is_zero())
            return found.emplace(question, LeadingTerm{coefficient, power}).first->second;
    }
    return std::nullopt;
}

} // namespace

LeadingTerm leading_term(const ex& e, const ex& x, int highest) {
    const std::optional<LeadingTerm> term = first_term(e, x, highest);
    if (!term) throw std::domain_error("no term of the series up to power " + std::to_string(highest));
    return *term;
}

Verdict decide_leading_term(const ex& e, const ex& x, const LeadingTerm& expected) {
    const std::optional<LeadingTerm> found = first_term(e, x, expected.power);
    if (!found || found->power != expected.power) return Verdict::refuted;
    const std::vector<Range> domain = domain_of({found->coefficient, expected.coefficient});
    const Verdict verdict = decide_equal(found->coefficient, expected.coefficient, domain).verdict;
    if (verdict != Verdict::proved) return verdict;
    const ex term = expected.coefficient * GiNaC::pow(x, expected.power);
    std::vector<Range> others = domain_of({e, expected.coefficient});
    std::erase_if(others, [&x](const Range& range) { return range.symbol.is_equal(x); });
    for (const Point& point : sample_points(others, 3)) {
        numeric last = 1;
        for (const numeric& small : {numeric(1, 1000000), numeric(1, 100000000), numeric("1/10000000000")}) {
            Point at = point;
            at.emplace_back(x, small);
            const numeric error = abs(evaluate(e, at) / evaluate(term, at) - 1);
            if (error > last / 10 && error > numeric("1e-30")) return Verdict::unknown;
            last = error;
        }
    }
    return Verdict::proved;
}

ex first_function(const ex& R, const ex& zeta) { return paper::first_damping_function(Symbolic(R), Symbolic(zeta)).expression(); }

ex second_function(const ex& R, const ex& zeta) {
    return paper::second_damping_function(Symbolic(R), Symbolic(zeta)).expression();
}

ex squared_response(const ex& R, const ex& zeta) {
    return squared_modulus(paper::complex_response(Symbolic(R), Symbolic(zeta))).expression();
}

ex squared_limit_of_single_mass(const ex& r, const ex& zeta) {
    const ex u = first_function(r, zeta), g = second_function(r, zeta);
    const ex demand = paper::s_d_at_zero(Symbolic(r), Symbolic(zeta), Symbolic(u), Symbolic(g)).expression() / (r * r);
    return squared_response(r, zeta) / (u * u + demand * demand);
}

void add_statement(Outcome& outcome, Verdict verdict, const std::string& what, const std::string& latex) {
    if (outcome.steps.empty()) outcome.verdict = Verdict::proved;
    if (verdict != Verdict::proved && outcome.verdict == Verdict::proved) outcome.verdict = verdict;
    outcome.steps.push_back({what + ", " + to_string(verdict), latex});
}

void add_argument(Outcome& outcome, const std::string& what, const std::string& latex) {
    outcome.steps.push_back({"Argument, given by a person: " + what, latex});
    outcome.argued = true;
    keep(Ground::argument);
}

void add_claim(Outcome& outcome, const std::string& id, const std::string& what) {
    keep(Ground::claim);
    const KeepNothing of_it; // it is exported by itself
    for (const Claim& claim : claims())
        if (claim.id == id) return add_statement(outcome, decide(claim).verdict, "Rests on " + id + ": " + what, "");
    throw std::logic_error("no claim named " + id);
}

} // namespace denhartog::derivation

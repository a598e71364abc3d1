// Limits along a path: known ones are proved, other coefficients and powers refuted.
#include "derivation/algebra/limits.hpp"

#include "derivation/algebra/symbols.hpp"
#include "tests/catch.hpp"

using namespace denhartog::derivation;
using GiNaC::ex;
using GiNaC::numeric;

namespace {

const ex& small() {
    static const ex x = new_symbol("x_test", "x", numeric(1, 1000), numeric(1, 100));
    return x;
}

} // namespace

TEST_CASE("a known limit is proved, and with another coefficient or power refuted", "[limit]") {
    const ex x = small(), e = (1 - GiNaC::cos(x)) / (x * x);
    CHECK(decide_leading_term(e, x, {numeric(1, 2), 0}) == Verdict::proved);
    CHECK(decide_leading_term(e, x, {numeric(1, 3), 0}) == Verdict::refuted);
    CHECK(decide_leading_term(e, x, {-numeric(1, 2), 0}) == Verdict::refuted);
    CHECK(decide_leading_term(e, x, {numeric(1, 2), 1}) == Verdict::refuted);
    CHECK(decide_leading_term(e, x, {numeric(1, 2), -1}) == Verdict::refuted);
    CHECK(decide_leading_term(e - numeric(1, 2), x, {-numeric(1, 24), 2}) == Verdict::proved);
}

TEST_CASE("a leading term with symbols in it is compared as an expression", "[limit]") {
    const ex x = small(), zeta = symbols().zeta, e = GiNaC::sinh(zeta * x) / x;
    CHECK(decide_leading_term(e, x, {zeta, 0}) == Verdict::proved);
    CHECK(decide_leading_term(e, x, {zeta * zeta, 0}) == Verdict::refuted);
}

TEST_CASE("the limit of the first damping function depends on the path to resonance", "[eq:28][limit]") {
    const ex x = small();
    CHECK(decide_leading_term(first_function(1, x), x, {1 / GiNaC::Pi, 0}) == Verdict::proved);
    CHECK(decide_leading_term(first_function(1, x), x, {0, 0}) == Verdict::refuted);
    CHECK(decide_leading_term(first_function(1 - x * x / 2, x), x, {1 / GiNaC::Pi, 0}) == Verdict::refuted);
    CHECK(decide_leading_term(first_function(1 + x, 0), x, {2 / GiNaC::Pi, -1}) == Verdict::proved);
}

TEST_CASE("an expression that vanishes has no leading term", "[limit]") {
    const ex x = small();
    CHECK_THROWS_AS(leading_term(GiNaC::sin(x) - GiNaC::sin(x), x), std::domain_error);
    CHECK_THROWS_AS(leading_term(x * x * x, x, 2), std::domain_error);
}

TEST_CASE("an outcome of several statements is proved only where all are", "[limit]") {
    Outcome outcome;
    add_statement(outcome, Verdict::proved, "one", "");
    CHECK(outcome.verdict == Verdict::proved);
    add_statement(outcome, Verdict::refuted, "another", "");
    add_statement(outcome, Verdict::proved, "a third", "");
    CHECK(outcome.verdict == Verdict::refuted);
    CHECK(outcome.steps.size() == 3);
    CHECK_THROWS_AS(add_claim(outcome, "no such claim", ""), std::logic_error);
}

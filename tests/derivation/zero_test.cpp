// The trusted base: what is zero is proved, what is not is refuted with a witness, near misses included.
#include "derivation/algebra/zero_test.hpp"

#include <algorithm>

#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/claim.hpp"
#include "tests/catch.hpp"

using namespace denhartog::derivation;
using GiNaC::ex;
using GiNaC::numeric;

namespace {

Verdict verdict(const ex& left, const ex& right) { return decide_equal(left, right, domain_of({left, right})).verdict; }

} // namespace

TEST_CASE("known identities are proved", "[zero_test]") {
    const Symbols& s = symbols();
    const ex a = s.tau, b = s.phi_j, R = s.R, zeta = s.zeta;
    CHECK(verdict(pow(sin(a), 2) + pow(cos(a), 2), 1) == Verdict::proved);
    CHECK(verdict(sin(a + b), sin(a) * cos(b) + cos(a) * sin(b)) == Verdict::proved);
    CHECK(verdict(sin(3 * a), 3 * sin(a) - 4 * pow(sin(a), 3)) == Verdict::proved);
    CHECK(verdict(cos(a), 2 * pow(cos(a / 2), 2) - 1) == Verdict::proved);
    CHECK(verdict(pow(cosh(a), 2) - pow(sinh(a), 2), 1) == Verdict::proved);
    CHECK(verdict(exp(a) * exp(-a / 3), exp(2 * a / 3)) == Verdict::proved);
    CHECK(verdict(sqrt((1 - zeta) * (1 + zeta)), sqrt(1 - zeta * zeta)) == Verdict::proved);
    CHECK(verdict(sqrt((1 - zeta * zeta) / (R * R)), sqrt(1 - zeta * zeta) / R) == Verdict::proved);
    CHECK(verdict(cos(atan2(b, a)), a / sqrt(a * a + b * b)) == Verdict::proved);
    CHECK(verdict(sin(a + GiNaC::Pi / 2), cos(a)) == Verdict::proved);
    CHECK(verdict((R * R - 1) / (R - 1), R + 1) == Verdict::proved);
}

TEST_CASE("a polynomial is zero where its coefficients are, and they are divided by what it is divided by", "[zero_test]") {
    const Symbols& s = symbols();
    const ex a = s.tau, R = s.R, zeta = s.zeta, beta = s.beta, U = s.U_j;
    const ex one = pow(sin(a), 2) + pow(cos(a), 2);
    CHECK(verdict(beta * beta * one + U * one, beta * beta + U) == Verdict::proved);
    CHECK(verdict(beta * beta * one + U * one, beta * beta + 2 * U) == Verdict::refuted);
    CHECK(verdict(beta * beta * one + U * one, beta * beta + U + numeric("1/1000000000000000000000000") * U) == Verdict::refuted);
    // zeta stands under the root too, so that its coefficients alone are not zero
    CHECK(verdict(zeta * zeta + sqrt(1 - zeta * zeta) * sqrt((1 - zeta) * (1 + zeta)), 1) == Verdict::proved);

    const ex left = beta / (R - 1) + U / (R + 1), right = (beta * (R + 1) + U * (R - 1)) / (R * R - 1);
    const Decision decision = decide_equal(left, right, domain_of({left, right}));
    CHECK(decision.verdict == Verdict::proved);
    for (const int pole : {1, -1})
        CHECK(std::any_of(decision.denominators.begin(), decision.denominators.end(),
                          [&](const ex& d) { return d.subs(R == pole).is_zero(); }));
}

TEST_CASE("a divisor that cancels is reported with the proof", "[zero_test]") {
    const Symbols& s = symbols();
    const ex R = s.R, a = s.tau;
    const auto divides = [](const ex& left, const ex& right, const GiNaC::exmap& pole) {
        const Decision decision = decide_equal(left, right, domain_of({left, right}));
        CHECK(decision.verdict == Verdict::proved);
        const GiNaC::exmap meanings(decision.generators.begin(), decision.generators.end());
        return std::any_of(decision.denominators.begin(), decision.denominators.end(),
                           [&](const ex& d) { return d.subs(meanings).subs(pole).is_zero(); });
    };
    const ex quotient = (R * R - 1) / (R - 1);
    CHECK(divides(quotient, R + 1, {{R, 1}}));
    CHECK(divides(quotient, quotient, {{R, 1}}));
    CHECK(divides(1 / (1 / (R - 1) + 1), (R - 1) / R, {{R, 1}}));
    CHECK(divides((1 - pow(cos(a), 2)) / sin(a), sin(a), {{a, 0}}));
    CHECK_FALSE(divides(quotient, R + 1, {{R, 2}}));
}

TEST_CASE("near identities are refuted with a witness", "[zero_test]") {
    const Symbols& s = symbols();
    const ex a = s.tau, tiny = numeric("1/1000000000000000000000000");
    CHECK(verdict(sin(a), a - pow(a, 3) / 6 + pow(a, 5) / 120) == Verdict::refuted);
    CHECK(verdict(pow(sin(a), 2) + pow(cos(a), 2), 1 + tiny) == Verdict::refuted);
    CHECK(verdict(sinh(a), sin(a)) == Verdict::refuted);
    CHECK(verdict(sqrt(a * a + 1), a + 1) == Verdict::refuted);
    CHECK(verdict(-sqrt(1 - s.zeta * s.zeta), sqrt(1 - s.zeta * s.zeta)) == Verdict::refuted);
    const Decision decision = decide_equal(cos(a), cos(2 * a), domain_of({a}));
    REQUIRE(decision.verdict == Verdict::refuted);
    CHECK(decision.witness.size() == 1);
    CHECK(decision.left != decision.right);
}

TEST_CASE("what cannot be decided is unknown, never proved", "[zero_test]") {
    const Symbols& s = symbols();
    CHECK(verdict(sqrt(2 * s.R) * sqrt(2 * s.R + 2), 2 * sqrt(s.R * s.R + s.R)) !=
          Verdict::refuted);                                                 // true, whatever the base makes of it
    CHECK(verdict(tan(s.tau), sin(s.tau) / cos(s.tau)) == Verdict::unknown); // a function it does not know
    CHECK(verdict(sqrt(-1 - s.R), sqrt(-1 - s.R)) != Verdict::refuted);
    CHECK(verdict(sqrt(-1 - s.R), sqrt(-1 - s.R)) != Verdict::proved); // no real value anywhere in the domain
}

TEST_CASE("the symbolic scalar counts its operations and replaces one of them", "[symbolic]") {
    const Symbolic R(symbols().R), zeta(symbols().zeta);
    long operations = 0;
    {
        const Mutation none(-1);
        (void)denhartog::paper::second_damping_function(R, zeta);
        operations = none.operations();
        CHECK(none.replaced().empty());
    }
    CHECK(operations > 10);
    const ex right = denhartog::paper::second_damping_function(R, zeta).expression();
    const Mutation last(operations - 1);
    const ex mutated = denhartog::paper::second_damping_function(R, zeta).expression();
    CHECK(last.replaced() == "/ -> *");
    CHECK(verdict(mutated, right) == Verdict::refuted);
}

TEST_CASE("a claim whose kernel is wrong is refuted, and a hole among its mutants is found", "[claim]") {
    const Symbols& s = symbols();
    Claim claim{.id = "test/wrong", .equations = {"28"}};
    claim.kernel = [&s] { return Values{denhartog::paper::second_damping_function(Symbolic(s.R), Symbolic(s.zeta))}; };
    claim.derived = [&s] {
        return std::vector<ex>{denhartog::paper::first_damping_function(Symbolic(s.R), Symbolic(s.zeta)).expression()};
    };
    CHECK(decide(claim).verdict == Verdict::refuted);
    // zero times anything: the second factor can be mutated and nothing is noticed; that is a hole and must be counted
    claim.kernel = [&s] { return Values{Symbolic(GiNaC::ex(0)) * (Symbolic(s.R) + Symbolic(s.zeta))}; };
    claim.derived = [] { return std::vector<ex>{0}; };
    CHECK(decide(claim).verdict == Verdict::proved);
    const MutantCount count = mutate(claim);
    CHECK(count.proved > 0);
    CHECK(count.holes.size() == static_cast<std::size_t>(count.proved + count.unknown));
}

// The kinds of mutated twins: each is made where it can be, and one that is not refuted is a hole.
#include <algorithm>

#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/claim.hpp"
#include "tests/catch.hpp"

using namespace denhartog::derivation;
using GiNaC::ex;

namespace {

Claim claim_of(std::function<Values()> kernel, std::function<std::vector<ex>()> derived) {
    Claim claim{.id = "test/twins", .equations = {"28"}};
    claim.kernel = std::move(kernel);
    claim.derived = std::move(derived);
    return claim;
}

bool has_hole(const MutantCount& count, const std::string& what) {
    return std::any_of(count.holes.begin(), count.holes.end(),
                       [&what](const std::string& hole) { return hole.find(what) != std::string::npos; });
}

/// The replacements of all operations of a kernel, in their order.
std::vector<std::string> replacements(const std::function<Values()>& kernel) {
    std::vector<std::string> found;
    for (long position = 0;; ++position) {
        const Mutation mutation(position);
        (void)kernel();
        if (mutation.replaced().empty()) return found;
        found.push_back(mutation.replaced());
    }
}

} // namespace

TEST_CASE("a sum has a twin with the other sign and one that has lost a term, and pi has one", "[twins]") {
    const Symbolic R(symbols().R), tau(symbols().tau);
    CHECK(replacements([&] { return Values{R + tau}; }) == std::vector<std::string>{"+ -> -", "a + b -> a"});
    CHECK(replacements([&] { return Values{R - tau}; }) == std::vector<std::string>{"- -> +", "a - b -> a"});
    CHECK(replacements([&] { return Values{denhartog::pi<Symbolic>() * R}; }) == std::vector<std::string>{"pi -> 3", "* -> /"});
}

TEST_CASE("indices that are exchanged and modes that are left out make twins; they are refuted", "[twins]") {
    const Symbols& s = symbols();
    const SymbolicModes m = symbolic_modes(2);
    const ex load = s.psi_ki * s.psi_li * s.u + s.psi_ji * s.g, sum = m.psi_j[0].expression() + 2 * m.psi_j[1].expression();
    Claim claim = claim_of([=] { return Values{Symbolic(load), Symbolic(sum)}; }, [=] { return std::vector<ex>{load, sum}; });
    const MutantCount count = mutate(claim);
    // three exchanges; two modes left out; the derived sides: one added, sign, doubled and two terms dropped, each twice
    CHECK(count.refuted == 3 + 2 + 10);
    CHECK(count.holes.empty());
}

TEST_CASE("a kernel in which an exchange changes nothing has no such twin", "[twins]") {
    const Symbols& s = symbols();
    const ex symmetric = s.psi_ji * s.psi_li;
    CHECK(mutate(claim_of([=] { return Values{Symbolic(symmetric)}; }, [=] { return std::vector<ex>{symmetric}; })).refuted ==
          1 + 3);
}

TEST_CASE("a twin that is proved is a hole, on either side", "[twins]") {
    const Symbols& s = symbols();
    // a kernel that is zero however it is altered, and a derived side of which a term is zero
    const ex nothing = GiNaC::pow(GiNaC::sin(s.tau), 2) + GiNaC::pow(GiNaC::cos(s.tau), 2) - 1;
    Claim claim = claim_of([&s, nothing] { return Values{Symbolic(s.R) - Symbolic(nothing)}; },
                           [=] { return std::vector<ex>{s.R + nothing}; });
    const MutantCount count = mutate(claim);
    CHECK(has_hole(count, "a - b -> a"));
    CHECK(count.proved > 0);
    CHECK(count.idle == 0);
    claim.special_case = true; // there an operation may meet a zero
    const MutantCount special = mutate(claim);
    CHECK_FALSE(has_hole(special, "a - b -> a"));
    CHECK(special.idle == 2); // + for -, and a for a - b
}

TEST_CASE("a claim with a check of its own counts the altered statements that it has refuted", "[twins]") {
    const Symbols& s = symbols();
    Claim claim{.id = "test/check", .equations = {"28"}};
    claim.check = [&s] {
        Outcome outcome;
        outcome.verdict = decide_equal(s.R, s.R, domain_of({s.R})).verdict;
        if (decide_equal(s.R + 1, s.R, domain_of({s.R})).verdict == Verdict::refuted) ++altered_statements_refuted();
        return outcome;
    };
    CHECK(decide(claim).altered == 1);
    claim.check = [] { return Outcome{Verdict::proved, {}, {}}; };
    CHECK(decide(claim).altered == 0);
}

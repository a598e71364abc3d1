// The kind of a claim follows from what is called while its sides are built and from what a false premise breaks, and from nothing that
// is written next to it.
#include "denhartog/formulas/mode.hpp"
#include "derivation/algebra/limits.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/claim.hpp"
#include "derivation/claims/provenance.hpp"
#include "derivation/claims/run.hpp"
#include "derivation/ledger/equation_order.hpp"
#include "derivation/paper/derived.hpp"
#include "tests/catch.hpp"

using namespace denhartog;
using namespace denhartog::derivation;
using GiNaC::ex;

namespace {

Claim claim_of(std::function<Values()> kernel, std::function<std::vector<ex>()> derived) {
    return {.id = "23/test", .equations = {"23"}, .kernel = std::move(kernel), .derived = std::move(derived)};
}

Values shipped_response() { return {paper::complex_response(Symbolic(symbols().R), Symbolic(symbols().zeta)).re}; }

ex typed_response() {
    const ex a = 1 - symbols().R * symbols().R, b = 2 * symbols().zeta * symbols().R;
    return a / (a * a + b * b);
}

} // namespace

TEST_CASE("the kind of a claim is computed from what its sides call", "[claim]") {
    const Result derived = decide(claim_of(shipped_response, [] { return std::vector<ex>{derived_complex_response().first}; }));
    CHECK(derived.verdict == Verdict::proved);
    CHECK(derived.kind == "derived");
    const Result refined =
        decide(claim_of(shipped_response, [] { return std::vector<ex>{shipped_response().front().expression()}; }));
    CHECK(refined.verdict == Verdict::proved);
    CHECK(refined.kind == "refinement");
    const Result restated = decide(claim_of(shipped_response, [] { return std::vector<ex>{typed_response()}; }));
    CHECK(restated.verdict == Verdict::proved);
    CHECK(restated.kind == "restated");
    CHECK(restated.fingerprint == refined.fingerprint);
    CHECK_FALSE(restated.fingerprint.empty());
}

TEST_CASE("a premise that makes no difference does not make a claim derived", "[claim]") {
    const Result needed = decide(claim_of(shipped_response, [] { return std::vector<ex>{from_premise() * typed_response()}; }));
    CHECK(needed.verdict == Verdict::proved);
    CHECK(needed.kind == "derived");
    const Result idle = decide(claim_of(shipped_response, [] { return std::vector<ex>{typed_response() + 0 * from_premise()}; }));
    CHECK(idle.verdict == Verdict::proved);
    CHECK(idle.kind == "restated");
    Claim check{.id = "23/check", .equations = {"23"}};
    check.check = [] { return Outcome{from_premise().is_equal(1) ? Verdict::proved : Verdict::refuted, {}, {}}; };
    CHECK(decide(check).kind == "derived");
    check.check = [] { return Outcome{from_premise().is_zero() ? Verdict::refuted : Verdict::proved, {}, {}}; };
    CHECK(decide(check).kind == "consequence");
}

TEST_CASE("claims come in the order of their equations, those named after one before the others", "[claim]") {
    std::size_t followed = 0; // own claims that another one follows
    const std::vector<Claim>& all = claims();
    const auto is_own = [](const Claim& claim) { return claim.id.starts_with(claim.equations.front() + "/"); };
    for (std::size_t n = 1; n < all.size(); ++n) {
        const Claim &before = all[n - 1], &claim = all[n];
        INFO(before.id << ", " << claim.id);
        const auto first = position_of_equation(before.equations.front()), second = position_of_equation(claim.equations.front());
        CHECK(first <= second);
        if (first == second) CHECK((is_own(before) || !is_own(claim)));
        followed += first == second && is_own(before) && !is_own(claim) ? 1 : 0;
    }
    CHECK(followed > 0);
}

TEST_CASE("a check is an argument where a person argued, and a consequence where none did", "[claim]") {
    const auto outcome_of = [](bool argued) {
        Outcome outcome;
        add_statement(outcome, Verdict::proved, "a statement", "");
        if (argued) add_argument(outcome, "an argument", "");
        return outcome;
    };
    Claim claim{.id = "86/test", .equations = {"86"}, .role = Role::step};
    claim.check = [&] { return outcome_of(false); };
    CHECK(decide(claim).kind == "consequence");
    claim.check = [&] { return outcome_of(true); };
    CHECK(decide(claim).kind == "argument");
    claim.role = Role::observation;
    CHECK(decide(claim).kind == "argument");
    claim.check = [&] { return outcome_of(false); };
    CHECK(decide(claim).kind == "observation");
}

TEST_CASE("the components of a claim decide their own equations", "[claim]") {
    const ex R = symbols().R;
    Claim claim = claim_of([=] { return Values{Symbolic(R), Symbolic(R)}; }, [=] { return std::vector<ex>{R, R + 1}; });
    claim.equations = claim.by_component = {"31", "32"};
    const Result result = decide(claim);
    CHECK(result.by_equation.at("31") == Verdict::proved);
    CHECK(result.by_equation.at("32") == Verdict::refuted);
}

TEST_CASE("a claim that says what one before it has said is known by its values", "[claim]") {
    const Claim first = claim_of(shipped_response, [] { return std::vector<ex>{typed_response()}; });
    Claim second = first,
          other = claim_of([] { return Values{Symbolic(symbols().R)}; }, [] { return std::vector<ex>{symbols().R}; });
    second.id = "23/again";
    other.id = "23/other";
    const Claim zero = claim_of([] { return Values{Symbolic(ex(0))}; }, [] { return std::vector<ex>{0}; });
    CHECK(decide(zero).fingerprint.empty());
    const std::vector<Claim> claims{first, second, other};
    Findings findings;
    for (const Claim& claim : claims) {
        const Result result = decide(claim);
        findings[claim.id] = {{"record",
                               {{"verdict", "proved"},
                                {"kind", result.kind},
                                {"by_equation", nlohmann::json::object()},
                                {"correction", ""},
                                {"witness", nlohmann::json::array()}}},
                              {"fingerprint", result.fingerprint},
                              {"twins", nullptr},
                              {"fault", ""}};
    }
    const Run run = run_of(claims, findings);
    REQUIRE(run.claims.size() == 3);
    CHECK(run.claims[0].same_as.empty());
    CHECK(run.claims[1].same_as == "23/test");
    CHECK(run.claims[2].same_as.empty());
    CHECK(claims_from_json(to_json(run.claims))[1].same_as == "23/test");
}

TEST_CASE("a claim that ends unknown makes the run fail, whatever it speaks of", "[claim]") {
    Claim claim = claim_of(shipped_response, [] { return std::vector<ex>{typed_response()}; });
    for (const Role role : {Role::both, Role::printed, Role::shipped, Role::step, Role::observation}) {
        claim.role = role;
        const Findings findings{{claim.id,
                                 {{"record",
                                   {{"verdict", "unknown"},
                                    {"kind", "restated"},
                                    {"by_equation", nlohmann::json::object()},
                                    {"correction", ""},
                                    {"witness", nlohmann::json::array()}}},
                                  {"fingerprint", ""},
                                  {"twins", nullptr},
                                  {"why_no_twin", "a test"},
                                  {"fault", ""}}}};
        CHECK(run_of({claim}, findings).faults.size() == 1);
    }
}

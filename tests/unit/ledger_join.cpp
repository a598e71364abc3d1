#include "derivation/ledger/ledger_join.hpp"

#include <algorithm>
#include <limits>

#include "tests/unit/ledger_fixtures.hpp"

using namespace denhartog;
using derivation::ClaimResult;
using derivation::join_ledger;
using derivation::JoinedLedger;
using derivation::LedgerParts;
using ledger::Json;
using tests::tells;

namespace {

ClaimResult claim(const std::string& id, const std::string& equation, const std::string& role, const std::string& verdict) {
    ClaimResult made;
    made.id = id;
    made.equations = {equation};
    made.role = role;
    made.verdict = verdict;
    made.what = "a claim";
    return made;
}

/// Parts that leave nothing to be desired: every result proved, every function tested.
LedgerParts complete_parts() {
    LedgerParts parts;
    parts.rows = tests::project_rows();
    parts.results.found = true;
    for (const Json& row : parts.rows) {
        const std::string equation = row.at("equation");
        const bool function = !row.contains("no_function");
        if (function) {
            parts.functions.push_back({equation, "denhartog::paper::f", "src/f.hpp", 7});
            parts.declared.push_back({"test of " + equation, {equation}, "f.cpp", 9});
            parts.results.runs.push_back({"test of " + equation, {equation}, true});
        }
        if (row.at("kind") != "definition" && row.at("kind") != "assumption")
            parts.claims.push_back(claim(equation + "/claim", equation, function ? "both" : "printed", "proved"));
    }
    return parts;
}

ClaimResult& claim_of(LedgerParts& parts, const std::string& id) {
    for (ClaimResult& found : parts.claims)
        if (found.id == id) return found;
    FAIL("no claim " << id);
    throw std::logic_error(id);
}

Json entry_of(const JoinedLedger& joined, const std::string& equation) {
    for (const Json& entry : joined.entries)
        if (entry.at("equation") == equation) return entry;
    FAIL("no entry " << equation);
    return {};
}

/// (46) refuted as printed and proved as corrected.
void correct_46(LedgerParts& parts) {
    ClaimResult& printed = claim_of(parts, "46/claim");
    printed.role = "printed";
    printed.verdict = "refuted";
    printed.departure = "misprint";
    printed.correction_latex = "\\bar{x}_k=0";
    printed.witness = {{"R", "0.5"}};
    printed.loss = 0.25;
    printed.consequence = "a quarter of the amplitude";
    parts.claims.push_back(claim("46/shipped", "46", "shipped", "proved"));
}

} // namespace

TEST_CASE("a ledger with nothing missing has no faults and every key that the interface promises", "[ledger]") {
    const JoinedLedger joined = join_ledger(complete_parts());
    for (const std::string& fault : joined.faults) UNSCOPED_INFO(fault);
    CHECK(joined.faults.empty());
    REQUIRE(joined.entries.size() == 103);
    for (const Json& entry : joined.entries)
        for (const char* key : {"equation", "section", "kind", "statement", "printed", "departure", "correction", "shipped",
                                "witness", "loss", "functions", "claims", "tests", "figures", "rests_on", "used_by"})
            CHECK(entry.contains(key));
    CHECK(joined.summary.at("equations") == 103);
    CHECK(joined.summary.at("refuted").empty());
    CHECK(joined.summary.at("with_function") == joined.summary.at("with_test"));
}

TEST_CASE("verdicts without claims follow from the kind and the function", "[ledger]") {
    const JoinedLedger joined = join_ledger(complete_parts());
    CHECK(entry_of(joined, "10").at("printed") == "definition");
    CHECK(entry_of(joined, "10").at("shipped") == "definition");
    CHECK(entry_of(joined, "10").at("loss") == 0.0);
    CHECK(entry_of(joined, "25").at("printed") == "assumption");
    CHECK(entry_of(joined, "25").at("shipped") == "not_applicable");
    CHECK(entry_of(joined, "73").at("printed") == "definition");
    CHECK(entry_of(joined, "74").at("printed") == "definition");
    CHECK(entry_of(joined, "12").at("printed") == "proved");
    CHECK(entry_of(joined, "12").at("shipped") == "not_applicable");
}

TEST_CASE("a slip of the scan is told apart from what the paper got wrong", "[ledger]") {
    LedgerParts parts = complete_parts();
    CHECK(entry_of(join_ledger(parts), "5").at("departure") == "scan");
    CHECK(entry_of(join_ledger(parts), "5").at("correction") == R"(\tau=\omega t\qquad\bar{\mathbf{x}}=\frac{k_1}{P}\mathbf{x})");
    CHECK(entry_of(join_ledger(parts), "5").at("printed") == "definition");
    CHECK(entry_of(join_ledger(parts), "46").at("departure") == "none");
    const auto slips =
        std::count_if(parts.rows.begin(), parts.rows.end(), [](const Json& row) { return row.contains("read_as"); });
    CHECK(slips > 0);
    CHECK(join_ledger(parts).summary.at("departure").at("scan") == slips);
    claim_of(parts, "A.7/claim").departure = "misprint";
    CHECK(entry_of(join_ledger(parts), "A.7").at("departure") == "misprint");
}

TEST_CASE("a refuted printed form with a proved correction is no fault", "[ledger]") {
    LedgerParts parts = complete_parts();
    correct_46(parts);
    const JoinedLedger joined = join_ledger(parts);
    for (const std::string& fault : joined.faults) UNSCOPED_INFO(fault);
    CHECK(joined.faults.empty());
    const Json entry = entry_of(joined, "46");
    CHECK(entry.at("printed") == "refuted");
    CHECK(entry.at("shipped") == "proved");
    CHECK(entry.at("departure") == "misprint");
    CHECK(entry.at("correction") == "\\bar{x}_k=0");
    CHECK(entry.at("witness").at("R") == "0.5");
    CHECK(entry.at("loss") == 0.25);
    CHECK(entry.at("consequence") == "a quarter of the amplitude");
    CHECK(entry.at("claims").size() == 2);
    CHECK(joined.summary.at("refuted") == Json({"46"}));
    CHECK(joined.summary.at("refuted_without_loss").empty());
}

TEST_CASE("what the scan made illegible is not counted among the paper's faults", "[ledger]") {
    LedgerParts parts = complete_parts();
    claim_of(parts, "16/claim").role = "shipped";
    parts.claims.push_back(claim("16/printed", "16", "printed", "refuted"));
    parts.claims.back().departure = "scan";
    parts.claims.back().correction_latex = "x";
    parts.claims.back().witness = {{"R", "2"}};
    JoinedLedger joined = join_ledger(parts);
    CHECK(joined.faults.empty());
    CHECK(entry_of(joined, "16").at("printed") == "illegible");
    CHECK(entry_of(joined, "16").at("shipped") == "proved");
    CHECK(entry_of(joined, "16").at("witness").at("R") == "2");
    CHECK(joined.summary.at("refuted").empty());
    CHECK(joined.summary.at("illegible") == Json({"16"}));
    claim_of(parts, "16/printed").departure = "misprint";
    joined = join_ledger(parts);
    CHECK(entry_of(joined, "16").at("printed") == "refuted");
    CHECK(joined.summary.at("illegible").empty());
}

TEST_CASE("an equation is proved by a claim that derives it, or that refines one that is derived", "[ledger]") {
    LedgerParts parts = complete_parts();
    ClaimResult& only = claim_of(parts, "36/claim");
    for (const char* kind : {"restated", "consequence", "refinement"}) {
        only.kind = kind;
        CHECK(entry_of(join_ledger(parts), "36").at("printed") == "unknown");
        CHECK(tells(join_ledger(parts).faults, "equation 36 is unknown as printed: no claim derives it"));
    }
    only.refines = {"31"};
    CHECK(entry_of(join_ledger(parts), "36").at("printed") == "proved");
    CHECK(entry_of(join_ledger(parts), "36").at("claims").at(0).at("kind") == "refinement");
    only.refines = {"31", "10"}; // a definition, without a claim
    CHECK(entry_of(join_ledger(parts), "36").at("printed") == "unknown");
    only.kind = "derived";
    only.same_as = "31/claim";
    CHECK(entry_of(join_ledger(parts), "36").at("printed") == "unknown");
    CHECK(join_ledger(parts).summary.at("kinds").at("repeated") == 1);
    only.same_as.clear();
    only.kind = "guessed";
    CHECK(tells(join_ledger(parts).faults, "has the kind guessed"));
}

TEST_CASE("a definition with claims that only restate it stays a definition", "[ledger]") {
    LedgerParts parts = complete_parts();
    parts.claims.push_back(claim("17/orthonormal", "17", "both", "proved"));
    CHECK(entry_of(join_ledger(parts), "17").at("printed") == "proved");
    parts.claims.back().kind = "restated";
    CHECK(entry_of(join_ledger(parts), "17").at("printed") == "definition");
    CHECK(join_ledger(parts).faults.empty());
}

TEST_CASE("a claim on several equations has a verdict on each", "[ledger]") {
    LedgerParts parts = complete_parts();
    parts.claims.push_back(claim("31/both", "31", "both", "refuted"));
    parts.claims.back().equations = {"31", "32"};
    parts.claims.back().by_equation = {{"31", "proved"}, {"32", "refuted"}};
    const JoinedLedger joined = join_ledger(parts);
    CHECK(entry_of(joined, "31").at("printed") == "proved");
    CHECK(entry_of(joined, "32").at("printed") == "refuted");
}

TEST_CASE("what a person argued is a step and never a verdict on an equation", "[ledger]") {
    LedgerParts parts = complete_parts();
    parts.claims.push_back(claim("86/velocity", "86", "step", "argued"));
    parts.claims.back().kind = "argument";
    CHECK(join_ledger(parts).faults.empty());
    parts.claims.back().role = "shipped";
    CHECK(tells(join_ledger(parts).faults, "claim 86/velocity is argued and no step"));
}

TEST_CASE("the worst claim decides", "[ledger]") {
    LedgerParts parts = complete_parts();
    parts.claims.push_back(claim("48/order", "48", "both", "approximation"));
    CHECK(entry_of(join_ledger(parts), "48").at("printed") == "approximation");
    CHECK(entry_of(join_ledger(parts), "48").at("shipped") == "approximation");
    parts.claims.push_back(claim("48/step", "48", "step", "refuted"));
    CHECK(entry_of(join_ledger(parts), "48").at("printed") == "approximation");
    CHECK(join_ledger(parts).summary.at("refuted_steps") == Json({"48/step"}));
    CHECK(join_ledger(parts).faults.empty());
}

TEST_CASE("the paper's form comes first among the functions, what merely uses the equation last", "[ledger]") {
    LedgerParts parts = complete_parts();
    parts.functions.insert(parts.functions.begin(), {{"46", "denhartog::response", "r.hpp", 1},
                                                     {"46", "denhartog::evaluation::e", "e.hpp", 2},
                                                     {"46", "denhartog::as_printed::a", "a.hpp", 3},
                                                     {"12", "denhartog::half_period", "h.hpp", 4}});
    const JoinedLedger joined = join_ledger(parts);
    CHECK(joined.faults.empty());
    const Json functions = entry_of(joined, "46").at("functions");
    REQUIRE(functions.size() == 3);
    CHECK(functions[0].at("name") == "denhartog::paper::f");
    CHECK(functions[1].at("name") == "denhartog::evaluation::e");
    CHECK(functions[2].at("name") == "denhartog::response");
    CHECK(entry_of(joined, "46").at("as_printed")[0].at("name") == "denhartog::as_printed::a");
    CHECK(entry_of(joined, "12").at("functions").size() == 1);
    CHECK(entry_of(joined, "12").at("shipped") == "not_applicable");
}

TEST_CASE("an observation that was searched without a counterexample is measured and says what was searched", "[ledger]") {
    LedgerParts parts = complete_parts();
    parts.claims.push_back(claim("48/observed", "48", "observation", "measured"));
    CHECK(tells(join_ledger(parts).faults, "claim 48/observed is measured and no observation"));
    parts.claims.back().witness = {{"cases", "100000"}};
    CHECK(join_ledger(parts).faults.empty());
    parts.claims.back().role = "step";
    CHECK(tells(join_ledger(parts).faults, "claim 48/observed is measured and no observation"));
    parts.claims.back().role = "observation";
    parts.claims.back().verdict = "unknown";
    CHECK(tells(join_ledger(parts).faults, "claim 48/observed is unknown"));
}

TEST_CASE("a claim on two equations counts for both", "[ledger]") {
    LedgerParts parts = complete_parts();
    claim_of(parts, "40/claim").equations = {"40", "A.15"};
    std::erase_if(parts.claims, [](const ClaimResult& made) { return made.id == "A.15/claim"; });
    CHECK(join_ledger(parts).faults.empty());
    CHECK(entry_of(join_ledger(parts), "A.15").at("printed") == "proved");
}

TEST_CASE("what rests on an equation is what it is used by", "[ledger]") {
    const JoinedLedger joined = join_ledger(complete_parts());
    CHECK(entry_of(joined, "A.15").at("used_by") == Json({"40"}));
    CHECK(entry_of(joined, "36").at("used_by") == Json({"38", "39"}));
}

TEST_CASE("each thing that is missing or wrong makes a fault", "[ledger]") {
    LedgerParts parts = complete_parts();
    const auto expect = [&parts](const std::string& told) {
        const JoinedLedger joined = join_ledger(parts);
        for (const std::string& fault : joined.faults) UNSCOPED_INFO(fault);
        CHECK(tells(joined.faults, told));
    };
    SECTION("no claim") {
        std::erase_if(parts.claims, [](const ClaimResult& made) { return made.id == "12/claim"; });
        expect("equation 12 has no verdict");
    }
    SECTION("no claim on what is shipped") {
        claim_of(parts, "46/claim").role = "printed";
        expect("equation 46 has a formula and no claim on it");
    }
    SECTION("an unknown verdict") {
        claim_of(parts, "46/claim").verdict = "unknown", expect("equation 46 is unknown as printed");
    }
    SECTION("an unknown step without a search") {
        parts.claims.push_back(claim("46/step", "46", "step", "unknown"));
        expect("claim 46/step is unknown");
    }
    SECTION("a word that is no verdict") { claim_of(parts, "46/claim").verdict = "true", expect("which is no verdict"); }
    SECTION("a word that is no departure") { claim_of(parts, "46/claim").departure = "typo", expect("which is none"); }
    SECTION("a word that is no role") { claim_of(parts, "46/claim").role = "chorus", expect("which is no role"); }
    SECTION("nothing at all on an equation of Section 4") {
        std::erase_if(parts.claims, [](const ClaimResult& made) { return made.id == "86/claim"; });
        std::erase_if(parts.functions, [](const auto& function) { return function.equation == "86"; });
        expect("equation 86 has no verdict");
        expect("equation 86 has neither a formula nor a reason why not");
        CHECK(entry_of(join_ledger(parts), "86").at("printed") == "unknown");
        CHECK(entry_of(join_ledger(parts), "86").at("loss").is_null());
    }
    SECTION("a verdict put off") { claim_of(parts, "86/claim").verdict = "pending", expect("pending, which is no verdict"); }
    SECTION("refuted as shipped") { claim_of(parts, "46/claim").verdict = "refuted", expect("46 is refuted as shipped"); }
    SECTION("refuted without a correction") {
        correct_46(parts), claim_of(parts, "46/claim").correction_latex = "";
        expect("the printed form of equation 46 is refuted without a correction");
    }
    SECTION("refuted without a kind of departure") {
        correct_46(parts), claim_of(parts, "46/claim").departure = "none";
        expect("is refuted, but its departure is not said");
    }
    SECTION("refuted and the correction refuted") {
        correct_46(parts), claim_of(parts, "46/shipped").verdict = "refuted";
        expect("the printed form of equation 46 is refuted and no correction is proved");
    }
    SECTION("a definition refuted, what is shipped unclaimed") {
        parts.claims.push_back(claim("64/claim", "64", "printed", "refuted"));
        expect("equation 64 has a formula and no claim on it");
    }
    SECTION("a loss that is no number") {
        correct_46(parts), claim_of(parts, "46/claim").loss = std::numeric_limits<double>::quiet_NaN();
        expect("claim 46/claim has a loss that is not finite");
    }
    SECTION("a claim twice") { parts.claims.push_back(parts.claims.front()), expect("is there twice"); }
    SECTION("a claim on nothing") { claim_of(parts, "46/claim").equations = {}, expect("speaks of no equation"); }
    SECTION("a claim on no equation of the paper") {
        parts.claims.push_back(claim("89/claim", "89", "both", "proved"));
        expect("claim 89/claim speaks of equation 89");
    }
    SECTION("no formula and no reason") {
        std::erase_if(parts.functions, [](const auto& function) { return function.equation == "46"; });
        expect("equation 46 has neither a formula nor a reason why not");
    }
    SECTION("the printed form alone is no formula") {
        for (auto& function : parts.functions)
            if (function.equation == "46") function.name = "denhartog::as_printed::f";
        expect("equation 46 has neither a formula nor a reason why not");
    }
    SECTION("a formula and a reason against it") {
        parts.functions.push_back({"15", "denhartog::evaluation::f", "src/f.hpp", 7});
        expect("equation 15 has a formula and a reason why it has none");
    }
    SECTION("a function of no equation") {
        parts.functions.push_back({"89", "denhartog::f", "src/f.hpp", 7});
        expect("denhartog::f (src/f.hpp:7) is tagged eq{89}");
    }
    SECTION("no test") {
        std::erase_if(parts.results.runs, [](const auto& run) { return run.name == "test of 46"; });
        std::erase_if(parts.declared, [](const auto& test) { return test.name == "test of 46"; });
        expect("equation 46 has a formula and no test that ran and passed");
    }
    SECTION("a test that did not run") {
        parts.declared.push_back({"left out", {"29"}, "f.cpp", 1});
        expect("test 'left out' tagged eq:29 did not run");
    }
    SECTION("a test that failed") { parts.results.runs.front().passed = false, expect("test 'test of 1' failed"); }
    SECTION("a test of no equation") {
        parts.declared.push_back({"test of 1", {"1", "89"}, "f.cpp", 1});
        expect("test 'test of 1' is tagged eq:89, which is not in the paper");
    }
    SECTION("a row missing") { parts.rows.erase(45), expect("equation 46 has no row"); }
}

TEST_CASE("a test over types ran if one of its types did", "[ledger]") {
    LedgerParts parts = complete_parts();
    parts.declared.push_back({"over types", {"46"}, "f.cpp", 1});
    CHECK(tells(join_ledger(parts).faults, "test 'over types' tagged eq:46 did not run"));
    parts.results.runs.push_back({"over types - double", {"46"}, true});
    CHECK(join_ledger(parts).faults.empty());
}

TEST_CASE("a test that passed once and failed once did not pass", "[ledger]") {
    LedgerParts parts = complete_parts();
    parts.results.runs.push_back({"test of 46", {"46"}, false});
    const JoinedLedger joined = join_ledger(parts);
    CHECK(entry_of(joined, "46").at("tests").empty());
    CHECK(entry_of(joined, "46").at("tests_failed") == Json({"test of 46"}));
    CHECK(tells(joined.faults, "equation 46 has a formula and no test that ran and passed"));
}

TEST_CASE("without results of tests the tests are not judged, and not counted either", "[ledger]") {
    LedgerParts parts = complete_parts();
    parts.results = {};
    const JoinedLedger joined = join_ledger(parts);
    CHECK(joined.faults.empty());
    CHECK(joined.summary.at("with_test").is_null());
}

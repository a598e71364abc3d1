#include "denhartog/ledger/ledger.hpp"

#include <algorithm>

#include "denhartog/number/errors.hpp"
#include "derivation/ledger/ledger_join.hpp"
#include "tests/unit/ledger_fixtures.hpp"

using namespace denhartog;
using ledger::Json;

namespace {

Json one_entry(const std::string& equation) {
    return ledger::entry_without_run(
        {{"equation", equation}, {"section", "2.4"}, {"kind", "result"}, {"statement", "x=1"}, {"rests_on", {"41", "44"}}});
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

} // namespace

TEST_CASE("an equation is understood however it is written", "[ledger]") {
    for (const std::string text : {"46", "(46)", "eq:46", "eq:(46)"}) CHECK(ledger::asked_equation(text) == "46");
    for (const std::string text : {"A.7", "(A.7)", "eq:A.7", "a.7", "A7", "a7"}) CHECK(ledger::asked_equation(text) == "A.7");
    for (const std::string text : {"54", "54a", "(54a)", "(54)b", "eq:54b"}) CHECK(ledger::asked_equation(text) == "54");
    for (const std::string text :
         {"", "0", "89", "A.0", "A.16", "A", "046", "46 ", "-1", "46a", "(46", "46)", "(4)6", "()", "A17", "4 6", "eq:", "1e1"}) {
        INFO("'" << text << "'");
        CHECK_THROWS_AS(ledger::asked_equation(text), InputError);
    }
}

TEST_CASE("the message on an unknown equation names the range and what was asked", "[ledger]") {
    CHECK_THROWS_WITH(ledger::asked_equation("99"), "the equation must be one of 1 to 88 or A.1 to A.15, but is '99'");
}

TEST_CASE("the ledger is looked for where the caller says, then the environment, then the build", "[ledger]") {
    const tests::Folder folder;
    const std::string option = folder.write("option.json", Json::array({one_entry("1")}).dump());
    const std::string environment = folder.write("environment.json", Json::array({one_entry("2")}).dump());
    const std::string built = folder.write("built.json", Json::array({one_entry("3")}).dump());
    const std::string none = (folder.path() / "none.json").string();
    CHECK(ledger::read_ledger({option, environment, built, none}).entries[0].at("equation") == "1");
    CHECK(ledger::read_ledger({"", environment, built, none}).entries[0].at("equation") == "2");
    CHECK(ledger::read_ledger({"", "", built, none}).entries[0].at("equation") == "3");
    CHECK(ledger::read_ledger({"", "", built, none}).from_a_run);
    CHECK_THROWS_AS(ledger::read_ledger({none, environment, built, none}), InputError);
    CHECK_THROWS_AS(ledger::read_ledger({"", none, built, none}), InputError);
    CHECK_THROWS_AS(ledger::read_ledger({"", "", none, none}), InputError);
}

TEST_CASE("without a run the rows are shown with every verdict unknown", "[ledger]") {
    const ledger::Ledger found =
        ledger::read_ledger({"", "", "/no/such/ledger.json", (tests::project() / "docs/ledger/equations.json").string()});
    CHECK_FALSE(found.from_a_run);
    REQUIRE(found.entries.size() == 103);
    for (const Json& entry : found.entries) {
        CHECK(entry.at("printed") == "unknown");
        CHECK(entry.at("shipped") == "unknown");
    }
    CHECK(ledger::entries_of(found.entries, "A.15")[0].at("used_by") == Json({"40"}));
}

TEST_CASE("a ledger that is none is bad input", "[ledger]") {
    const tests::Folder folder;
    Json broken = one_entry("1");
    broken.erase("printed");
    Json wrong = one_entry("1");
    wrong["tests"] = 3;
    for (const std::string& text : {std::string("["), std::string("{}"), std::string("[1]"), std::string(""), std::string("[{}]"),
                                    Json::array({broken}).dump(), Json::array({wrong}).dump()}) {
        INFO(text);
        CHECK_THROWS_AS(ledger::read_ledger({folder.write("ledger.json", text), "", "", ""}), InputError);
    }
    CHECK_THROWS_AS(ledger::read_ledger({folder.path().string(), "", "", ""}), InputError);
    CHECK_THROWS_AS(ledger::read_ledger({"", "", "", folder.write("rows.json", "[{\"equation\": \"1\"}]")}), InputError);
}

TEST_CASE("the table has a line an equation, in columns, and the counts", "[ledger]") {
    Json entries = Json::array();
    for (const Json& row : tests::project_rows()) entries.push_back(ledger::entry_without_run(row));
    entries[45]["printed"] = "refuted";
    entries[45]["functions"] = {{{"name", "denhartog::paper::steady_displacement"}, {"file", "f.hpp"}, {"line", 7}},
                                {{"name", "denhartog::paper::other"}, {"file", "f.hpp"}, {"line", 9}}};
    const std::string text = ledger::table(entries);
    CHECK(std::count(text.begin(), text.end(), '\n') == 1 + 103 + 5);
    CHECK(holds(text, "\n(46)      2.4       result         refuted     unknown     none       paper::steady_displacement +1\n"));
    CHECK(holds(text, "103 equations\nas printed: 102 unknown, 1 refuted\nas shipped: 103 unknown\n"));
}

TEST_CASE("the card of an equation has all that the ledger knows of it", "[ledger]") {
    Json entry = one_entry("46");
    const std::string before = ledger::card(entry);
    CHECK(holds(before, "(46)  Section 2.4, result\n"));
    CHECK(holds(before, "  statement   x=1\n"));
    CHECK_FALSE(holds(before, "correction"));
    CHECK_FALSE(holds(before, "loss"));
    entry["printed"] = "refuted";
    entry["departure"] = "misprint";
    entry["correction"] = "x=2";
    entry["shipped"] = "proved";
    entry["witness"] = {{"R", "0.5"}};
    entry["loss"] = 0.25;
    entry["used_by"] = {"47"};
    entry["functions"] = {{{"name", "denhartog::paper::f"}, {"file", "src/f.hpp"}, {"line", 7}}};
    entry["claims"] = {{{"id", "46/printed"}, {"verdict", "refuted"}, {"what", "as printed"}}};
    entry["tests"] = {"a test"};
    entry["figures"] = {"fig04_time_response"};
    const std::string text = ledger::card(entry);
    for (const std::string part :
         {"  as printed  refuted, departure: misprint\n", "  correction  x=2\n", "  as shipped  proved\n",
          "  witness     {\"R\":\"0.5\"}\n", "  loss        worst relative error 0.25 for who codes the printed form\n",
          "  rests on    (41), (44)\n", "  used by     (47)\n", "  function    denhartog::paper::f  src/f.hpp:7\n",
          "  claim       46/printed  refuted  as printed\n", "  test        a test\n", "  figure      fig04_time_response\n"}) {
        INFO(part);
        CHECK(holds(text, part));
    }
}

TEST_CASE("what the run joins is what the program reads back", "[ledger]") {
    derivation::LedgerParts parts;
    parts.rows = tests::project_rows();
    const derivation::JoinedLedger joined = derivation::join_ledger(parts);
    const tests::Folder folder;
    const ledger::Ledger found = ledger::read_ledger({folder.write("ledger.json", joined.entries.dump(2)), "", "", ""});
    CHECK(found.entries == joined.entries);
    for (const Json& entry : found.entries) CHECK_FALSE(ledger::card(entry).empty());
}

TEST_CASE("the derivation is shown as text and as LaTeX", "[ledger]") {
    const tests::Folder folder;
    const std::string file = folder.write("derivation.json", R"json([
        {"claim": "A.7/velocity", "equation": "A.7", "equations": ["A.7", "A.9"], "title": "rate of (A.6) at 100 %",
         "assumptions": ["R > 0"], "verdict": "proved",
         "steps": [{"text": "differentiate d_i", "latex": "d_i'=-q_i/R_i"}, {"text": "compare", "latex": ""}]},
        {"claim": "46/sum", "equation": "46", "title": "the sum", "assumptions": [], "verdict": "refuted", "steps": []}])json");
    const Json record = ledger::read_derivation(file, "", "");
    const Json claims = ledger::entries_of(record, "A.7");
    REQUIRE(claims.size() == 1);
    CHECK(ledger::entries_of(record, "A.9") == claims);
    CHECK(ledger::derivation_as_text(claims, "A.7") ==
          "(A.7)  rate of (A.6) at 100 %\n    claim A.7/velocity: proved\n    where R > 0\n"
          "  1. differentiate d_i\n       d_i'=-q_i/R_i\n  2. compare\n");
    CHECK(ledger::derivation_as_latex(claims) ==
          "\\paragraph{Eq.~(A.7): rate of (A.6) at 100 \\%} proved.\nWhere R > 0.\n\\begin{enumerate}\n"
          "\\item differentiate d\\_i\n\\[ d_i'=-q_i/R_i \\]\n\\item compare\n\\end{enumerate}\n");
    CHECK(ledger::derivation_as_text(ledger::entries_of(record, "1"), "1") == "The derivation has no step on equation (1).\n");
    CHECK(ledger::entries_of(record, "").size() == 2);
}

TEST_CASE("a step's formulas in its text, and a witness, are shown", "[ledger]") {
    const tests::Folder folder;
    const std::string file = folder.write("derivation.json", R"json([
        {"claim": "A.7/printed", "equation": "A.7", "equations": ["A.7"], "title": "as printed", "assumptions": [], "verdict": "refuted",
         "steps": [{"text": "the rate of d_i, 50 %", "text_latex": "the rate of $d_i$, 50 %", "latex": "d_i'"}],
         "witness": [{"name": "V_ki", "name_latex": "V_{ki}", "value": "-3/37"}, {"name": "under_test", "name_latex": "", "value": "0.5"}]}])json");
    const Json claims = ledger::read_derivation(file, "", "");
    CHECK(ledger::derivation_as_text(claims, "A.7") ==
          "(A.7)  as printed\n    claim A.7/printed: refuted\n  1. the rate of d_i, 50 %\n       d_i'\n"
          "    witness: V_ki = -3/37\n    witness: under_test = 0.5\n");
    CHECK(ledger::derivation_as_latex(claims) ==
          "\\paragraph{Eq.~(A.7): as printed} refuted.\n\\begin{enumerate}\n\\item the rate of $d_i$, 50 \\%\n\\[ d_i' \\]\n"
          "\\end{enumerate}\nWitness: $V_{ki}$ = -3/37, under\\_test = 0.5.\n");
    CHECK_THROWS_AS(ledger::read_derivation(folder.write("w.json", R"([{"claim": "x", "equation": "1", "title": "", "verdict": "",
        "assumptions": [], "steps": [], "witness": [{"name": "x"}]}])"),
                                            "", ""),
                    InputError);
}

TEST_CASE("a derivation that has not run, or is none, is told", "[ledger]") {
    const tests::Folder folder;
    CHECK_THROWS_WITH(ledger::read_derivation("", "", "/no/such/derivation.json"), Catch::Contains("./verify paper"));
    CHECK_THROWS_AS(ledger::read_derivation("/no/such/derivation.json", "", ""), InputError);
    CHECK_THROWS_AS(ledger::read_derivation(folder.write("d.json", "[{\"claim\": \"x\"}]"), "", ""), InputError);
    CHECK_THROWS_AS(ledger::read_derivation(folder.write("e.json", R"([{"claim": "x", "equation": "1", "title": "", "verdict": "",
        "assumptions": [], "steps": [{"text": "x"}]}])"),
                                            "", ""),
                    InputError);
}

#include <algorithm>
#include <fstream>

#include "denhartog/ledger/ledger.hpp"
#include "denhartog/number/errors.hpp"
#include "derivation/claims/threshold.hpp"
#include "derivation/ledger/ledger_audit.hpp"
#include "derivation/ledger/ledger_figures.hpp"
#include "derivation/ledger/ledger_join.hpp"
#include "derivation/ledger/ledger_kernel.hpp"
#include "derivation/ledger/ledger_scenes.hpp"
#include "tests/catch.hpp"
#include "tests/support/largest_over_range.hpp"
#include "tests/unit/ledger_fixtures.hpp"

using namespace denhartog::derivation;
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

using nlohmann::json;

namespace {

json record(const std::string& name, const std::vector<std::string>& equations) {
    return {{"name", name},
            {"title", "Amplitude over r"},
            {"equations", equations},
            {"given", {"mu = 1"}},
            {"chosen", json::array()},
            {"agreements", {{{"what", "amplitude"}, {"points", 12}, {"median", 1e-7}, {"worst", 0.25}, {"where", "r = 1"}}}},
            {"statements",
             {{{"text", "falls"}, {"found", "rises by 3"}, {"borne_out", false}},
              {{"text", "a"}, {"found", "b"}, {"borne_out", true}}}},
            {"remarks", json::array()}};
}

json ledger_with_figures() {
    return {{{"equation", "38"}, {"figures", json::array()}}, {{"equation", "A.7"}, {"figures", json::array()}}};
}

} // namespace

TEST_CASE("the ledger names the figures that show an equation", "[ledger][figures]") {
    json entries = ledger_with_figures();
    CHECK(add_figures(entries, {record("fig06_curves", {"38"}), record("printed", {"38", "A.7"})}).empty());
    CHECK(entries[0]["figures"] == json({"fig06_curves", "printed"}));
    CHECK(entries[1]["figures"] == json({"printed"}));
}

TEST_CASE("a figure that names an equation which is not in the paper is a fault", "[ledger][figures]") {
    json entries = ledger_with_figures();
    const std::vector<std::string> faults = add_figures(entries, {record("fig06_curves", {"38", "99"})});
    REQUIRE(faults.size() == 1);
    CHECK(faults[0] == "the figure fig06_curves shows (99), which the paper does not have");
}

TEST_CASE("figures of the paper come before the others, and a broken record is named", "[ledger][figures]") {
    const tests::Folder folder;
    CHECK(figure_records(folder.path() / "none").empty());
    folder.write("a.json", record("a", {"38"}).dump());
    folder.write("fig02.json", record("fig02", {"3"}).dump());
    folder.write("fig02.dat", "no record");
    const std::vector<json> records = figure_records(folder.path());
    REQUIRE(records.size() == 2);
    CHECK(records[0]["name"] == "fig02");
    folder.write("b.json", "{");
    CHECK_THROWS_WITH(figure_records(folder.path()), Catch::Contains("b.json"));
}

TEST_CASE("a statement that is not borne out is shown as such, and a bar within a text ends no cell", "[ledger][figures]") {
    json failed = record("fig06_curves", {"38"}), measured = failed, with_bars = failed;
    measured["statements"][0]["measure"] = "to 1 percent"; // a number of ours decides
    measured["statements"][1]["measure"] = "to 5 percent";
    with_bars["statements"][0]["text"] = "|v| falls";
    for (const auto& [of, row] : {std::pair{failed, "| falls | rises by 3 | no |"},
                                  {measured, "| falls | rises by 3 | not to 1 percent |"},
                                  {measured, "| a | b | yes |"},
                                  {with_bars, "| \\|v\\| falls | rises by 3 | no |"},
                                  {record("limits", {"38"}), "| statement | the data say | holds |"}})
        CHECK_THAT(figures_markdown({of}), Catch::Contains(row));
    CHECK_THAT(figures_table({failed}), Catch::Contains("| fig06_curves |") && Catch::Contains("| 1e-07 | 0.25 | 1 of 2 |"));
    CHECK_THAT(figures_table({measured}), Catch::Contains("| 1 of 2, 1 beyond the threshold that was chosen |"));
}

namespace {

/// Two equations: two claims on the first, one of them refuted and with the equation at its end; none on the second.
json two_entries() {
    return json::parse(R"([
        {"equation": "28", "kind": "result", "claims": [{"id": "28/formula"}, {"id": "28/printed/28"}], "no_function": ""},
        {"equation": "6", "kind": "definition", "claims": [], "no_function": ""}])");
}

const char* const exported = R"({"certificates": [
    {"claim": "28/formula", "status": "exported", "reason": "", "lemmas": [{}, {}], "file": "certificates/equation_28.v"},
    {"claim": "28/printed", "status": "not_exported", "reason": "refuted: the two sides are not equal", "lemmas": []}]})";

json joined(const tests::Folder& folder, const std::string& statements = "") {
    json entries = two_entries();
    (void)derivation::add_kernel(entries, derivation::read_kernel_record(folder.path(), statements));
    return entries;
}

} // namespace

TEST_CASE("where the kernel was not run the ledger says so, and nothing else", "[ledger][kernel]") {
    const tests::Folder folder;
    for (const bool with_certificates : {false, true}) {
        if (with_certificates) folder.write("certificates.json", exported);
        const json entries = joined(folder);
        CHECK(entries[0].at("kernel").at("status") == "not_run");
        CHECK(entries[0].at("claims")[0].at("kernel") == json{{"status", "not_run"}});
        CHECK(entries[1].at("kernel").at("status") == "not_run");
        CHECK(derivation::kernel_sentence(entries) == "The kernel was not run.");
    }
}

TEST_CASE("a claim is checked where the kernel accepted its lemmas, and not exported with the reason", "[ledger][kernel]") {
    const tests::Folder folder;
    folder.write("certificates.json", exported);
    folder.write("kernel.json", R"({"claims": {"28/formula": {"status": "checked", "message": "",
                                    "why_not_in_functions": "1 of 2: the angle of a point"}}})");
    const json entries = joined(folder);
    const json& claims = entries[0].at("claims");
    CHECK(claims[0].at("kernel").at("why_not_in_functions") == "1 of 2: the angle of a point");
    CHECK(claims[0].at("kernel").at("status") == "checked");
    CHECK(claims[0].at("kernel").at("lemmas") == 2);
    CHECK(claims[1].at("kernel").at("status") == "not_exported");
    CHECK(claims[1].at("kernel").at("reason") == "refuted: the two sides are not equal");
    CHECK(entries[0].at("kernel").at("status") == "checked");
    CHECK(entries[0].at("kernel").at("certificates") == 1);
    CHECK(entries[1].at("kernel").at("status") == "not_exported");
    CHECK(entries[1].at("kernel").at("reason") == "definition: there is nothing to prove");
    CHECK(derivation::kernel_sentence(entries) ==
          "The kernel has checked the certificates of 1 of 2 claims; 1 are not exported. Of "
          "2 equations 1 have a certificate or a theorem that it has checked.");
}

TEST_CASE("a lemma that the kernel refuses makes its claim and its equation red", "[ledger][kernel]") {
    const tests::Folder folder;
    folder.write("certificates.json", exported);
    folder.write("kernel.json", R"({"claims": {"28/formula": {"status": "failed", "message": "not a valid ring equation"}}})");
    json entries = two_entries();
    const auto faults = derivation::add_kernel(entries, derivation::read_kernel_record(folder.path(), ""));
    CHECK(tests::tells(faults, "the kernel refuses the certificate of claim 28/formula"));
    CHECK(entries[0].at("kernel").at("status") == "failed");
    CHECK(ledger::kernel_words(entries[0].at("claims")[0].at("kernel")) == "failed: not a valid ring equation");
}

TEST_CASE("a claim that was exported and that the kernel has not seen is not checked", "[ledger][kernel]") {
    const tests::Folder folder;
    folder.write("certificates.json", exported);
    folder.write("kernel.json", R"({"claims": {}})");
    CHECK(joined(folder)[0].at("claims")[0].at("kernel").at("status") == "not_run");
}

// Scenes that show a refuted equation, and the audit of what remains assumed.

namespace {

json small_entry(const std::string& equation, const std::string& kind, const std::string& printed) {
    return {{"equation", equation}, {"kind", kind},        {"printed", printed},        {"shipped", "proved"},
            {"correction", ""},     {"correction_by", ""}, {"rests_on", json::array()}, {"claims", json::array()}};
}

json scene_with_loss(double loss) {
    return {{"where", "a single mass"},
            {"scene", "{\"r\":0.9}"},
            {"regime", "stick_slip"},
            {"quantity", "amplitude"},
            {"printed", 1.5},
            {"holds", 1.0},
            {"loss", loss}};
}

json audit_claim(const std::string& id, const std::string& role, const std::string& kind, const std::string& verdict,
                 const std::vector<std::string>& assumptions) {
    return {{"id", id}, {"role", role}, {"kind", kind}, {"verdict", verdict}, {"assumptions", assumptions}};
}

} // namespace

TEST_CASE("each refuted equation gets its scene, and a missing or invisible one is a fault", "[ledger]") {
    json entries = {small_entry("38", "result", "proved"), small_entry("46", "result", "refuted"),
                    small_entry("2", "assumption", "illegible")};
    const json scenes = {{"46", scene_with_loss(0.5)}, {"2", {{"none", "a slip"}}}};
    CHECK(add_scenes(entries, scenes).empty());
    CHECK(entries[0].at("scene").empty());
    CHECK(entries[1].at("scene").at("loss") == 0.5);
    CHECK(add_scenes(entries, {{"2", {{"none", "a slip"}}}}).size() == 1);
    CHECK(add_scenes(entries, {{"46", scene_with_loss(0.001)}, {"2", {{"none", "a slip"}}}}).size() == 1);
    CHECK(add_scenes(entries, {{"46", scene_with_loss(0.5)}, {"2", {{"none", "a slip"}}}, {"38", scene_with_loss(0.5)}}).size() ==
          1);
}

TEST_CASE("a scene in a sentence has both values, the loss and what to type", "[ledger]") {
    const std::string text = scene_markdown(scene_with_loss(0.5));
    for (const char* part :
         {"a single mass", "stick slip motion", "1.5 as printed", "1 as it is", "a loss of 0.5", "`{\"r\":0.9}`"})
        CHECK(text.find(part) != std::string::npos);
    CHECK(scene_markdown({{"none", "a slip"}}) == "No scene shows it: a slip");
}

TEST_CASE("the audit says by which claims an equation is decided and what remains assumed", "[ledger]") {
    json assumed = small_entry("4", "assumption", "assumption"), middle = small_entry("12", "result", "proved"),
         result = small_entry("46", "result", "refuted");
    middle["rests_on"] = {"4"};
    result["rests_on"] = {"12"};
    result["correction"] = "x=y";
    result["correction_by"] = "hand";
    result["claims"] = {audit_claim("46/printed", "printed", "derived", "refuted", {"R_i > 0"}),
                        audit_claim("46/motion/N=1", "shipped", "derived", "proved", {"R_i > 0", "N = 1"}),
                        audit_claim("46/motion/N=2", "shipped", "derived", "proved", {"R_i > 0", "N = 2 modes"}),
                        audit_claim("46/look", "observation", "observation", "measured", {"everywhere"}),
                        audit_claim("46/thought", "step", "argument", "argued", {})};
    std::vector<AuditRow> rows = audit_of({assumed, middle, result});
    REQUIRE(rows.size() == 3);
    CHECK(rows[0].premises == std::vector<std::string>{"4"});
    CHECK(rows[2].kinds == "3 derived");
    CHECK(rows[2].premises == std::vector<std::string>{"4"});
    CHECK(rows[2].domains == std::vector<std::string>{"R_i > 0"});
    CHECK(rows[2].masses == "N = 1, 2 only");
    CHECK(rows[2].argued == std::vector<std::string>{"46/thought"});
    CHECK(rows[2].typed);
    CHECK(audit_summary(rows).find("(4)") != std::string::npos);
    CHECK(audit_markdown(rows).find("| (46) | 3 derived | refuted | proved |") != std::string::npos);
    CHECK(rows[0].kinds == "none: assumption");
    result["claims"].push_back(audit_claim("46/one-more-mode", "step", "derived", "proved", {"any number of modes before"}));
    rows = audit_of({assumed, middle, result});
    CHECK(rows[2].masses == "every number of masses, by the step of the sum (whole for N = 1, 2)");
    CHECK(remaining(rows[2]).find("premises (4)") == 0);
}

TEST_CASE("a threshold decides where another number turns the verdict and is not empty", "[ledger][thresholds]") {
    CHECK(decides({"relative error", 0.01, 0.3, 1}));
    CHECK_FALSE(decides({"ratio", 0.1, 5, 1}));
    CHECK(decides({"degrees between phases", 15, 4, 0}));
    CHECK_FALSE(decides({"fall", 0.01, -0.2, 0}));
    CHECK(decides({"distance", 0.2, 5}));
    CHECK(refuted_whatever_the_threshold({}));
    CHECK_FALSE(refuted_whatever_the_threshold({{"ratio", 0.1, 5, 1}, {"relative error", 0.01, 0.3, 1}}));
}

TEST_CASE("thresholds go through JSON and back", "[ledger][thresholds]") {
    const std::vector<Threshold> list{{"relative error", 0.01, 0.3, 1}, {"distance", 0.2, 5}};
    const std::vector<Threshold> back = thresholds_from_json(thresholds_to_json(list));
    REQUIRE(back.size() == 2);
    CHECK(sentence(back[0]) == "relative error: 0.01 taken, turns at 0.3");
    CHECK(back[0].empty == 1.0);
    CHECK_FALSE(back[1].empty.has_value());
}

TEST_CASE("the largest value over a range is found between the points of the grid", "[ledger]") {
    const auto peak = [](double x) { return 1 / (1e-4 + (x - 0.2295) * (x - 0.2295)) + std::sin(9 * x); };
    const LargestOverRange found = largest_over_range(peak, 0, 3, 100);
    CHECK(found.x == Approx(0.2295).margin(1e-5));
    CHECK(found.value == Approx(peak(0.2295)).epsilon(1e-8));
    const auto with_a_hole = [&](double x) { return x > 1 ? std::nan("") : x; };
    CHECK(largest_over_range(with_a_hole, 0, 3, 90).value == Approx(1).margin(1e-6));
}

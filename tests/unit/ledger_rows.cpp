#include <map>
#include <set>
#include <sstream>
#include <vector>

#include "denhartog/number/errors.hpp"
#include "derivation/ledger/ledger_rows.hpp"
#include "derivation/ledger/ledger_statements.hpp"
#include "derivation/ledger/source_index.hpp"
#include "derivation/ledger/source_text.hpp"
#include "derivation/ledger/test_index.hpp"
#include "tests/unit/ledger_fixtures.hpp"

using namespace denhartog;

using derivation::faults_of_rows;
using derivation::latex_fault;
using ledger::Json;
using tests::tells;

TEST_CASE("every numbered equation of the paper has a row, in the paper's order", "[ledger]") {
    const Json rows = tests::project_rows();
    const std::vector<std::string> faults = faults_of_rows(rows);
    for (const std::string& fault : faults) UNSCOPED_INFO(fault);
    CHECK(faults.empty());
    REQUIRE(rows.size() == 103);
    CHECK(rows[0].at("equation") == "1");
    CHECK(rows[87].at("equation") == "88");
    CHECK(rows[88].at("equation") == "A.1");
    CHECK(rows[102].at("equation") == "A.15");
}

TEST_CASE("what the paper prints wrong stands in the rows as printed", "[ledger]") {
    const Json rows = tests::project_rows();
    const std::map<std::size_t, std::string> printed = {
        {40, R"(\left[\sin\left(\frac{\tau\sqrt{1-\zeta_i^2}}{R_i}\right)+\frac{\zeta_i}{\sqrt{1-\zeta_i^2}}\cos)"},
        {41, R"(\left[\sin\left(\frac{\tau\sqrt{1-\zeta_i^2}}{R_i}\right)+\frac{\zeta_i}{\sqrt{1-\zeta_i^2}}\cos)"},
        {46, R"(\left[\sin\left(\frac{\tau\sqrt{1-\zeta_i^2}}{R_i}\right)+\frac{\zeta_i}{\sqrt{1-\zeta_i^2}}\cos)"},
        {50, R"(\overline{X}_{k_C}=\left[\frac{|V_{dk}|}{|V_{dj}|}\sqrt)"},
        {52, R"(\left(G_k\cos(\angle V_{dk}-\angle V_{dj})+U_{dk}\sin)"},
        {57, R"(e^{-\frac{\zeta_i\tau}{R_i}}\left[\sin)"},
        {70, R"(\left[1-\left(1-\frac{\zeta_i\tau}{R_i}\right)^2\right])"},
        {95, R"(\eta_i'=-d_i'\eta_{i0}+)"}, // (A.7)
        {103, R"(\left[\sin\left(\frac{\tau\sqrt{1-\zeta_i^2}}{R_i}\right)+\frac{\zeta_i}{\sqrt{1-\zeta_i^2}}\cos)"}};
    for (const auto& [row, part] : printed) {
        INFO("row " << row);
        CHECK(rows[row - 1].at("statement").get<std::string>().find(part) != std::string::npos);
    }
}

TEST_CASE("an equation of Section 2 or the Appendix has a formula or a reason why not, and never both", "[ledger]") {
    std::set<std::string> with_formula;
    for (const derivation::FunctionEntry& function : derivation::functions_of_sources(tests::project() / "src"))
        if (derivation::is_formula(function)) with_formula.insert(function.equation);
    int judged = 0;
    for (const Json& row : tests::project_rows()) {
        const std::string section = row.at("section");
        if (section.starts_with('3') || section.starts_with('4')) continue;
        INFO("equation " << row.at("equation"));
        CHECK(with_formula.contains(row.at("equation").get<std::string>()) != row.contains("no_function"));
        ++judged;
    }
    CHECK(judged == 72 + 15);
}

TEST_CASE("a row that breaks a rule is told by name", "[ledger]") {
    const Json good = tests::project_rows();
    Json rows = good;
    const auto expect = [&rows](const std::string& told) {
        const std::vector<std::string> faults = faults_of_rows(rows);
        for (const std::string& fault : faults) UNSCOPED_INFO(fault);
        CHECK(tells(faults, told));
    };
    SECTION("a row is missing") { rows.erase(45), expect("row 46 must be equation 46, but is 47"); }
    SECTION("the last row is missing") { rows.erase(102), expect("equation A.15 has no row"); }
    SECTION("a row is there twice") { rows.push_back(good[102]), expect("row 104 must be equation none"); }
    SECTION("two rows are exchanged") { std::swap(rows[3], rows[4]), expect("row 4 must be equation 4, but is 5"); }
    SECTION("an unknown kind") { rows[45]["kind"] = "theorem", expect("equation 46: unknown kind"); }
    SECTION("an unknown section") { rows[45]["section"] = "2.9", expect("equation 46: unknown section"); }
    SECTION("an unknown key") { rows[45]["verdict"] = "proved", expect("unknown key verdict"); }
    SECTION("a missing key") { rows[45].erase("statement"), expect("has no statement"); }
    SECTION("a text that is empty") { rows[45]["statement"] = "", expect("statement must be a text that is not empty"); }
    SECTION("a number for a text") { rows[45]["kind"] = 3, expect("kind must be a text"); }
    SECTION("grounds that are no array") { rows[45]["rests_on"] = "41", expect("rests_on must be an array"); }
    SECTION("a row that is no object") { rows[45] = 46, expect("row 46 must be an object"); }
    SECTION("a ground that is not there") { rows[45]["rests_on"] = {"89"}, expect("46 rests on 89, which has no row"); }
    SECTION("a ground twice") { rows[45]["rests_on"] = {"41", "41"}, expect("46 rests on 41 twice"); }
    SECTION("a later result") { rows[45]["rests_on"] = {"58"}, expect("46 rests on 58, which comes later"); }
    SECTION("itself") { rows[45]["rests_on"] = {"46"}, expect("46 rests on itself"); }
    SECTION("a circle through the Appendix") { rows[88]["rests_on"] = {"40"}, expect("rests on itself by way of"); }
    SECTION("a brace too few") { rows[45]["statement"] = "\\frac{1}{2", expect("46: statement: has a { too many"); }
    SECTION("a reading without a note") { rows[45]["read_as"] = "x", expect("printed_note and read_as belong together"); }
    SECTION("a reading that changes nothing") { rows[1]["read_as"] = rows[1]["statement"], expect("2: read_as says the same"); }
}

TEST_CASE("rows that are no array are told", "[ledger]") { CHECK(tells(faults_of_rows(Json::object()), "must be an array")); }

TEST_CASE("LaTeX that cannot be set is told", "[ledger]") {
    CHECK(latex_fault(R"(\left\{\frac{a}{b}\right\}\begin{cases}a\\b\end{cases})").empty());
    CHECK(latex_fault(R"(\leftarrow a\}\{)").empty());
    CHECK(latex_fault("a}") == "has a } too many");
    CHECK(latex_fault("{a") == "has a { too many");
    CHECK(latex_fault(R"(\left(a)") == R"(has a \left without its \right)");
    CHECK(latex_fault(R"(a\right)\left()") == R"(has a \right without its \left)");
    CHECK(latex_fault(R"(\begin{cases}a)") == R"(has \begin{cases} without its end)");
    CHECK(latex_fault(R"(\begin{cases}{a\end{cases}})") == R"(has \end{cases} without its beginning)");
    CHECK(latex_fault(R"(\begin)") == R"(has a \begin without a name)");
    CHECK(latex_fault("$a$") == "has a $");
}

TEST_CASE("rows that cannot be read are bad input", "[ledger]") {
    const tests::Folder folder;
    CHECK_THROWS_AS(derivation::read_rows(folder.path() / "none.json"), InputError);
    CHECK_THROWS_AS(derivation::read_rows(folder.write("half.json", "[{\"equation\": \"1\"")), InputError);
}

using derivation::ClaimResult;
using derivation::join_statements;
using derivation::Statements;
using derivation::Threshold;

namespace {

ClaimResult claim(const std::string& id, const std::string& verdict, std::vector<Threshold> thresholds = {}) {
    ClaimResult made;
    made.id = id;
    made.verdict = verdict;
    made.thresholds = std::move(thresholds);
    return made;
}

Json row(const std::string& statement, const std::vector<std::string>& claims) {
    return {{"section", "4.1"}, {"statement", statement}, {"claims", claims}};
}

const Json equations = {{{"equation", "34"}, {"statement", "U_{dk}=\\sum u_{di}"}},
                        {{"equation", "35"}, {"statement", "G_k=\\sum g_i"}}};

} // namespace

TEST_CASE("a statement has the worst verdict of its claims, and those of every N count", "[ledger][statements]") {
    const std::vector<ClaimResult> claims{claim("a/text", "measured"), claim("19/matrix/N=1", "proved"),
                                          claim("19/matrix/N=2", "refuted"), claim("19/matrix/N=3", "proved")};
    const Statements all =
        join_statements({row("first", {"a/text"}), row("second", {"a/text", "19/matrix"})}, claims, equations, {});
    CHECK(all.faults.empty());
    CHECK(all.rows[0].at("verdict") == "measured");
    CHECK(all.rows[1].at("verdict") == "refuted");
    CHECK(all.counts.at("refuted") == 1);
}

TEST_CASE("a refutation that another number would turn is one at a threshold of ours", "[ledger][statements]") {
    const Threshold turns{"relative error", 0.01, 0.3, 1}, never{"ratio", 0.1, 5, 1};
    const Statements all =
        join_statements({row("may turn", {"a/text"}), row("cannot", {"b/text"})},
                        {claim("a/text", "refuted", {turns}), claim("b/text", "refuted", {never})}, equations, {});
    CHECK(all.rows[0].at("verdict") == "refuted at a threshold of ours");
    CHECK(all.rows[1].at("verdict") == "refuted");
}

TEST_CASE("a claim that is not there, an observation in no row and a statement without a claim are faults",
          "[ledger][statements]") {
    const Statements all = join_statements({row("first", {"nowhere"}), {{"section", "2.1"}, {"statement", "second"}}},
                                           {claim("a/text", "proved")}, equations, {});
    CHECK(tells(all.faults, "nowhere"));
    CHECK(tells(all.faults, "a/text"));
    CHECK(tells(all.faults, "'second' is decided by nothing"));
}

TEST_CASE("a reference to the wrong equation is found by the symbol that it lacks", "[ledger][statements]") {
    const auto reference = [](const std::string& cited, const std::string& meant) {
        return Json{{"section", "4.1"},
                    {"statement", "U_dk is the sum of (" + cited + ")"},
                    {"reference", {{"symbol", "U_{dk}"}, {"cited", {cited}}, {"meant", {meant}}}}};
    };
    const Statements all = join_statements({reference("35", "34"), reference("34", "34")}, {}, equations, {});
    CHECK(all.rows[0].at("verdict") == "slip of reference");
    CHECK(all.rows[0].at("remark") == "(34) is meant");
    CHECK(tells(all.faults, "'U_dk is the sum of (34)' is said to be a slip"));
}

TEST_CASE("a reference to the wrong figure is found where the figures' records are there", "[ledger][statements]") {
    const Json of_figures = {
        {"section", "4.1"},
        {"statement", "peaks in Figs. 6 and 7"},
        {"reference", {{"figures", {"fig06", "fig07"}}, {"meant_figures", {"fig06", "fig08"}}, {"any_of", {"38", "52"}}}}};
    const std::vector<nlohmann::json> records{{{"name", "fig06_a"}, {"equations", {"38"}}},
                                              {{"name", "fig07_b"}, {"equations", {"69"}}},
                                              {{"name", "fig08_c"}, {"equations", {"52", "53"}}}};
    CHECK(join_statements(Json::array({of_figures}), {}, equations, records).rows[0].at("verdict") == "slip of reference");
    CHECK(join_statements(Json::array({of_figures}), {}, equations, {}).rows[0].at("verdict") == "not decided");
}

TEST_CASE("every row of the project's statements has a section and a statement of its own", "[ledger][statements]") {
    std::ifstream in(tests::project() / "docs/ledger/statements.json");
    const Json rows = Json::parse(in);
    CHECK(rows.size() > 100);
    std::vector<std::string> seen;
    for (const Json& each : rows) {
        INFO(each.dump());
        CHECK_FALSE(each.at("section").get<std::string>().empty());
        const std::string key = each.at("section").get<std::string>() + " " + each.at("statement").get<std::string>();
        CHECK(std::find(seen.begin(), seen.end(), key) == seen.end());
        seen.push_back(key);
        CHECK((each.contains("claims") || each.contains("left") || each.contains("reference") || each.contains("assumed")));
    }
}

using derivation::FunctionEntry;
using derivation::functions_of_header;
using derivation::functions_of_sources;

TEST_CASE("a tag in a doc comment gives the function behind it, with namespace and line", "[ledger]") {
    const std::string header = R"cpp(/// @file
/// @brief (28), (29) of something.
#pragma once
#include <vector>
namespace outer {
/// @eq{24}
template <class T>
struct Start { // } a brace in a comment
    T eta_0; ///< not a tag: @eq{99}
    /// @eq{25}
    [[nodiscard]] T end(const T& tau) const { return tau < eta_0 ? tau : eta_0; }
};
namespace paper {

/// @brief A formula. @eq{28,
/// A.8}
/// @param R  a ratio
template <class T, class U = std::vector<T>>
[[nodiscard("a ( in an attribute")]] constexpr const T&
    first_damping_function(const T& R) { return f("}", '{', R"(})"); }

/// no tag here
template <class T>
T plain(const T& x);

/* @eq{1} in a comment that documents nothing */
/** @eq{54a} */
double margin(double x = {}) noexcept;
} // namespace paper
/// @eq{23}
int after();
} // namespace outer
namespace denhartog::as_printed {
/// @eq{46}
double steady(double tau);
}
)cpp";
    const std::vector<FunctionEntry> found = functions_of_header(header, "x.hpp");
    const std::vector<FunctionEntry> expected = {{"24", "outer::Start", "x.hpp", 8},
                                                 {"25", "outer::Start::end", "x.hpp", 11},
                                                 {"28", "outer::paper::first_damping_function", "x.hpp", 20},
                                                 {"A.8", "outer::paper::first_damping_function", "x.hpp", 20},
                                                 {"54", "outer::paper::margin", "x.hpp", 28},
                                                 {"23", "outer::after", "x.hpp", 31},
                                                 {"46", "denhartog::as_printed::steady", "x.hpp", 35}};
    for (const FunctionEntry& entry : found) UNSCOPED_INFO(entry.equation << " " << entry.name << ":" << entry.line);
    CHECK((found == expected));
    CHECK(derivation::is_as_printed(found.back()));
    CHECK_FALSE(derivation::is_formula(found.back()));
    CHECK_FALSE(derivation::is_as_printed(found[2]));
    CHECK(derivation::is_formula(found[2]));
    CHECK_FALSE(derivation::is_formula(found[0]));
}

TEST_CASE("a tag that belongs to nothing, or names nothing, is told", "[ledger]") {
    CHECK_THROWS_AS(functions_of_header("/// @eq{28}\nint;\n", "x.hpp"), InputError);
    CHECK_THROWS_AS(functions_of_header("/// @eq{28}\n", "x.hpp"), InputError);
    CHECK_THROWS_AS(functions_of_header("/// @eq{28\nint f();\n", "x.hpp"), InputError);
    CHECK_THROWS_AS(functions_of_header("/// @eq{28,}\nint f();\n", "x.hpp"), InputError);
    CHECK_THROWS_AS(functions_of_header("/// @eq{}\nint f();\n", "x.hpp"), InputError);
    CHECK(functions_of_header("/// @eq{99}\nint f();\n", "x.hpp").at(0).equation == "99");
}

TEST_CASE("a source root without headers is told", "[ledger]") {
    const tests::Folder folder;
    CHECK_THROWS_AS(functions_of_sources(folder.path()), InputError);
}

TEST_CASE("every tag of the project leads to a line that has the name of its function", "[ledger]") {
    const std::filesystem::path root = tests::project();
    const std::vector<FunctionEntry> entries = functions_of_sources(root / "src");
    for (const FunctionEntry& entry : entries) {
        std::istringstream text(derivation::text_of(root / entry.file));
        std::string line;
        for (int n = 0; n < entry.line; ++n) std::getline(text, line);
        INFO(entry.file << ":" << entry.line << " " << entry.name);
        CHECK(line.find(entry.name.substr(entry.name.rfind(':') + 1)) != std::string::npos);
        CHECK(entry.name.starts_with("denhartog::"));
    }
    // Counted another way: the commas within the tags, over the bare text.
    std::size_t tagged = 0;
    for (const std::filesystem::path& file : derivation::files_in(root / "src/denhartog", ".hpp")) {
        const std::string text = derivation::text_of(file);
        for (std::size_t at = text.find("@eq{"); at != std::string::npos; at = text.find("@eq{", at + 1)) {
            const std::string list = text.substr(at, text.find('}', at) - at);
            tagged += 1 + std::count(list.begin(), list.end(), ',');
        }
    }
    CHECK(entries.size() == tagged);
    const auto damping = std::find_if(entries.begin(), entries.end(), [](const FunctionEntry& entry) {
        return entry.equation == "28" && entry.name == "denhartog::paper::first_damping_function";
    });
    REQUIRE(damping != entries.end());
    CHECK(damping->file == "src/denhartog/formulas/mode.hpp");
}

using derivation::DeclaredTest;
using derivation::read_test_results;
using derivation::runs_of_xml;
using derivation::TestRun;
using derivation::tests_of_source;

namespace {

// As Catch2 2.13 writes it; version 3 leaves out <Group> and adds `skips` to <OverallResult>.
const std::string results = R"xml(<?xml version="1.0" encoding="UTF-8"?>
<Catch name="unit-tests">
  <Randomness seed="0"/>
  <Group name="unit-tests">
    <TestCase name="a mode with R &lt; 1 &amp; &quot;zeta&quot; = 0 isn&apos;t damped"
              tags="[eq:28][eq:29][limit]" filename="m.cpp" line="7">
      <Section name="within &lt;TestCase&gt;" filename="m.cpp" line="8">
        <OverallResults successes="1" failures="0" expectedFailures="0"/>
      </Section>
      <OverallResult success="true"/>
    </TestCase>
    <TestCase name="the velocity follows" tags="[eq:A.7]" filename="m.cpp" line="20">
      <Expression success="false" type="CHECK" filename="m.cpp" line="21">
        <Original>
          a == b
        </Original>
      </Expression>
      <OverallResult success="false"/>
    </TestCase>
    <TestCase name="no equation" tags="[subject]" filename="m.cpp" line="30">
      <OverallResult success="true"/>
    </TestCase>
    <TestCase name="half of (54)" tags="[eq:54a]" filename="m.cpp" line="40">
      <OverallResult success="true" skips="0"/>
    </TestCase>
    <TestCase name="it stopped here" tags="[eq:46]" filename="m.cpp" line="50">
)xml";

} // namespace

TEST_CASE("results give the tests of an equation that ran, and whether they passed", "[ledger]") {
    const std::vector<TestRun> runs = runs_of_xml(results);
    REQUIRE(runs.size() == 4);
    CHECK(runs[0].name == "a mode with R < 1 & \"zeta\" = 0 isn't damped");
    CHECK(runs[0].equations == std::vector<std::string>{"28", "29"});
    CHECK(runs[0].passed);
    CHECK(runs[1].equations == std::vector<std::string>{"A.7"});
    CHECK_FALSE(runs[1].passed);
    CHECK(runs[2].equations == std::vector<std::string>{"54"});
    CHECK(runs[2].passed);
    CHECK(runs[3].name == "it stopped here");
    CHECK_FALSE(runs[3].passed);
}

TEST_CASE("what is no XML has no results and does no harm", "[ledger]") {
    for (const std::string text :
         {"", "<", "<TestCase", "<TestCase name=\"x", "<TestCase name=>", "a < b", "&lt;", "</", "<a b", "< >"})
        CHECK(runs_of_xml(text).empty());
    CHECK(runs_of_xml("<TestCase tags='[eq:46]' name='&#65;&unknown;&'/>").at(0).name == "A&unknown;&");
}

TEST_CASE("a folder that is not there has no results, an empty one neither", "[ledger]") {
    const tests::Folder folder;
    CHECK_FALSE(read_test_results(folder.path() / "none").found);
    CHECK_FALSE(read_test_results(folder.path()).found);
}

TEST_CASE("results are gathered from every finished file of a folder", "[ledger]") {
    const tests::Folder folder;
    folder.write("unit.xml", results);
    folder.write("limits.xml", "<Catch><TestCase name=\"far away\" tags=\"[eq:69]\">"
                               "<OverallResult success=\"true\"/></TestCase></Catch>");
    folder.write("accuracy.xml.partial", results);
    const derivation::TestResults found = read_test_results(folder.path());
    CHECK(found.found);
    CHECK(found.runs.size() == 5);
}

TEST_CASE("sources give the tests that should run, not what merely looks like one", "[ledger]") {
    const std::string source = R"cpp(
// TEST_CASE("in a comment", "[eq:1]")
const char* text = "TEST_CASE(\"in a string\", \"[eq:2]\")";
const char* raw = R"(TEST_CASE("in a raw string", "[eq:3]"))";
TEST_CASE("first of all, \"quoted\"", "[eq:28][eq:29][limit]") { CHECK(f(1'000) == 1); }
TEST_CASE("a name in "
          "two parts",
          "[eq:A.7]") {}
TEST_CASE("no equation", "[subject]") {}
TEMPLATE_TEST_CASE("over types", "[eq:46]", double, long double) {}
)cpp";
    const std::vector<DeclaredTest> tests = tests_of_source(source, "x.cpp");
    REQUIRE(tests.size() == 3);
    CHECK(tests[0].name == "first of all, \"quoted\"");
    CHECK(tests[0].equations == std::vector<std::string>{"28", "29"});
    CHECK(tests[0].line == 5);
    CHECK(tests[1].name == "a name in two parts");
    CHECK(tests[1].equations == std::vector<std::string>{"A.7"});
    CHECK(tests[2].name == "over types");
    CHECK(tests[2].file == "x.cpp");
}

TEST_CASE("sources are looked for in every folder below", "[ledger]") {
    const tests::Folder folder;
    folder.write("unit/a.cpp", "TEST_CASE(\"one\", \"[eq:1]\") {}");
    folder.write("limits/b.cpp", "TEST_CASE(\"two\", \"[eq:2]\") {}");
    folder.write("limits/b.hpp", "TEST_CASE(\"three\", \"[eq:3]\") {}");
    const std::vector<DeclaredTest> tests = derivation::tests_of_sources(folder.path());
    REQUIRE(tests.size() == 2);
    CHECK(tests[0].file == "limits/b.cpp");
    CHECK(tests[1].file == "unit/a.cpp");
}

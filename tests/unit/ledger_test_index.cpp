#include "derivation/ledger/test_index.hpp"

#include "tests/unit/ledger_fixtures.hpp"

using namespace denhartog;
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

#include "derivation/ledger/ledger_rows.hpp"

#include <map>
#include <set>

#include "denhartog/number/errors.hpp"
#include "derivation/ledger/source_index.hpp"
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

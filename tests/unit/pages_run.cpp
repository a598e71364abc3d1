// Pages from a run with one equation proved and one refuted: what they say, and what they refuse.
#include "denhartog/formulas/mode.hpp"
#include "pages/chapter.hpp"
#include "pages/overview_pages.hpp"
#include "pages/site.hpp"
#include "pages/written.hpp"
#include "tests/unit/ledger_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::pages;
using denhartog::tests::tells;

namespace {

/// Two equations, (37) and (38), of which (38) rests on (37), with a claim each; the rest of the paper left out.
class SmallRun {
public:
    SmallRun() {
        folder.write("src/f.hpp", "namespace denhartog::paper {\n\n/// @brief X.\ntemplate <class T>\nT amplitude(const T& x) {\n"
                                  "    return x < 1 ? x : 2;\n}\n}\n");
        folder.write("derivation/c.cpp", "const char* id = \"38/amplitude\";\nconst char* other = \"37/sine\";\n");
        folder.write("tests/t.cpp", "TEST_CASE(\"the amplitude is right\", \"[eq:38]\") {}\n");
        for (const char* number : {"37", "38"}) {
            Json row = {
                {"equation", number}, {"section", "2.3"}, {"kind", "result"}, {"statement", "a_{" + std::string(number) + "}=b"}};
            row["rests_on"] = Json::array();
            run.ledger.push_back(ledger::entry_without_run(row));
        }
        Json& entry = run.ledger[1];
        entry["rests_on"].push_back("37");
        run.ledger[0]["used_by"].push_back("38");
        entry["printed"] = "refuted";
        entry["shipped"] = "proved";
        entry["departure"] = "misprint";
        entry["correction"] = "a=c";
        entry["witness"] = {{"V_jr", "1/3"}};
        entry["as_printed"] = Json::array();
        run.ledger[0]["as_printed"] = Json::array();
        run.ledger[0]["tests_failed"] = entry["tests_failed"] = Json::array();
        entry["tests"].push_back("the amplitude is right");
        entry["functions"].push_back({{"name", "denhartog::paper::amplitude"}, {"file", "src/f.hpp"}, {"line", 5}});
        run.run["agreement"] = Json::array();
        run.run["stand_ins"] =
            Json::array({{{"name", "sinc"}, {"header", "evaluation/special.hpp"}, {"theorem", "x \\mapsto \\sin(x)/x"}}});
        add_claim(0, "37/sine");
        add_claim(1, "38/amplitude");
    }

    void add_claim(std::size_t row, const std::string& id) {
        run.ledger[row]["claims"].push_back(
            {{"id", id}, {"role", "shipped"}, {"verdict", "proved"}, {"what", "The amplitude"}, {"assumptions", {"R_i > 0"}}});
        run.claims[id] = {{"claim", id},
                          {"equations", {run.ledger[row].at("equation")}},
                          {"title", "The amplitude"},
                          {"verdict", "proved"},
                          {"steps", {{{"text", "A quadratic"}, {"latex", "x^2=y"}}}}};
    }

    [[nodiscard]] std::string page(const std::string& equation) const {
        const Sources sources(folder.path());
        std::string text;
        for (const Page& page : equation_pages({run, sources}, equation)) text += page.text;
        return text;
    }

    tests::Folder folder;
    RunRecord run;
};

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

} // namespace

TEST_CASE("the page of an equation has statement, correction, witness, function, steps, test and neighbours", "[pages]") {
    const std::string text = SmallRun().page("38");
    CHECK(text.starts_with("# Equation (38) {#eq_38}\n"));
    CHECK(has(text, "\\f[ a_{38}=b \\f]"));
    CHECK(has(text, "\\f[ a=c \\f]"));
    CHECK(has(text, "\\f$\\mathrm{Re}\\,V_{dj}\\f$ = \\f$\\tfrac{1}{3}\\f$"));
    CHECK(has(text, "\\ref denhartog::paper::amplitude \"paper::amplitude\""));
    CHECK(has(text, "href=\"source:src/f.hpp:5\""));
    CHECK(has(text, "x &lt; 1 ? x : 2;"));
    CHECK(has(text, "href=\"source:derivation/c.cpp:1\""));
    CHECK(has(text, "\\f[ x^2=y \\f]"));
    CHECK(has(text, "href=\"source:tests/t.cpp:1\""));
    CHECK(has(text, "previous: \\ref eq_37"));
    CHECK(has(text, "next: \\ref eq_39"));
    CHECK(has(text, "<dt>Rests on</dt><dd>\\ref eq_37 \"(37)\"</dd>"));
}

TEST_CASE("a snippet has the lines of the source from its template head to its closing brace", "[pages]") {
    const SmallRun small;
    const Snippet snippet = Sources(small.folder.path()).snippet("denhartog::paper::amplitude", {"src/f.hpp", 5});
    CHECK(snippet.first == 4);
    CHECK(snippet.lines.size() == 4);
    CHECK(snippet.lines.back() == "}");
    CHECK(snippet.signature == 2);
}

TEST_CASE("a function that is not at its line, a claim without source or record, a test without source: no page", "[pages]") {
    SmallRun moved, unmade, unrecorded, untested;
    moved.run.ledger[1]["functions"][0]["line"] = 6;
    CHECK_THROWS_WITH(moved.page("38"), Catch::Contains("denhartog::paper::amplitude must stand where the ledger has it"));
    unmade.add_claim(1, "nowhere");
    CHECK_THROWS_WITH(unmade.page("38"), Catch::Contains("claim nowhere must be made in a source"));
    unrecorded.run.claims.erase("38/amplitude");
    CHECK_THROWS_WITH(unrecorded.page("38"), Catch::Contains("must have its steps"));
    untested.run.ledger[1]["tests"].push_back("a test that is nowhere");
    CHECK_THROWS_WITH(untested.page("38"), Catch::Contains("a test that is nowhere"));
}

TEST_CASE("the chapter replaces place-holders by the run's LaTeX and lists what it does not show", "[pages]") {
    const SmallRun small;
    const Sources sources(small.folder.path());
    std::vector<std::string> faults;
    const std::vector<Page> made =
        chapter_pages({small.run, sources},
                      {{"derivation_chapter",
                        "# All\n\nBy (37), $a<b$ in `code`.\n\n{{equation 38}}\n\n{{steps 38/amplitude}}\n\n{{claims 37}}\n"}},
                      faults);
    CHECK(faults.empty());
    REQUIRE(made.size() == 1);
    CHECK(has(made[0].text, "By \\ref eq_37 \"(37)\", \\f$a<b\\f$ in <code>code</code>."));
    CHECK(has(made[0].text, "\\f[ a=c\\tag{38} \\f]"));
    CHECK(has(made[0].text, "\\f[ x^2=y \\f]"));
    CHECK(has(made[0].text, "37/sine"));
}

TEST_CASE("an unknown place-holder, an unknown claim and a claim that is left out are faults of the chapter", "[pages]") {
    const SmallRun small;
    const Sources sources(small.folder.path());
    std::vector<std::string> faults;
    (void)chapter_pages(
        {small.run, sources},
        {{"derivation_chapter", "# All\n\n{{proof 38}}\n\n{{steps 38/none}}\n\n{{equation 99}}\n\nopen $x\n\n{{claims 38}}\n"}},
        faults);
    CHECK(tells(faults, "{{proof 38}}"));
    CHECK(tells(faults, "38/none"));
    CHECK(tells(faults, "(99)"));
    CHECK(tells(faults, "must be closed"));
    CHECK(tells(faults, "claim 37/sine is on a result"));
    CHECK_FALSE(tells(faults, "claim 38/amplitude"));
}

TEST_CASE("formulas within a sentence of a step and the run's own names of symbols are typeset", "[pages]") {
    SmallRun small;
    small.run.claims["38/amplitude"]["steps"][0]["text_latex"] = "With $a_1$ as in (37)";
    small.run.symbols["V_jr"] = "V'_{jr}";
    const std::string text = small.page("38");
    CHECK(has(text, "With \\f$a_1\\f$ as in \\ref eq_37 \"(37)\":"));
    CHECK(has(text, "\\f$V'_{jr}\\f$ = "));
    small.run.claims["38/amplitude"]["steps"][0]["text_latex"] = "With $a_1";
    CHECK_THROWS_WITH(small.page("38"), Catch::Contains("must be closed"));
}

TEST_CASE("what the tests measured stands on the page of its equation alone", "[pages]") {
    SmallRun small;
    small.run.accuracy.push_back(
        Json::parse(R"({"type":"double","functions":[{"function":"u","equations":["38"],"zone":"R near 1",
        "points":7,"printed":null,"shipped":1.5,"shipped_at":"0x1.8p-1"}]})"));
    CHECK(has(small.page("38"), "<td>double</td><td>R near 1</td><td>7</td><td>not finite</td><td>1.5</td><td>0x1.8p-1</td>"));
    CHECK_FALSE(has(small.page("37"), "0x1.8p-1"));
}

TEST_CASE("a departure is said in words, with the difference marked, and what it says must fit what is printed", "[pages]") {
    SmallRun small;
    small.run.departures["38"] = {"The sign of $b$ is wrong, see (37).", "a_{38}=\\misprint{b}", "a=\\mended{-b}"};
    const std::string text = small.page("38");
    CHECK(has(text, "The sign of \\f$b\\f$ is wrong, see \\ref eq_37 \"(37)\"."));
    CHECK(has(text, "\\f[ a_{38}=\\misprint{b} \\f]"));
    CHECK(text.find("mended") < text.find("The proof"));
    CHECK(text.find("The proof") < text.find("The function"));
    CHECK(faults_of(small.run.departures, small.run.ledger).empty());
    small.run.departures["38"].printed = "a_{38}=\\misprint{c}";
    CHECK(tells(faults_of(small.run.departures, small.run.ledger), "is not the printed formula"));
    CHECK(tells(faults_of({}, small.run.ledger), "has no sentence"));
    CHECK(tells(faults_of({{"37", {"x", "", ""}}}, small.run.ledger), "does not depart"));
}

TEST_CASE("a formula that is written down is the one that runs, in each language", "[pages]") {
    const Written R = Written::symbol("R"), zeta = Written::symbol("zeta");
    const WrittenFormula u{"u", {"R", "zeta"}, {}, {paper::first_damping_function(R, zeta)}};
    CHECK(code_of(u, Language::python) == "def u(R, zeta):\n    w = np.sqrt(1 - zeta * zeta)\n    theta = np.pi * w / R\n"
                                          "    return np.sin(theta) / (R * w * (np.cosh(np.pi * zeta / R) + np.cos(theta)))\n");
    CHECK(has(code_of(u, Language::matlab), "theta = pi .* w ./ R;"));
    const WrittenFormula order{
        "f", {"a", "b"}, {}, {Written::symbol("a") - (Written::symbol("b") - 1) * (-Written::symbol("a"))}};
    CHECK(has(code_of(order, Language::cxx), "return a - (b - 1) * (-a);"));
    const WrittenFormula sum{"s", {"x"}, {"x"}, {2 * Written::sum_over_modes(Written::symbol("x") * Written::symbol("x"))}};
    CHECK(has(code_of(sum, Language::python), "2 * np.sum(x * x)"));
    CHECK(has(code_of(sum, Language::javascript), "sum += x[i] * x[i];"));
}

TEST_CASE("departures and the index count what the ledger has", "[pages]") {
    const SmallRun small;
    const Sources sources(small.folder.path());
    const Book book{small.run, sources};
    const std::string errata = errata_page(book).text;
    CHECK(has(errata, "1 of the 2 equations depart"));
    CHECK(has(errata, "\\ref claim_38_amplitude"));
    const std::string stand_ins = stand_ins_page(book).text;
    CHECK(has(stand_ins, "<code>sinc</code>"));
    CHECK(has(stand_ins, "\\f$x \\mapsto \\sin(x)/x\\f$"));
    const std::string index = index_page(book).text;
    CHECK(has(index, "2 equations"));
    CHECK(has(index, "1 refuted"));
    CHECK(has(index, "\\subpage eq_38 \"(38)\""));
}

TEST_CASE("in the graph every equation stands below what it rests on, and no two in one place", "[pages]") {
    const Json rows = tests::project_rows();
    const std::vector<Node> nodes = layout(rows, 20);
    REQUIRE(nodes.size() == rows.size());
    std::map<std::string, Node> at;
    std::set<std::pair<int, int>> places;
    for (const Node& node : nodes) {
        at[node.equation] = node;
        CHECK(places.insert({node.row, node.column}).second);
        CHECK(node.column >= 0);
        CHECK(node.column < 20);
    }
    for (const Json& row : rows)
        for (const Json& ground : row.at("rests_on")) CHECK(at.at(row.at("equation")).row > at.at(ground).row);
}

TEST_CASE("a graph with a way round or a hole is refused", "[pages]") {
    const Json round = Json::parse(R"([{"equation":"1","rests_on":["2"]},{"equation":"2","rests_on":["1"]}])");
    CHECK_THROWS_WITH(layout(round, 20), Catch::Contains("must not rest on itself"));
    CHECK_THROWS_WITH(layout(Json::parse(R"([{"equation":"1","rests_on":["2"]}])"), 20), Catch::Contains("must have an entry"));
}

TEST_CASE("pages are written once, and one that is no page any more is removed", "[pages]") {
    const tests::Folder folder;
    folder.write("old.md", "of an earlier run");
    CHECK(write_pages({{"a", "x"}, {"b", "y"}}, folder.path()) == 2);
    CHECK(write_pages({{"a", "x"}, {"b", "z"}}, folder.path()) == 1);
    CHECK_FALSE(std::filesystem::exists(folder.path() / "old.md"));
}

TEST_CASE("a run without an equation of the paper is refused", "[pages]") {
    const SmallRun small;
    const Site site = make_site(small.run, Sources(small.folder.path()), tests::project() / "docs/chapter");
    CHECK(tells(site.faults, "must have an entry for equation (46)"));
}

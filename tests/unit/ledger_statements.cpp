#include "derivation/ledger/ledger_statements.hpp"

#include "tests/unit/ledger_fixtures.hpp"

using namespace denhartog;
using derivation::ClaimResult;
using derivation::join_statements;
using derivation::Statements;
using derivation::Threshold;
using ledger::Json;
using tests::tells;

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

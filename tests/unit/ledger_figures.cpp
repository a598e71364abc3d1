#include "derivation/ledger/ledger_figures.hpp"

#include <fstream>

#include "tests/catch.hpp"

using namespace denhartog::derivation;
using nlohmann::json;
namespace fs = std::filesystem;

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

json ledger() { return {{{"equation", "38"}, {"figures", json::array()}}, {{"equation", "A.7"}, {"figures", json::array()}}}; }

} // namespace

TEST_CASE("the ledger names the figures that show an equation", "[ledger][figures]") {
    json entries = ledger();
    CHECK(add_figures(entries, {record("fig06_curves", {"38"}), record("printed", {"38", "A.7"})}).empty());
    CHECK(entries[0]["figures"] == json({"fig06_curves", "printed"}));
    CHECK(entries[1]["figures"] == json({"printed"}));
}

TEST_CASE("a figure that names an equation which is not in the paper is a fault", "[ledger][figures]") {
    json entries = ledger();
    const std::vector<std::string> faults = add_figures(entries, {record("fig06_curves", {"38", "99"})});
    REQUIRE(faults.size() == 1);
    CHECK(faults[0] == "the figure fig06_curves shows (99), which the paper does not have");
}

TEST_CASE("figures of the paper come before the others, and a broken record is named", "[ledger][figures]") {
    const fs::path folder = fs::temp_directory_path() / "denhartog-figure-records";
    fs::remove_all(folder);
    CHECK(figure_records(folder).empty());
    fs::create_directories(folder);
    std::ofstream(folder / "a.json") << record("a", {"38"});
    std::ofstream(folder / "fig02.json") << record("fig02", {"3"});
    std::ofstream(folder / "fig02.dat") << "no record";
    const std::vector<json> records = figure_records(folder);
    REQUIRE(records.size() == 2);
    CHECK(records[0]["name"] == "fig02");
    std::ofstream(folder / "b.json") << "{";
    CHECK_THROWS_WITH(figure_records(folder), Catch::Contains("b.json"));
    fs::remove_all(folder);
}

TEST_CASE("a statement that is not borne out is shown as such", "[ledger][figures]") {
    const std::vector<json> records{record("fig06_curves", {"38"})};
    CHECK_THAT(figures_markdown(records), Catch::Contains("| falls | rises by 3 | no |"));
    const std::string table = figures_table(records);
    CHECK_THAT(table, Catch::Contains("| fig06_curves |") && Catch::Contains("| 1e-07 | 0.25 | 1 of 2 |"));
    CHECK_THAT(figures_markdown({record("limits", {"38"})}), Catch::Contains("| statement | the data say | holds |"));
}

TEST_CASE("where a number of ours decides, a statement is not borne out to that number", "[ledger][figures]") {
    json measured = record("fig06_curves", {"38"});
    measured["statements"][0]["measure"] = "to 1 percent";
    measured["statements"][1]["measure"] = "to 5 percent";
    CHECK_THAT(figures_markdown({measured}), Catch::Contains("| falls | rises by 3 | not to 1 percent |"));
    CHECK_THAT(figures_markdown({measured}), Catch::Contains("| a | b | yes |"));
    CHECK_THAT(figures_table({measured}), Catch::Contains("| 1 of 2, 1 beyond the threshold that was chosen |"));
}

TEST_CASE("a bar within a text does not end a cell of a table", "[ledger][figures]") {
    json with_bars = record("fig06_curves", {"38"});
    with_bars["statements"][0]["text"] = "|v| falls";
    CHECK_THAT(figures_markdown({with_bars}), Catch::Contains("| \\|v\\| falls | rises by 3 | no |"));
}

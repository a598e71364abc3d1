// Scenes that show a refuted equation, and the audit of what remains assumed.
#include "derivation/ledger/ledger_scenes.hpp"

#include "derivation/ledger/ledger_audit.hpp"
#include "tests/catch.hpp"

using namespace denhartog::derivation;
using nlohmann::json;

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

// What the surveys leave for the site's pages.
#include "tests/speed_accuracy/accuracy_record.hpp"

#include <limits>
#include <nlohmann/json.hpp>

#include "tests/catch.hpp"

using namespace denhartog::tests;

TEST_CASE("the record of a survey has a row a function and zone, with its equations, and null for what is no number",
          "[accuracy][pages]") {
    ZoneErrors zone;
    zone.zone = "R near 1";
    zone.points = 7;
    zone.functions[2].printed = {std::numeric_limits<double>::infinity(), "0x1p+0", 7};
    zone.functions[2].by_both = {1.5, "0x1.8p-1", 7};
    const nlohmann::json record = nlohmann::json::parse(accuracy_record("double", std::vector<ZoneErrors>{zone, zone}));
    CHECK(record.at("type") == "double");
    REQUIRE(record.at("functions").size() == 8);
    const nlohmann::json& u = record.at("functions").at(4);
    CHECK(u.at("function") == "u");
    CHECK(u.at("equations") == nlohmann::json{"28"});
    CHECK(u.at("zone") == "R near 1");
    CHECK(u.at("points") == 7);
    CHECK(u.at("printed").is_null());
    CHECK(u.at("shipped") == 1.5);
    CHECK(u.at("shipped_at") == "0x1.8p-1");
}

TEST_CASE("a function that belongs to no equation has no record", "[accuracy][pages]") {
    FunctionInZone unknown;
    unknown.function = "h";
    CHECK_THROWS(accuracy_record("double", std::vector<FunctionInZone>{unknown}));
}

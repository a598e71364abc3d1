#include <nlohmann/json.hpp>

#include "denhartog/scene/scene_json.hpp"
#include "tests/catch.hpp"

using namespace denhartog;

namespace {

const std::string scene = R"({"mass_ratios": [1], "stiffness_ratios": [1], "damping_ratios": 0.125, "contact": 1, "load": 1})";

} // namespace

TEST_CASE("one object over many lines is one scene", "[scene][json]") {
    const std::string text = nlohmann::json::parse(scene).dump(2);
    const auto scenes = read_scenes<double>("\n" + text + "\n\n");
    REQUIRE(scenes.size() == 1);
    REQUIRE(scenes[0].scene);
    REQUIRE(read_scenes<double>("\xEF\xBB\xBF" + text)[0].scene);
}

TEST_CASE("one object a line is many scenes, each with its own error in its place", "[scene][json][bad-input]") {
    const std::string text = scene + "\r\n\n{\"r\": }\n" + scene + "\n{\"r\": 1}\nnonsense\n{\"contact\": 1, \"contact\": 1}\n";
    const auto scenes = read_scenes<double>(text);
    REQUIRE(scenes.size() == 6);
    REQUIRE(scenes[0].scene);
    REQUIRE(scenes[2].scene);
    REQUIRE(scenes[2].line == 4);
    REQUIRE(scenes[1].error->place == "line 3, column 7");
    REQUIRE(scenes[3].error->quantity == "mass_ratios");
    REQUIRE(scenes[3].error->place == "line 5");
    REQUIRE(scenes[4].error->place == "line 6, column 2");
    REQUIRE(scenes[5].error->place == "line 7, /contact");
    for (const auto& one : scenes) REQUIRE(one.scene.has_value() != one.error.has_value());
}

TEST_CASE("broken lines do not merge into one scene", "[scene][json][bad-input]") {
    const auto scenes = read_scenes<double>("{\"r\": }\n{\"r\": ]\n");
    REQUIRE(scenes.size() == 2);
    REQUIRE(scenes[0].error->place == "line 1, column 7");
    REQUIRE(scenes[1].error->place == "line 2, column 7");
}

TEST_CASE("a syntax error in a scene of many lines is reported once, with its line", "[scene][json][bad-input]") {
    const auto scenes = read_scenes<double>("{\n  \"mass_ratios\": [1, 2,\n  \"contact\" 1\n}\n");
    REQUIRE(scenes.size() == 1);
    REQUIRE(scenes[0].error->place.find("line 3, column") == 0);
}

TEST_CASE("a text without a scene is an error and not an empty answer", "[scene][json][bad-input]") {
    for (const std::string text : {"", "\n \n", "[]", "null", "42"}) {
        const auto scenes = read_scenes<double>(text);
        REQUIRE(scenes.size() == 1);
        REQUIRE(scenes[0].error);
    }
}

TEST_CASE("the places of a scene alone have no line", "[scene][json][bad-input]") {
    const auto scenes = read_scenes<double>(R"({"mass_ratios": [1, -1], "stiffness_ratios": [1, 1], "damping_ratios": 0,
        "contact": 1, "load": 1})");
    REQUIRE(scenes[0].error->place == "/mass_ratios/1");
}

TEST_CASE("a zero byte makes no end of a scene, alone or among others", "[scene][json][bad-input]") {
    using namespace std::string_literals;
    for (const std::string& text : {scene + "\0"s + scene, scene + "\0garbage {"s, scene + "\0"s}) {
        const auto scenes = read_scenes<double>(text);
        REQUIRE(scenes.size() == 1);
        REQUIRE(scenes[0].error);
        REQUIRE(scenes[0].error->place == "line 1, column " + std::to_string(scene.size() + 1));
    }
    const auto three = read_scenes<double>(scene + "\n" + scene + "\0{}\n"s + scene);
    REQUIRE(three.size() == 3);
    REQUIRE(three[0].scene);
    REQUIRE(three[1].error->place == "line 2, column " + std::to_string(scene.size() + 1));
    REQUIRE(three[2].scene);
    const auto after = read_scenes<double>(scene + "\n\0"s);
    REQUIRE(after.size() == 2);
    REQUIRE(after[1].error->place == "line 2, column 1");
}

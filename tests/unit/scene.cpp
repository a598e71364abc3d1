#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "denhartog/denhartog.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/program/json/solution_json.hpp"
#include "denhartog/scene/json_document.hpp"
#include "denhartog/scene/scene.hpp"
#include "denhartog/scene/scene_json.hpp"
#include "tests/catch.hpp"
#include "tests/support/multiprecision.hpp"
#include "tests/support/paper_systems.hpp"

using namespace denhartog;

namespace {

template <class T>
Scene<T> good() {
    Scene<T> scene;
    scene.system.mass_ratios = {T(1), T(5) / 2, T(3) / 4};
    scene.system.stiffness_ratios = {T(1), T(5) / 8, T(15) / 8};
    scene.system.damping_ratios = {T(1) / 32, T(0), T(1) / 8};
    scene.system.contact.index = 1;
    scene.system.load.index = 0;
    scene.mu = T(11) / 8;
    scene.r = T(9) / 8;
    scene.beta = T(5) / 32;
    return scene;
}

/// The good scene with matrices in place of ratios.
Scene<double> by_matrices() {
    Scene<double> scene = good<double>();
    System<double>& s = scene.system;
    s.mass_ratios.clear();
    s.stiffness_ratios.clear();
    s.damping_ratios.clear();
    s.mass_matrix = Matrix<double>{{1, 0.5, 0}, {0.5, 2.5, 0}, {0, 0, 0.75}};
    s.stiffness_matrix = Matrix<double>{{2, -1, 0}, {-1, 2, -1}, {0, -1, 1}};
    s.damping_matrix = Matrix<double>::Zero(3, 3);
    return scene;
}

template <class T>
InputError refusal(const Scene<T>& scene) {
    try {
        check(scene);
    } catch (const InputError& fault) {
        return fault;
    }
    FAIL("no error");
    return InputError("", "", "");
}

/// A change that breaks a rule, and what is said of it: quantity, a piece of the rule, value.
struct Broken {
    std::function<void(System<double>&, Scene<double>&)> change;
    const char *quantity, *rule, *value;
};

/// Checks what is said of a scene after each change.
void check_broken(const Scene<double>& good, const std::vector<Broken>& table) {
    for (const Broken& broken : table) {
        Scene<double> scene = good;
        broken.change(scene.system, scene);
        const InputError fault = refusal(scene);
        INFO(fault.what());
        CHECK(fault.place.empty());
        CHECK(fault.quantity == broken.quantity);
        CHECK_THAT(fault.rule, Catch::Contains(broken.rule));
        CHECK(fault.value == broken.value);
        CHECK_THAT(std::string(fault.what()), Catch::StartsWith(broken.quantity));
    }
}

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

} // namespace

TEST_CASE("a scene that keeps every rule is accepted in every number type", "[scene]") {
    REQUIRE_NOTHROW(check(good<double>()));
    REQUIRE_NOTHROW(check(good<Real50>()));
    REQUIRE_NOTHROW(check(good<Real100>()));
    REQUIRE_NOTHROW(check(by_matrices()));
    Scene<double> edge = good<double>();
    edge.mu = 1;
    edge.beta = 0;
    edge.system.damping_ratios = {0, 0, 0};
    edge.r.reset();
    REQUIRE_NOTHROW(check(edge));
}

TEST_CASE("a scene made in code breaks the rules that one in JSON breaks, without a place, and more", "[scene][bad-input]") {
    // The other rules, and what is said of them, stand in scene_json.cpp.
    check_broken(
        good<double>(),
        {{[](auto& s, auto&) { s.stiffness_ratios.clear(); }, "stiffness_ratios", "", ""},
         {[](auto& s, auto&) { s.damping_ratios.clear(); }, "damping_ratios", "", ""},
         {[](auto& s, auto&) { s.mass_matrix = Matrix<double>::Identity(3, 3); }, "mass_matrix",
          "must not be given together with mass_ratios", ""},
         {[](auto& s, auto&) { s.damping_matrix = Matrix<double>::Identity(3, 3); }, "damping_matrix",
          "must not be given together with damping_ratios", ""},
         {[](auto& s, auto&) { s.mass_ratios[1] = -2; }, "mass_ratios", "of mass 2 must be positive", "-2"},
         {[](auto& s, auto&) { s.mass_ratios[2] = not_a_number; }, "mass_ratios", "of mass 3 must be finite", "nan"},
         {[](auto& s, auto&) { s.mass_ratios[2] = infinity; }, "mass_ratios", "of mass 3 must be finite", "inf"},
         {[](auto& s, auto&) { s.stiffness_ratios[1] = not_a_number; }, "stiffness_ratios", "of spring 2 must be finite", "nan"},
         {[](auto& s, auto&) { s.damping_ratios[2] = not_a_number; }, "damping_ratios", "of mode 3 must be finite", "nan"},
         {[](auto& s, auto&) { s.damping_ratios[0] = infinity; }, "damping_ratios", "of mode 1 must be finite", "inf"},
         {[](auto&, auto& s) { s.mu = not_a_number; }, "mu", "finite", "nan"},
         {[](auto&, auto& s) { s.beta = infinity; }, "beta", "finite", "inf"},
         {[](auto&, auto& s) { s.r = not_a_number; }, "r", "finite", "nan"}});
    check_broken(
        by_matrices(),
        {{[](auto& s, auto&) { s.stiffness_matrix = Matrix<double>::Ones(3, 2); }, "stiffness_matrix",
          "must have 3 rows and columns", "3 by 2"},
         {[](auto& s, auto&) { s.mass_matrix(2, 0) = not_a_number; }, "mass_matrix", "in row 3, column 1 must be finite", "nan"},
         {[](auto& s, auto&) { s.damping_matrix(0, 1) = 0x1p-1000; }, "damping_matrix", "symmetric", "0"}});
    REQUIRE(refusal(Scene<double>{}).quantity == "mass_ratios");
    for (const double zeta : {1.0, 1.5, 1e300}) {
        Scene<double> scene = good<double>();
        scene.system.damping_ratios[1] = zeta;
        REQUIRE_NOTHROW(check(scene));
    }
}

TEST_CASE("a matrix that is singular only to fifteen digits is accepted in fifty", "[scene]") {
    Scene<double> scene = by_matrices();
    scene.system.stiffness_matrix = Matrix<double>{{1 + 0x1p-52, -1, 0}, {-1, 1, 0}, {0, 0, 1}};
    REQUIRE(refusal(scene).value.find("singular") == 0);
    Scene<Real50> fifty;
    fifty.system.mass_matrix = scene.system.mass_matrix.cast<Real50>();
    fifty.system.stiffness_matrix = scene.system.stiffness_matrix.cast<Real50>();
    fifty.system.damping_matrix = scene.system.damping_matrix.cast<Real50>();
    REQUIRE_NOTHROW(check(fifty));
}

namespace {

const std::string one_mass = R"({"mass_ratios": [1], "stiffness_ratios": [1], "damping_ratios": 0.125, "contact": 1, "load": 1})";

} // namespace

TEST_CASE("one object over many lines is one scene", "[scene][json]") {
    const std::string text = nlohmann::json::parse(one_mass).dump(2);
    const auto scenes = read_scenes<double>("\n" + text + "\n\n");
    REQUIRE(scenes.size() == 1);
    REQUIRE(scenes[0].scene);
    REQUIRE(read_scenes<double>("\xEF\xBB\xBF" + text)[0].scene);
}

TEST_CASE("one object a line is many scenes, each with its own error in its place", "[scene][json][bad-input]") {
    const std::string text =
        one_mass + "\r\n\n{\"r\": }\n" + one_mass + "\n{\"r\": 1}\nnonsense\n{\"contact\": 1, \"contact\": 1}\n";
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
    for (const std::string& text : {one_mass + "\0"s + one_mass, one_mass + "\0garbage {"s, one_mass + "\0"s}) {
        const auto scenes = read_scenes<double>(text);
        REQUIRE(scenes.size() == 1);
        REQUIRE(scenes[0].error);
        REQUIRE(scenes[0].error->place == "line 1, column " + std::to_string(one_mass.size() + 1));
    }
    const auto three = read_scenes<double>(one_mass + "\n" + one_mass + "\0{}\n"s + one_mass);
    REQUIRE(three.size() == 3);
    REQUIRE(three[0].scene);
    REQUIRE(three[1].error->place == "line 2, column " + std::to_string(one_mass.size() + 1));
    REQUIRE(three[2].scene);
    const auto after = read_scenes<double>(one_mass + "\n\0"s);
    REQUIRE(after.size() == 2);
    REQUIRE(after[1].error->place == "line 2, column 1");
}

namespace {

InputError refusal(std::string_view text) {
    INFO(text);
    try {
        (void)read_json(text);
    } catch (const InputError& fault) {
        return fault;
    }
    FAIL("no error");
    return InputError("", "", "");
}

} // namespace

TEST_CASE("JSON is read as it stands", "[scene][json]") {
    const nlohmann::json value = read_json(R"( {"a": [1, 2.5, "x"], "b": [[-1, true], [null]], "c": {}} )");
    REQUIRE(value == nlohmann::json::parse(R"({"a": [1, 2.5, "x"], "b": [[-1, true], [null]], "c": {}})"));
}

TEST_CASE("a syntax error gives line and column", "[scene][json][bad-input]") {
    const InputError fault = refusal("{\"a\": 1,\n \"b\": NaN}");
    REQUIRE(fault.quantity == "scene");
    REQUIRE(fault.rule.find("must be JSON") == 0);
    REQUIRE(fault.place == "line 2, column 7");
    REQUIRE(refusal("{\"a\": Infinity}").place == "line 1, column 7");
    REQUIRE(refusal("{\"a\": [1, 2").rule.find("unexpected end of input") != std::string::npos);
    REQUIRE(refusal("").place == "line 1, column 1");
    REQUIRE(refusal("\n\n{]").place == "line 3, column 2");
    REQUIRE(refusal("{} {}").place == "line 1, column 4");
}

TEST_CASE("a text cut off anywhere is an error", "[scene][json][bad-input]") {
    const std::string text = R"({"mass_ratios": [1, 2.5], "r": "0.1", "beta": -1e-3})";
    for (std::size_t length = 0; length < text.size(); ++length) (void)refusal(text.substr(0, length));
    REQUIRE_NOTHROW(read_json(text));
}

TEST_CASE("a key that is given twice is refused by its name", "[scene][json][bad-input]") {
    const InputError fault = refusal(R"({"r": 1, "beta": 2, "r": 1})");
    REQUIRE(fault.quantity == "r");
    REQUIRE(fault.rule == "must be given once");
    REQUIRE(fault.place == "/r");
    REQUIRE(refusal(R"({"a": [{"b/c": 1, "b/c": 1}]})").place == "/a/0/b~1c");
}

TEST_CASE("a number that no double holds is refused and points to its place", "[scene][json][bad-input]") {
    const InputError large = refusal(R"({"mass_ratios": [1, 1e999]})");
    REQUIRE(large.quantity == "mass_ratios");
    REQUIRE(large.value == "1e999");
    REQUIRE(large.place == "/mass_ratios/1");
    REQUIRE(refusal(R"({"k": [[1, 2], [3, -1e999]]})").place == "/k/1/1");
    REQUIRE(refusal(R"({"beta": 1e-999})").value == "1e-999");
    REQUIRE(read_json("[0.0e-999]")[0] == 0.0);
}

TEST_CASE("values nested deeper than a scene's are refused", "[scene][json][bad-input]") {
    REQUIRE(refusal(R"({"k": [[1, [2]]]})").place == "/k/0/1");
    REQUIRE(refusal(std::string(100000, '[')).quantity == "scene");
}

TEST_CASE("messages hold printable characters and not many of them", "[scene][json]") {
    for (const char c : refusal("{\"\xC3\x28\x01").value) REQUIRE((c >= ' ' && c <= '~'));
    const InputError twice = refusal("{\"\\u001b[31m\": 1, \"\\u001b[31m\": 1}");
    REQUIRE(twice.quantity == "\\x1B[31m");
    REQUIRE(twice.place == "/\\x1B[31m");
    const std::string key(1'000'000, 'k');
    REQUIRE(std::string(refusal("{\"" + key + "\": 1, \"" + key + "\": 1}").what()).size() < 1000);
}

TEST_CASE("a key without a letter is named all the same", "[scene][json][bad-input]") {
    REQUIRE(refusal(R"({"": 1, "": 2})").quantity == "\"\"");
    REQUIRE(std::string(refusal(R"({"": 1, "": 2})").what()) == "\"\" must be given once, but is given twice (at /)");
}

TEST_CASE("a value that is nested without an end is none", "[scene][json][bad-input]") {
    REQUIRE(json_or_nothing(std::string(16, '[') + std::string(16, ']')).is_array());
    REQUIRE(json_or_nothing(std::string(17, '[') + std::string(17, ']')).is_discarded());
    REQUIRE(json_or_nothing(R"({"a": "[[[[[[[[[[[[[[[[[[[\"[["})").is_object());
}

TEST_CASE("a zero byte is refused where it stands, not taken for the end", "[scene][json][bad-input]") {
    using namespace std::string_literals;
    for (const std::string& text : {"{}\0"s, "{}\0{}"s, "{}\0garbage {"s, "{\"a\0\": 1}"s, "\0{}"s, "{\"a\": 1\0}"s, "{} \0"s}) {
        const InputError fault = refusal(text);
        REQUIRE(fault.quantity == "scene");
        REQUIRE(fault.value == "a zero byte");
        REQUIRE(fault.place == "line 1, column " + std::to_string(text.find('\0') + 1));
        REQUIRE_FALSE(is_json(text));
        REQUIRE_FALSE(json_or_nothing(text).is_object());
    }
    REQUIRE(refusal("{\"a\":\n 1}\n\0"s).place == "line 3, column 1");
    REQUIRE(is_json("{}"));
    REQUIRE(json_or_nothing("{}").is_object());
}

TEST_CASE("a multiplier that has no bound is printed with null for it", "[program][stability]") {
    Solution s = solve(scene_of(single_mass(0.01), 0.1, 0.2));
    REQUIRE(s.stability);
    REQUIRE(s.stability->multipliers.size() == 2);
    s.stability->multipliers.back().error = std::numeric_limits<double>::infinity();
    const program::Json bounds = program::solution_json(s, {})["multiplier_error_bounds"];
    REQUIRE(bounds.size() == 2);
    CHECK(bounds.front().is_number());
    CHECK(bounds.back().is_null());
}

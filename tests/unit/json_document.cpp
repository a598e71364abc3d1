#include "denhartog/scene/json_document.hpp"

#include <nlohmann/json.hpp>

#include "denhartog/number/errors.hpp"
#include "tests/catch.hpp"

using namespace denhartog;

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

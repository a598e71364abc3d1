#include "conformance/question.hpp"

#include "denhartog/number/errors.hpp"
#include "tests/catch.hpp"

using namespace denhartog;
using namespace denhartog::conformance;

namespace {

const std::set<std::string> ids{"a-1", "a-2", "a-3"};

std::string fault(const std::string& text) {
    try {
        static_cast<void>(answers_in(text, ids));
    } catch (const InputError& e) {
        return e.what();
    }
    return "";
}

} // namespace

TEST_CASE("answers are read from CSV, with quotes, CRLF, a byte order mark and empty lines", "[conformance]") {
    const auto answers = answers_in("\xEF\xBB\xBFid,value\r\n\"a-1\",\"0.5 0x1p-2\"\r\n\r\na-2,stick_slip\r\na-3,reject", ids);
    REQUIRE(answers.size() == 3);
    CHECK(std::get<Value>(answers.at("a-1")).numbers == std::vector<double>{0.5, 0.25});
    CHECK(std::get<Value>(answers.at("a-2")).word == "stick_slip");
    CHECK(std::holds_alternative<Rejected>(answers.at("a-3")));
    CHECK(std::holds_alternative<Unusable>(answers_in("id,value\na-1,\"0,5\"\n", ids).at("a-1")));
    CHECK(std::holds_alternative<Skipped>(answers_in("id,value\na-1,\n", ids).at("a-1")));
    CHECK(std::holds_alternative<Unusable>(answers_in("id,value\na-1,\"say \"\"x\"\"\"\n", ids).at("a-1")));
    CHECK(std::holds_alternative<Unusable>(answers_in("id,value\na-1,nan\n", ids).at("a-1")));
}

TEST_CASE("answers are read from JSON Lines", "[conformance]") {
    const auto answers = answers_in("{\"id\":\"a-1\",\"value\":[1,\"0x1p-2\"]}\r\n\n{\"id\":\"a-2\",\"skip\":\"no\"}\n", ids);
    REQUIRE(answers.size() == 2);
    CHECK(std::get<Value>(answers.at("a-1")).numbers == std::vector<double>{1, 0.25});
    CHECK(std::holds_alternative<Skipped>(answers.at("a-2")));
}

TEST_CASE("a file that is none is refused with quantity, rule, value and line", "[conformance]") {
    CHECK(fault("") == "answers must be JSON Lines, or CSV with the heading id,value, but is empty (at line 1)");
    CHECK(fault("id;value\n").find("but is id;value") != std::string::npos);
    CHECK(fault("id,value\na-1,1\nb-1,1\n") == "id must be a vector's, but is b-1 (at line 3)");
    CHECK(fault("id,value\na-1,1\na-1,2\n") == "id must be given once, but is a-1 (at line 3)");
    CHECK(fault("id,value\na-1,1,2\n") ==
          "answers must have two cells a line, numbers separated by spaces, but is 3 cells (at line 2)");
    CHECK(fault("id,value\na-1,\"1\n") == "answers must end every quoted cell (at line 2)");
    CHECK(fault("{\"id\":\"a-1\",\"value\":1}\nnonsense\n").find("line 2") != std::string::npos);
    CHECK(fault("{\"id\":\"b-1\",\"value\":1}\n") == "id must be a vector's, but is b-1 (at line 1)");
    CHECK(fault("{\"id\":\"a-1\",\"value\":1}\n{\"id\":\"a-1\",\"value\":1}\n").find("given once") != std::string::npos);
}

TEST_CASE("a zero byte ends neither a file nor an answer", "[conformance]") {
    using namespace std::string_literals;
    CHECK(fault("id,value\na-1,1\0junk\n"s) == "answers must be text, but is a zero byte (at line 2, column 6)");
    CHECK(fault("{\"id\":\"a-1\",\"value\":1}\n\n{\"id\":\"a-2\",\"value\":1}\0{\n"s) ==
          "answers must be text, but is a zero byte (at line 3, column 23)");
    CHECK(std::holds_alternative<Unusable>(answer_from_json("{\"id\":\"a-1\",\"value\":1}\0{"s, "a-1")));
    CHECK(std::holds_alternative<Unusable>(answer_from_json("{\"id\":\"a-1\",\"value\":\"1\\u00002\"}", "a-1")));
    CHECK(std::holds_alternative<Unusable>(answer_from_plain("a-1 value 1\0junk"s, "a-1")));
    CHECK(std::holds_alternative<Unusable>(answer_from_cell("1\0"s)));
}

TEST_CASE("an answer that is nested without an end is unusable and does no harm", "[conformance]") {
    const std::string deep = "{\"id\":\"a-1\",\"value\":" + std::string(400000, '[') + std::string(400000, ']') + "}";
    const Answer answer = answer_from_json(deep, "a-1");
    REQUIRE(std::holds_alternative<Unusable>(answer));
    CHECK(std::get<Unusable>(answer).reason.find("nested too deeply") != std::string::npos);
    CHECK(
        std::holds_alternative<Value>(answer_from_json(R"({"id":"a-1","value":[1],"note":"[[[[[[[[[[[[[[[[[[[[\"[["})", "a-1")));
}

// Answers files: CSV and JSON Lines mean the same, and an answer is to a question that there is.
#include "conformance/question.hpp"

#include <nlohmann/json.hpp>

#include "tests/fuzz/answer_claims.hpp"

using namespace denhartog;
using namespace denhartog::conformance;

namespace {

const std::set<std::string> known{"a-1", "b-2", "boundary-0001"};

void check_again(const std::map<std::string, Value>& values, const std::string& file) {
    std::map<std::string, Answer> again;
    fuzz::claim(fuzz::answers([&] { again = answers_in(file, known); }), "an answers file that is written is read", file);
    fuzz::claim(again.size() == values.size(), "every answer that is written is read", file);
    for (const auto& [id, value] : values) fuzz::claim_same(again.at(id), value, file);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::map<std::string, Answer> answers;
    if (!fuzz::answers([&] { answers = answers_in(fuzz::text_of(data, size), known); })) return 0;
    std::map<std::string, Value> values;
    std::string csv = "id,value\n", lines;
    for (const auto& [id, answer] : answers) {
        fuzz::claim(known.contains(id), "an answer is to a question that there is", id);
        fuzz::claim_answer(answer);
        const auto* value = std::get_if<Value>(&answer);
        if (value == nullptr || (value->numbers.empty() && value->word.empty())) continue; // CSV has no empty list
        values.emplace(id, *value);
        csv += id + ",\"" + fuzz::words_of(*value) + "\"\n";
        const nlohmann::json of_json = value->word.empty() ? nlohmann::json(value->numbers) : nlohmann::json(value->word);
        lines += nlohmann::json{{"id", id}, {"value", of_json}}.dump() + "\n";
    }
    check_again(values, csv);
    if (!values.empty()) check_again(values, lines);
    return 0;
}

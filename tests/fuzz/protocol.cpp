// The conformance protocol. The first line is a vector's object with its question; the rest is an answer, read in both dialects.
#include <nlohmann/json.hpp>
#include <sstream>

#include "conformance/vector.hpp"
#include "conformance/verdict.hpp"
#include "denhartog/scene/json_document.hpp"
#include "denhartog/scene/scene.hpp"
#include "tests/fuzz/answer_claims.hpp"

using namespace denhartog;
using namespace denhartog::conformance;

namespace {

std::string all_members(const ProtocolQuestion& q) { return question_json(q).dump(); }
std::string all_members(const Vector& v) { return vector_json(v).dump(); }

// Requires that a thing, written and read again, is unchanged.
template <class Read, class Thing>
void check_again(const Read& read, const Thing& thing) {
    const std::string written = all_members(thing);
    Thing again;
    fuzz::claim(fuzz::answers([&] { again = read(nlohmann::json::parse(written)); }), "what is written is read", written);
    fuzz::claim(all_members(again) == written, "what is written and read is the same", written);
}

// One line of words with single spaces, as docs/protocol.md has them.
void check_plain_question(const ProtocolQuestion& q) {
    const std::string line = question_plain(q);
    std::istringstream stream(line);
    std::string joined, id;
    std::size_t count = 0;
    for (std::string word; stream >> word; ++count) joined += (count > 0 ? " " : "") + (count == 0 ? id = word : word);
    constexpr std::size_t before_lists = 11;
    const std::size_t numbers = q.mass_ratios.size() + q.stiffness_ratios.size() + q.damping_ratios.size();
    fuzz::claim(joined == line && id == q.id && count == before_lists + numbers, "a plain question is its words", line);
}

// A value means the same in both dialects, its numbers in JSON as numbers or as text.
void check_in_both_dialects(const Value& value, const std::string& id) {
    const std::string plain = id + " value " + fuzz::words_of(value);
    fuzz::claim_same(answer_from_plain(plain, id), value, plain);
    nlohmann::json numbers = nlohmann::json::array(), texts = nlohmann::json::array();
    if (!value.word.empty()) numbers = texts = value.word;
    for (const double x : value.numbers) {
        numbers.push_back(x);
        texts.push_back(number_to_text(x));
    }
    for (const nlohmann::json& list : {numbers, texts}) {
        const std::string line = nlohmann::json{{"id", id}, {"value", list}}.dump();
        fuzz::claim_same(answer_from_json(line, id), value, line);
    }
}

void check_answer(const Answer& answer, const std::string& id, const Vector* v) {
    fuzz::claim_answer(answer);
    if (const auto* value = std::get_if<Value>(&answer)) check_in_both_dialects(*value, id);
    if (v == nullptr) return;
    const Judged judged = grade(*v, answer);
    if (!judged.reason.empty()) fuzz::claim_message(judged.reason);
    fuzz::claim(!judged.error || *judged.error >= 0, "an error is a size", all_members(*v));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view text = fuzz::text_of(data, size);
    const nlohmann::json object = json_or_nothing(fuzz::first_line(text));
    ProtocolQuestion q;
    if (fuzz::answers([&] { q = question_from_json(object); })) {
        check_again(question_from_json, q);
        fuzz::answers([&] { static_cast<void>(scene_of(q)); });
    }
    Vector v;
    const bool known = fuzz::answers([&] { v = vector_from_json(object); });
    if (known) {
        check_again(vector_from_json, v);
        check_plain_question(v.question);
    }
    const std::string id = known ? v.question.id : "a-1";
    for (const Answer& answer : {answer_from_json(text, id), answer_from_plain(text, id), answer_from_cell(text)})
        check_answer(answer, id, known ? &v : nullptr);
    return 0;
}

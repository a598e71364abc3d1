/// @file
/// @brief What an implementation under test answers, from the lines that it writes.
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "conformance/question.hpp"
#include "denhartog/number/legible.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/json_document.hpp"

namespace denhartog::conformance {
namespace {

// A number as an answer writes it: decimal or hexadecimal, nothing after it.
std::optional<double> finite_number(std::string_view text) {
    const std::string copy(text);
    if (copy.empty() || copy.front() == ' ') return std::nullopt;
    char* end = nullptr;
    const double x = std::strtod(copy.c_str(), &end);
    if (end != copy.c_str() + copy.size() || !std::isfinite(x)) return std::nullopt;
    return x;
}

bool is_regime(std::string_view text) { return text == "continuous" || text == "stick_slip" || text == "permanent_sticking"; }

std::string in_quotes(std::string_view text) {
    constexpr std::size_t most = 60;
    return "'" + legible(text, most) + "'";
}

// As it stands, whatever bytes its strings hold.
std::string as_text(const nlohmann::json& x) { return x.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace); }

Answer value_of_words(const std::vector<std::string>& words) {
    Value value;
    if (words.size() == 1 && is_regime(words.front())) {
        value.word = words.front();
        return value;
    }
    for (const std::string& word : words) {
        const std::optional<double> x = finite_number(word);
        if (!x) return Unusable{in_quotes(word) + " is neither a finite number nor a regime"};
        value.numbers.push_back(*x);
    }
    return value;
}

std::vector<std::string> words_of(std::string_view text) {
    std::istringstream stream{std::string(text)};
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

// A member of an answer's value: a JSON number, or a text that holds one or a regime.
std::optional<std::string> word_of(const nlohmann::json& x) {
    if (x.is_string()) return x.get<std::string>();
    if (x.is_number()) return number_to_text(x.get<double>());
    return std::nullopt;
}

} // namespace

Answer answer_from_json(std::string_view line, std::string_view id) {
    if (nested_too_deeply(line)) return Unusable{in_quotes(line) + " is nested too deeply"};
    const nlohmann::json object = json_or_nothing(line);
    if (!object.is_object()) return Unusable{in_quotes(line) + " is no JSON object"};
    const auto text = [&](const char* key) {
        return object[key].is_string() ? object[key].get<std::string>() : as_text(object[key]);
    };
    if (!object.contains("id")) return Unusable{"the answer has no id"};
    if (text("id") != id) return Unusable{"the answer is to " + in_quotes(text("id")) + ", the question was " + std::string(id)};
    if (object.contains("skip")) return Skipped{text("skip")};
    if (object.contains("reject")) return Rejected{text("reject")};
    if (!object.contains("value")) return Unusable{"the answer has neither value nor reject nor skip"};
    const nlohmann::json& value = object["value"];
    std::vector<std::string> words;
    for (const nlohmann::json& x : value.is_array() ? value : nlohmann::json::array({value})) {
        const std::optional<std::string> word = word_of(x);
        if (!word) return Unusable{in_quotes(as_text(x)) + " is no number"};
        words.push_back(*word);
    }
    return value_of_words(words);
}

Answer answer_from_plain(std::string_view line, std::string_view id) {
    const std::vector<std::string> words = words_of(line);
    if (words.empty()) return Unusable{"the answer is an empty line"};
    if (words.front() != id)
        return Unusable{"the answer is to " + in_quotes(words.front()) + ", the question was " + std::string(id)};
    if (words.size() < 2) return Unusable{"the answer has neither value nor reject nor skip"};
    std::string rest;
    for (std::size_t n = 2; n < words.size(); ++n) rest += (n > 2 ? " " : "") + words[n];
    if (words[1] == "skip") return Skipped{rest};
    if (words[1] == "reject") return Rejected{rest};
    if (words[1] != "value") return Unusable{in_quotes(words[1]) + " is neither value nor reject nor skip"};
    return value_of_words({words.begin() + 2, words.end()});
}

Answer answer_from_cell(std::string_view text) {
    const std::vector<std::string> words = words_of(text);
    if (words.empty()) return Skipped{"no answer"};
    if (words.front() == "skip") return Skipped{"skip"};
    if (words.front() == "reject") return Rejected{"reject"};
    return value_of_words(words);
}

} // namespace denhartog::conformance

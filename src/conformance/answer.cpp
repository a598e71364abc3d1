// Reads an answer of an implementation under test: from a line of its own dialect, JSON or plain, or from a file of answers, CSV
// or lines of JSON. Text that is no answer becomes `Unusable` with the reason. Read `answer_from_json` first, then `answers_in`.
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "conformance/question.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/legible.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/json_document.hpp"

namespace denhartog::conformance {
namespace {

std::string in_quotes(std::string_view text) {
    constexpr std::size_t most = 60;
    return "'" + legible(text, most) + "'";
}

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

bool is_regime(std::string_view word) { return word == "continuous" || word == "stick_slip" || word == "permanent_sticking"; }

std::optional<double> finite_number(std::string_view text) {
    const std::string copy(text);
    if (copy.empty() || copy.front() == ' ') return std::nullopt;
    char* end = nullptr;
    const double x = std::strtod(copy.c_str(), &end);
    if (end != copy.c_str() + copy.size() || !std::isfinite(x)) return std::nullopt;
    return x;
}

std::string joined(std::span<const std::string> words, std::string_view between) {
    std::string text;
    for (const std::string& word : words) text.append(text.empty() ? "" : between).append(word);
    return text;
}

std::string joined(std::span<const double> numbers, std::string_view between) {
    std::vector<std::string> words;
    for (const double x : numbers) words.push_back(number_to_text(x));
    return joined(words, between);
}

std::string text_of_json(const nlohmann::json& x) { return x.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace); }

Answer answer_from_json(std::string_view line, std::string_view id) {
    if (nested_too_deeply(line)) return Unusable{in_quotes(line) + " is nested too deeply"};
    const nlohmann::json object = json_or_nothing(line);
    if (!object.is_object()) return Unusable{in_quotes(line) + " is no JSON object"};
    const auto text = [&](const char* key) {
        return object[key].is_string() ? object[key].get<std::string>() : text_of_json(object[key]);
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
        if (!word) return Unusable{in_quotes(text_of_json(x)) + " is no number"};
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
    const std::string rest = joined(std::span(words).subspan(2));
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

namespace {

struct Row {
    std::vector<std::string> cells;
    std::size_t line = 1;
};

std::string place(std::size_t line) { return "line " + std::to_string(line); }

// CSV as RFC 4180 has it: quotes round a cell, doubled within.
std::vector<Row> rows_of(std::string_view text) {
    std::vector<Row> rows;
    std::size_t line = 1;
    for (std::size_t n = 0; n < text.size();) {
        Row row{{""}, line};
        bool quoted = false;
        for (; n < text.size(); ++n) {
            const char c = text[n];
            if (c == '\n') ++line;
            if (quoted && c == '"' && n + 1 < text.size() && text[n + 1] == '"') {
                row.cells.back() += '"';
                ++n;
            } else if (c == '"' && (quoted || row.cells.back().empty())) {
                quoted = !quoted;
            } else if (!quoted && c == ',') {
                row.cells.emplace_back();
            } else if (!quoted && c == '\n') {
                ++n;
                break;
            } else {
                row.cells.back() += c;
            }
        }
        if (quoted) throw InputError("answers", "must end every quoted cell", "", place(row.line));
        if (!row.cells.back().empty() && row.cells.back().back() == '\r') row.cells.back().pop_back();
        if (row.cells.size() > 1 || !row.cells.front().empty()) rows.push_back(std::move(row));
    }
    return rows;
}

void put(std::map<std::string, Answer>& answers, const std::set<std::string>& known, const std::string& id, Answer answer,
         std::size_t line) {
    if (!known.contains(id)) throw InputError("id", "must be a vector's", legible(id), place(line));
    if (!answers.emplace(id, std::move(answer)).second) throw InputError("id", "must be given once", id, place(line));
}

std::map<std::string, Answer> from_csv(std::string_view text, const std::set<std::string>& known) {
    const std::vector<Row> rows = rows_of(text);
    if (rows.empty() || rows.front().cells != std::vector<std::string>{"id", "value"})
        throw InputError("answers", "must be JSON Lines, or CSV with the heading id,value",
                         rows.empty() ? "empty" : legible(rows.front().cells.front()), place(1));
    std::map<std::string, Answer> answers;
    for (std::size_t n = 1; n < rows.size(); ++n) {
        const Row& row = rows[n];
        if (row.cells.size() != 2)
            throw InputError("answers", "must have two cells a line, numbers separated by spaces",
                             std::to_string(row.cells.size()) + " cells", place(row.line));
        put(answers, known, row.cells[0], answer_from_cell(row.cells[1]), row.line);
    }
    return answers;
}

std::map<std::string, Answer> from_json_lines(std::string_view text, const std::set<std::string>& known) {
    std::map<std::string, Answer> answers;
    std::size_t line = 1;
    for (std::size_t start = 0; start < text.size(); ++line) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        const std::string_view one = text.substr(start, end - start);
        start = end + 1;
        if (one.find_first_not_of(" \t\r") == std::string_view::npos) continue;
        const nlohmann::json object = json_or_nothing(one);
        if (!object.is_object() || !object.contains("id") || !object["id"].is_string())
            throw InputError("answers", "must hold a JSON object with an id in every line", legible(one), place(line));
        const std::string id = object["id"];
        put(answers, known, id, answer_from_json(one, id), line);
    }
    return answers;
}

} // namespace

std::map<std::string, Answer> answers_in(std::string_view text, const std::set<std::string>& known) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    refuse_zero_byte("answers", text);
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && text[first] == '{' ? from_json_lines(text, known) : from_csv(text, known);
}

} // namespace denhartog::conformance

#include "conformance/question.hpp"

#include <nlohmann/json.hpp>
#include <vector>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/legible.hpp"
#include "denhartog/scene/json_document.hpp"

namespace denhartog::conformance {
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

#include "tests/unit/program_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "tests/catch.hpp"

namespace denhartog::tests {
namespace {

using Json = nlohmann::ordered_json;

std::string trimmed(const std::string& text, const char* of = " ") {
    const std::size_t from = text.find_first_not_of(of);
    return from == std::string::npos ? "" : text.substr(from, text.find_last_not_of(of) + 1 - from);
}

// The texts with each alternative in the place of the first `{a|b}`, and what was taken.
std::vector<std::pair<std::string, std::string>> alternatives_of(const std::string& text) {
    const std::size_t from = text.find('{'), to = text.find('}', from);
    if (to == std::string::npos) return {{text, ""}};
    std::vector<std::pair<std::string, std::string>> all;
    std::istringstream parts(text.substr(from + 1, to - from - 1) + "|");
    for (std::string part; std::getline(parts, part, '|');)
        for (const auto& [rest, taken] : alternatives_of(text.substr(to + 1)))
            all.emplace_back(text.substr(0, from) + part + rest, taken.empty() ? part : taken);
    return all;
}

// True if the printed text fits a pattern, which may be a rule.
bool follows(const std::string& rule, const Json& found) {
    const std::size_t space = rule.find(' ');
    const std::string word = rule.substr(0, space), rest = space == std::string::npos ? "" : rule.substr(space + 1);
    if (word == "keys") {
        std::string keys;
        for (const auto& item : found.items()) keys += (keys.empty() ? "" : " ") + item.key();
        return keys == rest;
    }
    if (word == "#") return found.size() == std::stoul(rest);
    if (word == "longer") return found.is_string() && found.get<std::string>().size() > std::stoul(rest);
    if (word == "has") return found.is_string() && found.get<std::string>().find(rest) != std::string::npos;
    if (rule == "text") return found.is_string();
    if (word == "~" || word == ">" || word == ">=" || word == "<" || rule == "number") {
        if (!found.is_number()) return false;
        const auto x = found.get<double>();
        std::istringstream numbers(rest);
        double limit = 0, near = 0;
        if (numbers >> limit; word == ">" || word == ">=" || word == "<")
            return word == "<" ? x < limit : word == ">" ? x > limit : x >= limit;
        return rule == "number" || (numbers >> near && std::abs(x - limit) <= near * std::abs(limit));
    }
    return found == rule;
}

// Faults of the printed text. If claims are counted, each is an assertion of its own.
struct Faults {
    std::vector<std::string> all{};
    bool counted = false;
    void unless(bool right, const std::string& claim) {
        if (!right) all.push_back(claim);
        if (right && counted) CHECK(right);
    }
};

void compare(const Json& pattern, const Json& found, const std::string& place, Faults& faults) {
    const std::string claim = place + " must be " + pattern.dump() + ", but is " + found.dump().substr(0, 2000);
    if (pattern.is_string()) return faults.unless(follows(pattern.get<std::string>(), found), claim);
    if (!pattern.is_object()) return faults.unless(found == pattern, claim);
    for (const auto& [key, part] : pattern.items()) {
        const std::string below = place + "/" + key;
        const bool number = key.find_first_not_of("0123456789") == std::string::npos;
        if (key == "*") {
            faults.unless(!found.empty(), claim);
            for (const auto& item : found.items()) compare(part, item.value(), place + "/" + item.key(), faults);
        } else if (found.is_array() && number && std::stoul(key) < found.size()) {
            compare(part, found[std::stoul(key)], below, faults);
        } else if (part.is_null() || !found.contains(key)) {
            faults.unless(part.is_null() && found.is_object() && !found.contains(key), claim);
        } else {
            compare(part, found[key], below, faults);
        }
    }
}

// A row of a table.
struct Row {
    int status = 0;
    std::string arguments, input;
    bool several = false;                              ///< scenes
    std::vector<std::pair<char, std::string>> texts{}; ///< of the output, after `>`, and of the error, after `!`
    std::vector<std::pair<char, std::string>> below{}; ///< lines below the row: `=` a pattern, `|` a line of the output
};

Row row_of(std::string line, const std::string& begin) {
    Row row;
    for (std::size_t at; (at = std::max(line.rfind(" > ") + 1, line.rfind(" ! ") + 1)) > 0; line.erase(at - 1))
        row.texts.emplace_back(line[at], trimmed(line.substr(at + 1)));
    if (const std::size_t at = line.find(" << "); at != std::string::npos) {
        row.input = line.substr(at + 4);
        line.erase(at);
    } else if (const std::size_t scene = line.find(" < "); scene != std::string::npos) {
        row.input = scene_text(line.substr(scene + 3));
        row.several = line.find(" + ", scene) != std::string::npos;
        line.erase(scene);
    }
    std::size_t used = 0;
    row.status = std::stoi(line, &used);
    row.arguments = trimmed(begin + " " + trimmed(line.substr(used)));
    return row;
}

void check_error(const std::string& error, Faults& faults) {
    const auto printable = [](char c) { return c == '\n' || (c >= ' ' && c != '\x7F'); };
    faults.unless(lines_of(error).size() == 1 && error.size() < 2000, "the error must be one line of less than 2000 characters");
    faults.unless(error.starts_with("denhartog: "), "the error must begin with denhartog: ");
    faults.unless(std::ranges::all_of(error, printable), "the error must be printable");
}

void check_row(const Row& row, const std::string& arguments, const std::string& taken, Faults& faults) {
    const Run run = run_program(arguments, row.input);
    const std::size_t before = faults.all.size();
    faults.unless(run.status == row.status, "the status must be " + std::to_string(row.status));
    bool error = row.status != 0;
    if (error) check_error(run.error, faults);
    if (error && !row.several) faults.unless(run.output.empty(), "the output must be empty");
    for (auto [where, text] : row.texts) {
        if (const std::size_t at = text.find("{}"); at != std::string::npos) text.replace(at, 2, taken);
        faults.unless((where == '>' ? run.output : run.error).find(text) != std::string::npos,
                      std::string(1, where) + " " + text);
        error = error || where == '!';
    }
    if (!error) faults.unless(run.error.empty(), "there must be no error");
    const std::vector<std::string> lines = lines_of(run.output);
    std::size_t next = 0;
    for (const auto& [kind, text] : row.below) {
        if (kind == '=') {
            std::string output = run.output;
            if (row.several) { // a line each
                output = "[" + trimmed(output, "\n") + "]";
                std::ranges::replace(output, '\n', ',');
            }
            const Json found = Json::parse(output, nullptr, false);
            faults.unless(!found.is_discarded(), "the output must be JSON");
            if (!found.is_discarded()) compare(Json::parse(text), found, "", faults);
        } else if (text.starts_with("# ")) {
            faults.unless(lines.size() == std::stoul(text.substr(2)), "the output must have " + text.substr(2) + " lines");
        } else {
            faults.unless(next < lines.size() && lines[next] == text, "the output must have the line " + text);
            ++next;
        }
    }
    for (std::size_t n = before; n < faults.all.size(); ++n)
        faults.all[n] = arguments + " of " + row.input.substr(0, 1000) + ": " + faults.all[n] + "; status " +
                        std::to_string(run.status) + ", " + run.error.substr(0, 2000);
}

} // namespace

std::string scene_text(const std::string& text) {
    std::string input;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t to = std::min(text.find(" + ", from), text.size());
        const std::string one = trimmed(text.substr(from, to - from));
        input += (one.empty() ? "" : text_of_scene(one)) + (to < text.size() || from > 0 ? "\n" : "");
        from = to + 2;
    }
    return input;
}

nlohmann::json answer_of(const std::string& arguments, const std::string& scene) {
    const Run run = run_program(arguments, scene_text(scene));
    INFO(arguments << " of " << scene << ": " << run.error);
    REQUIRE(run.status == 0);
    return nlohmann::json::parse(run.output);
}

void check_refused(const Run& run, int status, const std::string& piece) {
    Faults faults;
    check_error(run.error, faults);
    INFO("status " << run.status << ": " << run.error.substr(0, 2000));
    CHECK(faults.all == std::vector<std::string>());
    CHECK(run.status == status);
    CHECK(run.output.empty());
    CHECK(run.error.find(piece) != std::string::npos);
}

namespace {

Faults checked_rows(const std::string& table, const std::string& begin, bool counted) {
    std::vector<std::string> lines;
    for (const std::string& line : lines_of(table))
        if (const std::string text = trimmed(line); !text.empty() && std::strchr("0123456789=|", text[0]) != nullptr)
            lines.push_back(text);
        else if (!text.empty())
            lines.at(lines.size() - 1) += " " + text;
    std::vector<Row> rows;
    for (const std::string& line : lines)
        if (line[0] == '=' || line[0] == '|')
            rows.at(rows.size() - 1).below.emplace_back(line[0], trimmed(line.substr(1)));
        else
            rows.push_back(row_of(line, begin));
    if (rows.empty()) throw std::logic_error("a table must have a row");
    Faults faults{{}, counted};
    for (const Row& row : rows)
        for (const auto& [arguments, taken] : alternatives_of(row.arguments)) check_row(row, arguments, taken, faults);
    return faults;
}

} // namespace

std::vector<std::string> faults_of(const std::string& table, const std::string& begin) {
    return checked_rows(table, begin, false).all;
}

void expect(const std::string& table, const std::string& begin) {
    CHECK(checked_rows(table, begin, true).all == std::vector<std::string>());
}

} // namespace denhartog::tests

#include "tests/unit/program_table.hpp"

#include <algorithm>
#include <cmath>

#include "tests/catch.hpp"

namespace denhartog::tests {
namespace {

using Json = nlohmann::ordered_json;

std::string trimmed(const std::string& text) {
    const std::size_t from = text.find_first_not_of(' ');
    return from == std::string::npos ? "" : text.substr(from, text.find_last_not_of(' ') + 1 - from);
}

Json named_scene(const std::string& name) {
    static const std::vector<std::string> lines = lines_of(content_of(source_file("tests/named_scenes.jsonl")));
    for (const std::string& line : lines)
        if (Json scene = Json::parse(line); scene.at("name") == name) {
            scene.erase("name");
            scene.erase("why");
            return scene;
        }
    throw std::logic_error("no scene has the name " + name);
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

// Whether what was printed is what a text of a pattern says, which may be a rule.
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

void check_pattern(const Json& pattern, const Json& found, const std::string& place) {
    INFO(place << " must be " << pattern << ", but is " << found.dump().substr(0, 2000));
    if (pattern.is_object()) {
        for (const auto& [key, part] : pattern.items()) {
            const bool in_list = found.is_array() && key.find_first_not_of("0123456789") == std::string::npos;
            const std::string below = place + "/" + key;
            INFO(below);
            if (key == "*") {
                CHECK(!found.empty());
                for (const auto& item : found.items()) check_pattern(part, item.value(), place + "/" + item.key());
            } else if (part.is_null()) {
                CHECK_FALSE(found.contains(key));
            } else if (in_list) {
                REQUIRE(std::stoul(key) < found.size());
                check_pattern(part, found[std::stoul(key)], below);
            } else {
                REQUIRE(found.contains(key));
                check_pattern(part, found[key], below);
            }
        }
    } else if (pattern.is_string()) {
        CHECK(follows(pattern.get<std::string>(), found));
    } else {
        CHECK(found == pattern);
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

void check_error(const std::string& error) {
    CHECK(lines_of(error).size() == 1);
    CHECK(error.size() < 2000);
    CHECK(error.starts_with("denhartog: "));
    CHECK(std::ranges::all_of(error, [](char c) { return c == '\n' || (c >= ' ' && c != '\x7F'); }));
}

void check_row(const Row& row, const std::string& arguments, const std::string& taken) {
    const Run run = run_program(arguments, row.input);
    INFO(arguments << " of " << row.input.substr(0, 1000) << ": status " << run.status << ", " << run.error.substr(0, 2000));
    CHECK(run.status == row.status);
    bool error = row.status != 0;
    if (error) {
        check_error(run.error);
        if (!row.several) CHECK(run.output.empty());
    }
    for (auto [where, text] : row.texts) {
        if (const std::size_t at = text.find("{}"); at != std::string::npos) text.replace(at, 2, taken);
        INFO(where << " " << text);
        const std::string& printed = where == '>' ? run.output : run.error;
        CHECK(printed.find(text) != std::string::npos);
        error = error || where == '!';
    }
    if (!error) CHECK(run.error.empty());
    const std::vector<std::string> lines = lines_of(run.output);
    Json found = Json::array();
    std::size_t next = 0;
    for (const auto& [kind, text] : row.below) {
        if (kind == '=' && found.empty()) {
            if (!row.several) found = Json::parse(run.output);
            for (const std::string& line : row.several ? lines : std::vector<std::string>()) found.push_back(Json::parse(line));
        }
        if (kind == '=') {
            check_pattern(Json::parse(text), found, "");
        } else if (text.starts_with("# ")) {
            CHECK(lines.size() == std::stoul(text.substr(2)));
        } else {
            REQUIRE(next < lines.size());
            CHECK(lines[next++] == text);
        }
    }
}

} // namespace

std::string scene_text(const std::string& text) {
    std::string input;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t to = std::min(text.find(" + ", from), text.size());
        const std::string one = trimmed(text.substr(from, to - from));
        const std::size_t patch = std::min(one.find('{'), one.size());
        Json scene = one.empty() ? Json() : named_scene(trimmed(one.substr(0, patch)));
        if (patch < one.size()) scene.merge_patch(Json::parse(one.substr(patch)));
        input += (one.empty() ? "" : scene.dump()) + (to < text.size() || from > 0 ? "\n" : "");
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
    INFO("status " << run.status << ": " << run.error.substr(0, 2000));
    CHECK(run.status == status);
    CHECK(run.output.empty());
    check_error(run.error);
    CHECK(run.error.find(piece) != std::string::npos);
}

void expect(const std::string& table, const std::string& begin) {
    std::vector<Row> rows;
    for (const std::string& line : lines_of(table)) {
        const std::string text = trimmed(line);
        if (text.empty()) continue;
        if (text[0] == '=' || text[0] == '|')
            rows.at(rows.size() - 1).below.emplace_back(text[0], trimmed(text.substr(1)));
        else
            rows.push_back(row_of(text, begin));
    }
    REQUIRE(!rows.empty());
    for (const Row& row : rows)
        for (const auto& [arguments, taken] : alternatives_of(row.arguments)) check_row(row, arguments, taken);
}

} // namespace denhartog::tests

#include "derivation/ledger/test_index.hpp"

#include <cstdlib>
#include <map>

#include "denhartog/ledger/ledger_entry.hpp"
#include "derivation/ledger/source_text.hpp"

namespace denhartog::derivation {

namespace {

std::vector<std::string> equations_of_tags(const std::string& tags) {
    std::vector<std::string> equations;
    for (std::size_t at = tags.find("[eq:"); at != std::string::npos; at = tags.find("[eq:", at + 1)) {
        const std::size_t close = tags.find(']', at);
        if (close == std::string::npos) break;
        const std::string item = tags.substr(at + 4, close - at - 4);
        equations.push_back(ledger::equation_number(item).value_or(item));
    }
    return equations;
}

std::string without_entities(const std::string& text) {
    static const std::map<std::string, std::string> entities = {
        {"amp", "&"}, {"lt", "<"}, {"gt", ">"}, {"quot", "\""}, {"apos", "'"}};
    std::string plain;
    for (std::size_t n = 0; n < text.size(); ++n) {
        const std::size_t end = text[n] == '&' ? text.find(';', n) : std::string::npos;
        if (end == std::string::npos) {
            plain += text[n];
            continue;
        }
        const std::string name = text.substr(n + 1, end - n - 1);
        const auto known = entities.find(name);
        if (known != entities.end())
            plain += known->second;
        else if (name.starts_with("#")) {
            const bool hexadecimal = name.starts_with("#x");
            plain += static_cast<char>(std::strtol(name.c_str() + (hexadecimal ? 2 : 1), nullptr, hexadecimal ? 16 : 10));
        } else {
            plain += text[n];
            continue;
        }
        n = end;
    }
    return plain;
}

/// An element's tag: its name and its attributes.
struct Tag {
    std::string name; ///< with its slash where it ends an element
    std::map<std::string, std::string> attributes;
};

/// The tag that starts at a `<`; moves behind its `>`.
Tag tag_at(const std::string& xml, std::size_t& at) {
    Tag tag;
    const auto until = [&](const std::string& stops) {
        const std::size_t end = std::min(xml.find_first_of(stops, at), xml.size());
        const std::string text = xml.substr(at, end - at);
        at = end;
        return text;
    };
    ++at;
    if (at < xml.size() && xml[at] == '/') ++at, tag.name = "/";
    tag.name += until(" \t\r\n/>");
    while (at < xml.size() && xml[at] != '>') {
        at = std::min(xml.find_first_not_of(" \t\r\n/?", at), xml.size());
        if (at >= xml.size() || xml[at] == '>') break;
        const std::string key = until("= \t\r\n>");
        at = std::min(xml.find_first_not_of("= \t\r\n", at), xml.size());
        if (at >= xml.size() || (xml[at] != '"' && xml[at] != '\'')) continue;
        const std::string quote(1, xml[at++]);
        tag.attributes[key] = without_entities(until(quote));
        if (at < xml.size()) ++at;
    }
    if (at < xml.size()) ++at;
    return tag;
}

} // namespace

std::vector<DeclaredTest> tests_of_source(const std::string& source, const std::string& file) {
    std::vector<DeclaredTest> tests;
    const std::vector<Piece> pieces = pieces_of(source);
    for (std::size_t n = 0; n < pieces.size(); ++n) {
        if (pieces[n].sort != Piece::Sort::code) continue;
        const std::size_t last = pieces[n].text.find_last_not_of(" \t\r\n");
        if (last == std::string::npos || pieces[n].text[last] != '(') continue;
        const std::string before = pieces[n].text.substr(0, last);
        if (!before.ends_with("TEST_CASE") && !before.ends_with("SCENARIO")) continue;
        DeclaredTest test{"", {}, file, 0};
        std::string tags;
        std::string* part = &test.name;
        for (++n; n < pieces.size(); ++n) {
            const Piece& piece = pieces[n];
            if (piece.sort == Piece::Sort::literal) {
                if (test.line == 0) test.line = piece.line;
                *part += piece.text;
            } else if (piece.sort == Piece::Sort::code) {
                if (piece.text.find(',') != std::string::npos) part = &tags;
                if (piece.text.find(')') != std::string::npos) break;
            }
        }
        test.equations = equations_of_tags(tags);
        if (!test.equations.empty()) tests.push_back(test);
        if (n < pieces.size()) --n; // the closing piece may open the next test
    }
    return tests;
}

std::vector<DeclaredTest> tests_of_sources(const std::filesystem::path& tests_root) {
    std::vector<DeclaredTest> tests;
    for (const std::filesystem::path& file : files_in(tests_root, ".cpp")) {
        const std::vector<DeclaredTest> found =
            tests_of_source(text_of(file), file.lexically_relative(tests_root).generic_string());
        tests.insert(tests.end(), found.begin(), found.end());
    }
    return tests;
}

std::vector<TestRun> runs_of_xml(const std::string& xml) {
    std::vector<TestRun> runs;
    bool open = false;
    for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at)) {
        const Tag tag = tag_at(xml, at);
        const auto attribute = [&](const char* key) {
            const auto found = tag.attributes.find(key);
            return found == tag.attributes.end() ? std::string() : found->second;
        };
        if (tag.name == "TestCase") {
            runs.push_back({attribute("name"), equations_of_tags(attribute("tags")), false});
            open = true;
        } else if (tag.name == "OverallResult" && open) {
            runs.back().passed = attribute("success") == "true";
        } else if (tag.name == "/TestCase") {
            open = false;
        }
    }
    std::erase_if(runs, [](const TestRun& run) { return run.equations.empty(); });
    return runs;
}

TestResults read_test_results(const std::filesystem::path& results) {
    TestResults all;
    for (const std::filesystem::path& file : files_in(results, ".xml")) {
        all.found = true;
        const std::vector<TestRun> runs = runs_of_xml(text_of(file));
        all.runs.insert(all.runs.end(), runs.begin(), runs.end());
    }
    return all;
}

} // namespace denhartog::derivation

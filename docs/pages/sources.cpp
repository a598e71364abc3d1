#include "sources.hpp"

#include <algorithm>
#include <sstream>

#include "denhartog/number/errors.hpp"
#include "derivation/ledger/source_text.hpp"
#include "derivation/ledger/test_index.hpp"
#include "text.hpp"

namespace denhartog::pages {

namespace fs = std::filesystem;

namespace {

std::string trimmed(const std::string& line) {
    const std::size_t first = line.find_first_not_of(" \t");
    return first == std::string::npos ? "" : line.substr(first, line.find_last_not_of(" \t") - first + 1);
}

bool ends_a_statement(const std::string& line) {
    const std::string text = trimmed(line);
    return text.empty() || text.starts_with("//") || text.starts_with("#") || text.ends_with(";") || text.ends_with("{") ||
           text.ends_with("}");
}

/// Whether a word stands in a line by itself.
bool has_word(const std::string& line, const std::string& word) {
    const auto is_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
    for (std::size_t at = line.find(word); at != std::string::npos; at = line.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || !is_word(line[at - 1])) && (end == line.size() || !is_word(line[end]))) return true;
    }
    return false;
}

/// A line of a snippet, comments and keywords marked as Doxygen marks them.
std::string marked(const std::string& line) {
    static const std::vector<std::string> keywords = {"template", "class",    "struct", "return",
                                                      "const",    "typename", "inline", "requires"};
    const std::size_t comment = line.find("//");
    std::string code = html(line.substr(0, comment));
    std::string out;
    for (std::size_t at = 0; at < code.size();) {
        std::size_t end = at;
        while (end < code.size() && (std::isalnum(static_cast<unsigned char>(code[end])) || code[end] == '_')) ++end;
        const std::string word = code.substr(at, std::max<std::size_t>(end - at, 1));
        const bool keyword = std::find(keywords.begin(), keywords.end(), word) != keywords.end();
        out += keyword ? "<span class=\"keyword\">" + word + "</span>" : word;
        at += word.size();
    }
    if (comment != std::string::npos) out += "<span class=\"comment\">" + html(line.substr(comment)) + "</span>";
    return out;
}

} // namespace

Sources::Sources(fs::path root) : root_(std::move(root)) {
    for (const fs::path& file : derivation::files_in(root_ / "derivation", ".cpp")) {
        const std::string name = file.lexically_relative(root_).generic_string();
        std::string before;
        for (const derivation::Piece& piece : derivation::pieces_of(derivation::text_of(file))) {
            if (piece.sort == derivation::Piece::Sort::literal) {
                const Place place{name, piece.line};
                if (piece.text.find('/') == std::string::npos)
                    lines_of_.try_emplace(name + ":" + piece.text, piece.line);
                else
                    (before.ends_with(".id =") ? makers_ : literals_).try_emplace(piece.text, place);
            }
            before = piece.sort == derivation::Piece::Sort::code ? trimmed(piece.text) : "";
        }
    }
    for (const derivation::DeclaredTest& test : derivation::tests_of_sources(root_ / "tests"))
        tests_.try_emplace(test.name, Place{"tests/" + test.file, test.line});
}

const std::vector<std::string>& Sources::lines(const std::string& file) const {
    const auto [place, fresh] = files_.try_emplace(file);
    if (fresh) {
        std::istringstream in(derivation::text_of(root_ / file));
        for (std::string line; std::getline(in, line);) place->second.push_back(line);
    }
    return place->second;
}

Snippet Sources::snippet(const std::string& name, const Place& at) const {
    const std::vector<std::string>& all = lines(at.file);
    const std::string place = at.file + ":" + std::to_string(at.line);
    const std::size_t colons = name.rfind("::");
    const std::string word = colons == std::string::npos ? name : name.substr(colons + 2);
    if (at.line < 1 || static_cast<std::size_t>(at.line) > all.size() ||
        !has_word(all[static_cast<std::size_t>(at.line) - 1], word))
        throw InputError(name, "must stand where the ledger has it; run ./verify paper again", "", place);
    std::size_t first = static_cast<std::size_t>(at.line) - 1;
    while (first > 0 && !ends_a_statement(all[first - 1])) --first;
    Snippet snippet{at.file, static_cast<int>(first) + 1, {}, 0};
    int depth = 0;
    for (std::size_t i = first; i < all.size(); ++i) {
        snippet.lines.push_back(all[i]);
        bool closed = false;
        for (const char c : all[i].substr(0, all[i].find("//"))) {
            if (c == '{' && depth++ == 0 && snippet.signature == 0) snippet.signature = snippet.lines.size();
            if (c == '}') closed = --depth == 0;
            if (c == ';' && depth == 0) closed = true;
        }
        if (closed) break;
    }
    if (snippet.signature == 0) snippet.signature = snippet.lines.size();
    return snippet;
}

Place Sources::claim(const std::string& id) const {
    for (const std::map<std::string, Place>* places : {&makers_, &literals_}) {
        if (const auto exact = places->find(id); exact != places->end()) return exact->second;
        const std::pair<const std::string, Place>* best = nullptr;
        for (const auto& found : *places) {
            const std::string& text = found.first;
            const bool begins = id.starts_with(text) && (text.ends_with('=') || text.ends_with('/') || id[text.size()] == '/');
            if (begins && (best == nullptr || text.size() > best->first.size())) best = &found;
        }
        if (best == nullptr) continue;
        const auto rest = lines_of_.find(best->second.file + ":" + id.substr(best->first.size()));
        return {best->second.file, rest == lines_of_.end() ? best->second.line : rest->second};
    }
    return {};
}

Place Sources::test(const std::string& name) const {
    const auto exact = tests_.find(name);
    if (exact != tests_.end()) return exact->second;
    const std::size_t dash = name.rfind(" - "); // a test over types
    const auto general = dash == std::string::npos ? tests_.end() : tests_.find(name.substr(0, dash));
    return general == tests_.end() ? Place{} : general->second;
}

std::string code_block(const Snippet& snippet) {
    std::string out = "\\htmlonly[block]\n<div class=\"fragment\" tabindex=\"0\">";
    int line = snippet.first;
    for (const std::string& text : snippet.lines) {
        const std::string number = std::to_string(line);
        out += "<div class=\"line\"><span class=\"lineno\"><a href=\"source:" + snippet.file + ":" + number + "\">" +
               std::string(number.size() < 5 ? 5 - number.size() : 0, ' ') + number + "</a></span>&#160;" + marked(text) +
               "</div>\n";
        ++line;
    }
    return out + "</div>\n\\endhtmlonly\n";
}

} // namespace denhartog::pages

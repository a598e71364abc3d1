#include "derivation/ledger/source_text.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <sstream>

#include "denhartog/number/errors.hpp"

namespace denhartog::derivation {

namespace {

/// A cursor over source that knows its line and collects pieces.
struct Cutter {
    const std::string& source;
    std::size_t at = 0;
    int line = 1;
    std::vector<Piece> pieces = {};
    Piece open = {};

    [[nodiscard]] char next(std::size_t ahead = 0) const { return at + ahead < source.size() ? source[at + ahead] : '\0'; }
    [[nodiscard]] bool at_end() const { return at >= source.size(); }
    char take() {
        const char c = source[at++];
        if (c == '\n') ++line;
        return c;
    }
    void begin(Piece::Sort sort) {
        if (!open.text.empty() || open.sort == Piece::Sort::literal) pieces.push_back(open);
        open = {sort, "", line};
    }
};

void cut_literal(Cutter& c) {
    c.begin(Piece::Sort::literal);
    const char quote = c.take();
    while (!c.at_end() && c.next() != quote) {
        if (c.next() != '\\') {
            c.open.text += c.take();
            continue;
        }
        c.take();
        if (c.at_end()) break;
        const char escape = c.take();
        c.open.text += escape == 'n' ? '\n' : escape == 't' ? '\t' : escape;
    }
    if (!c.at_end()) c.take();
    c.begin(Piece::Sort::code);
}

void cut_raw_literal(Cutter& c) {
    c.begin(Piece::Sort::literal);
    c.take();
    std::string end = ")";
    while (!c.at_end() && c.next() != '(') end += c.take();
    end += '"';
    if (!c.at_end()) c.take();
    while (!c.at_end() && c.source.compare(c.at, end.size(), end) != 0) c.open.text += c.take();
    for (std::size_t n = 0; n < end.size() && !c.at_end(); ++n) c.take();
    c.begin(Piece::Sort::code);
}

void cut_comment(Cutter& c) {
    c.begin(Piece::Sort::comment);
    const bool block = c.next(1) == '*';
    while (!c.at_end() && (block || c.next() != '\n')) {
        c.open.text += c.take();
        if (block && c.open.text.size() > 3 && c.open.text.ends_with("*/")) break;
    }
    c.begin(Piece::Sort::code);
}

bool within_word(const std::string& text) {
    return !text.empty() && (std::isalnum(static_cast<unsigned char>(text.back())) || text.back() == '_');
}

} // namespace

std::vector<Piece> pieces_of(const std::string& source) {
    Cutter c{source};
    c.begin(Piece::Sort::code);
    while (!c.at_end()) {
        const char here = c.next();
        if (here == '/' && (c.next(1) == '/' || c.next(1) == '*'))
            cut_comment(c);
        else if (here == '"' && c.open.text.ends_with('R')) {
            c.open.text.pop_back();
            cut_raw_literal(c);
        } else if (here == '"' || (here == '\'' && !within_word(c.open.text))) { // not the ' of 1'000
            cut_literal(c);
        } else
            c.open.text += c.take();
    }
    c.begin(Piece::Sort::code);
    return c.pieces;
}

std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw InputError("a file", "must be one that can be read", "", file.string());
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder, const std::string& extension) {
    std::vector<std::filesystem::path> files;
    if (!std::filesystem::is_directory(folder)) return files;
    for (const auto& item : std::filesystem::recursive_directory_iterator(folder))
        if (item.is_regular_file() && item.path().extension() == extension) files.push_back(item.path());
    std::sort(files.begin(), files.end());
    return files;
}

} // namespace denhartog::derivation

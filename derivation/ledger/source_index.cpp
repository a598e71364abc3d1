#include "derivation/ledger/source_index.hpp"

#include <algorithm>
#include <cctype>

#include "denhartog/ledger/ledger_entry.hpp"
#include "denhartog/number/errors.hpp"
#include "derivation/ledger/source_text.hpp"

namespace denhartog::derivation {

namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

std::string trimmed(const std::string& text) {
    const char* blanks = " \t\r\n/*";
    const std::size_t first = text.find_first_not_of(blanks);
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// Equations in every `@eq{28,29}` of a doc comment.
std::vector<std::string> equations_of(const std::string& comment, const std::string& place) {
    std::vector<std::string> equations;
    for (std::size_t at = comment.find("@eq{"); at != std::string::npos; at = comment.find("@eq{", at + 1)) {
        const std::size_t close = comment.find('}', at);
        if (close == std::string::npos) throw InputError("@eq{", "must be closed by }", "", place);
        std::string list = comment.substr(at + 4, close - at - 4) + ",";
        for (std::size_t comma = list.find(','); comma != std::string::npos; comma = list.find(',')) {
            const std::string item = trimmed(list.substr(0, comma));
            if (item.empty()) throw InputError("@eq", "must name equations", "@eq{" + list + "}", place);
            equations.push_back(ledger::equation_number(item).value_or(item));
            list.erase(0, comma + 1);
        }
    }
    return equations;
}

/// The last identifier before a place, and where it starts.
std::size_t word_before(const std::string& text, std::size_t end, std::string& word) {
    while (end > 0 && !is_word(text[end - 1])) --end;
    std::size_t first = end;
    while (first > 0 && is_word(text[first - 1])) --first;
    word = text.substr(first, end - first);
    return first;
}

/// A declaration, as far as it has been read.
struct Declaration {
    std::string text;       ///< from the end of the last statement
    std::vector<int> lines; ///< line of each character
    int angle = 0;          ///< depth of template brackets
    int square = 0;         ///< depth of attribute brackets

    void add(char c, int line) {
        text += c;
        lines.push_back(line);
        if (c == '<') ++angle;
        if (c == '>' && angle > 0 && --angle == 0 && find_word("template") != std::string::npos) {
            text.clear(); // the words `class T` of a template's head name nothing
            lines.clear();
        }
        if (c == '[') ++square;
        if (c == ']' && square > 0) --square;
    }
    /// Whether text holds a word of its own, outside of other words.
    [[nodiscard]] std::size_t find_word(const std::string& word) const {
        for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
            const bool starts = at == 0 || !is_word(text[at - 1]);
            const std::size_t end = at + word.size();
            if (starts && (end >= text.size() || !is_word(text[end]))) return at;
        }
        return std::string::npos;
    }
    /// The word that follows a word, `a::b` for namespaces.
    [[nodiscard]] std::string word_after(std::size_t at, const std::string& word) const {
        at += word.size();
        while (at < text.size() && !is_word(text[at])) ++at;
        std::size_t end = at;
        while (end < text.size() && (is_word(text[end]) || text[end] == ':')) ++end;
        std::string found = text.substr(at, end - at);
        while (!found.empty() && found.back() == ':') found.pop_back();
        return found;
    }
};

/// Reads one header from its first character to its last.
class Reader {
public:
    explicit Reader(std::string file) : file_(std::move(file)) {}

    void comment(const Piece& piece) {
        const bool doc = (piece.text.starts_with("///") && !piece.text.starts_with("///<")) ||
                         (piece.text.starts_with("/**") && !piece.text.starts_with("/**<"));
        if (!doc) return;
        doc_ += piece.text + "\n";
        doc_line_ = piece.line;
    }

    void code(const Piece& piece) {
        int line = piece.line;
        for (const char c : piece.text) {
            if (c == '\n') ++line;
            if (c == '(' && declaration_.angle == 0 && declaration_.square == 0) name_function();
            if (c == '{' || c == '}' || c == ';')
                end_of_statement(c);
            else
                declaration_.add(c, line);
        }
    }

    [[nodiscard]] std::vector<FunctionEntry> entries() && {
        close_doc();
        return std::move(entries_);
    }

private:
    void name_function() {
        if (doc_.empty()) return;
        std::string name;
        const std::size_t first = word_before(declaration_.text, declaration_.text.size(), name);
        if (name.empty() || name == "requires") return;
        record(name, declaration_.lines[first]);
    }

    void end_of_statement(char c) {
        if (c == '{') {
            std::string scope;
            for (const std::string word : {"namespace", "struct", "class", "union", "concept"}) {
                const std::size_t at = declaration_.angle == 0 ? declaration_.find_word(word) : std::string::npos;
                if (at == std::string::npos) continue;
                scope = declaration_.word_after(at, word);
                if (word != "namespace" && !doc_.empty() && !scope.empty())
                    record(scope, declaration_.lines[declaration_.text.find(scope, at)]);
                break;
            }
            scopes_.push_back(scope);
        }
        if (c == '}' && !scopes_.empty()) scopes_.pop_back();
        close_doc();
        declaration_ = {};
    }

    void record(const std::string& name, int line) {
        std::string full;
        for (const std::string& scope : scopes_)
            if (!scope.empty()) full += scope + "::";
        for (const std::string& equation : equations_of(doc_, file_ + ":" + std::to_string(doc_line_)))
            entries_.push_back({equation, full + name, file_, line});
        doc_.clear();
    }

    void close_doc() {
        if (doc_.find("@eq{") != std::string::npos)
            throw InputError("@eq", "must belong to a function or a type", "", file_ + ":" + std::to_string(doc_line_));
        doc_.clear();
    }

    std::string file_;
    std::string doc_;
    int doc_line_ = 0;
    Declaration declaration_;
    std::vector<std::string> scopes_;
    std::vector<FunctionEntry> entries_;
};

} // namespace

std::vector<FunctionEntry> functions_of_header(const std::string& source, const std::string& file) {
    Reader reader(file);
    for (const Piece& piece : pieces_of(source)) {
        if (piece.sort == Piece::Sort::comment) reader.comment(piece);
        if (piece.sort == Piece::Sort::code) reader.code(piece);
    }
    return std::move(reader).entries();
}

std::vector<FunctionEntry> functions_of_sources(const std::filesystem::path& source_root) {
    const std::vector<std::filesystem::path> headers = files_in(source_root / "denhartog", ".hpp");
    if (headers.empty()) throw InputError("the source root", "must hold headers under denhartog/", source_root.string());
    const std::filesystem::path above = std::filesystem::absolute(source_root).lexically_normal() / "..";
    std::vector<FunctionEntry> entries;
    for (const std::filesystem::path& header : headers) {
        const std::string file =
            std::filesystem::absolute(header).lexically_normal().lexically_relative(above.lexically_normal()).generic_string();
        const std::vector<FunctionEntry> found = functions_of_header(text_of(header), file);
        entries.insert(entries.end(), found.begin(), found.end());
    }
    return entries;
}

bool is_formula(const FunctionEntry& function) {
    return function.name.find("::paper::") != std::string::npos || function.name.find("::evaluation::") != std::string::npos;
}

bool is_as_printed(const FunctionEntry& function) { return function.name.find("::as_printed::") != std::string::npos; }

} // namespace denhartog::derivation

// The notation page has every symbol that the formulas take, and no name that the code does not know.
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>

#include "derivation/ledger/source_text.hpp"
#include "tests/catch.hpp"

using denhartog::derivation::text_of;

namespace {

std::filesystem::path root() {
    const char* source = std::getenv("DENHARTOG_SOURCE_DIR");
    REQUIRE(source != nullptr);
    return source;
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

std::set<std::string> words_of(const std::string& text) {
    std::set<std::string> words;
    std::string word;
    for (const char c : text + " ") {
        if (is_word(c)) {
            word += c;
            continue;
        }
        if (!word.empty()) words.insert(word);
        word.clear();
    }
    return words;
}

/// Names in the column `code` of the tables of the page.
std::set<std::string> noted(const std::string& page) {
    std::istringstream lines(page);
    std::set<std::string> names;
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("| ", 0) != 0) continue;
        const std::size_t first = line.find('|', 1);
        const std::size_t last = line.find('|', first + 1);
        if (last == std::string::npos) continue;
        const std::string cell = line.substr(first + 1, last - first - 1);
        for (std::size_t open = cell.find('`'); open != std::string::npos;) {
            const std::size_t close = cell.find('`', open + 1);
            REQUIRE(close != std::string::npos);
            names.merge(words_of(cell.substr(open + 1, close - open - 1)));
            open = cell.find('`', close + 1);
        }
    }
    return names;
}

std::set<std::string> parameters_of(const std::string& header) {
    const std::string tag = "@param ";
    std::set<std::string> names;
    for (std::size_t at = header.find(tag); at != std::string::npos; at = header.find(tag, at + 1)) {
        std::size_t from = at + tag.size();
        while (header[from] == ' ') ++from;
        std::size_t to = from;
        while (is_word(header[to])) ++to;
        names.insert(header.substr(from, to - from));
    }
    return names;
}

} // namespace

TEST_CASE("every symbol that a formula takes stands in the notation", "[documentation]") {
    const std::set<std::string> names = noted(text_of(root() / "docs/notation.md"));
    int found = 0;
    for (const auto& entry : std::filesystem::directory_iterator(root() / "src/denhartog/formulas"))
        for (const std::string& name : parameters_of(text_of(entry.path()))) {
            INFO(entry.path().filename().string() << ": " << name);
            CHECK(names.count(name) == 1);
            ++found;
        }
    CHECK(found > 150);
}

TEST_CASE("every name in the notation is one that the code has", "[documentation]") {
    std::set<std::string> known;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root() / "src"))
        if (entry.path().extension() == ".hpp") known.merge(words_of(text_of(entry.path())));
    for (const std::string& name : noted(text_of(root() / "docs/notation.md"))) {
        INFO(name);
        CHECK(known.count(name) == 1);
    }
}

TEST_CASE("a symbol without a row, and a row without a symbol, would be told", "[documentation]") {
    CHECK(noted("| $R_i$ | `R`, `psi_k[i]` | text `none` | (22) | |\n") == std::set<std::string>{"R", "psi_k", "i"});
    CHECK(parameters_of("/// @param zeta  damping @param  R ratio\n") == std::set<std::string>{"zeta", "R"});
}

// What the doc comments point at is there.
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>

#include "denhartog/number/effort.hpp"
#include "derivation/ledger/source_text.hpp"
#include "tests/catch.hpp"

using denhartog::default_effort;
using denhartog::derivation::text_of;

TEST_CASE("every derivation that a doc comment names is a file", "[documentation]") {
    const char* source = std::getenv("DENHARTOG_SOURCE_DIR");
    REQUIRE(source != nullptr);
    const std::filesystem::path root(source);
    const std::string tag = "@derivation{";
    int found = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / "src")) {
        if (entry.path().extension() != ".hpp") continue;
        const std::string text = text_of(entry.path());
        for (std::size_t at = text.find(tag); at != std::string::npos; at = text.find(tag, at + 1)) {
            const std::size_t from = at + tag.size();
            const std::string name = text.substr(from, text.find('}', from) - from);
            INFO(entry.path().string() << ": " << name);
            CHECK(std::filesystem::exists(root / "derivation" / (name + ".cpp")));
            ++found;
        }
    }
    CHECK(found > 50);
}

TEST_CASE("the program that the page of the library shows is the one that is compiled", "[documentation]") {
    const std::filesystem::path root(std::getenv("DENHARTOG_SOURCE_DIR"));
    const std::string program = text_of(root / "tests/package/first_program.cpp");
    REQUIRE(program.size() > 100);
    CHECK(text_of(root / "docs/library.md").find("```cpp\n" + program + "```") != std::string::npos);
}

TEST_CASE("the lines of C++ that README shows are lines of that program", "[documentation]") {
    const std::filesystem::path root(std::getenv("DENHARTOG_SOURCE_DIR"));
    const std::string program = text_of(root / "tests/package/first_program.cpp"), readme = text_of(root / "README.md");
    const std::size_t from = readme.find("```cpp\n") + 7;
    std::istringstream shown(readme.substr(from, readme.find("```", from) - from));
    int found = 0;
    for (std::string line; std::getline(shown, line);) {
        line = line.substr(0, line.find(" //"));
        if (line.find("scene(text)") != std::string::npos) line.erase(line.find("(text)")); // its own scene stands there
        INFO(line);
        CHECK(program.find(line) != std::string::npos);
        found += !line.empty();
    }
    CHECK(found > 3);
}

TEST_CASE("every promise names a test that is there", "[documentation]") {
    const std::filesystem::path root(std::getenv("DENHARTOG_SOURCE_DIR"));
    std::string tests;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / "tests"))
        if (entry.path().extension() == ".cpp" || entry.path().extension() == ".py") tests += text_of(entry.path());
    std::istringstream page(text_of(root / "docs/promises.md"));
    int found = 0;
    for (std::string line; std::getline(page, line);) {
        const std::size_t from = line.rfind("| *"), to = line.rfind("* |");
        if (from == std::string::npos || to == std::string::npos) continue;
        const std::string name = line.substr(from + 3, to - from - 3);
        INFO(name);
        const bool in_cpp = tests.find("TEST_CASE(\"" + name + "\"") != std::string::npos;
        const bool in_python = tests.find("        \"\"\"" + name + "\"\"\"\n") != std::string::npos;
        CHECK((in_cpp || in_python));
        ++found;
    }
    CHECK(found > 10);
}

TEST_CASE("the default budget is told as it is", "[documentation][effort]") {
    const std::filesystem::path root(std::getenv("DENHARTOG_SOURCE_DIR"));
    const auto in_words = [](long operations) {
        const auto exponent = static_cast<int>(std::floor(std::log10(static_cast<double>(operations)) + 1e-6));
        std::ostringstream text;
        text << std::round(10 * static_cast<double>(operations) / std::pow(10.0, exponent)) / 10 << 'e' << exponent;
        return text.str();
    };
    const std::string few = in_words(default_effort(12)), many = in_words(default_effort(100)) + " for 100";
    for (const char* name : {"src/denhartog/program/commands/scene_command.cpp", "src/denhartog/c/denhartog.h",
                             "docs/c-interface.md", "docs/promises.md"}) {
        std::string text;
        for (const char letter : text_of(root / name)) { // words that a line or a literal ends between follow each other here
            if (letter == '"' || letter == '/') continue;
            const bool space = letter == ' ' || letter == '\n';
            if (!space || text.empty() || text.back() != ' ') text += space ? ' ' : letter;
        }
        INFO(name);
        CHECK(text.find(few) != std::string::npos);
        CHECK(text.find(many) != std::string::npos);
    }
}

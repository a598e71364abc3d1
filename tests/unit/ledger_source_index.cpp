#include "derivation/ledger/source_index.hpp"

#include <sstream>

#include "denhartog/number/errors.hpp"
#include "derivation/ledger/source_text.hpp"
#include "tests/unit/ledger_fixtures.hpp"

using namespace denhartog;
using derivation::FunctionEntry;
using derivation::functions_of_header;
using derivation::functions_of_sources;

TEST_CASE("a tag in a doc comment gives the function behind it, with namespace and line", "[ledger]") {
    const std::string header = R"cpp(/// @file
/// @brief (28), (29) of something.
#pragma once
#include <vector>
namespace outer {
/// @eq{24}
template <class T>
struct Start { // } a brace in a comment
    T eta_0; ///< not a tag: @eq{99}
    /// @eq{25}
    [[nodiscard]] T end(const T& tau) const { return tau < eta_0 ? tau : eta_0; }
};
namespace paper {

/// @brief A formula. @eq{28,
/// A.8}
/// @param R  a ratio
template <class T, class U = std::vector<T>>
[[nodiscard("a ( in an attribute")]] constexpr const T&
    first_damping_function(const T& R) { return f("}", '{', R"(})"); }

/// no tag here
template <class T>
T plain(const T& x);

/* @eq{1} in a comment that documents nothing */
/** @eq{54a} */
double margin(double x = {}) noexcept;
} // namespace paper
/// @eq{23}
int after();
} // namespace outer
namespace denhartog::as_printed {
/// @eq{46}
double steady(double tau);
}
)cpp";
    const std::vector<FunctionEntry> found = functions_of_header(header, "x.hpp");
    const std::vector<FunctionEntry> expected = {{"24", "outer::Start", "x.hpp", 8},
                                                 {"25", "outer::Start::end", "x.hpp", 11},
                                                 {"28", "outer::paper::first_damping_function", "x.hpp", 20},
                                                 {"A.8", "outer::paper::first_damping_function", "x.hpp", 20},
                                                 {"54", "outer::paper::margin", "x.hpp", 28},
                                                 {"23", "outer::after", "x.hpp", 31},
                                                 {"46", "denhartog::as_printed::steady", "x.hpp", 35}};
    for (const FunctionEntry& entry : found) UNSCOPED_INFO(entry.equation << " " << entry.name << ":" << entry.line);
    CHECK((found == expected));
    CHECK(derivation::is_as_printed(found.back()));
    CHECK_FALSE(derivation::is_formula(found.back()));
    CHECK_FALSE(derivation::is_as_printed(found[2]));
    CHECK(derivation::is_formula(found[2]));
    CHECK_FALSE(derivation::is_formula(found[0]));
}

TEST_CASE("a tag that belongs to nothing, or names nothing, is told", "[ledger]") {
    CHECK_THROWS_AS(functions_of_header("/// @eq{28}\nint;\n", "x.hpp"), InputError);
    CHECK_THROWS_AS(functions_of_header("/// @eq{28}\n", "x.hpp"), InputError);
    CHECK_THROWS_AS(functions_of_header("/// @eq{28\nint f();\n", "x.hpp"), InputError);
    CHECK_THROWS_AS(functions_of_header("/// @eq{28,}\nint f();\n", "x.hpp"), InputError);
    CHECK_THROWS_AS(functions_of_header("/// @eq{}\nint f();\n", "x.hpp"), InputError);
    CHECK(functions_of_header("/// @eq{99}\nint f();\n", "x.hpp").at(0).equation == "99");
}

TEST_CASE("a source root without headers is told", "[ledger]") {
    const tests::Folder folder;
    CHECK_THROWS_AS(functions_of_sources(folder.path()), InputError);
}

TEST_CASE("every tag of the project leads to a line that has the name of its function", "[ledger]") {
    const std::filesystem::path root = tests::project();
    const std::vector<FunctionEntry> entries = functions_of_sources(root / "src");
    for (const FunctionEntry& entry : entries) {
        std::istringstream text(derivation::text_of(root / entry.file));
        std::string line;
        for (int n = 0; n < entry.line; ++n) std::getline(text, line);
        INFO(entry.file << ":" << entry.line << " " << entry.name);
        CHECK(line.find(entry.name.substr(entry.name.rfind(':') + 1)) != std::string::npos);
        CHECK(entry.name.starts_with("denhartog::"));
    }
    // Counted another way: the commas within the tags, over the bare text.
    std::size_t tagged = 0;
    for (const std::filesystem::path& file : derivation::files_in(root / "src/denhartog", ".hpp")) {
        const std::string text = derivation::text_of(file);
        for (std::size_t at = text.find("@eq{"); at != std::string::npos; at = text.find("@eq{", at + 1)) {
            const std::string list = text.substr(at, text.find('}', at) - at);
            tagged += 1 + std::count(list.begin(), list.end(), ',');
        }
    }
    CHECK(entries.size() == tagged);
    const auto damping = std::find_if(entries.begin(), entries.end(), [](const FunctionEntry& entry) {
        return entry.equation == "28" && entry.name == "denhartog::paper::first_damping_function";
    });
    REQUIRE(damping != entries.end());
    CHECK(damping->file == "src/denhartog/formulas/mode.hpp");
}

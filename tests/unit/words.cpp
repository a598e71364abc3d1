#include <algorithm>
#include <cctype>
#include <cmath>
#include <new>
#include <set>
#include <sstream>
#include <string>
#include <system_error>

#include "denhartog/formulas/mode.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/legible.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/number/why.hpp"
#include "derivation/ledger/source_text.hpp"
#include "derivation/offers/formula_list.hpp"
#include "tests/unit/ledger_fixtures.hpp"

using namespace denhartog::offers;
using namespace denhartog;

// The places to which doc comments point exist.

using denhartog::default_effort;
using denhartog::derivation::text_of;
using denhartog::tests::project;

TEST_CASE("every derivation that a doc comment names is a file", "[documentation]") {
    const std::string tag = "@derivation{";
    int found = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(project() / "src")) {
        if (entry.path().extension() != ".hpp") continue;
        const std::string text = text_of(entry.path());
        for (std::size_t at = text.find(tag); at != std::string::npos; at = text.find(tag, at + 1)) {
            const std::size_t from = at + tag.size();
            const std::string name = text.substr(from, text.find('}', from) - from);
            INFO(entry.path().string() << ": " << name);
            CHECK(std::filesystem::exists(project() / "derivation" / (name + ".cpp")));
            ++found;
        }
    }
    CHECK(found > 50);
}

TEST_CASE("the program that the page of the library shows is the one that is compiled", "[documentation]") {
    const std::string program = text_of(project() / "tests/package/first_program.cpp");
    REQUIRE(program.size() > 100);
    CHECK(text_of(project() / "docs/library.md").find("```cpp\n" + program + "```") != std::string::npos);
}

TEST_CASE("the lines of C++ that README shows are lines of that program", "[documentation]") {
    const std::string program = text_of(project() / "tests/package/first_program.cpp"), readme = text_of(project() / "README.md");
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
    std::string tests;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(project() / "tests"))
        if (entry.path().extension() == ".cpp" || entry.path().extension() == ".py") tests += text_of(entry.path());
    std::istringstream page(text_of(project() / "docs/promises.md"));
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
        for (const char letter :
             text_of(project() / name)) { // words that a line or a literal ends between follow each other here
            if (letter == '"' || letter == '/') continue;
            const bool space = letter == ' ' || letter == '\n';
            if (!space || text.empty() || text.back() != ' ') text += space ? ' ' : letter;
        }
        INFO(name);
        CHECK(text.find(few) != std::string::npos);
        CHECK(text.find(many) != std::string::npos);
    }
}

TEST_CASE("text from outside is shown as UTF-8 without what a terminal obeys", "[number][input]") {
    CHECK(legible("mass_ratios") == "mass_ratios");
    CHECK(legible("m\xC3\xBC \xE2\x82\xAC \xF0\x9F\x98\x80") == "m\xC3\xBC \xE2\x82\xAC \xF0\x9F\x98\x80");
    CHECK(legible("a\x1b[31mb\n\t\x7F") == "a\\x1B[31mb\\x0A\\x09\\x7F");
    CHECK(legible(std::string("a\0b", 3)) == "a\\x00b");
    CHECK(legible("\xC2\x9B") == "\\xC2\\x9B");          // the second control block
    CHECK(legible("\xE2\x80\xAE") == "\\xE2\\x80\\xAE"); // from right to left
    CHECK(legible("\xFF\xC3\x28") == "\\xFF\\xC3(");     // no UTF-8
    CHECK(legible("\xC0\xAF\xED\xA0\x80\xF4\x90\x80\x80\xC3").find('\xC0') ==
          std::string::npos); // overlong, surrogate, beyond, cut
}

TEST_CASE("a long text loses its middle, and no character is cut", "[number][input]") {
    CHECK(legible("0123456789", 10) == "0123456789");
    CHECK(legible("0123456789a", 10) == "01234...9a");
    const std::string path = "/" + std::string(5000, 'd') + "/scene.json";
    CHECK(legible(path).size() <= most_shown);
    CHECK(legible(path).ends_with("/scene.json"));
    std::string umlauts;
    for (int n = 0; n < 1000; ++n) umlauts += "\xC3\xBC";
    for (std::size_t most = 8; most < 40; ++most) {
        const std::string shown = legible(umlauts, most);
        CHECK(shown.size() <= most);
        CHECK(shown.find('\\') == std::string::npos);
        CHECK(legible(shown, most) == shown);
    }
    CHECK(legible(std::string(10'000'000, '\x1b')).size() <= most_shown);
}

TEST_CASE("every part of an error of input is legible, and its message is short", "[number][input]") {
    const std::string evil = "\x1b[2J\xFF" + std::string(1'000'000, 'k');
    const InputError e(evil, "must be " + evil, evil, "/" + evil);
    for (const std::string& part : {std::string(e.what()), e.quantity, e.rule, e.value, e.place}) {
        CHECK(part.size() < 1300);
        CHECK(part.find('\x1b') == std::string::npos);
        CHECK(part.find('\xFF') == std::string::npos);
        CHECK(part.find("\\x1B[2J") != std::string::npos);
    }
    const InputError again(e.quantity, e.rule, e.value, e.place);
    CHECK(std::string(again.what()) == e.what());
}

TEST_CASE("what others throw is told in words of this library", "[number]") {
    const auto told = [](const auto& e) { return std::string(in_own_words(e)); };
    CHECK(told(InputError("r", "must be positive", "0")) == "r must be positive, but is 0");
    CHECK(told(DomainError("a pole")) == "a pole");
    CHECK(told(PrecisionError("no digits")) == "no digits");
    CHECK(told(std::bad_alloc()).starts_with("memory must hold"));
    CHECK(told(std::length_error("vector::_M_fill_insert")).starts_with("memory must hold"));
    CHECK(told(std::overflow_error("Error in function boost::math::expm1")).starts_with("the numbers of the computation must"));
    CHECK(is_beyond_range(std::overflow_error("")));
    CHECK_FALSE(is_beyond_range(std::bad_alloc()));
    CHECK(told(std::system_error(std::make_error_code(std::errc::io_error), "basic_filebuf")).starts_with("the system must"));
    CHECK(told(std::logic_error("a slip")).find("a slip") == std::string::npos);
}

// The notation page has every symbol that the formulas take, and no name that the code does not know.

namespace {

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
    const std::set<std::string> names = noted(text_of(project() / "docs/notation.md"));
    int found = 0;
    for (const auto& entry : std::filesystem::directory_iterator(project() / "src/denhartog/formulas"))
        for (const std::string& name : parameters_of(text_of(entry.path()))) {
            INFO(entry.path().filename().string() << ": " << name);
            CHECK(names.count(name) == 1);
            ++found;
        }
    CHECK(found > 150);
}

TEST_CASE("every name in the notation is one that the code has", "[documentation]") {
    std::set<std::string> known;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(project() / "src"))
        if (entry.path().extension() == ".hpp") known.merge(words_of(text_of(entry.path())));
    for (const std::string& name : noted(text_of(project() / "docs/notation.md"))) {
        INFO(name);
        CHECK(known.count(name) == 1);
    }
}

TEST_CASE("a symbol without a row, and a row without a symbol, would be told", "[documentation]") {
    CHECK(noted("| $R_i$ | `R`, `psi_k[i]` | text `none` | (22) | |\n") == std::set<std::string>{"R", "psi_k", "i"});
    CHECK(parameters_of("/// @param zeta  damping @param  R ratio\n") == std::set<std::string>{"zeta", "R"});
}

// The formulas that the pages of equations offer as code.

TEST_CASE("a formula that is written down is the one that runs, in the order of its operations", "[pages]") {
    const Written R = Written::of("R"), zeta = Written::of("zeta"), a = Written::of("a"), b = Written::of("b");
    const std::string root = "sqrt((1-(zeta*zeta)))", theta = "((pi*" + root + ")/R)";
    CHECK(paper::first_damping_function(R, zeta).text() ==
          "(sin(" + theta + ")/((R*" + root + ")*(cosh(((pi*zeta)/R))+cos(" + theta + "))))");
    CHECK((a - (b - 1) * (-a)).text() == "(a-((b-1)*(-a)))");
    CHECK((0 + a + (b + -2)).text() == "(a+(b+(-2)))");
    CHECK((2 * over_modes(a * a)).text() == "(2*sum((a*a)))");
    CHECK(atan2(a, b).text() == "atan2(a,b)");
}

TEST_CASE("an offered formula has no symbol but its arguments, and as many results as printed", "[pages]") {
    for (const OfferedFormula& formula : offered_formulas()) {
        INFO(formula.equation);
        std::set<std::string> known{"sqrt", "exp", "sin", "cos", "sinh", "cosh", "atan2", "sum", "pi"};
        known.insert(formula.arguments.begin(), formula.arguments.end());
        CHECK((formula.printed.empty() || formula.printed.size() == formula.results.size()));
        for (const std::string& argument : formula.of_modes)
            CHECK(std::count(formula.arguments.begin(), formula.arguments.end(), argument) == 1);
        for (const std::vector<Written>& results : {formula.results, formula.printed})
            for (const Written& result : results) {
                std::string words = result.text();
                for (char& c : words)
                    if (std::string("()+-*/,").find(c) != std::string::npos) c = ' ';
                std::istringstream in(words);
                for (std::string word; in >> word;)
                    CHECK((known.contains(word) || word.find_first_not_of("0123456789") == std::string::npos));
            }
    }
}

// Sentences of the reasons.

TEST_CASE("every reason has a sentence, with all its numbers in it", "[messages]") {
    for (auto n = 0; n <= static_cast<int>(Why::newton); ++n) {
        for (const double number : {0.0, 1.0}) {
            const std::string words = in_words(Reasons(static_cast<Why>(n), number, number, number, number));
            INFO(n << ": " << words);
            CHECK(words.empty() == (n == 0)); // which says what somebody else said
            CHECK(words.find_first_of("{}|") == std::string::npos);
        }
    }
}

TEST_CASE("numbers stand in a sentence as it asks for them", "[messages]") {
    CHECK(in_words({Why::mode_out_of_range, 100000}) == "mode 100000 is beyond the range of the number type");
    CHECK(in_words({Why::not_sliding, 0.1, 1e-7}) ==
          "the contact does not slide throughout: beta = 0.1 is not below beta_lim = " + number_to_text(1e-7) + ", Eq. (69)");
    CHECK(in_words({Why::can_rest, 0.123456789, 1e-4}) == "it can also rest for ever, because beta is not below 0.123");
    // Two numbers that are told apart differ in words, too.
    CHECK(in_words({Why::slides, 0.79, 0.79 * (1 + 1e-14), 1e-16, 0})
              .starts_with("beta = 0.79 is below beta_lim = 0.79000000000001,"));
    CHECK(in_words({Why::no_closed_form, 0.79 * (1 + 1e-14), 0.79, 1e-16, 0})
              .find("beta = 0.79000000000001 is not below beta_lim = 0.79,") != std::string::npos);
    CHECK(in_words({Why::fast_mode, 123456.0}).find(" has 1.2e+05 times ") != std::string::npos);
    CHECK(in_words({Why::bound, true, 6, false, true}) == "the error bound guarantees the 6 digits asked for");
    CHECK(in_words({Why::bound, false, 1, true, false}) == "the error bound does not guarantee the 1 digit aimed at");
    CHECK(in_words({Why::may_depend, 3}) == "not known: a mode has no damping, and the motion may depend on the start");
    CHECK(in_words({Why::pole_by_rounding, 2, 1, true}).find("R = 1: its complex") != std::string::npos);
    CHECK(in_words({Why::pole_by_rounding, 2, 1 - 0x1p-53, false}).find(", which is 1 to the last digits") != std::string::npos);
}

TEST_CASE("reasons follow each other as sentences do", "[messages]") {
    const Reasons why = Why::in_double + Reasons(Why::bound, true, 6, false, false) + Why::but + Why::on_boundary;
    CHECK(in_words(why + Reasons(Why::proved, 128)) == "in double: the error bound guarantees the 6 digits aimed at, but beta "
                                                       "lies within the error bound of a boundary; every number is proved, with "
                                                       "balls of 128 bits");
    CHECK(in_words(Reasons(Why::so_many_certain, 3) + Why::no_bound + Why::end_of_brackets) ==
          "only 3 are certain (a number has no bound)");
    CHECK(in_words(Why::not_proved + Reasons("as somebody says")) == "the reference does not prove it: as somebody says");
    CHECK(in_words(Reasons()).empty());
    CHECK(PrecisionError(Why::no_bound).what() == in_words(Why::no_bound));
    CHECK(PrecisionError(why).why == why);
}

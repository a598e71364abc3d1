// The formulas that the pages of equations offer as code.
#include "derivation/offers/formula_list.hpp"

#include <algorithm>
#include <set>
#include <sstream>

#include "denhartog/formulas/mode.hpp"
#include "tests/catch.hpp"

using namespace denhartog;
using namespace denhartog::offers;

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

// The program that writes what the page of an equation offers: the formula as the library computes it, and certified questions
// with the answers of known mistakes to them, for a number that a reader pastes.
#include <algorithm>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "conformance/mistakes/mistake.hpp"
#include "conformance/vector.hpp"
#include "derivation/offers/formula_list.hpp"

namespace {

using namespace denhartog;
using Json = nlohmann::ordered_json;

constexpr std::size_t most_questions = 6, most_mistakes = 8;

Json formula_json(const offers::OfferedFormula& formula) {
    const auto texts = [](const std::vector<offers::Written>& results) {
        Json list = Json::array();
        for (const offers::Written& result : results) list.push_back(result.text());
        return list;
    };
    return {{"what", formula.what},
            {"name", formula.name},
            {"arguments", formula.arguments},
            {"of_modes", formula.of_modes},
            {"holds", texts(formula.results)},
            {"printed", texts(formula.printed)}};
}

/// The answers of the mistakes that get a question wrong: those in its equation first.
Json question_with_mistakes(const conformance::Vector& vector, const std::string& equation) {
    Json mistakes = Json::array();
    for (const bool own : {true, false})
        for (const conformance::Mistake& mistake : conformance::mistakes()) {
            if ((mistake.equation == equation) != own || mistakes.size() >= most_mistakes) continue;
            if (!std::binary_search(vector.catches.begin(), vector.catches.end(), mistake.name)) continue;
            const auto answer = conformance::answer_with_mistake(mistake.name, vector.question);
            if (answer && answer->numbers.size() == vector.nearest.size())
                mistakes.push_back({{"what", mistake.told}, {"value", answer->numbers}});
        }
    return {{"question", conformance::question_json(vector.question)}, {"right", vector.nearest}, {"mistakes", mistakes}};
}

/// For each equation some certified questions that ask for it, or that a mistake in it gets wrong.
Json questions_by_equation(const std::string& vectors) {
    Json questions = Json::object();
    std::map<std::string, std::string> equation_of;
    for (const conformance::Mistake& mistake : conformance::mistakes()) equation_of[mistake.name] = mistake.equation;
    for (const conformance::Vector& vector : conformance::read_vectors(vectors)) {
        if (vector.tier == "stress" || !vector.reject.empty() || vector.nearest.empty() || vector.nearest.size() > 2) continue;
        std::set<std::string> equations{vector.equation};
        for (const std::string& name : vector.catches)
            if (const auto found = equation_of.find(name); found != equation_of.end()) equations.insert(found->second);
        for (const std::string& equation : equations) {
            if (equation.empty() || questions[equation].size() >= most_questions) continue;
            Json question = question_with_mistakes(vector, equation);
            if (!question.at("mistakes").empty()) questions[equation].push_back(std::move(question));
        }
    }
    return questions;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: offers VECTORS, the folder of the certified vectors; writes JSON\n";
        return 2;
    }
    try {
        Json formulas = Json::object();
        for (const offers::OfferedFormula& formula : offers::offered_formulas())
            formulas.emplace(formula.equation, formula_json(formula)); // the first of an equation
        std::cout << Json{{"formulas", formulas}, {"questions", questions_by_equation(argv[1])}}.dump(1) << "\n";
        return std::cout.flush() ? 0 : 1;
    } catch (const std::exception& e) {
        std::cerr << "offers: " << e.what() << "\n";
        return 1;
    }
}

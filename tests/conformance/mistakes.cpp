#include "conformance/mistakes/mistake.hpp"

#include <cmath>
#include <map>
#include <set>

#include "conformance/plain/closed_form.hpp"
#include "denhartog/number/errors.hpp"
#include "tests/catch.hpp"
#include "tests/conformance/seeded_questions.hpp"

using namespace denhartog;
using namespace denhartog::conformance;

namespace {

constexpr double apart = 1e-5;

bool differ(const Value& a, const Value& b) {
    if (a.word != b.word || a.numbers.size() != b.numbers.size()) return true;
    double size = 0, difference = 0;
    for (std::size_t n = 0; n < a.numbers.size(); ++n) {
        size = std::max(size, std::abs(a.numbers[n]));
        difference = std::max(difference, std::abs(a.numbers[n] - b.numbers[n]));
    }
    return difference > apart * size;
}

// Every quantity on seeded scenes, with the right answer.
struct Asked {
    ProtocolQuestion question;
    Value right;
};

const std::vector<Asked>& all_asked() {
    static const std::vector<Asked> all = [] {
        std::vector<Asked> asked;
        std::vector<ProtocolQuestion> questions = tests::seeded_questions(2022, 30);
        for (const ProtocolQuestion& q : tests::seeded_systems(2022, 8)) questions.push_back(q);
        for (ProtocolQuestion q : questions)
            for (const Quantity& quantity : quantities()) {
                q.quantity = quantity.name;
                if (const std::optional<Value> right = plain_answer(q)) asked.push_back({q, *right});
            }
        return asked;
    }();
    return all;
}

// Answers of each mistake to all of them, by its name, computed once.
const std::map<std::string, std::vector<std::optional<Value>>>& all_answers() {
    static const std::map<std::string, std::vector<std::optional<Value>>> all = [] {
        std::map<std::string, std::vector<std::optional<Value>>> answers;
        for (const Mistake& mistake : mistakes())
            for (const Asked& each : all_asked())
                answers[mistake.name].push_back(answer_with_mistake(mistake.name, each.question));
        return answers;
    }();
    return all;
}

// The answers of an implementation that makes a mistake: right where the mistake says nothing.
std::vector<Value> answers_of(const Mistake& mistake) {
    const std::vector<std::optional<Value>>& given = all_answers().at(mistake.name);
    std::vector<Value> answers;
    for (std::size_t n = 0; n < given.size(); ++n) answers.push_back(given[n].value_or(all_asked()[n].right));
    return answers;
}

} // namespace

TEST_CASE("known mistakes have a name of their own and tell what they are", "[conformance][mistake]") {
    std::set<std::string> names;
    for (const Mistake& mistake : mistakes()) {
        INFO(mistake.name);
        CHECK(names.insert(mistake.name).second);
        CHECK(mistake.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos);
        CHECK(mistake.told.size() > 20);
        CHECK(mistake.told.back() == '.');
        CHECK(mistake.look_at.size() > 10);
        CHECK(mistake.agreement > 0);
        if (mistake.as_printed) CHECK(mistake.name.starts_with(mistake.equation + "-as-printed"));
    }
    CHECK(names.size() >= 70);
    CHECK_THROWS_AS(answer_with_mistake("no-mistake", ProtocolQuestion{}), InputError);
}

TEST_CASE("every known mistake gives itself away on a seeded scene, and no two are the same there", "[conformance][mistake]") {
    std::map<std::string, std::vector<Value>> answers;
    for (const Mistake& mistake : mistakes()) answers[mistake.name] = answers_of(mistake);
    for (const auto& [name, given] : answers) {
        int shown = 0;
        for (std::size_t n = 0; n < given.size(); ++n) shown += differ(given[n], all_asked()[n].right);
        INFO(name);
        CHECK(shown >= 2);
        for (const auto& [other, others] : answers) {
            if (other <= name) continue;
            bool told_apart = false;
            for (std::size_t n = 0; n < given.size() && !told_apart; ++n) told_apart = differ(given[n], others[n]);
            INFO(other);
            CHECK(told_apart);
        }
    }
}

TEST_CASE("an implementation that makes a mistake answers with finite numbers or a regime", "[conformance][mistake]") {
    for (const auto& [name, given] : all_answers())
        for (std::size_t n = 0; n < given.size(); ++n) {
            const Asked& each = all_asked()[n];
            const std::optional<Value>& value = given[n];
            if (!value) continue;
            INFO(name << " on " << question_plain(each.question));
            CHECK((!value->word.empty() || value->numbers.size() == each.right.numbers.size() ||
                   quantity(each.question.quantity).shape == Shape::durations));
            for (const double x : value->numbers) CHECK(std::isfinite(x));
        }
}

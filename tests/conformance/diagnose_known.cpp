// The diagnosis with the known mistakes, on seeded scenes.
#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "conformance/diagnose.hpp"
#include "conformance/plain/closed_form.hpp"
#include "conformance/verdict.hpp"
#include "tests/catch.hpp"
#include "tests/conformance/runner_fixtures.hpp"
#include "tests/conformance/seeded_questions.hpp"
#include "tests/conformance/vector_folder.hpp"

using namespace denhartog;
using namespace denhartog::conformance;
using namespace denhartog::tests;

namespace {

// Every quantity on seeded scenes; what is true is what the plain closed form answers.
std::vector<Vector> seeded_vectors() {
    std::vector<Vector> vectors;
    int number = 0;
    std::vector<ProtocolQuestion> questions = seeded_questions(535, 60);
    for (const ProtocolQuestion& q : seeded_systems(535, 12)) questions.push_back(q);
    for (ProtocolQuestion q : questions)
        for (const Quantity& asked : quantities()) {
            q.quantity = asked.name;
            const std::optional<Value> right = plain_answer(q);
            if (!right) continue;
            Vector v = vector_of("seeded-" + std::to_string(++number), std::string(asked.name), right->numbers);
            q.id = v.question.id;
            v.question = q;
            v.word = right->word;
            v.tolerance = {1e-11, 1e-9, 1e-6};
            vectors.push_back(std::move(v));
        }
    return vectors;
}

} // namespace

TEST_CASE("each known mistake is found by its answers, it alone", "[conformance][diagnosis][mistake]") {
    const std::vector<Vector> vectors = seeded_vectors();
    // All mistakes get the same questions: each answer is computed once.
    std::map<std::string, std::map<std::string, std::optional<Value>>> answers;
    for (const Mistake& mistake : mistakes())
        for (const Vector& v : vectors) answers[mistake.name][v.question.id] = answer_with_mistake(mistake.name, v.question);
    std::vector<Mistake> remembered(mistakes().begin(), mistakes().end());
    for (Mistake& mistake : remembered)
        mistake.answer.alone = [&of_one = answers.at(mistake.name)](const ProtocolQuestion& q) { return of_one.at(q.id); };
    for (const Mistake& mistake : mistakes()) {
        std::vector<Judged> judged;
        for (const Vector& v : vectors)
            judged.push_back(grade(v, answers.at(mistake.name).at(v.question.id).value_or(truth_of(v))));
        const Diagnosis d = diagnose(judged, remembered);
        std::string found;
        for (const Finding& f : d.findings)
            found += f.mistake.name + " explains " + std::to_string(f.explained) + ", contradicted " +
                     std::to_string(f.contradicted) + "; ";
        INFO(mistake.name << ": " << d.wrong << " wrong, " << d.unexplained.size() << " unexplained; " << found);
        CHECK(d.wrong > 0);
        CHECK(d.unexplained.empty());
        REQUIRE(d.findings.size() == 1);
        CHECK(d.findings.front().mistake.name == mistake.name);
        CHECK(d.findings.front().contradicted == 0);
    }
}

// The diagnosis of programs that make several known mistakes at once, on the certified vectors.

namespace {

// Some of the vectors of the paper that are not rejected.
const std::vector<Vector>& some_vectors() {
    static const std::vector<Vector> some = [] {
        std::vector<Vector> kept;
        std::map<std::string, int> seen;
        for (const Vector& v : tests::vectors()) {
            const bool of_68 = v.question.quantity == "beta_lim_exact"; // (68) shows in few answers
            if (is_of_the_paper(v.question) && v.reject.empty() && (of_68 || v.tier != "stress") &&
                seen[v.question.quantity]++ % (of_68 ? 1 : 4) == 0)
                kept.push_back(v);
        }
        return kept;
    }();
    return some;
}

// The names that a program gets which makes some mistakes and is right otherwise.
std::set<std::string> names_of(const std::vector<const Mistake*>& made) {
    std::vector<const Answering*> changes;
    for (const Mistake* mistake : made) changes.push_back(&mistake->answer);
    std::vector<Judged> judged;
    for (const Vector& v : some_vectors())
        judged.push_back(grade(v, answer_with_several(changes, v.question).value_or(truth_of(v))));
    std::set<std::string> names;
    for (const Finding& f : diagnose(judged, fitted_to(judged)).findings) names.insert(f.mistake.name);
    return names;
}

// True if a mistake shows in the answers. One in base excitation, for example, does not on scenes of the paper.
bool shows(const Mistake& mistake) {
    return std::ranges::any_of(some_vectors(), [&](const Vector& v) {
        const std::optional<Value> value = mistake.answer(v.question);
        return value && is_wrong_value(grade(v, *value).verdict);
    });
}

std::string joined(const std::set<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

// Without (4), which leaves no load but that on the contact, so that others are hidden.
std::vector<const Mistake*> printed() {
    std::vector<const Mistake*> all;
    for (const Mistake& mistake : mistakes())
        if (mistake.as_printed && mistake.equation != "4") all.push_back(&mistake);
    return all;
}

} // namespace

TEST_CASE("every two equations as printed are named, and nothing else", "[conformance][diagnosis][mistake]") {
    const std::vector<const Mistake*> all = printed();
    REQUIRE(all.size() == 11);
    for (std::size_t a = 0; a < all.size(); ++a)
        for (std::size_t b = a + 1; b < all.size(); ++b) {
            CHECK(joined(names_of({all[a], all[b]})) == all[a]->name + ", " + all[b]->name);
        }
}

TEST_CASE("the paper as printed gets all its names at once", "[conformance][diagnosis][mistake]") {
    std::set<std::string> names;
    for (const Mistake* mistake : printed()) names.insert(mistake->name);
    CHECK(joined(names_of(printed())) == joined(names));
}

TEST_CASE("programs that make two known mistakes get no other name", "[conformance][diagnosis][mistake]") {
    std::vector<const Mistake*> all;
    for (const Mistake& mistake : mistakes())
        if (mistake.answer.touches && shows(mistake)) all.push_back(&mistake);
    std::mt19937_64 random(65);
    int both = 0;
    constexpr int pairs = 60;
    for (int n = 0; n < pairs; ++n) {
        const std::size_t first = random() % all.size(), apart = 1 + random() % (all.size() - 1);
        const Mistake *a = all[first], *b = all[(first + apart) % all.size()];
        const std::set<std::string> names = names_of({a, b});
        INFO(a->name << " and " << b->name << ": " << joined(names));
        for (const std::string& name : names) CHECK((name == a->name || name == b->name));
        both += names.contains(a->name) && names.contains(b->name);
    }
    CHECK(both >= 24);
}

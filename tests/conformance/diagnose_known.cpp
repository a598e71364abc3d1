// The diagnosis with the known mistakes, on seeded scenes.
#include <map>

#include "conformance/diagnose.hpp"
#include "conformance/plain/closed_form.hpp"
#include "conformance/verdict.hpp"
#include "tests/catch.hpp"
#include "tests/conformance/runner_fixtures.hpp"
#include "tests/conformance/seeded_questions.hpp"

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

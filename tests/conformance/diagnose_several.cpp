// The diagnosis of programs that make several known mistakes at once, on the certified vectors.
#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "conformance/diagnose.hpp"
#include "conformance/verdict.hpp"
#include "tests/catch.hpp"
#include "tests/conformance/vector_folder.hpp"

using namespace denhartog;
using namespace denhartog::conformance;

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

#include "conformance/diagnose.hpp"

#include "conformance/verdict.hpp"
#include "tests/catch.hpp"
#include "tests/conformance/runner_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::conformance;
using namespace denhartog::tests;

namespace {

double truth(const ProtocolQuestion& q) { return q.r + q.mu; }

// Right: r + mu. The stubs' answers, `printed` for displacements alone and `mu-squared` for amplitudes alone.
std::optional<Value> stub_answer(std::string_view name, const ProtocolQuestion& q) {
    if (name == "twice") return Value{{2 * truth(q)}, ""};
    if (name == "rough") return Value{{3 * truth(q)}, ""};
    if (name == "mu-squared" && q.quantity == "amplitude") return Value{{q.r + q.mu * q.mu}, ""};
    if (name == "printed" && q.quantity == "displacement") return Value{{q.r - q.mu}, ""};
    return std::nullopt;
}

std::vector<Mistake> known_stubs() {
    std::vector<Mistake> stubs{{"twice", "38", "Everything is twice as large.", "factors of two", {}},
                               {"mu-squared", "", "Amplitudes go with mu squared.", "where mu enters", {}},
                               {"printed", "46", "The sign of the print.", "the sign in (46)", {}},
                               {"rough", "", "An integrator's mistake.", "the steps", {}, {}, 3e-2}};
    stubs[2].as_printed = true;
    for (Mistake& stub : stubs)
        stub.answer.alone = [name = stub.name](const ProtocolQuestion& q) { return stub_answer(name, q); };
    return stubs;
}

const std::vector<Mistake> stubs = known_stubs();

// Ten amplitudes, half of them at mu = 1, and ten displacements.
const std::vector<Vector> twenty_vectors = [] {
    std::vector<Vector> twenty;
    for (const char* quantity : {"amplitude", "displacement"})
        for (int n = 0; n < 10; ++n) {
            ProtocolQuestion q;
            q.r = 1 + n / 8.0;
            q.mu = n % 2 == 0 ? 1 : 1.5;
            twenty.push_back(vector_of(std::string(quantity) + "-" + std::to_string(n), quantity, {truth(q)}));
            twenty.back().question.r = q.r;
            twenty.back().question.mu = q.mu;
        }
    return twenty;
}();

template <class Answering>
std::vector<Judged> judged_by(const Answering& answering) {
    std::vector<Judged> judged;
    for (const Vector& v : twenty_vectors) judged.push_back(grade(v, answering(v.question)));
    return judged;
}

Value right(const ProtocolQuestion& q) { return {{truth(q)}, ""}; }
Value by(const char* name, const ProtocolQuestion& q) { return stub_answer(name, q).value_or(right(q)); }

} // namespace

TEST_CASE("right answers need no diagnosis", "[conformance][diagnosis]") {
    std::vector<Judged> judged = judged_by(right);
    const Diagnosis d = diagnose(judged, stubs);
    CHECK(d.wrong == 0);
    CHECK(d.findings.empty());
    CHECK(d.in_common.empty());
}

TEST_CASE("a mistake is found by its answers and told with an example", "[conformance][diagnosis]") {
    std::vector<Judged> judged = judged_by([](const ProtocolQuestion& q) { return by("twice", q); });
    const Diagnosis d = diagnose(judged, stubs);
    CHECK(d.wrong == 20);
    REQUIRE(d.findings.size() == 1);
    CHECK(d.findings.front().mistake.name == "twice");
    CHECK(d.findings.front().explained == 20);
    CHECK(d.findings.front().contradicted == 0);
    CHECK(d.findings.front().quantities == std::vector<std::string>{"amplitude", "displacement"});
    CHECK(d.findings.front().mistaken.numbers == d.findings.front().example->given.numbers);
    CHECK(d.unexplained.empty());
}

TEST_CASE("two mistakes in different functions are both found, and the print is called by its equation",
          "[conformance][diagnosis]") {
    std::vector<Judged> judged =
        judged_by([](const ProtocolQuestion& q) { return by(q.quantity == "amplitude" ? "mu-squared" : "printed", q); });
    const Diagnosis d = diagnose(judged, stubs);
    CHECK(d.wrong == 15);
    REQUIRE(d.findings.size() == 2);
    CHECK(d.findings[0].mistake.name == "printed");
    CHECK(d.findings[1].mistake.name == "mu-squared");
    CHECK(d.findings[1].explained == 5);
    for (const Judged& one : judged) {
        INFO(one.vector->question.id);
        CHECK((one.verdict == Verdict::as_printed) == (one.vector->question.quantity == "displacement"));
        CHECK(one.equation == (one.verdict == Verdict::as_printed ? "46" : ""));
    }
}

TEST_CASE("a mistake that right answers contradict is not told", "[conformance][diagnosis]") {
    // Twice as large at three of ten points alone: no implementation that makes the mistake does so.
    std::vector<Judged> judged =
        judged_by([](const ProtocolQuestion& q) { return q.quantity == "amplitude" && q.r < 1.3 ? by("twice", q) : right(q); });
    const Diagnosis d = diagnose(judged, stubs);
    CHECK(d.wrong == 3);
    CHECK(d.findings.empty());
    CHECK(d.unexplained.size() == 3);
}

TEST_CASE("an inaccurate answer is no mistake's whose answer is the truth there", "[conformance][diagnosis]") {
    // mu-squared is right at mu = 1: an answer that is off by 1e-7 there agrees with it to 1e-6, and says nothing.
    std::vector<Judged> judged = judged_by([](const ProtocolQuestion& q) { return Value{{truth(q) * (1 + 1e-7)}, ""}; });
    const Diagnosis d = diagnose(judged, stubs);
    CHECK(d.wrong == 20);
    CHECK(d.findings.empty());
}

TEST_CASE("a mistake is matched to its own agreement: an integrator's loosely, a formula's not", "[conformance][diagnosis]") {
    std::vector<Judged> loosely = judged_by([](const ProtocolQuestion& q) { return Value{{3.03 * truth(q)}, ""}; });
    const Diagnosis d = diagnose(loosely, stubs);
    REQUIRE(d.findings.size() == 1);
    CHECK(d.findings.front().mistake.name == "rough");
    std::vector<Judged> off = judged_by([](const ProtocolQuestion& q) { return Value{{2.001 * truth(q)}, ""}; });
    CHECK(diagnose(off, stubs).findings.empty());
}

TEST_CASE("what cannot be used agrees with nothing", "[conformance][diagnosis]") {
    std::vector<Mistake> nothing = stubs;
    for (Mistake& stub : nothing) stub.answer.alone = [](const ProtocolQuestion&) { return std::optional(Value{}); };
    std::vector<Judged> judged = judged_by([](const ProtocolQuestion&) { return Unusable{"nan"}; });
    const Diagnosis d = diagnose(judged, nothing);
    CHECK(d.wrong == 20);
    CHECK(d.findings.empty());
}

TEST_CASE("where nothing matches, what the wrong answers have in common is told", "[conformance][diagnosis]") {
    std::vector<Judged> judged = judged_by([](const ProtocolQuestion& q) {
        return q.quantity == "amplitude" && q.mu > 1 ? Value{{-7}, ""} : right(q);
    });
    const Diagnosis d = diagnose(judged, stubs);
    CHECK(d.unexplained.size() == 5);
    REQUIRE(d.by_quantity.size() == 1);
    CHECK(d.by_quantity.front().property == "amplitude");
    CHECK(d.by_quantity.front().asked == 10);
    REQUIRE(d.in_common.size() == 3);
    CHECK(d.in_common[1].property == "the answer is too large");
    CHECK(d.in_common[2].property == "the answer has no more than 3 digits");
    CHECK(d.in_common.front().property == "mu > 1");
    CHECK(d.in_common.front().wrong == 5);
    CHECK(d.in_common.front().asked == 5);
}

TEST_CASE("one or two wrong answers have nothing in common", "[conformance][diagnosis]") {
    std::vector<Judged> judged = judged_by([](const ProtocolQuestion& q) {
        return q.quantity == "amplitude" && q.r > 2 ? Value{{-7}, ""} : right(q);
    });
    const Diagnosis d = diagnose(judged, stubs);
    CHECK(d.unexplained.size() == 1);
    CHECK(d.by_quantity.size() == 1);
    CHECK(d.in_common.empty());
}

TEST_CASE("rules that were not kept are counted", "[conformance][diagnosis]") {
    const Vector v = reject_vector("reject-1");
    std::vector<Judged> judged{grade(v, Value{{1}, ""})};
    CHECK(diagnose(judged, stubs).accepted == std::map<std::string, std::size_t>{{"mu must be at least 1", 1}});
}

// The outcomes of questions: each kind of reason why there is no answer is met by a scene, whose twin has an answer.
#include <string>
#include <vector>

#include "denhartog/answer/certify.hpp"
#include "denhartog/map/regime_map.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/tried.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/search/largest.hpp"
#include "denhartog/solve/solve.hpp"
#include "tests/catch.hpp"

using namespace denhartog;

namespace {

// The contact of a scene, whose other mass loads it by exactly twice the force, is next to the boundary of permanent sticking.
std::string held(const char* beta) {
    return std::string(
               R"({"mass_ratios": [1, "0.6"], "stiffness_ratios": [1, "0.3"], "damping_ratios": 0, "contact": 1, "load": 2,
        "r": 0.5, "beta": )") +
           beta + "}";
}

std::string one_mass(const char* zeta, const char* r, const char* beta) {
    return std::string(R"({"mass_ratios": [1], "stiffness_ratios": [1], "contact": 1, "load": 1, "damping_ratios": )") + zeta +
           R"(, "r": )" + r + R"(, "beta": )" + beta + "}";
}

// Static friction a hundred times kinetic friction, which is small: without damping no motion from rest repeats itself.
std::string restless(const char* zeta) {
    return std::string(R"({"mass_ratios": [1, 1.25, 2, 1.25], "stiffness_ratios": [1, 1.75, 0.25, 1.5], "contact": 1, "load": 3,
        "mu": 100, "r": 1.25, "beta": 0.0009765625, "damping_ratios": )") +
           zeta + "}";
}

Tried<Solution> decided(const std::string& scene, std::optional<int> digits = {}, Effort* effort = nullptr) {
    const SceneSource source = scene_source(SceneText{scene});
    const Question question{Asked::motion, digits};
    const PreparedSystem p = prepare(source, question);
    return decide(p, {frequency_ratio_of(p.scene()), friction_ratio_of(p.scene()), &source, effort}, question);
}

void same_as_thrown(const std::string& scene, std::optional<int> digits, const Tried<Solution>& made) {
    try {
        (void)solve(scene_source(SceneText{scene}), {Asked::motion, digits});
        FAIL("there is an answer");
    } catch (const Refusal& none) {
        CHECK(none.outcome == made.outcome);
        CHECK(none.why == made.why);
    }
}

} // namespace

TEST_CASE("an error leaves the digits whose tolerance it keeps, and no more", "[outcomes]") {
    for (int digits = 1; digits <= 16; ++digits) {
        INFO(digits);
        CHECK(digits_of(tolerance_of(digits)) == digits);
        CHECK(digits_of(1.001 * tolerance_of(digits)) == digits - 1);
    }
    CHECK(digits_of(0) == 17);
    CHECK(digits_of(1) == 0);
}

TEST_CASE("each outcome of a question is met by a scene, and its twin has an answer", "[solve][errors]") {
    struct Case {
        const char* name;
        Outcome outcome;
        std::string scene, twin;
        std::optional<int> digits;
    };
    const std::vector<Case> cases{
        {"a pole", Outcome::at_a_pole, one_mass("0", "1", "0.125"), one_mass("0.0625", "1", "0.125"), {}},
        {"digits", Outcome::digits_missing, held("2"), held("2.000000000001"), 20},
        {"range", Outcome::out_of_range, one_mass("0.05", "1e-200", "0.5"), one_mass("0.05", "1e-2", "0.5"), {}},
        {"no periodic motion", Outcome::not_converged, restless("0"), restless("0.0625"), {}},
    };
    for (const Case& c : cases) {
        INFO(c.name);
        const Tried<Solution> none = decided(c.scene, c.digits);
        CHECK(none.outcome == c.outcome);
        CHECK_FALSE(none.value);
        CHECK_FALSE(none.why.empty());
        same_as_thrown(c.scene, c.digits, none);
        const Tried<Solution> twin = decided(c.twin, c.digits);
        CHECK(twin.outcome == Outcome::answered);
        CHECK((twin.value && twin.value->digits_reached));
        CHECK(twin.why.empty());
    }
}

TEST_CASE("a point of a map without an answer has the status of its outcome, whoever is asked for it", "[map][errors]") {
    struct Case {
        PointStatus status;
        std::string scene;
    };
    const std::vector<Case> cases{{PointStatus::at_a_pole, one_mass("0", "1", "0.125")},
                                  {PointStatus::answered, one_mass("0.0625", "1", "0.125")},
                                  {PointStatus::failed, one_mass("0.05", "1e-200", "0.5")},
                                  {PointStatus::answered, one_mass("0.05", "1e-2", "2")},
                                  {PointStatus::not_converged, restless("0")}};
    const std::atomic<bool> never{false};
    for (const Case& c : cases)
        for (const bool phases : {false, true}) { // a column of the map is asked, or `decide`
            const Scene<double> scene = read_scene<double>(c.scene);
            MapRequest request{{*scene.r}, {*scene.beta}, {Mass{0}}};
            request.phases = phases;
            INFO(c.scene << (phases ? " with phases" : ""));
            CHECK(regime_map(scene, request, never).points.front().status == c.status);
        }
}

TEST_CASE("a question whose work is spent says so, and with more work it has an answer", "[solve][errors][effort]") {
    for (const std::optional<int> digits : {std::optional<int>(), std::optional<int>(20)}) {
        QuestionEffort little(4, 50), enough(4, 100'000'000);
        const Tried<Solution> none = decided(restless("0.0625"), digits, &little);
        CHECK(none.outcome == Outcome::budget_spent);
        CHECK_FALSE(none.value);
        CHECK(decided(restless("0.0625"), digits, &enough).outcome == Outcome::answered);
    }
    // With enough work the outcome of this scene is `not_converged`.
    QuestionEffort short_of_periods(4, 3000);
    CHECK(decided(restless("0"), {}, &short_of_periods).outcome == Outcome::budget_spent);
}

TEST_CASE("what is thrown and what is passed on are the same outcome", "[errors]") {
    const auto fails = [](Outcome outcome) { return tried([&]() -> int { throw PrecisionError(Why::no_bound, outcome); }); };
    for (const Outcome outcome :
         {Outcome::budget_spent, Outcome::digits_missing, Outcome::out_of_range, Outcome::not_converged}) {
        Tried<int> made = fails(outcome);
        CHECK(made.outcome == outcome);
        CHECK(made.why == Reasons(Why::no_bound));
        CHECK_FALSE(made.value);
        CHECK(tried([&] { return made.required(); }).outcome == outcome);
    }
    CHECK(PrecisionError(Why::no_bound).outcome == Outcome::digits_missing);
    Tried<int> pole = tried([]() -> int { throw DomainError(Why::pole); });
    CHECK(pole.outcome == Outcome::at_a_pole);
    CHECK_THROWS_AS(pole.required(), DomainError);
    CHECK(tried([] { return 7; }).required() == 7);
    CHECK_THROWS_AS(tried([]() -> int { throw InputError("r", "must be positive", "0"); }), InputError);
    Effort spent{10, 10};
    CHECK(tried([&] {
              pay(&spent, 1);
              return true;
          }).outcome == Outcome::budget_spent);
}

TEST_CASE("a search that has not settled tells a spent budget from a share that was too small", "[largest][errors][effort]") {
    Curve flat; // whatever the samples, the bound on the rate lets more be between them
    flat.sample = [](double) { return Sample{1, 0, 0}; };
    flat.rate = [](double, double) { return 1e9; };
    const auto outcome_with = [&](Effort* question) {
        flat.question = question;
        return tried([&] { return global_maximum(flat, 0.0, 1.0); }).outcome;
    };
    CHECK(outcome_with(nullptr) == Outcome::budget_spent);
    QuestionEffort little(1, 100), much(1, 1'000'000'000);
    much.chosen = false; // a search then has its share alone
    CHECK(outcome_with(&little) == Outcome::budget_spent);
    CHECK(outcome_with(&much) == Outcome::not_converged);
    flat.rate = [](double, double) { return 0.0; };
    flat.sample = [](double tau) { return Sample{-tau * tau, -2 * tau, -2}; };
    CHECK(outcome_with(&much) == Outcome::answered);
}

// Scenes from the corners of what a scene may be; the full surveys are `speed-accuracy adversarial` and `contradictions`.
#include "tests/speed_accuracy/adversarial_survey.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "denhartog/denhartog.hpp"
#include "tests/catch.hpp"
#include "tests/speed_accuracy/answer_numbers.hpp"
#include "tests/support/named_scenes.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

AdversarialSurvey sample(std::size_t scenes, std::uint64_t seed, bool questions, const AdversarialRange& range = mild,
                         std::optional<long> effort = {}) {
    AdversarialRun run;
    run.effort = effort;
    run.scenes = scenes;
    run.seed = seed;
    run.range = range;
    run.questions = questions;
    run.contradictions = !questions;
    run.all_motions = false;
    return survey_in_process(run);
}

long most_phases(const AdversarialSurvey& survey) {
    long most = 0;
    for (const auto& [question, of] : survey.most_phases) most = std::max(most, of.first);
    return most;
}

void check_without_faults(const AdversarialSurvey& survey) {
    for (const auto& [what, of] : survey.faults) {
        INFO(what << ", " << of.second.text << ", at " << of.second.json);
        CHECK(of.first == 0);
    }
}

void check_little_is_spent(const AdversarialSurvey& survey) {
    check_without_faults(survey);
    for (const auto& [question, most] : survey.most_spent) {
        INFO(question << " at " << most.second);
        CHECK(most.first <= 4'000'000);
    }
}

void check_without_contradictions(const AdversarialSurvey& survey) {
    check_without_faults(survey);
    long compared = 0;
    for (const auto& [number, of] : survey.quantities) {
        INFO(number << " of " << of.worst.between << ": " << of.worst.ratio << " of both bounds at " << of.json);
        CHECK(of.violations == 0);
        compared += of.count;
    }
    CHECK(compared > 3000);
    CHECK(survey.quantities.size() > 20);
}

bool is_answered_or_refused(const std::string& scene) {
    try {
        (void)solve(named_scene(scene));
    } catch (const DomainError&) {
    } catch (const PrecisionError&) {
    }
    return true;
}

} // namespace

TEST_CASE("every question to seeded scenes is answered by finite numbers or refused by an error of the project's own",
          "[accuracy]") {
    const AdversarialSurvey survey = sample(6, 2, true);
    check_without_faults(survey);
    CHECK(survey.questions > 150);
    // A map of coincident modes near zeta = 1, none of whose points double decides: each of them asks `solve`.
    CHECK(survey.most_eigen_solves <= 40);
    CHECK(survey.most_mode_evaluations <= 170);
    CHECK(most_phases(survey) <= 10000);
}

TEST_CASE("questions to scenes of every kind that may spend little are answered or refused, and spend little more",
          "[accuracy]") {
    const AdversarialSurvey survey = sample(12, 5, true, everything, 30'000);
    check_little_is_spent(survey);
    CHECK(survey.most_spent.at("solve motion").first > 30'000);
}

TEST_CASE("five times as many questions that may spend little are answered or refused, and spend little more",
          "[.][accuracy][sweep]") {
    check_little_is_spent(sample(60, 5, true, everything, 30'000));
    check_little_is_spent(sample(100, 5, true, any_double, 30'000));
}

TEST_CASE("questions to scenes of any doubles that may spend little are answered or refused, and spend little more",
          "[accuracy]") {
    check_little_is_spent(sample(20, 5, true, any_double, 30'000));
    // From an instant of 0 on the search for the end of a stop in 50 digits had a billion steps to shorten.
    CHECK(is_answered_or_refused("billion steps"));
}

TEST_CASE("beyond the range of a double no bound is zero, and none is no number", "[accuracy]") {
    // A displacement of 1e-579 to 30 digits, which in double is zero.
    const Solution sliding = sliding_answer(scene_source(named_scene("far above")), Question{Asked::motion, 30});
    CHECK(sliding.masses[0].amplitude.value == 0);
    CHECK(sliding.masses[0].amplitude.error > 0);
    CHECK(faults_of(sliding).empty());
    // Friction of 7e299: squares of it overflow in the bound of where the contact rests.
    for (const std::string change :
         {R"("damping_ratios": 0.9999999999863517, "mu": 179.9784218711654, "r": 5.439988966263014e-70)",
          R"("damping_ratios": 0.07058154281311652, "mu": 1.0000000000000004, "r": 2.627139795186739e-23)"})
        for (const bool all : {false, true}) {
            const Solution held =
                solve(named_scene(R"(one {"beta": 6.696928794914171e+299, )" + change + "}"), {Asked::motion, {}, all});
            CHECK(held.regime.regime == Regime::permanent_sticking);
            for (const std::string& fault : faults_of(held)) FAIL_CHECK(fault);
        }
}

TEST_CASE("a single mass under a load that is a number moves as under that number times the unit load",
          "[accuracy][exact-solver]") {
    const auto answer = [](const std::string& load) {
        return solve(named_scene(R"(one {"damping_ratios": 0.5, "r": 0.859, )" + load + "}"));
    };
    const Solution unit = answer(R"("load": 1, "beta": 0.78125)");
    for (const char* load : {R"("load": [0.75], "beta": 0.5859375)", R"("load": [-0.75], "beta": 0.5859375)"}) {
        const Solution found = answer(load);
        CHECK(found.stops.size() == 2);
        CHECK(found.masses[0].amplitude.value == Approx(0.75 * unit.masses[0].amplitude.value).epsilon(1e-12));
    }
}

TEST_CASE("answers of few digits and of many contradict each other in no number on seeded scenes", "[accuracy]") {
    const AdversarialSurvey survey = sample(12, 3, false);
    check_without_contradictions(survey);
    CHECK(survey.most_eigen_solves <= 134);
    CHECK(survey.most_mode_evaluations <= 344);
}

TEST_CASE("answers about systems as users give them, in units, contradict each other in no number", "[accuracy]") {
    check_without_contradictions(sample(16, 7, false, units));
    check_without_faults(sample(4, 8, true, units));
}

TEST_CASE("an answer whose boundaries are out of order, or whose displacement is beyond its amplitude, contradicts itself",
          "[accuracy]") {
    const auto number = [](double x) { return Certified{x, 0.125, {}}; };
    Solution s = solve(named_scene(R"(one {"r": 0.5, "beta": 0.1})"));
    Limits& limits = s.limits.value();
    limits.exact = number(2);
    limits.paper = number(2.25);
    limits.approximate = number(1.75);
    s.slides_below = number(2.25);
    s.masses[0].amplitude = number(1);
    s.masses[0].sliding.value().x0 = number(-1.25);
    s.start = SolvedState{{number(-1.25)}, {number(9)}};
    CHECK(contradictions_within(s).empty());
    const auto is_found = [&](Certified& x, double value) {
        const Certified before = std::exchange(x, number(value));
        const bool found = contradictions_within(s).size() == 1;
        x = before;
        return found;
    };
    CHECK(is_found(limits.paper, 2.5));
    CHECK(is_found(limits.approximate, 1.5));
    CHECK(is_found(*s.slides_below, 2.5));
    CHECK(is_found(s.masses[0].sliding->x0, -1.5));
    CHECK(is_found(s.start->x[0], -1.5));
}

TEST_CASE("samples beyond an amplitude, without a mirror image, not finite, or of too few masses are faults", "[accuracy]") {
    const Scene<double> at = named_scene(R"(two {"damping_ratios": 0.05, "beta": 0.4})");
    const Solution s = solve(at);
    REQUIRE(s.symmetric);
    const std::vector<State> states = motion(at, 16).states();
    CHECK(faults_of_samples(s, states).empty());
    const auto is_found = [&](const std::string& fault, const auto& change) {
        std::vector<State> changed = states;
        change(changed);
        return std::ranges::count(faults_of_samples(s, changed), fault) > 0;
    };
    const double more = 2e-6 * s.masses[1].amplitude.value;
    CHECK(is_found("a sample is beyond its amplitude", [&](auto& c) { c[3].x[1] = -s.masses[1].amplitude.value - more; }));
    CHECK(is_found("samples of a symmetric motion do not mirror themselves", [&](auto& c) { c[3].x[1] += more; }));
    CHECK(is_found("a displacement is not finite", [](auto& c) { c[5].x[0] = std::nan(""); }));
    CHECK(is_found("a velocity is not finite", [](auto& c) { c[5].x_prime[0] = HUGE_VAL; }));
    CHECK(is_found("a sample lacks masses", [](auto& c) { c[15].x.pop_back(); }));
}

TEST_CASE("a point at the end of a double's range is answered or refused by an error of the project's own", "[accuracy]") {
    for (const std::string r : {"5e-324", "1e300"}) {
        INFO("r = " << r);
        CHECK(is_answered_or_refused(R"(long period {"r": )" + r + "}"));
    }
}

TEST_CASE("far above its frequency a mass has finite boundaries whatever is asked", "[accuracy][eq:69]") {
    const Scene<double> at = named_scene(R"(one {"r": 1e82, "beta": 2})");
    for (const Asked asked : {Asked::regime, Asked::amplitude, Asked::phase, Asked::motion}) {
        const Solution s = solve(at, {asked, {}});
        REQUIRE(s.limits);
        for (const Certified& limit : {s.limits->exact, s.limits->paper, s.limits->approximate}) // (86) at mu = 1
            CHECK(limit.value == Approx(2 / std::hypot(2, std::acos(-1))).epsilon(1e-6));
    }
}

TEST_CASE("modes of nearly one frequency, a stop without deceleration and a weak spring widen the bounds they make wide",
          "[accuracy]") {
    // Each of these had a number whose error was 4 to 10000 times its bound.
    for (const std::string name : {"nearly one frequency", "weakly joined"}) {
        const Scene<double> at = named_scene(name);
        const Solution few = solve(at), many = solve(at, {Asked::motion, 25});
        for (std::size_t k = 0; k < 2; ++k) {
            const SolvedMass &a = few.masses[k], &b = many.masses[k];
            INFO("mass " << k + 1 << " of " << name);
            CHECK(std::abs(a.amplitude.value - b.amplitude.value) <=
                  a.amplitude.error + b.amplitude.error + 1e-16 * b.amplitude.value);
            if (a.phase) CHECK(std::abs(a.phase->value - b.phase->value) <= a.phase->error + b.phase->error + 4e-16);
        }
        if (few.rest_interval)
            CHECK(std::abs(few.rest_interval->to.value - many.rest_interval->to.value) <=
                  few.rest_interval->to.error + 1e-15 * many.rest_interval->to.value);
    }
}

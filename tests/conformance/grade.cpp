#include "conformance/verdict.hpp"

#include <cmath>
#include <functional>
#include <limits>

#include "conformance/plain/closed_form.hpp"
#include "denhartog/number/number.hpp"
#include "denhartog/sliding/boundary.hpp"
#include "tests/catch.hpp"
#include "tests/conformance/runner_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::conformance;
using namespace denhartog::tests;

namespace {

Verdict verdict_on(const Vector& v, const Answer& answer) { return grade(v, answer).verdict; }
Answer number(double x) { return Value{{x}, ""}; }

} // namespace

TEST_CASE("an error is judged by the three tolerances of the vector, each up to its end", "[conformance]") {
    const Vector v = vector_of("amplitude-1", "amplitude", {0.25});
    CHECK(verdict_on(v, number(0.25)) == Verdict::pass);
    CHECK(verdict_on(v, number(0.25 * (1 + 0.9e-12))) == Verdict::pass);
    CHECK(verdict_on(v, number(0.25 * (1 + 1.1e-12))) == Verdict::pass_loose);
    CHECK(verdict_on(v, number(0.25 * (1 - 0.9e-9))) == Verdict::pass_loose);
    CHECK(verdict_on(v, number(0.25 * (1 - 1.1e-9))) == Verdict::inaccurate);
    CHECK(verdict_on(v, number(0.25 * (1 + 0.9e-3))) == Verdict::inaccurate);
    CHECK(verdict_on(v, number(0.25 * (1 + 1.1e-3))) == Verdict::wrong);
    CHECK(verdict_on(v, number(-0.25)) == Verdict::wrong);
    CHECK(verdict_on(v, number(1e308)) == Verdict::wrong);
}

TEST_CASE("an error is measured against the 40 digits, not against the double nearest to them", "[conformance]") {
    Vector v = vector_of("amplitude-1", "amplitude", {0x1.999999999999ap-4});
    v.value = {"0.1"};
    const Judged judged = grade(v, number(0x1.999999999999ap-4));
    INFO(hexadecimal(*judged.error));
    CHECK(*judged.error > 0);
    CHECK(*judged.error < 0x1p-53);
}

TEST_CASE("an angle is compared round the circle", "[conformance]") {
    const Vector v = vector_of("phase-1", "phase", {3.141592653589793});
    CHECK(verdict_on(v, number(-3.141592653589793)) == Verdict::pass);
    CHECK(verdict_on(v, number(3.141592653589793 - 1e-3)) == Verdict::inaccurate);
    CHECK(verdict_on(v, number(0)) == Verdict::wrong);
}

TEST_CASE("an answer of another shape is wrong, with the reason", "[conformance]") {
    const Vector two = vector_of("modes-1", "modal_frequency_ratios", {1.5, 0.75});
    CHECK(grade(two, number(1.5)).reason == "1 number in place of 2");
    CHECK(verdict_on(two, Value{{1.5, 0.75, 0}, ""}) == Verdict::wrong);
    CHECK(grade(two, Value{{}, "stick_slip"}).reason == "a regime in place of numbers");
    CHECK(grade(two, Value{{1.5, 0.7}, ""}).worst == 1);
    CHECK(verdict_on(word_vector("regime-1", "stick_slip"), number(1)) == Verdict::wrong);
    CHECK(verdict_on(word_vector("regime-1", "stick_slip"), Value{{}, "stick_slip"}) == Verdict::pass);
    CHECK(verdict_on(word_vector("regime-1", "stick_slip"), Value{{}, "continuous"}) == Verdict::wrong_regime);
}

TEST_CASE("rejecting is right where a rule is broken and wrong where none is", "[conformance]") {
    const Vector good = vector_of("amplitude-1", "amplitude", {0.25});
    CHECK(verdict_on(good, Rejected{"no"}) == Verdict::wrong);
    CHECK(grade(good, Rejected{"mu"}).reason == "it was rejected, but keeps all rules: mu");
    CHECK(verdict_on(reject_vector("reject-1"), Rejected{"mu"}) == Verdict::rejected);
    CHECK(verdict_on(reject_vector("reject-1"), number(1)) == Verdict::not_rejected);
    CHECK(verdict_on(reject_vector("reject-1"), Unusable{"nan"}) == Verdict::not_rejected);
    CHECK(verdict_on(reject_vector("reject-1"), Skipped{"later"}) == Verdict::skipped);
    CHECK(verdict_on(good, Unusable{"nan"}) == Verdict::wrong);
    CHECK_FALSE(grade(good, Unusable{"nan"}).answered);
}

TEST_CASE("the closed form continued beyond its boundary is the answer of another regime", "[conformance][eq:38][eq:69]") {
    for (const char* quantity : {"amplitude", "phase", "displacement", "motion_under_force"}) {
        Vector v = vector_of("slip-1", quantity, {0.125});
        v.question.r = 0.5;
        v.question.contact = v.question.load = 1;
        const Scene<double> scene = scene_of(v.question);
        const ModeSums<double> sums = mode_sums(modal_basis(scene.system), scene.system.contact, scene.system.load, v.question.r);
        v.question.beta = 1.01 * boundary(sums, v.question.mu).exact;
        v.question.tau = v.question.quantity == "displacement" ? 0.5 : 0;
        v.regime = "stick_slip";
        if (v.question.quantity == "motion_under_force") {
            v.question.samples = 16;
            v.nearest.assign(16, 0.125);
            v.value.assign(16, "0.125");
        }
        Choices forgetful;
        forgetful.beyond_the_boundary = true;
        const std::optional<Value> beyond = plain_answer(v.question, forgetful);
        INFO(quantity);
        REQUIRE(beyond);
        CHECK(verdict_on(v, *beyond) == Verdict::wrong_regime);
        Value near = *beyond;
        for (double& x : near.numbers) x *= 1 + 1e-4;
        CHECK(verdict_on(v, near) == Verdict::wrong);
        v.regime = "continuous";
        CHECK(verdict_on(v, *beyond) == Verdict::wrong);
    }
    Vector stops = vector_of("slip-2", "stops_per_period", {2});
    stops.regime = "stick_slip";
    CHECK(verdict_on(stops, number(0)) == Verdict::wrong_regime);
    CHECK(verdict_on(stops, number(4)) == Verdict::wrong);
}

TEST_CASE("a curve has a tube around an event and none elsewhere", "[conformance]") {
    constexpr std::size_t n = 64;
    const double step = 2 * pi<double>() / n;
    const auto sampled = [&](const std::function<double(double)>& x, double late) {
        std::vector<double> samples;
        for (std::size_t i = 0; i < n; ++i)
            samples.push_back(x(std::fmod(static_cast<double>(i) * step - late + 2 * pi<double>(), 2 * pi<double>())));
        return samples;
    };
    const auto smooth = [](double t) { return std::cos(t); };
    CHECK(curve_deviation(sampled(smooth, 0), sampled(smooth, 0)).size == 0);
    const double late = curve_deviation(sampled(smooth, 0.4 * step), sampled(smooth, 0)).size;
    INFO(hexadecimal(late));
    CHECK(late > 0.9 * 0.4 * step);
    // A triangle: its corners are events, its flanks are not.
    const auto corner = [](double t) { return 1 - std::abs(t - pi<double>()); };
    std::vector<double> given = sampled(corner, 0);
    given[n / 2] -= 0.4 * step;
    CHECK(curve_deviation(given, sampled(corner, 0)).size == 0);
    given[n / 2] -= 0.4 * step;
    CHECK(curve_deviation(given, sampled(corner, 0)).size > 0.2 * step);
    given = sampled(corner, 0);
    given[n / 4] -= 0.4 * step;
    CHECK(curve_deviation(given, sampled(corner, 0)).size > 0.3 * step);
    CHECK(curve_deviation(given, sampled(corner, 0)).worst == n / 4);
}

TEST_CASE("a score has counts, median and worst digits a tier and group, the tier that binds first", "[conformance]") {
    std::vector<Vector> vectors{vector_of("a-1", "amplitude", {1}, "should")};
    for (int k = 1; k <= 3; ++k) vectors.push_back(vector_of("b-" + std::to_string(k), "amplitude", {1}));
    const std::vector<Judged> judged{grade(vectors[0], Skipped{""}), grade(vectors[1], number(1 + 1e-10)),
                                     grade(vectors[2], number(1 + 1e-6)), grade(vectors[3], number(1.1))};
    const std::vector<Score> all = scores(judged);
    REQUIRE(all.size() == 2);
    CHECK(all[0].tier == "must");
    CHECK(all[0].asked == 3);
    CHECK(all[0].counts[static_cast<std::size_t>(Verdict::inaccurate)] == 1);
    CHECK(*all[0].median_digits == Approx(6).epsilon(1e-6));
    CHECK(*all[0].worst_digits == Approx(1).epsilon(1e-6));
    CHECK_FALSE(all[1].median_digits);
    CHECK(worst_first(judged).front()->vector->question.id == "b-3");
}

TEST_CASE("digits are from 0 to 17", "[conformance]") {
    CHECK(digits(0) == 17);
    CHECK(digits(1e-300) == 17);
    CHECK(digits(1e-3) == Approx(3));
    CHECK(digits(1) == 0);
    CHECK_FALSE(std::signbit(digits(1)));
    CHECK(digits(7) == 0);
    CHECK(digits(std::numeric_limits<double>::infinity()) == 0);
}

TEST_CASE("nothing answered does not conform, a skipped needed quantity neither", "[conformance]") {
    const Vector v = vector_of("a-1", "amplitude", {1});
    const Vector other = vector_of("a-2", "phase", {1});
    const std::vector<Judged> none{grade(v, Skipped{""})};
    CHECK_FALSE(conforms(none, {}));
    const std::vector<Judged> one{grade(v, Skipped{""}), grade(other, number(1))};
    CHECK(conforms(one, {}));
    CHECK_FALSE(conforms(one, {"amplitude"}));
    CHECK(conforms(one, {"phase"}));
}

TEST_CASE("text of a program is shown without control characters and as valid UTF-8", "[conformance]") {
    const Judged judged = grade(vector_of("a-1", "amplitude", {1}), Unusable{"a\x1b[31mb\xFF" + std::string(5000, 'x')});
    CHECK(judged.reason.starts_with("a\\x1B[31mb\\xFFxxx"));
    CHECK(judged.reason.size() < 300);
    for (std::size_t n = 0; n < number_of_verdicts; ++n)
        CHECK(verdict_named(name(static_cast<Verdict>(n))) == static_cast<Verdict>(n));
}

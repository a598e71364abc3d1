// Mistakes with a number of their own: the number is found from the answers.
#include "conformance/diagnosis/explanations.hpp"

#include <numbers>

#include "conformance/diagnose.hpp"
#include "conformance/plain/closed_form.hpp"
#include "conformance/verdict.hpp"
#include "tests/catch.hpp"
#include "tests/conformance/vector_folder.hpp"

using namespace denhartog;
using namespace denhartog::conformance;
using namespace denhartog::tests;

namespace {

// Every so many certified vectors of some quantities, answered by a program.
template <class Answering>
std::vector<Judged> answered(const std::vector<std::string>& quantities, std::size_t every, const Answering& answering) {
    std::vector<Judged> judged;
    std::size_t n = 0;
    for (const Vector& v : vectors()) {
        if (!is_of_the_paper(v.question)) continue;
        if (!v.reject.empty() || std::find(quantities.begin(), quantities.end(), v.question.quantity) == quantities.end())
            continue;
        if (n++ % every != 0) continue;
        const std::optional<Value> value = answering(v);
        judged.push_back(grade(v, value.value_or(truth_of(v))));
    }
    return judged;
}

Finding first_finding(std::vector<Judged>& judged) {
    const Diagnosis d = diagnose(judged, fitted_to(judged));
    INFO(d.wrong << " wrong of " << judged.size());
    REQUIRE_FALSE(d.findings.empty());
    return d.findings.front();
}

} // namespace

TEST_CASE("the period in which a transient is read off is found from the answers", "[conformance][diagnosis][fitted]") {
    for (const int period : {1, 7, 43, 160}) {
        std::vector<Judged> judged = answered({"amplitude", "motion_under_force"}, 6, [&](const Vector& v) {
            return answers_of_transient(v.question, period, period).front();
        });
        const Finding found = first_finding(judged);
        INFO(period << ": " << found.mistake.name << " explains " << found.explained);
        CHECK(found.mistake.name == "transient");
        CHECK(found.mistake.number == "read off in period " + std::to_string(period) + " from rest");
    }
}

TEST_CASE("a transient that was found has no answer to a question that breaks a rule", "[conformance][diagnosis][fitted]") {
    const std::vector<Judged> judged =
        answered({"amplitude"}, 12, [&](const Vector& v) { return answers_of_transient(v.question, 7, 7).front(); });
    const std::vector<Mistake> known = fitted_to(judged);
    const auto transient = std::ranges::find(known, "transient", &Mistake::name);
    REQUIRE(transient != known.end());
    REQUIRE(transient->number == "read off in period 7 from rest");
    ProtocolQuestion q = judged.front().vector->question;
    CHECK(transient->answer(q));
    q.mass_ratios.front() = -1;
    CHECK_FALSE(transient->answer(q));
}

TEST_CASE("answers that are all right, or wrong by a factor, show no transient", "[conformance][diagnosis][fitted]") {
    for (const double factor : {1.0, 1.25, 1.4}) {
        const std::vector<Judged> judged = answered({"amplitude"}, 6, [&](const Vector& v) {
            return Value{{factor * v.nearest.front()}, ""};
        });
        CHECK_FALSE(fitted_transient(judged));
    }
}

TEST_CASE("instants that go with r or R from scene to scene are found from the answers",
          "[conformance][diagnosis][fitted][eq:57]") {
    struct Steps {
        std::string told;
        double (*of)(const PlainModes&);
    };
    for (const Steps& steps :
         {Steps{"", [](const PlainModes&) { return 1.0; }}, Steps{" times r", [](const PlainModes& m) { return m.r; }},
          Steps{" times 1/r", [](const PlainModes& m) { return 1 / m.r; }},
          Steps{" times R_1", [](const PlainModes& m) { return m.R[0]; }},
          Steps{" times R_N", [](const PlainModes& m) { return m.R.tail(1)[0]; }}}) {
        std::vector<Judged> judged = answered({"S_j", "beta_lim_paper", "beta_lim_exact"}, 3, [&](const Vector& v) {
            const PlainModes m = plain_modes(v.question, {});
            const double h = 0.0125 * steps.of(m);
            Choices c;
            c.demand_as_printed = true;
            const double count = std::min(4096.0, std::round(std::numbers::pi / h - 2)) + 1;
            c.instants = Instants{h, h, static_cast<std::size_t>(std::max(2.0, count))};
            return is_overdamped(v.question) ? std::optional<Value>() : plain_answer(v.question, c);
        });
        INFO(steps.told);
        const Finding found = first_finding(judged);
        INFO(steps.told << ": " << found.mistake.number);
        CHECK(found.mistake.name == "57-as-printed");
        CHECK(found.mistake.number.starts_with("instants from 0.0125" + steps.told + " to pi - 0.0125" + steps.told + ";"));
        CHECK(found.contradicted == 0);
    }
}

TEST_CASE("where r alone is wrong, the natural frequencies are right and R is first wrong", "[conformance][diagnosis]") {
    std::vector<Judged> judged =
        answered({"natural_frequency_ratios", "modal_frequency_ratios", "mode_shape_products", "complex_response"}, 3,
                 [&](const Vector& v) {
                     ProtocolQuestion q = v.question;
                     q.r *= 1.37;
                     return plain_answer(q);
                 });
    const Diagnosis d = diagnose(judged, fitted_to(judged));
    REQUIRE(d.chain.size() >= 3);
    CHECK(d.chain[0].property == "natural frequencies");
    CHECK(d.chain[0].wrong == 0);
    CHECK(d.chain[1].property == "R = r / r_n, (22)");
    CHECK(d.chain[1].wrong == d.chain[1].asked);
}

// Answers are judged by the abilities of their method.
#include "conformance/verdict.hpp"

#include "tests/catch.hpp"
#include "tests/conformance/runner_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::conformance;
using namespace denhartog::tests;

namespace {

const SolverMethod& stepping() { return method_named("time-stepping"); }

// An amplitude of 1 with a condition number of 2, and an answer that is so much off.
Judged judged_by(const SolverMethod& method, Vector& v, double off) {
    widen(v, method);
    Judged judged = grade(v, Value{{1 + off}, ""});
    excuse(judged, method);
    return judged;
}

const std::string groups = "contact,boundary,stick-slip,stuck,solver";

} // namespace

TEST_CASE("a method's tolerances grow with the condition number and never narrow the vector's", "[conformance][method]") {
    const Vector own = vector_of("amplitude-1", "amplitude", {1});
    for (const SolverMethod& method : methods()) {
        INFO(method.name);
        CHECK(method.displacement.pass <= method.displacement.loose);
        CHECK(method.displacement.loose <= method.displacement.inaccurate);
        Vector v = own;
        widen(v, method);
        CHECK(v.tolerance.loose == std::max(own.tolerance.loose, 2 * method.displacement.loose));
        CHECK(v.tolerance.inaccurate >= own.tolerance.inaccurate);
    }
    Vector v = own;
    CHECK(judged_by(methods().front(), v, 1e-4).verdict == Verdict::inaccurate);
    CHECK(judged_by(stepping(), v, 1e-4).verdict == Verdict::pass_loose);
    CHECK(judged_by(stepping(), v, 0.05).verdict == Verdict::wrong);
    Vector other = vector_of("functions-1", "first_damping_function", {1}), untouched = other;
    widen(untouched, stepping());
    CHECK(untouched.tolerance.loose == other.tolerance.loose);
}

TEST_CASE("what a method cannot know is skipped where it is wrong, and counts where it is right", "[conformance][method]") {
    Vector undamped = vector_of("amplitude-1", "amplitude", {1});
    undamped.question.damping_ratios = {0.125, 0};
    Vector v = undamped;
    CHECK(judged_by(methods().front(), v, 0.5).verdict == Verdict::wrong);
    CHECK(judged_by(method_named("harmonic-balance"), v, 0.5).verdict == Verdict::wrong);
    const Judged skipped = judged_by(stepping(), v, 0.5);
    CHECK(skipped.verdict == Verdict::skipped);
    CHECK(skipped.reason.find("without damping") != std::string::npos);
    CHECK(judged_by(stepping(), v, 0).verdict == Verdict::pass);
    Vector function = vector_of("functions-1", "first_damping_function", {1}); // nothing of the motion
    function.question.damping_ratios = {0.125, 0};
    CHECK(judged_by(stepping(), function, 0.5).verdict == Verdict::wrong);

    Vector near = word_vector("regime-1", "continuous");
    near.margin = 0.5 * stepping().margin;
    for (const double margin : {0.5, 2.0}) {
        near.margin = margin * stepping().margin;
        Judged judged = grade(near, Value{{}, "stick_slip"});
        excuse(judged, stepping());
        CHECK(judged.verdict == (margin < 1 ? Verdict::skipped : Verdict::wrong_regime));
    }
    Vector phase = vector_of("phase-1", "phase", {1});
    phase.regime = "stick_slip";
    CHECK(judged_by(method_named("harmonic-balance"), phase, 1).verdict == Verdict::skipped);
    CHECK(judged_by(stepping(), phase, 1).verdict != Verdict::skipped);
    CHECK_THROWS_AS(method_named("guesswork"), InputError);
}

TEST_CASE("integrators and harmonic balance conform by what their methods can do, and by no more",
          "[conformance][method][program]") {
    struct Solver {
        std::string program, setting, method;
    };
    for (const Solver& solver : {Solver{"paper_algorithm_adapter", "1e-6", "event-driven"},
                                 Solver{"harmonic_balance_adapter", "51", "harmonic-balance"}}) {
        const std::string ask = "run --jobs 2 --filter '[05]$' --group " + groups + " ",
                          program = " -- " + quoted_program(solver.program) + " " + solver.setting;
        const Run by_method = conform(ask + "--method " + solver.method + program);
        INFO(by_method.output << by_method.error);
        CHECK(by_method.status == 0);
        CHECK(contains(by_method.output, "judged by what " + solver.method + " can do"));
        CHECK(conform(ask + program).status == 1);
    }
    // Friction that is too large by a tenth is no matter of the method.
    const std::string halved =
        quoted_program("paper_algorithm_adapter") + " 1e-6 | stdbuf -oL sed -E 's/\"value\":0\\.0/\"value\":0.1/'";
    const Run wrong =
        conform("run --filter '[05]$' --group contact --method event-driven -- " + script("tenth.sh", halved + "\n"));
    INFO(wrong.output << wrong.error);
    CHECK(wrong.status == 1);
}

TEST_CASE("methods are listed with their tolerances, and a name that is none is told them", "[conformance][method][program]") {
    const Run listed = conform("list --methods");
    CHECK(listed.status == 0);
    for (const SolverMethod& method : methods()) CHECK(contains(listed.output, std::string(method.name)));
    const Run none = conform("run " + with_vectors(six(), "--method guesswork -- true"));
    CHECK(none.status == 2);
    CHECK(contains(none.error, "method must be one of closed-form, event-driven, time-stepping, harmonic-balance"));
    const Run graded = conform("grade " + with_vectors(six(), "--method time-stepping --format json ") +
                               file_with("answers.csv", "id,value\namplitude-1,0.2501\n").string());
    INFO(graded.output << graded.error);
    const auto report = nlohmann::json::parse(graded.output);
    CHECK(report.at("method") == "time-stepping");
    CHECK(report.at("counts").at("pass-loose") == 1);
}

// The time integrators of the conformance kit, asked through a pipe.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "tests/conformance/shell.hpp"

namespace denhartog::tests {
namespace {

using Json = nlohmann::json;

constexpr double near = 1e-9; // tolerances are 1e-12; errors add up over periods, and a largest displacement is flat

std::vector<std::string> lines_through_a_pipe(const std::string& command, const std::string& input) {
    const Run run = run_shell("cat | " + command, input);
    INFO(run.error);
    REQUIRE(run.status == 0);
    return lines_of(run.output);
}

std::vector<Json> answers(const std::string& command, const std::vector<Json>& questions) {
    std::string input = "denhartog-conform 1\n";
    for (const Json& question : questions) input += question.dump() + "\n";
    const std::vector<std::string> lines = lines_through_a_pipe(command, input);
    REQUIRE(lines.size() == questions.size() + 1);
    CHECK(lines[0].starts_with("denhartog-conform 1 json "));
    std::vector<Json> all;
    for (std::size_t n = 0; n < questions.size(); ++n) {
        all.push_back(Json::parse(lines[n + 1]));
        CHECK(all.back().at("id") == questions[n].at("id"));
    }
    return all;
}

Json question(const Json& scene, const std::string& quantity, int mass = 0, int samples = 0) {
    Json q = {{"id", quantity + "-" + std::to_string(mass)}, {"quantity", quantity}, {"scene", scene}};
    if (mass > 0) q["mass"] = mass;
    if (samples > 0) q["samples"] = samples;
    return q;
}

Json chain(const std::vector<double>& masses, const std::vector<double>& springs, const std::vector<double>& zeta, int contact,
           double mu, double r, double beta) {
    return {{"mass_ratios", masses},
            {"stiffness_ratios", springs},
            {"damping_ratios", zeta},
            {"contact", contact},
            {"load", 1},
            {"mu", mu},
            {"r", r},
            {"beta", beta}};
}

Json one_mass(double zeta, double mu, double r, double beta) { return chain({1}, {1}, {zeta}, 1, mu, r, beta); }

Json three_masses(const std::vector<double>& zeta, double mu, double r, double beta) {
    return chain({1, 2.5, 0.75}, {1, 0.625, 1.875}, zeta, 2, mu, r, beta);
}

Json solved(const Json& scene) {
    const Run run = run_program("solve --json --digits 12", scene.dump());
    REQUIRE(run.status == 0);
    return Json::parse(run.output);
}

void check_near(double given, double expected, const std::string& what) {
    char text[160];
    std::snprintf(text, sizeof text, "%s: %a, expected %a, apart %.1e", what.c_str(), given, expected, given - expected);
    INFO(text);
    CHECK(std::abs(given - expected) <= near);
}

// Everything that an integrator answers, against the library's own exact routes.
void check_against_solve(const Json& scene, const std::string& regime,
                         const std::string& integrator = "paper_algorithm_adapter") {
    const Json truth = solved(scene);
    INFO(scene.dump());
    REQUIRE(truth.at("regime") == regime);
    const int N = static_cast<int>(scene.at("mass_ratios").size());
    std::vector<Json> questions = {question(scene, "regime"), question(scene, "stops_per_period"),
                                   question(scene, "stop_durations")};
    for (int k = 1; k <= N; ++k) {
        questions.push_back(question(scene, "amplitude", k));
        questions.push_back(question(scene, "phase", k));
        questions.push_back(question(scene, "motion_under_force", k, 6));
    }
    const std::vector<Json> given = answers(quoted_program(integrator), questions);
    CHECK(given[0].at("value") == regime);
    if (regime == "permanent_sticking") {
        CHECK(given[1].contains("skip"));
        CHECK(given[2].contains("skip"));
    } else {
        std::vector<double> durations;
        for (const Json& stop : truth.value("stops", Json::array()))
            durations.push_back(stop.at("end").get<double>() - stop.at("start").get<double>());
        std::sort(durations.begin(), durations.end());
        CHECK(given[1].at("value") == durations.size());
        REQUIRE(given[2].at("value").size() == durations.size());
        for (std::size_t n = 0; n < durations.size(); ++n)
            check_near(given[2].at("value")[n], durations[n], "duration of stop " + std::to_string(n + 1));
    }
    for (int k = 1; k <= N; ++k) {
        const Json& mass = truth.at("masses")[static_cast<std::size_t>(k - 1)];
        const std::size_t at = static_cast<std::size_t>(3 * k);
        const std::string name = " of mass " + std::to_string(k);
        check_near(given[at].at("value"), mass.at("amplitude"), "amplitude" + name);
        if (mass.contains("phase"))
            check_near(
                std::remainder(given[at + 1].at("value").get<double>() - mass.at("phase").get<double>(), 2 * std::numbers::pi), 0,
                "phase" + name);
        else
            CHECK(given[at + 1].contains("skip"));
        const std::vector<double> x = given[at + 2].at("value");
        REQUIRE(x.size() == 6);
        for (std::size_t n = 0; n < 3; ++n) check_near(x[n + 3], -x[n], "half a period later, the displacement" + name);
    }
}

} // namespace

TEST_CASE(
    "the paper's algorithm under the conformance kit is right in every regime, with little damping and beyond critical damping",
    "[eq:6][eq:18][eq:38][eq:74][eq:75][eq:88]") {
    const std::vector<double> usual{0.03125, 0.0625, 0.09375};
    check_against_solve(one_mass(0.0625, 1, 1.125, 0.25), "continuous");
    check_against_solve(three_masses(usual, 1.375, 1.125, 0.03125), "continuous");
    check_against_solve(three_masses({0.0009765625, 0.0009765625, 0.001953125}, 1, 1.125, 0.03125), "continuous");
    check_against_solve(one_mass(0.0625, 1, 0.25, 0.75), "stick_slip");
    check_against_solve(three_masses(usual, 1.375, 0.375, 0.296875), "stick_slip");
    check_against_solve(three_masses({0.125, 1.5, 2.5}, 1, 0.5, 0.25), "stick_slip");
    check_against_solve(one_mass(0.0625, 1, 0.75, 1.25), "permanent_sticking");
    check_against_solve(three_masses(usual, 1, 1.125, 2), "permanent_sticking");
}

TEST_CASE("with mu > 1 integration is not led by extrapolation to a motion that is not stable", "[eq:3][eq:6]") {
    const Json scene = one_mass(0.03125, 3.75, 0.359375, 0.1640625), truth = solved(scene);
    REQUIRE(truth.at("symmetric") == false);
    const std::vector<Json> given =
        answers(quoted_program("paper_algorithm_adapter"), {question(scene, "amplitude", 1), question(scene, "stop_durations")});
    check_near(given[0].at("value"), truth.at("masses").at(0).at("amplitude"), "amplitude");
    REQUIRE(given[1].at("value").size() == 2);
    const Json& shorter = truth.at("stops").at(0);
    check_near(given[1].at("value")[0], shorter.at("end").get<double>() - shorter.at("start").get<double>(), "shorter stop");
    // The motion of the next scene returns after three periods only.
    const Json of_three = one_mass(0.015625, 3.5, 0.40625, 0.078125);
    CHECK(solved(of_three).at("periods") == 3);
    CHECK(answers(quoted_program("paper_algorithm_adapter"), {question(of_three, "amplitude", 1)})[0].contains("skip"));
}

TEST_CASE("without friction the motion under the force is that of a linear oscillator", "[eq:23]") {
    const double zeta = 0.125, r = 1.5;
    const double real = 1 - r * r, imaginary = 2 * zeta * r, size = std::hypot(real, imaginary),
                 lag = std::atan2(imaginary, real);
    const std::vector<Json> given =
        answers(quoted_program("paper_algorithm_adapter"),
                {question(one_mass(zeta, 1, r, 0), "motion_under_force", 1, 32), question(one_mass(zeta, 1, r, 0), "phase", 1)});
    const std::vector<double> x = given[0].at("value");
    REQUIRE(x.size() == 32);
    for (std::size_t n = 0; n < x.size(); ++n)
        check_near(x[n], std::cos(std::numbers::pi * static_cast<double>(n) / 16 - lag) / size, "sample " + std::to_string(n));
    check_near(given[1].at("value"), lag, "phase");
}

TEST_CASE("an integrator that cannot tell says so, and a scene that breaks a rule is rejected", "[eq:6]") {
    const Json fine = one_mass(0.0625, 1, 1.125, 0.25);
    Json unknown = question(fine, "amplitude", 1);
    unknown["quantity"] = "colour";
    // The last at the resonance of a mode without damping, of which so little friction takes less than the force gives.
    const std::vector<Json> given =
        answers(quoted_program("paper_algorithm_adapter"),
                {question(fine, "H_j"), unknown, question(one_mass(0.0625, 0.5, 1.125, 0.25), "amplitude", 1),
                 question(fine, "amplitude", 2), question(one_mass(0, 1, 1, 0.03125), "amplitude", 1)});
    CHECK(given[0].contains("skip"));
    CHECK(given[1].contains("skip"));
    CHECK(given[2].at("reject").get<std::string>().find("mu") != std::string::npos);
    CHECK(given[3].at("reject").get<std::string>().find("mass") != std::string::npos);
    CHECK(given[4].at("skip").get<std::string>().find("has not settled within") != std::string::npos);
}

TEST_CASE("a solver whose package is missing skips every question by the package's name", "[eq:6]") {
    const std::vector<Json> given = answers(
        quoted_program("missing_adapter") + " 'SUNDIALS CVODE' libsundials-dev",
        {question(one_mass(0.0625, 1, 1.125, 0.25), "amplitude", 1), question(one_mass(0.0625, 1, 1.125, 0.25), "regime")});
    for (const Json& answer : given) CHECK(answer.at("skip") == "not installed: libsundials-dev");
}

TEST_CASE("CVODE under the conformance kit is right in every regime", "[eq:6][eq:74]") {
    if (!is_built_or_skipped("cvode_adapter")) return;
    check_against_solve(three_masses({0.03125, 0.0625, 0.09375}, 1, 1.125, 0.03125), "continuous", "cvode_adapter");
    check_against_solve(three_masses({0.03125, 0.0625, 0.09375}, 1.375, 0.375, 0.296875), "stick_slip", "cvode_adapter");
    check_against_solve(three_masses({0.03125, 0.0625, 0.09375}, 1, 1.125, 2), "permanent_sticking", "cvode_adapter");
    // Near each extremum of the force the load exceeds static friction for less than a step.
    check_against_solve(one_mass(0.015625, 1, 0.0625, 0.59375), "stick_slip", "cvode_adapter");
}

TEST_CASE("Siconos under the conformance kit is as near as its steps allow", "[eq:6][eq:74]") {
    if (!is_built_or_skipped("siconos_adapter")) return;
    const Json scene = one_mass(0.0625, 1, 0.25, 0.75);
    const Json truth = solved(scene), &stop = truth.at("stops").at(0);
    const std::vector<Json> given =
        answers(quoted_program("siconos_adapter"), {question(scene, "amplitude", 1), question(scene, "stop_durations")});
    // A step is 2 pi / 16384 long, and its square 1.5e-7, by which the amplitude is off. The instants in a step are interpolated.
    // A tenth of what is allowed would hold for neither.
    CHECK(given[0].at("value").get<double>() == Approx(truth.at("masses").at(0).at("amplitude").get<double>()).epsilon(1e-6));
    CHECK(given[1].at("value").at(0).get<double>() ==
          Approx(stop.at("end").get<double>() - stop.at("start").get<double>()).epsilon(1e-5));
}

} // namespace denhartog::tests

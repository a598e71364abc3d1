// How much amplitudes change with the numbers of a scene, against the derivative by hand and against what units ask for.
#include "denhartog/solve/find.hpp"

#include <cmath>
#include <map>

#include "denhartog/number/errors.hpp"
#include "tests/catch.hpp"
#include "tests/unit/program_runs.hpp"

using namespace denhartog;

namespace {

using Conditions = std::map<std::string, std::vector<std::optional<double>>>;

Conditions conditions(const std::string& scene) {
    Conditions found;
    for (const ConditionOfAmplitudes& c : conditions_of(scene)) found.emplace(c.number, c.of_masses);
    return found;
}

std::string linear(const std::string& r) {
    return R"({"mass_ratios": 1, "stiffness_ratios": 1, "damping_ratios": 0.1, "contact": 1, "load": 1, "beta": 0, "r": )" + r +
           "}";
}

} // namespace

TEST_CASE("the condition of a mass without friction is the derivative by hand", "[condition]") {
    for (const double r : {0.5, 0.9, 1.0, 1.5, 3.0}) {
        const double zeta = 0.1, s = r * r, D = (1 - s) * (1 - s) + 4 * zeta * zeta * s;
        const Conditions found = conditions(linear(std::to_string(r)));
        INFO("r = " << r);
        REQUIRE(found.size() == 2); // beta is zero, and the two ratios are 1 by definition
        REQUIRE(found.at("r")[0]);
        CHECK(std::abs(*found.at("r")[0] - s * (2 * (1 - s) - 4 * zeta * zeta) / D) < 1e-5 * (1 + 1 / D));
        REQUIRE(found.at("damping_ratios")[0]);
        CHECK(std::abs(*found.at("damping_ratios")[0] + 4 * zeta * zeta * s / D) < 1e-5);
    }
}

TEST_CASE("conditions add up as the units of a scene ask", "[condition]") {
    for (const char* friction : {"20", "150"}) { // without stops, and with
        const std::string scene =
            R"({"masses": [10, 5], "stiffnesses": [4000, 3000], "damping_ratios": [0.02, 0.03], "contact": 1,
            "load": 2, "force": 100, "frequency_hz": 2.5, "friction": )" +
            std::string(friction) + "}";
        const Conditions found = conditions(scene);
        INFO(scene);
        REQUIRE(found.size() == 9);
        for (std::size_t k = 0; k < 2; ++k) {
            const auto of = [&](const char* number) {
                REQUIRE(found.at(number)[k]);
                return *found.at(number)[k];
            };
            const double forces = of("force") + of("friction"), masses = of("masses/1") + of("masses/2"),
                         springs = of("stiffnesses/1") + of("stiffnesses/2");
            CHECK(std::abs(forces - 1) < 1e-3);                                         // all forces twice as large
            CHECK(std::abs(forces + masses + springs) < 1e-3 * std::abs(masses));       // another unit of mass
            CHECK(std::abs(2 * masses - of("frequency_hz")) < 1e-3 * std::abs(masses)); // another unit of time
        }
    }
}

TEST_CASE("a condition that is not known is left out, and --condition goes with whole answers", "[condition][program]") {
    const std::string stuck =
        R"({"mass_ratios": 1, "stiffness_ratios": 1, "damping_ratios": 0.1, "contact": 1, "load": 1, "r": 0.5,
        "beta": 2})"; // the mass does not move
    for (const auto& [number, of_masses] : conditions(stuck)) CHECK(!of_masses[0]);
    using tests::Run;
    using tests::run_program;
    const Run run = run_program("solve - --condition --json", linear("0.5"));
    REQUIRE(run.status == 0);
    const auto answer = nlohmann::json::parse(run.output);
    CHECK(answer["condition"].size() == 2);
    CHECK(answer["condition"]["r"].size() == 1);
    CHECK(run_program("solve - --condition", linear("0.5")).output.find("for one of r") != std::string::npos);
    for (const char* options : {"--samples 4", "--mass 1", "--ask regime"}) {
        const Run bad = run_program(std::string("solve - --condition ") + options, linear("0.5"));
        CHECK(bad.status == 2);
        CHECK(bad.error.find("condition must") != std::string::npos);
    }
}

TEST_CASE("amplitudes that hang on the last digits of a scene come with a warning, others do not",
          "[condition][program][solve]") {
    using tests::run_program;
    const auto asked = [](const std::string& r, const std::string& zeta, const std::string& command = "solve --json") {
        return nlohmann::json::parse(run_program(command, R"({"mass_ratios": [1], "stiffness_ratios": [1], "contact": 1,
            "load": 1, "beta": 0.1, "damping_ratios": )" + zeta +
                                                              R"(, "r": )" + r + "}")
                                         .output);
    };
    // The amplitude at two neighbouring doubles, r of the second a unit in the last place above that of the first.
    const double far = asked("1.0000000000001", "0")["masses"][0]["amplitude"],
                 near = asked("1.0000000000001003", "0")["masses"][0]["amplitude"];
    CHECK(std::abs(far / near - 1) > 1e-3);
    CHECK(asked("1.0000000000001", "0")["warning"].get<std::string>().find("mode 1 has next to no damping") != std::string::npos);
    for (const auto& [r, zeta] : {std::pair("1.0000000001", "0"), {"1.0000000000001", "1e-9"}, {"0.5", "0"}})
        CHECK_FALSE((asked(r, zeta).contains("warning") || asked(r, zeta, "response --json").contains("warning")));
    CHECK(asked("1.0000000000001", "0", "response --json")["warning"] == asked("1.0000000000001", "0")["warning"]);
}

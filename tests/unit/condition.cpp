// Condition numbers of amplitudes, against derivatives by hand and against the scaling that units demand.
#include "denhartog/solve/find.hpp"

#include <cmath>
#include <map>

#include "tests/catch.hpp"
#include "tests/unit/program_table.hpp"

using namespace denhartog;
using namespace denhartog::tests;

namespace {

using Conditions = std::map<std::string, std::vector<std::optional<double>>>;

Conditions conditions(const std::string& scene) {
    Conditions found;
    for (const ConditionOfAmplitudes& c : conditions_of(scene)) found.emplace(c.number, c.of_masses);
    return found;
}

std::string linear(const std::string& r) {
    return text_of_scene(R"(one {"damping_ratios": 0.1, "beta": 0, "mu": null, "r": )" + r + "}");
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
        const std::string scene = text_of_scene(R"(two in hertz {"friction": )" + std::string(friction) + "}");
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
    const std::string stuck = text_of_scene(R"(one {"damping_ratios": 0.1, "r": 0.5, "beta": 2})"); // the mass does not move
    for (const auto& [number, of_masses] : conditions(stuck)) CHECK(!of_masses[0]);
    expect(R"(
        0 solve - --condition --json < one {"damping_ratios": 0.1, "beta": 0, "mu": null, "r": 0.5}
          = {"condition": "# 2"}
          = {"condition": {"r": "# 1"}}
        0 solve - --condition < one {"damping_ratios": 0.1, "beta": 0, "mu": null, "r": 0.5} > for one of r
        2 solve - --condition {--samples 4|--mass 1|--ask regime} < one ! condition must
    )");
}

TEST_CASE("amplitudes that hang on the last digits of a scene come with a warning, others do not",
          "[condition][program][solve]") {
    const auto asked = [](const std::string& r, const std::string& zeta, const std::string& command = "solve --json") {
        return answer_of(command, R"(one {"beta": 0.1, "damping_ratios": )" + zeta + R"(, "r": )" + r + "}");
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

#include <cmath>
#include <numbers>

#include "tests/catch.hpp"
#include "tests/unit/program_table.hpp"

using namespace denhartog::tests;
using nlohmann::json;

namespace {

// The pair of masses where its contact slides, where it stops, and where it never moves.
const std::vector<std::string> regimes{R"(two {"r": 1.25, "beta": 0.0625})", "two", R"(two {"r": 0.75, "beta": 3})"};

} // namespace

TEST_CASE("solve answers with the object of response in the sliding regime", "[program][solve]") {
    const json a = answer_of("solve --json", regimes[0]), b = answer_of("response --json", regimes[0]);
    for (const auto& [key, value] : b.items()) {
        INFO(key);
        CHECK(a.contains(key));
    }
    for (const auto& [key, value] : b["masses"][0].items()) {
        INFO(key);
        REQUIRE(a["masses"][0].contains(key));
        if (key != "error_bound") CHECK(a["masses"][0][key].get<double>() == Approx(value.get<double>()).epsilon(1e-12));
    }
    expect("0 solve --json < " + regimes[0] + R"(
        = {"regime": "continuous", "stops_per_period": 0, "unique": true, "counters": {"phases_propagated": 0}})");
}

TEST_CASE("solve lists the stops where the contact sticks and slips", "[program][solve]") {
    expect(R"(
        0 solve --json < two
          = {"regime": "stick_slip", "method": {"model": "exact solver"}, "stable": true,
             "counters": {"phases_propagated": "> 0"}}
          = {"stops": {"*": {"start": ">= 0"}}}
          = {"stops": {"*": {"start": "< 6.283185307179586"}}, "masses": {"0": {"x0": null}, "1": {"amplitude": "> 0"}}}
          = {"multipliers": "# 4", "multiplier_error_bounds": "# 4"}
          = {"multiplier_error_bounds": {"*": "< 1e-6"}}
    )");
    const json a = answer_of("solve --json", "two");
    REQUIRE(a["stops"].size() == a["stops_per_period"]);
    for (const json& stop : a["stops"]) CHECK(stop["end"].get<double>() > stop["start"].get<double>());
    CHECK(a["contact"]["amplitude"] == a["masses"][1]["amplitude"]);
}

TEST_CASE("solve gives the interval of rest where the contact never moves", "[program][solve]") {
    expect("0 solve --json < " + regimes[2] + R"(
        = {"regime": "permanent_sticking", "contact": {"amplitude": 0, "phase": null}, "stops": null,
           "rest_interval": {"to": "> 0"}})");
}

TEST_CASE("what is asked decides what is answered", "[program][solve]") {
    expect(R"(
        0 solve --json --ask regime < two
          = {"masses": null, "beta_lim": {"exact": "number", "sticking_by_88": "number"}}
        0 solve --json --ask amplitude --digits 3 < two
          = {"masses": {"0": {"amplitude": "number"}}, "stable": null}
        0 solve --json --digits 20 < two
          = {"masses": {"0": {"amplitude": "text"}}}
        2 solve --ask colour < two
    )");
}

TEST_CASE("the motion that is sampled has the amplitudes and stops that are answered", "[program][solve]") {
    for (const std::string& scene : regimes) {
        const json a = answer_of("solve --json", scene);
        expect("0 solve --samples 2000 < " + scene + "\n | # 2001 \n | tau,x_1,x_2,v_1,v_2");
        const std::vector<std::string> lines = lines_of(run_program("solve --samples 2000", scene_text(scene)).output);
        double largest[2] = {0, 0};
        int at_rest = 0;
        for (std::size_t n = 1; n < lines.size(); ++n) {
            const std::vector<double> row = numbers_of(lines[n]);
            for (std::size_t k = 0; k < 2; ++k) largest[k] = std::max(largest[k], std::abs(row[k + 1]));
            at_rest += row[4] == 0;
        }
        for (std::size_t k = 0; k < 2; ++k)
            CHECK(largest[k] == Approx(a["masses"][k]["amplitude"].get<double>()).epsilon(1e-4).margin(1e-12));
        double resting = a["regime"] == "permanent_sticking" ? 2 * std::numbers::pi : 0;
        if (a.contains("stops"))
            for (const json& stop : a["stops"]) resting += stop["end"].get<double>() - stop["start"].get<double>();
        CHECK(at_rest / 2000.0 == Approx(resting / (2 * std::numbers::pi)).margin(0.003));
    }
    expect(R"(
        2 solve {--samples 10 --ask phase|--samples -1} < two
        2 solve --samples 10 --json < two ! samples must not be given with --json
    )");
}

TEST_CASE("all motions stand in the answer with the start that leads to each", "[program][solve]") {
    expect(R"(
        0 solve --json --all < one {"mu": 2, "r": 1, "beta": 0.55}
          = {"unique": false, "motions": {"0": {"regime": "permanent_sticking"}, "1": {"regime": "continuous"}}}
          = {"motions": {"1": {"from": {"x": {"0": "~ 5 1e-5"}}}}}
        0 solve --all < one {"mu": 2, "r": 1, "beta": 0.55} > motion: continuous
    )");
}

TEST_CASE("solve --mass lists one mass, counted from 1, in every regime", "[program][solve]") {
    for (const std::string& scene : regimes) {
        const json all = answer_of("solve --json", scene);
        for (const std::size_t k : {1u, 2u}) {
            const json one = answer_of("solve --json --mass " + std::to_string(k), scene);
            REQUIRE(one["masses"].size() == 1);
            CHECK(one["masses"][0]["mass"] == k);
            CHECK(one["regime"] == all["regime"]);
            CHECK(one["masses"][0]["amplitude"].get<double>() ==
                  Approx(all["masses"][k - 1]["amplitude"].get<double>()).epsilon(1e-6));
            CHECK(one["contact"].contains("amplitude") == (k == 2));
        }
    }
    expect(R"(
        2 solve --json --mass {0|3|-1} < two ! mass must be a mass from 1 to 2, but is {}
        2 solve {--mass one|--mass 1 --samples 10} < two
    )");
}

TEST_CASE("what solve cannot answer gives status 3 and no number", "[program][solve]") {
    expect(R"(
        3 solve --json --digits 60 --effort 1000 < two
        2 solve --json < one {"damping_ratios": 0.1, "r": 1, "beta": null}
        2 solve --digits 0 < two
    )");
}

TEST_CASE("a pole that is met to the last digits of a double is refused as the pole is", "[program][solve][response][domain]") {
    // With 20 digits every number is taken as it stands; a mode that the load does not excite has no pole; and what is farther
    // away than the last place is not at it.
    expect(R"(
        2 {solve|solve --digits 10|response|solve --ask amplitude --mass 1} < near a pole
          ! frequency_hz must not be at a pole: mode 1 has no damping and R = 1 ! (at /frequency_hz)
        0 solve --digits 20 < near a pole
        0 solve < unexcited
        0 solve < near a pole {"frequency_hz": 3.183098861838907}
        0 map --r 1.0000000000000002:1.0000000000000002:1 --beta 0.1:0.1:1 < undamped > at_a_pole
    )");
}

TEST_CASE("a motion from rest that does not settle leaves a steady one, or gives status 3, and says what was seen",
          "[program][solve]") {
    expect(R"(
        0 solve --json < restless
          = {"from_rest": "not known", "from_rest_because": "has comes to no periodic motion", "masses": "# 2"}
        0 solve --samples 4 < restless ! the start from rest is not known to lead to this motion
          | # 5
        2 solve --json < undamped {"r": 1, "beta": 0.025} ! The motion still grows
        0 map --r 1.15625:1.15625:1 --beta 1.03125:1.03125:1 < restless
          | r,beta,regime,stops_per_period,periods,amplitude_2,status
          | 1.15625,1.03125,,nan,nan,nan,not_converged
    )");
}

TEST_CASE("solve tells of a contact between two masses by the one relative to the other", "[program][solve][vectors]") {
    const json a = answer_of("solve --json", "rubbing"), exactly = answer_of("integrate --json --method exact", "rubbing"),
               by_algorithm = answer_of("integrate --json --absolute-tolerance 1e-9", "rubbing");
    for (const json& each : {a, by_algorithm}) CHECK(each["contact"]["between"] == json::array({2, 1}));
    CHECK(a["contact"]["amplitude"].get<double>() > 0);
    REQUIRE(a["masses"].size() == 2);
    CHECK(by_algorithm["contact"]["amplitude"].get<double>() == Approx(a["contact"]["amplitude"].get<double>()).epsilon(1e-6));
    for (std::size_t k = 0; k < 2; ++k) {
        const double amplitude = a["masses"][k]["amplitude"].get<double>();
        CHECK(by_algorithm["masses"][k]["amplitude"].get<double>() == Approx(amplitude).epsilon(1e-6));
        CHECK(exactly["masses"][k]["amplitude"].get<double>() == Approx(amplitude).epsilon(1e-6));
        const json one = answer_of("solve --json --ask amplitude --mass " + std::to_string(k + 1), "rubbing");
        REQUIRE(one["masses"].size() == 1);
        CHECK(one["masses"][0]["mass"] == k + 1);
        CHECK(one["masses"][0]["amplitude"].get<double>() == Approx(amplitude).epsilon(1e-6));
        CHECK_FALSE(one["contact"].contains("amplitude"));
    }
    expect(R"(
        0 solve < rubbing > contact: between masses 2 and 1, which slide on each other by 0.
        0 boundary --json --invariant-points 0.2:3 < rubbing
          = {"invariant_points": "# 2"}
    )");
}

TEST_CASE("a dimensional scene is answered in its own units too", "[program][solve][units]") {
    expect(R"(
        0 solve --json < in units
          = {"dimensional": {"frequency": "~ 1.5 1e-5", "frequency_hz": "~ 0.238732414637843 1e-5", "friction": "~ 1 1e-5"}}
          = {"dimensional": {"force": 8.0, "displacement_unit": 0.5}}
        0 solve --json < in units {"friction": 3, "frequency": 0.5}
          = {"regime": "stick_slip"}
        0 solve < in units > in the units of the scene:
        0 solve --json < two
          = {"dimensional": null}
    )");
    const json sliding = answer_of("solve --json", "in units"), &in_units = sliding["dimensional"],
               sticking = answer_of("solve --json", R"(in units {"friction": 3, "frequency": 0.5})");
    CHECK(in_units["friction_limit"]["exact"].get<double>() == Approx(8 * sliding["beta_lim"]["exact"].get<double>()));
    for (std::size_t k = 0; k < 2; ++k)
        CHECK(in_units["masses"][k]["amplitude"].get<double>() == Approx(0.5 * sliding["masses"][k]["amplitude"].get<double>()));
    CHECK(sticking["dimensional"]["stops"][0]["end"].get<double>() == Approx(2 * sticking["stops"][0]["end"].get<double>()));
}

TEST_CASE("energies are printed in ratios and in the units of the scene", "[program][solve][energy]") {
    const std::string text = R"({"masses": [2], "stiffnesses": [800], "damping_ratios": 0.02, "contact": 1, "load": 1, "force": 4,
                               "friction": 1.5, "frequency": 25})";
    const Run run = run_program("solve --json --energy", text);
    REQUIRE(run.status == 0);
    const auto answer = nlohmann::json::parse(run.output);
    const auto &e = answer["energy"], &there = answer["dimensional"]["energy"];
    const double X = answer["dimensional"]["masses"][0]["amplitude"], F = 1.5, omega = 25;
    CHECK(there["contact"].get<double>() == Approx(4 * F * X).epsilon(1e-9));
    CHECK(there["friction"].get<double>() == Approx(F).epsilon(1e-12));
    CHECK(there["equivalent_damping"].get<double>() == Approx(4 * F / (std::numbers::pi * omega * X)).epsilon(1e-9));
    CHECK(there["equivalent_damping_ratio"].get<double>() ==
          Approx(there["equivalent_damping"].get<double>() / (2 * std::sqrt(2.0 * 800))).epsilon(1e-9));
    CHECK(there["contact"].get<double>() == Approx(e["contact"].get<double>() * 4 * 4 / 800).epsilon(1e-12));
    CHECK(there["textbook"]["contact"].get<double>() == Approx(4 * F * X).epsilon(1e-9));
    CHECK(e["contact_error_bound"].get<double>() < 1e-9);
    const Run table = run_program("solve --energy", text);
    CHECK(table.output.find("energy dissipated in the contact") != std::string::npos);
    CHECK(table.output.find("in the units of the scene") != std::string::npos);
    CHECK(run_program("solve --json", text).output.find("energy") == std::string::npos);
    const auto many = nlohmann::json::parse(run_program("solve --json --energy --digits 30", text).output);
    CHECK(many["energy"]["dampers"].get<std::string>().size() > 30);
    for (const char* with : {"--mass 1", "--ask amplitude", "--samples 8", "--ask regime"})
        CHECK(run_program(std::string("solve --energy ") + with, text).error.find("energy must be given without") !=
              std::string::npos);
}

#include <cmath>
#include <numbers>

#include "tests/catch.hpp"
#include "tests/unit/program_runs.hpp"

using namespace denhartog::tests;
using nlohmann::json;

namespace {

std::string two_masses(const std::string& r, const std::string& beta, const std::string& mu = "1") {
    return R"({"mass_ratios": [1, 1], "stiffness_ratios": [1, 1], "damping_ratios": [0.03125, 0.0625], )"
           R"("contact": 2, "load": 1, "mu": )" +
           mu + R"(, "r": )" + r + R"(, "beta": )" + beta + "}";
}

} // namespace

TEST_CASE("solve answers with the object of response in the sliding regime", "[program][solve]") {
    const std::string scene = two_masses("1.25", "0.0625");
    const Run run = run_program("solve --json", scene);
    REQUIRE(run.status == 0);
    const json a = json::parse(run.output), b = json::parse(run_program("response --json", scene).output);
    for (const auto& [key, value] : b.items()) {
        INFO(key);
        CHECK(a.contains(key));
    }
    for (const auto& [key, value] : b["masses"][0].items()) {
        INFO(key);
        REQUIRE(a["masses"][0].contains(key));
        if (key != "error_bound") CHECK(a["masses"][0][key].get<double>() == Approx(value.get<double>()).epsilon(1e-12));
    }
    CHECK(a["regime"] == "continuous");
    CHECK(a["stops_per_period"] == 0);
    CHECK(a["unique"] == true);
    CHECK(a["counters"]["phases_propagated"] == 0);
}

TEST_CASE("solve lists the stops where the contact sticks and slips", "[program][solve]") {
    const json a = json::parse(run_program("solve --json", two_masses("0.5", "0.5")).output);
    CHECK(a["regime"] == "stick_slip");
    CHECK(a["method"]["model"] == "exact solver");
    REQUIRE(a["stops"].size() == a["stops_per_period"]);
    REQUIRE_FALSE(a["stops"].empty());
    for (const json& stop : a["stops"]) {
        CHECK(stop["start"].get<double>() >= 0);
        CHECK(stop["start"].get<double>() < 2 * std::numbers::pi);
        CHECK(stop["end"].get<double>() > stop["start"].get<double>());
    }
    CHECK_FALSE(a["masses"][0].contains("x0"));
    CHECK(a["masses"][1]["amplitude"].get<double>() > 0);
    CHECK(a["contact"]["amplitude"] == a["masses"][1]["amplitude"]);
    CHECK(a["stable"] == true);
    CHECK(a["multipliers"].size() == 4);
    CHECK(a["multiplier_error_bounds"].size() == 4);
    for (const json& bound : a["multiplier_error_bounds"]) CHECK(bound.get<double>() < 1e-6);
    CHECK(a["counters"]["phases_propagated"].get<int>() > 0);
}

TEST_CASE("solve gives the interval of rest where the contact never moves", "[program][solve]") {
    const json a = json::parse(run_program("solve --json", two_masses("0.75", "3")).output);
    CHECK(a["regime"] == "permanent_sticking");
    CHECK(a["contact"]["amplitude"] == 0);
    CHECK_FALSE(a["contact"].contains("phase"));
    CHECK(a["rest_interval"]["to"].get<double>() > 0);
    CHECK_FALSE(a.contains("stops"));
}

TEST_CASE("what is asked decides what is answered", "[program][solve]") {
    const std::string scene = two_masses("0.5", "0.5");
    const json regime = json::parse(run_program("solve --json --ask regime", scene).output);
    CHECK_FALSE(regime.contains("masses"));
    CHECK(regime["beta_lim"].contains("exact"));
    CHECK(regime["beta_lim"].contains("sticking_by_88"));
    const json amplitude = json::parse(run_program("solve --json --ask amplitude --digits 3", scene).output);
    CHECK(amplitude["masses"][0].contains("amplitude"));
    CHECK_FALSE(amplitude.contains("stable"));
    const json digits = json::parse(run_program("solve --json --digits 20", scene).output);
    CHECK(digits["masses"][0]["amplitude"].is_string());
    CHECK(run_program("solve --ask colour", scene).status == 2);
}

TEST_CASE("the motion that is sampled has the amplitudes and stops that are answered", "[program][solve]") {
    for (const std::string& scene : {two_masses("1.25", "0.0625"), two_masses("0.5", "0.5"), two_masses("0.75", "3")}) {
        const json a = json::parse(run_program("solve --json", scene).output);
        const Run run = run_program("solve --samples 2000", scene);
        REQUIRE(run.status == 0);
        const std::vector<std::string> lines = lines_of(run.output);
        REQUIRE(lines.size() == 2001);
        CHECK(lines[0] == "tau,x_1,x_2,v_1,v_2");
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
    CHECK(run_program("solve --samples 10 --ask phase", two_masses("0.5", "0.5")).status == 2);
    CHECK(run_program("solve --samples -1", two_masses("0.5", "0.5")).status == 2);
    const Run with_json = run_program("solve --samples 10 --json", two_masses("0.5", "0.5"));
    CHECK(with_json.status == 2);
    CHECK(with_json.output.empty());
    CHECK(with_json.error.find("samples must not be given with --json") != std::string::npos);
}

TEST_CASE("all motions stand in the answer with the start that leads to each", "[program][solve]") {
    const std::string scene = R"({"mass_ratios": [1], "stiffness_ratios": [1], "damping_ratios": 0.05, "contact": 1, "load": 1,
                                  "mu": 2, "r": 1, "beta": 0.55})";
    const json a = json::parse(run_program("solve --json --all", scene).output);
    CHECK(a["unique"] == false);
    REQUIRE(a["motions"].size() >= 2);
    CHECK(a["motions"][0]["regime"] == "permanent_sticking");
    CHECK(a["motions"][1]["regime"] == "continuous");
    CHECK(a["motions"][1]["from"]["x"][0].get<double>() == Approx(5));
    const Run table = run_program("solve --all", scene);
    CHECK(table.status == 0);
    CHECK(table.output.find("motion: continuous") != std::string::npos);
}

TEST_CASE("solve --mass lists one mass, counted from 1, in every regime", "[program][solve]") {
    for (const std::string& scene : {two_masses("1.25", "0.0625"), two_masses("0.5", "0.5"), two_masses("0.75", "3")}) {
        const json all = json::parse(run_program("solve --json", scene).output);
        for (const std::size_t k : {1u, 2u}) {
            const json one = json::parse(run_program("solve --json --mass " + std::to_string(k), scene).output);
            REQUIRE(one["masses"].size() == 1);
            CHECK(one["masses"][0]["mass"] == k);
            CHECK(one["regime"] == all["regime"]);
            CHECK(one["masses"][0]["amplitude"].get<double>() ==
                  Approx(all["masses"][k - 1]["amplitude"].get<double>()).epsilon(1e-6));
            CHECK(one["contact"].contains("amplitude") == (k == 2));
        }
    }
    for (const std::string mass : {"0", "3", "-1"}) {
        const Run run = run_program("solve --json --mass " + mass, two_masses("0.5", "0.5"));
        CHECK(run.status == 2);
        CHECK(run.output.empty());
        CHECK(run.error.find("mass must be a mass from 1 to 2, but is " + mass) != std::string::npos);
    }
    CHECK(run_program("solve --mass one", two_masses("0.5", "0.5")).status == 2);
    CHECK(run_program("solve --mass 1 --samples 10", two_masses("0.5", "0.5")).status == 2);
}

TEST_CASE("what solve cannot answer gives status 3 and no number", "[program][solve]") {
    const Run run = run_program("solve --json --digits 60 --effort 1000", two_masses("0.5", "0.5"));
    CHECK(run.status == 3);
    CHECK(run.output.empty());
    CHECK(lines_of(run.error).size() == 1);
    CHECK(run_program("solve --json",
                      R"({"mass_ratios": [1], "stiffness_ratios": [1], "damping_ratios": 0.1, "contact": 1, "load": 1, "r": 1})")
              .status == 2);
    CHECK(run_program("solve --digits 0", two_masses("0.5", "0.5")).status == 2);
}

TEST_CASE("a pole that is met to the last digits of a double is refused as the pole is", "[program][solve][response][domain]") {
    // 20 radians a second, to the last digit, of a mass whose natural frequency is 20.
    const std::string scene = R"({"masses": 10, "stiffnesses": 4000, "damping_ratios": 0, "force": 100, "friction": 11.772,
                                  "frequency_hz": 3.183098861837907, "contact": 1, "load": 1})";
    for (const std::string command : {"solve", "solve --digits 10", "response", "solve --ask amplitude --mass 1"}) {
        const Run run = run_program(command, scene);
        CHECK(run.status == 2);
        CHECK(run.error.find("frequency_hz must not be at a pole: mode 1 has no damping and R = 1") != std::string::npos);
        CHECK(run.error.find("(at /frequency_hz)") != std::string::npos);
    }
    CHECK(run_program("solve --digits 20", scene).status == 0); // every number as it stands
    // A mode that the load does not excite has no pole.
    CHECK(run_program("solve", R"({"mass_ratios": [1, 1, 1], "stiffness_matrix": [[3, -1, -0.5], [-1, 2, -1], [-0.5, -1, 3]],
        "damping_ratios": 0, "contact": 2, "load": 2, "beta": 0.1, "r": 1.8708286933869707})")
              .status == 0);
    // As far away as a unit in the last place does not count.
    std::string apart = scene;
    apart.replace(apart.find("3.183098861837907"), 17, "3.183098861838907");
    CHECK(run_program("solve", apart).status == 0);
    const Run map = run_program("map --r 1.0000000000000002:1.0000000000000002:1 --beta 0.1:0.1:1",
                                R"({"mass_ratios": 1, "stiffness_ratios": 1, "damping_ratios": 0, "contact": 1, "load": 1})");
    CHECK(map.output.find("at_a_pole") != std::string::npos);
}

TEST_CASE("a motion from rest that does not settle leaves a steady one, or gives status 3, and says what was seen",
          "[program][solve]") {
    const std::string scene = R"({"mass_ratios": [1, 1], "stiffness_ratios": [1, 1], "damping_ratios": [0.03125, 0.03125],
                                  "contact": 2, "load": 1, "mu": 1.5, "r": 1.15625, "beta": 1.03125})";
    const json found = json::parse(run_program("solve --json", scene).output);
    CHECK(found["from_rest"] == "not known");
    CHECK(found["from_rest_because"].get<std::string>().find("comes to no periodic motion") != std::string::npos);
    CHECK(found["masses"].size() == 2);
    const Run samples = run_program("solve --samples 4", scene);
    CHECK(samples.status == 0);
    CHECK(lines_of(samples.output).size() == 5);
    CHECK(samples.error.find("the start from rest is not known to lead to this motion") != std::string::npos);
    const Run grows = run_program("solve --json", R"({"mass_ratios": 1, "stiffness_ratios": 1, "damping_ratios": 0, "contact": 1,
                                                      "load": 1, "r": 1, "beta": 0.025})");
    CHECK(grows.status == 2);
    CHECK(grows.output.empty());
    CHECK(grows.error.find("The motion still grows") != std::string::npos);
    const Run map = run_program("map --r 1.15625:1.15625:1 --beta 1.03125:1.03125:1", scene);
    CHECK(map.status == 0);
    CHECK(lines_of(map.output)[1] == "1.15625,1.03125,,nan,nan,nan,not_converged");
}

TEST_CASE("solve tells of a contact between two masses by the one relative to the other", "[program][solve][vectors]") {
    const std::string scene =
        R"({"mass_ratios": [1, 2], "stiffness_ratios": [1, 0.75], "damping_ratios": [0.05, 0.04], "contact": [2, 1],
            "load": [0.5, 1], "r": 0.75, "beta": 0.0625})";
    const json a = json::parse(run_program("solve --json", scene).output);
    CHECK(a["contact"]["between"] == json::array({2, 1}));
    CHECK(a["contact"]["amplitude"].get<double>() > 0);
    REQUIRE(a["masses"].size() == 2);
    const json by_algorithm = json::parse(run_program("integrate --json --absolute-tolerance 1e-9", scene).output);
    CHECK(by_algorithm["contact"]["between"] == json::array({2, 1}));
    CHECK(by_algorithm["contact"]["amplitude"].get<double>() == Approx(a["contact"]["amplitude"].get<double>()).epsilon(1e-6));
    const json exactly = json::parse(run_program("integrate --json --method exact", scene).output);
    for (std::size_t k = 0; k < 2; ++k) {
        const double amplitude = a["masses"][k]["amplitude"].get<double>();
        CHECK(by_algorithm["masses"][k]["amplitude"].get<double>() == Approx(amplitude).epsilon(1e-6));
        CHECK(exactly["masses"][k]["amplitude"].get<double>() == Approx(amplitude).epsilon(1e-6));
        const json one = json::parse(run_program("solve --json --ask amplitude --mass " + std::to_string(k + 1), scene).output);
        REQUIRE(one["masses"].size() == 1);
        CHECK(one["masses"][0]["mass"] == k + 1);
        CHECK(one["masses"][0]["amplitude"].get<double>() == Approx(amplitude).epsilon(1e-6));
        CHECK_FALSE(one["contact"].contains("amplitude"));
    }
    CHECK(run_program("solve", scene).output.find("contact: between masses 2 and 1, which slide on each other by 0.") !=
          std::string::npos);
    const json invariant = json::parse(run_program("boundary --json --invariant-points 0.2:3", scene).output);
    CHECK(invariant["invariant_points"].size() == 2);
}

TEST_CASE("a dimensional scene is answered in its own units too", "[program][solve][units]") {
    const std::string scene = R"({"masses": [4, 10], "stiffnesses": [16, 10], "damping_ratios": 0.0625, "contact": 2, "load": 1,
                                  "force": 8, "friction": )";
    const json sliding = json::parse(run_program("solve --json", scene + R"(1, "frequency": 1.5})").output);
    const json& in_units = sliding["dimensional"];
    CHECK(in_units["frequency"].get<double>() == Approx(1.5));
    CHECK(in_units["frequency_hz"].get<double>() == Approx(1.5 / (2 * std::numbers::pi)));
    CHECK(in_units["force"] == 8.0);
    CHECK(in_units["friction"].get<double>() == Approx(1));
    CHECK(in_units["displacement_unit"] == 0.5);
    CHECK(in_units["friction_limit"]["exact"].get<double>() == Approx(8 * sliding["beta_lim"]["exact"].get<double>()));
    for (std::size_t k = 0; k < 2; ++k)
        CHECK(in_units["masses"][k]["amplitude"].get<double>() == Approx(0.5 * sliding["masses"][k]["amplitude"].get<double>()));
    const json sticking = json::parse(run_program("solve --json", scene + R"(3, "frequency": 0.5})").output);
    REQUIRE(sticking["regime"] == "stick_slip");
    CHECK(sticking["dimensional"]["stops"][0]["end"].get<double>() == Approx(2 * sticking["stops"][0]["end"].get<double>()));
    CHECK(run_program("solve", scene + R"(1, "frequency": 1.5})").output.find("in the units of the scene:") != std::string::npos);
    CHECK_FALSE(json::parse(run_program("solve --json", two_masses("0.5", "0.5")).output).contains("dimensional"));
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

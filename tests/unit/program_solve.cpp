#include <cmath>
#include <cstdlib>
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
        0 solve --json --ask {amplitude|phase} < two {"r": 1.25, "beta": 0.0625}
          = {"masses": {"0": {"amplitude": "number", "phase": "number", "x0": null}}, "unique": true}
        0 solve --json < two {"r": 1.25, "beta": 0.0625}
          = {"masses": {"0": {"x0": "number"}}}
        0 solve --json --digits 20 < two
          = {"masses": {"0": {"amplitude": "text"}}}
        2 solve --ask colour < two
        0 solve < one {"beta": -0.0} > beta = 0 is below
        0 solve < one {"beta": "-0.0"} > beta = 0 is below
    )");
}

TEST_CASE("the regime alone is that of the motion, which may turn more often beyond the boundary and never stop",
          "[program][solve][eq:69]") {
    // An integration from turn to turn finds six turns in a period, no stop, and the amplitudes 0.99404399521 and 0.99591283592.
    expect(R"(
        0 solve --json {--ask regime|--ask regime --digits 20|--ask regime --proved|--ask motion}
          < undamped {"r": 0.2, "beta": 0.001}
          = {"regime": "continuous"}
        0 solve --json {--ask regime|--ask regime --digits 20|--ask motion}
          < undamped {"damping_ratios": 0.001, "r": 0.2, "beta": 0.001}
          = {"regime": "continuous"}
        0 map --r 0.2:0.2:1 --beta 0.001:0.001:1 < undamped > 0.2,0.001,continuous,0,1,0.99404399
        0 map --r 0.2:0.2:1 --beta 0.001:0.001:1 < undamped {"damping_ratios": 0.001} > 0.2,0.001,continuous,0,1,0.99591283
    )");
    // Static friction equals the load on the contact, which it holds.
    expect(R"(
        0 solve --json {--ask regime|--ask regime --proved|--ask motion} < unequal undamped
          {"mass_ratios": [1, 1], "stiffness_ratios": [1, 1.25], "contact": 2, "load": 2, "mu": 2, "r": 0.3, "beta": 0.5}
          = {"regime": "permanent_sticking"}
    )");
}

TEST_CASE("next to a pole the boundaries are told, whatever mu is", "[program][solve][eq:69][domain]") {
    expect(R"(
        0 boundary --json < undamped {"r": 1.0000000000000002, "mu": 2}
          = {"beta_lim": {"exact": "~ 0.7853981633974 1e-12"}}
        0 solve --json < undamped {"r": 1.0000000000000002, "mu": 2, "beta": 1.25}
          = {"regime": "permanent_sticking", "beta_lim": {"exact": "~ 0.7853981633974 1e-12", "sticking": 0.5}}
          = {"reason": "has from the start from rest the contact came to rest", "method": {"proved": true}}
        0 solve < undamped {"r": 1.0000000000000002, "mu": 2, "beta": 1.25} > the closed form does not hold: beta = 1.25
        0 solve < undamped {"r": 1, "mu": 2, "beta": 1.25} > the boundaries are not known: mode 1 has no damping and R = 1
    )");
}

TEST_CASE("boundaries that have not their digits are printed with the reason", "[program]") {
    expect(R"(
        0 boundary < unequal {"mass_ratios": [1, 1e-100], "mu": 1} > the error bound does not guarantee the 6 digits
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
        2 solve --samples 10 --ask phase < two
        2 {solve|integrate|motion} --samples -1 < two ! samples must be from 1 to 10000000, but is -1
        2 {solve|integrate|motion} --samples 0 < two ! samples must be from 1 to 10000000, but is 0
        2 {solve|integrate|motion} --samples '' < two ! samples must be from 1 to 10000000, but is 0
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
        2 solve --mass one < two
        2 solve --samples 10 {--mass 1|--all} < two ! samples must be given without --mass and --all
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
        0 {solve|response} < rubbing > contact: between masses 2 and 1, which slide on each other by 0.
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
    const std::string text = scene_text("driven");
    const auto answer = answer_of("solve --json --energy", "driven");
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
    CHECK(run_program("solve --json", text).output.find("energy") == std::string::npos);
    expect(R"(
        0 solve --energy < driven > energy dissipated in the contact > in the units of the scene
        0 solve --json --energy --digits 30 < driven
          = {"energy": {"dampers": "longer 30"}}
        2 solve --energy {--mass 1|--ask amplitude|--samples 8|--ask regime} < driven ! energy must be given without
    )");
    // At a pole as next to it: nothing but the contact dissipates, 4 beta X.
    for (const std::string r : {"1", "1.0000000000000002"})
        expect("0 solve --json --energy < undamped {\"r\": " + r + R"(, "beta": 0.9}
            = {"energy": {"dampers": 0, "contact": "~ 0.116526237485 1e-10", "friction": 0.9}}
            = {"energy": {"on_base": "~ 0.0323683993013 1e-10", "textbook": {"amplitude": null}}})");
}

TEST_CASE("the answer in the sliding regime has the keys of the interface", "[program]") {
    expect(R"(
        0 response - --json < three
          = "keys regime r beta beta_lim beta_lim_error_bounds method contact masses stops_per_period"
          = {"beta_lim": "keys exact paper approximate sticking",
             "beta_lim_error_bounds": "keys exact paper approximate sticking"}
          = {"method": "keys model precision proved why", "contact": "keys mass amplitude phase", "masses": "# 3"}
          = {"masses": {"0": "keys mass x0 v0 amplitude phase amplitude_monoharmonic phase_monoharmonic error_bound
             phase_error_bound"}, "regime": "continuous", "stops_per_period": 0, "contact": {"mass": 2}}
          = {"method": {"model": "closed form", "proved": false}}
    )");
    const std::string output = run_program("response --json", scene_text("three")).output;
    const json a = json::parse(output);
    CHECK(a["contact"]["amplitude"] == a["masses"][1]["amplitude"]);
    for (const char* never : {"-0.0", "null"}) CHECK(output.find(never) == std::string::npos);
}

TEST_CASE("outside the sliding regime the closed-form fields are absent and a reason is there", "[program]") {
    expect(R"(
        0 response --json < three {"beta": 0.75}
          = {"regime": "stick_slip"}
          = {"reason": "longer 40", "masses": null, "stops_per_period": null, "contact": "# 1", "beta_lim": {"exact": "> 0"}}
        0 response --json < three {"beta": 4}
          = {"regime": "permanent_sticking"}
          = {"reason": "longer 40", "masses": null, "stops_per_period": null, "contact": "# 1", "beta_lim": {"exact": "> 0"}}
    )");
}

TEST_CASE("above 15 digits numbers are text with these digits", "[program]") {
    expect(R"(
        0 response --json --digits 40 < three {"beta": "0.1"}
          = {"beta": "1.000000000000000000000000000000000000000e-01", "method": {"precision": "reference"}}
        0 response --json --digits 12 < three {"beta": 0.1}
          = {"contact": {"amplitude": "number"}}
    )");
    const std::string amplitude = answer_of("response --json --digits 40", R"(three {"beta": "0.1"})")["contact"]["amplitude"];
    CHECK(std::count_if(amplitude.begin(), amplitude.begin() + static_cast<long>(amplitude.find('e')), ::isdigit) == 40);
    const double in_double = answer_of("response --json", R"(three {"beta": 0.1})")["contact"]["amplitude"];
    CHECK(std::stod(amplitude) == Approx(in_double).epsilon(1e-14));
}

TEST_CASE("a table has the same numbers", "[program]") {
    char amplitude[40];
    std::snprintf(amplitude, sizeof amplitude, "%.12g",
                  answer_of("response --json", "three")["masses"][2]["amplitude"].get<double>());
    expect(std::string("0 response < three > ") + amplitude + "\n | regime: continuous");
}

TEST_CASE("in JSON Lines a bad scene has its error in its place and the others are answered", "[program]") {
    expect(R"(
        2 response --json < three {"beta": 0.125} + three {"beta": -1} + + three {"beta": 0.25}
          | # 3
          = {"0": {"beta": 0.125}, "2": {"beta": 0.25}}
          = {"1": {"error": {"quantity": "beta", "value": "-1", "rule": "longer 5", "place": "has /beta"}}}
    )");
}

TEST_CASE("digits that cannot be reached give status 3 and no number", "[program]") {
    // Next to a pole of an undamped mode the boundary loses a dozen digits and more.
    expect(R"(
        3 response --json --digits 95 < one {"r": 5e-324, "beta": 0.125} ! the reference does not prove it
        0 response --json --digits 95 < undamped {"damping_ratios": null, "damping_matrix": [[0]],
          "damping_tolerance": 0.5, "r": 0.3333333333333333, "beta": 0.125}
    )");
}

TEST_CASE("the boundary needs no friction ratio", "[program][eq:69]") {
    expect(R"(
        0 boundary --json < undamped {"r": 3}
          = {"beta_lim": {"exact": "~ 0.5625 1e-14", "sticking": 1}, "binding_condition": "54a and 54b"}
        0 boundary < undamped {"r": 3} > 0.5625
        2 response --json < undamped {"r": 3} ! beta must be given
    )");
}

TEST_CASE("the functions have the keys of the interface and the values of the response", "[program]") {
    expect(R"(
        0 functions --json < three
          = "keys modes masses H_j S_j error_bounds"
          = {"modes": {"0": "keys mode natural_frequency_ratio R zeta v u g error_bounds"}, "error_bounds": "keys H_j S_j"}
          = {"modes": {"0": {"error_bounds": "keys natural_frequency_ratio R zeta v u g"}}, "S_j": "keys exact paper"}
          = {"masses": {"0": "keys mass V U G error_bounds"}}
        0 functions < three
    )");
    const json contact = answer_of("functions --json", "three")["masses"][1];
    const double V_re = contact["V"][0], V_im = contact["V"][1], U = contact["U"], G = contact["G"], beta = 0.15625;
    const double X_j = -beta * G + std::sqrt(V_re * V_re + V_im * V_im - beta * beta * U * U);
    CHECK(answer_of("response --json", "three")["contact"]["amplitude"].get<double>() == Approx(X_j).epsilon(1e-13));
}

TEST_CASE("the modes of a system with a light mass have the digits of those without it", "[program][eq:15]") {
    // Double alone has the first natural frequency of this matrix to three digits.
    const json with = answer_of("functions --json", "light mass")["modes"],
               without = answer_of("functions --json", "no light mass")["modes"];
    for (const std::size_t i : {0, 1})
        for (const char* key : {"natural_frequency_ratio", "R", "u", "g"})
            CHECK(with[i].at(key).get<double>() == Approx(without[i].at(key).get<double>()).epsilon(1e-6));
}

TEST_CASE("invariant points without digits have those that are asked for", "[program][eq:87]") {
    const json a = answer_of("boundary --json --invariant-points 0.5:2", "frame").at("invariant_points"),
               b = answer_of("boundary --json --invariant-points 0.5:2 --digits 12", "frame").at("invariant_points");
    std::size_t compared = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        REQUIRE(a[k].at("points").size() == b[k].at("points").size());
        for (std::size_t n = 0; n < a[k].at("points").size(); ++n, ++compared)
            for (const char* key : {"r", "amplitude"})
                CHECK(a[k].at("points")[n].at(key).get<double>() ==
                      Approx(b[k].at("points")[n].at(key).get<double>()).epsilon(1e-6));
    }
    CHECK(compared == 8);
}

TEST_CASE("the motion is a table of one period that mirrors itself", "[program]") {
    expect(R"(
        0 motion --samples 8 < three
          | # 9
          | tau,x_1,x_2,x_3,v_1,v_2,v_3
        2 motion < three {"beta": 0.75}
        2 motion --samples 0 < three
        2 motion < three {"beta": 0.125} + three {"beta": 0.25}
    )");
    const std::vector<std::string> lines = lines_of(run_program("motion --samples 8", scene_text("three")).output);
    const std::vector<double> first = numbers_of(lines[1]), opposite = numbers_of(lines[5]);
    REQUIRE(first.size() == 7);
    CHECK(first[0] == 0);
    CHECK(numbers_of(lines[3])[0] == 1.5707963267948966);
    for (std::size_t n = 1; n < 7; ++n) CHECK(first[n] == Approx(-opposite[n]).margin(1e-14));
    const json a = answer_of("response --json", "three");
    CHECK(first[2] == Approx(a["contact"]["amplitude"].get<double>()).epsilon(1e-14));
    CHECK(first[4] == Approx(a["masses"][0]["v0"].get<double>()).epsilon(1e-12));
}

TEST_CASE("displacements above a moving base are said to be relative to it", "[program][response][solve]") {
    expect(R"(
        0 {response|solve|integrate --cycles 3} --json < based {"base_motion": "with_wall"}
          = {"relative_to": "longer 0"}
        0 {response|solve|integrate --cycles 3} --json < based {"base_motion": "alone"}
          = {"relative_to": null}
        0 {response|solve|integrate --cycles 3} < based {"base_motion": "with_wall"} > relative to base and wall
    )");
    for (const std::string command : {"response", "solve", "integrate --cycles 3"})
        CHECK(run_program(command, scene_text(R"(based {"base_motion": "alone"})")).output.find("relative to base and wall") ==
              std::string::npos);
}

TEST_CASE("how far damping couples the modes is told of a scene of which double has no modes", "[program][response][eq:18]") {
    expect(R"(
        0 response --json < no modes in double
          = {"damping": {"coupling": "taken_in", "largest_coupling": "> 0.1"}}
          = {"damping": {"largest_coupling": "< 1"}}
    )");
}

namespace {

// Output of the program if the C library may not use newer instructions, as on an older processor.
Run run_on_older(const std::string& without, const std::string& arguments, const std::string& scenes) {
    const std::string file = file_with("scenes-of-same-digits.jsonl", scenes).string();
    return run_program("--version >/dev/null; GLIBC_TUNABLES=glibc.cpu.hwcaps=" + without + " exec " + quoted_program() + " " +
                       arguments + " '" + file + "'");
}

} // namespace

TEST_CASE("the digits are the same whichever code paths of its functions the system takes", "[program]") {
    const std::string all = scene_text("one overdamped + rubbing dashpots + heavily damped") + "\n";
    for (const std::string without : {"-FMA", "-AVX2", "-AVX512F", "-AVX2,-FMA,-AVX512F"}) {
        INFO(without);
        for (const std::string arguments : {"solve --json --digits 6", "solve --json --digits 13", "solve --json --digits 30"}) {
            INFO(arguments);
            const Run here = run_on_older("", arguments, all), there = run_on_older(without, arguments, all);
            CHECK(here.status == 0);
            CHECK(here.output.size() > 1000);
            CHECK(here.output == there.output);
        }
        const std::string map = "map --threads 1 --r 0.21:2.7:24 --beta 0.01:1.5:24";
        for (const std::string& scene : {scene_text("one overdamped"), scene_text("heavily damped")}) {
            const Run here = run_on_older("", map, scene), there = run_on_older(without, map, scene);
            CHECK(here.status == there.status);
            CHECK(here.output.size() > 10000);
            CHECK(here.output == there.output);
        }
    }
}

TEST_CASE("the program says that its digits are the same on every machine", "[program]") {
    CHECK(run_program("--version").output.find("The digits are the same on every machine") != std::string::npos);
}

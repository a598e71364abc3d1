#include <cmath>

#include "tests/catch.hpp"
#include "tests/unit/program_table.hpp"

using namespace denhartog::tests;
using nlohmann::json;

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

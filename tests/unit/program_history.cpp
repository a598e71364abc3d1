// `denhartog integrate --history`, `"force": 0` and `static_load`: formats, units, refusals.
#include <cmath>
#include <cstring>

#include "tests/catch.hpp"
#include "tests/unit/program_table.hpp"

using namespace denhartog::tests;
using nlohmann::json;

TEST_CASE("a history is CSV or NPY with the columns of motion and whether the contact sticks", "[program][history]") {
    const std::string command = "integrate --history 2 --cycles 6 --samples 8 --units scene",
                      file = (scratch() / "history.npy").string(), as_csv = (scratch() / "history.csv").string();
    expect("0 " + command + " < stopping \n | # 17 \n | t,x_1,x_2,v_1,v_2,direction \n" + //
           "0 " + command + " --output {" + file + "|" + as_csv + "} < stopping");
    const std::string printed = run_program(command, scene_text("stopping")).output, bytes = content_of(file);
    CHECK(content_of(as_csv) == printed);
    CHECK(bytes.substr(1, 5) == "NUMPY");
    const std::size_t header = 10 + static_cast<unsigned char>(bytes[8]) + 256 * static_cast<unsigned char>(bytes[9]);
    REQUIRE(bytes.size() == header + 16 * (5 * 8 + 1));
    CHECK(bytes.find("('direction', '|i1')") != std::string::npos);
    const std::vector<std::string> lines = lines_of(printed);
    int resting = 0;
    for (std::size_t n = 0; n < 16; ++n) {
        const std::vector<double> row = numbers_of(lines[n + 1]);
        REQUIRE(row.size() == 6);
        for (std::size_t c = 0; c < 5; ++c) {
            double x = 0;
            std::memcpy(&x, bytes.data() + header + n * 41 + 8 * c, 8);
            CHECK(x == row[c]);
        }
        CHECK(static_cast<int>(static_cast<signed char>(bytes[header + n * 41 + 40])) == static_cast<int>(row[5]));
        CHECK((row[5] == 0) == (row[3] == 0));
        resting += row[5] == 0;
    }
    CHECK(resting > 0);
    CHECK(numbers_of(lines[1])[0] == Approx(4 * 2 * std::acos(-1.0) / 6));
}

TEST_CASE("the history in JSON has every stop, in ratios and in the units of the scene", "[program][history]") {
    expect(R"(
        0 integrate --history all --cycles 6 --json < stopping
          = {"method": "exact", "history": {"periods": 6, "from": 0}}
        0 integrate --history 2 --cycles 6 < stopping > history of 2 periods from
        0 integrate --cycles 6 --json --method exact < stopping
          = {"history": null}
    )");
    json a = answer_of("integrate --history all --cycles 6 --json", "stopping");
    const json ratios = a["history"]["stops"], units = a["dimensional"]["history"]["stops"];
    REQUIRE(ratios.size() == units.size());
    CHECK(ratios.size() >= a["stops"].size() + 5);
    for (std::size_t n = 0; n < ratios.size(); ++n) {
        CHECK(units[n]["start"].get<double>() == Approx(ratios[n]["start"].get<double>() / 6));
        CHECK(units[n]["x"].get<double>() == Approx(ratios[n]["x"].get<double>() * 40 / 800));
        CHECK(units[n].contains("end") == ratios[n].contains("end"));
    }
    a.erase("history");
    a["dimensional"].erase("history");
    CHECK(a == answer_of("integrate --cycles 6 --json --method exact", "stopping"));
}

TEST_CASE("without a force the answer is where the masses come to rest, in the units of the scene, with bounds",
          "[program][free-decay]") {
    // Each half-cycle takes 2 F / k = 0.12 m, until F holds the spring; a weight moves it all. In 4 s there are 6.
    expect(R"(
        0 integrate --start 1,0 --json < free
          = {"status": "at_rest", "proved": true, "half_cycles": 8, "turns": "# 8"}
          = {"rest": {"x": "~ 0.04 1e-14", "from": "~ 5.026548245743669 1e-15", "error_bound": "< 1e-15", "others": null}}
        0 integrate --start 1,0 --cycles 3 --samples 4 < free {"frequency_hz": 0.25, "load": 1}
          | # 13
          | t,x_1,v_1,direction
        0 integrate --start 1.4,0 --json < free {"static_load": [20]}
          = {"rest": {"x": "~ 0.44 1e-13"}, "half_cycles": 8}
        0 integrate --start 1,0 --json --cycles 1 < free {"frequency_hz": 0.25, "load": 1}
          = {"status": "in_motion", "rest": null, "half_cycles": 6}
        0 integrate --start 1,0 < free > after 8 half-cycles
    )");
    const json a = answer_of("integrate --start 1,0 --json", "free");
    for (int n = 1; n <= 8; ++n) {
        CHECK(std::abs(a["turns"][n - 1]["x"].get<double>()) == Approx(1 - 0.12 * n).epsilon(1e-13));
        CHECK(a["turns"][n - 1]["t"].get<double>() == Approx(n * std::acos(-1.0) / 5).epsilon(1e-15));
    }
    // A frequency of the load counts for nothing but what is called a period.
    const std::string with_frequency = R"(free {"frequency_hz": 0.25, "load": 1})";
    CHECK(answer_of("integrate --start 1,0 --json", with_frequency) == a);
    const std::vector<std::string> lines =
        lines_of(run_program("integrate --start 1,0 --cycles 3 --samples 4", scene_text(with_frequency)).output);
    for (std::size_t n = 0; n < 12; ++n) CHECK(numbers_of(lines[n + 1])[0] == Approx(static_cast<double>(n)).margin(1e-14));
    CHECK(numbers_of(lines[12])[1] == Approx(0.04));
}

TEST_CASE("solve and response say where a constant load holds the masses, and answer as without it", "[program][static-load]") {
    // 800 x_1 = 10 - 4, 200 (x_2 - x_1) = -4
    expect(R"(
        0 {solve|response} --json < stopping {"static_load": [10, -4]}
          = {"place_of_rest": "# 2", "dimensional":
               {"place_of_rest": {"0": {"x": "~ 0.0075 1e-14"}, "1": {"x": "~ -0.0125 1e-14"}}}}
          = {"place_of_rest": {"0": {"x": "~ 0.15 1e-14"}}, "dimensional": {"place_of_rest": {"0": {"error_bound": "< 1e-16"}}}}
        0 solve < stopping {"static_load": [10, -4]} > displacements count from the place of rest
        0 solve --json < one {"r": 0.5, "beta": 0.25, "static_load": ["0.1"]}
          = {"place_of_rest": {"0": {"x": 0.1}}}
    )");
    for (const char* command : {"solve --json", "response --json"}) {
        json a = answer_of(command, R"(stopping {"static_load": [10, -4]})");
        a.erase("place_of_rest");
        a["dimensional"].erase("place_of_rest");
        CHECK(a == answer_of(command, "stopping"));
    }
}

TEST_CASE("what a history, a free motion or a constant load cannot be is refused by name", "[program][bad-input][history]") {
    expect(R"(
        2 integrate --cycles 6 --history={0|-2|1.5|x|nan|7}            < stopping ! history must be all, or
        2 integrate --history all --method paper                       < stopping ! --method exact
        2 integrate --history all --output a.npy                       < stopping ! output must be given with --samples
        2 integrate --history all --samples 4 --output a.txt           < stopping ! output must end in .csv or .npy
        2 integrate                                                    < free ! start must be given where force is 0
        2 integrate --start 1                                          < free ! start must have 2 numbers
        2 integrate --start 1,0 --cycles 0                             < free ! cycles must be from 1
        2 integrate --start 1,0 --method paper                         < free ! method must be exact
        2 {solve|response|boundary|motion|functions|map --r 1:2:3 --beta 0:1:3} < free
          ! force must be positive, except for `denhartog integrate`
        2 integrate --start 1,0 < free {"friction": 0}                 ! friction must be positive
        2 integrate --start 1,0 < free {"friction": null}              ! friction must be given
        2 integrate --start 1,0 < free {"friction": null, "base_motion": "with_wall"}
          ! base_motion must not be given where force is 0
        2 integrate --start 1,0 < free {"friction": null, "base_acceleration": 1}
          ! base_acceleration must not be given where force is 0
        2 solve < stopping {"static_load": [1]}
          ! static_load must have as many values as there are masses (2), but is 1 (at /static_load)
        2 solve < stopping {"static_load": [1, "x"]}                   ! /static_load/1
        2 solve < stopping {"static_load": 1}                          ! static_load must have as many values
        2 boundary < stopping {"static_load": [1, 2], "force": null, "friction": null} ! force must be given
    )");
}

TEST_CASE("a free motion has no ratios", "[program][integrate][bad-input]") {
    const std::string text =
        R"({"masses": [1], "stiffnesses": [1], "damping_ratios": 0, "contact": 1, "force": 0, "friction": 0.1})";
    const Run refused = run_program("integrate --start 1,0 --units ratios", text);
    CHECK(refused.status == 2);
    CHECK(refused.error.find("units must be scene where force is 0") != std::string::npos);
    CHECK(run_program("integrate --start 1,0 --units scene", text).output == run_program("integrate --start 1,0", text).output);
}

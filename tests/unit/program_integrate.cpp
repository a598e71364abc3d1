#include <cmath>
#include <cstring>

#include "tests/catch.hpp"
#include "tests/unit/program_table.hpp"

using namespace denhartog::tests;

// `denhartog integrate`: both methods, their agreement, samples, bad input, what cannot be finished.

using nlohmann::json;

TEST_CASE("integrate prints the same fields by both methods, and the numbers agree to the tolerance",
          "[program][paper-algorithm]") {
    const std::string scene = R"(one {"r": 0.1, "beta": 0.2})";
    expect("0 integrate --json --cycles 20 < " + scene + R"(
          = "keys method status r beta cycles absolute_tolerance relative_tolerance regime contact masses
             stops_per_period stops counters"
          = {"counters": "keys steps rejected_steps right_hand_sides phases", "masses": {"0": {"phase": null}}}
          = {"method": "paper", "status": "complete", "regime": "stick_slip", "relative_tolerance": 1e-6}
        0 integrate - --json --cycles 20 --method exact < )" +
           scene + R"(
          = "keys method status r beta cycles regime contact masses stops_per_period stops counters"
    )");
    const json a = answer_of("integrate --json --cycles 20", scene),
               b = answer_of("integrate --json --cycles 20 --method exact", scene);
    CHECK(a["counters"]["phases"] == b["counters"]["phases"]);
    REQUIRE(a["stops_per_period"] == a["stops"].size());
    REQUIRE(a["stops"].size() == b["stops"].size());
    for (std::size_t n = 0; n < a["stops"].size(); ++n)
        for (const char* key : {"start", "end", "x"})
            CHECK(std::abs(a["stops"][n][key].get<double>() - b["stops"][n][key].get<double>()) <= 3e-5);
    CHECK(std::abs(a["contact"]["amplitude"].get<double>() - b["contact"]["amplitude"].get<double>()) <= 1e-5);
}

TEST_CASE("integrate speaks in the units of a scene of masses, of its start and its samples too", "[program][paper-algorithm]") {
    const std::string scene = R"(stopping {"friction": 6, "frequency": 12})", in_ratios = " --start 2,1,0.5,0",
                      in_units = " --start 0.1,0.05,0.3,0 --units scene"; // the same start in metres and metres per second
    const std::string exactly = "integrate --method exact --cycles 2", both = exactly + " --json";
    const double length = 40.0 / 800, omega = 12;
    expect("0 " + both + in_ratios + " < " + scene + R"(
          = {"dimensional": {"force": 40, "friction": "~ 6 1e-15", "static_friction": "~ 7.5 1e-15"}}
          = {"dimensional": {"static_over_kinetic_friction": 1.25}}
        2 integrate --units scene < one {"r": 1, "beta": 0.55, "mu": 2}
    )");
    const json ratios = answer_of(both + in_ratios, scene), same = answer_of(both + in_units, scene);
    for (std::size_t k = 0; k < 2; ++k)
        CHECK(ratios["dimensional"]["masses"][k]["amplitude"].get<double>() ==
              Approx(length * ratios["masses"][k]["amplitude"].get<double>()).epsilon(1e-15));
    CHECK(same["masses"][0]["amplitude"].get<double>() == Approx(ratios["masses"][0]["amplitude"].get<double>()).epsilon(1e-13));
    const std::vector<std::string> csv = lines_of(run_program(exactly + " --samples 2" + in_units, scene_text(scene)).output),
                                   plain = lines_of(run_program(exactly + " --samples 2" + in_ratios, scene_text(scene)).output);
    CHECK(csv[0].substr(0, 5) == "t,x_1");
    const std::vector<double> in_seconds = numbers_of(csv[2]), in_tau = numbers_of(plain[2]);
    CHECK(in_seconds[0] == Approx(in_tau[0] / omega).epsilon(1e-14));
    CHECK(in_seconds[1] == Approx(length * in_tau[1]).epsilon(1e-12));
    CHECK(in_seconds[3] == Approx(length * omega * in_tau[3]).epsilon(1e-12));
}

TEST_CASE("integrate starts where it is told to", "[program][paper-algorithm]") {
    expect(R"(
        0 integrate --json --method {paper|exact} < one {"r": 1, "beta": 0.55, "mu": 2}
          = {"regime": "permanent_sticking", "contact": {"amplitude": 0}, "stops": null}
        0 integrate --json --method {paper|exact} --start 5,0 < one {"r": 1, "beta": 0.55, "mu": 2}
          = {"regime": "continuous", "stops_per_period": 0, "contact": {"phase": "~ 1.5533 6e-5"}}
    )");
}

TEST_CASE("a load out of phase drives modes that only the reference knows to their digits", "[program][exact-solver][phases]") {
    // Nearly nothing couples mass 1: its amplitude is 1/|1 - r^2 + 0.3 i r|.
    expect(R"(
        0 integrate --json --method exact < soft mode {"load": [1, 1], "load_phases": [0, 0.5], "r": 1.25}
          = {"masses": {"0": {"amplitude": "~ 1.4792005232672776 1e-11"}}}
    )");
}

TEST_CASE("samples are the last period as CSV, by both methods the same", "[program][paper-algorithm]") {
    std::vector<std::vector<std::string>> both;
    for (const std::string method : {"paper --absolute-tolerance 1e-10", "exact"}) {
        const std::string arguments = "integrate --samples 16 --cycles 30 --method " + method;
        expect("0 " + arguments + " < one \n | # 17 \n | tau,x_1,v_1");
        both.push_back(lines_of(run_program(arguments, scene_text("one")).output));
    }
    for (std::size_t n = 1; n <= 16; ++n) {
        const std::vector<double> a = numbers_of(both[0][n]), b = numbers_of(both[1][n]);
        REQUIRE(a.size() == 3);
        for (std::size_t c = 0; c < 3; ++c) CHECK(std::abs(a[c] - b[c]) <= 1e-8);
    }
}

TEST_CASE("integrate answers bad input with the quantity, the rule and status 2", "[program][bad-input][paper-algorithm]") {
    expect(R"(
        2 integrate --cycles 0                < one ! cycles must be from 1 to 1000000, but is 0
        2 integrate --cycles 1.5              < one ! --cycles
        2 integrate --method exact --cycles 0 < one ! cycles must be from 1
        2 integrate --absolute-tolerance -1   < one ! absolute_tolerance must be positive and below 1, but is -1
        2 integrate --relative-tolerance nan  < one ! relative_tolerance must be zero or positive and below 1, but is nan
        2 integrate --method ode45            < one ! method must be paper or exact, but is ode45
        2 integrate --start 1                 < one ! start must have 2 numbers
        2 integrate --start 1,x               < one ! start must be written as a number, but is x
        2 integrate --samples 3 --json        < one ! samples must not be given with --json
        2 integrate                           < one {"beta": null} ! beta must be given
        2 integrate --json --cycles 3         < one + one {"r": -1} + one
          | # 3
          = {"1": {"error": {"quantity": "r"}}}
    )");
    const std::vector<std::string> lines =
        lines_of(run_program("integrate --json --cycles 3", scene_text(R"(one + one {"r": -1} + one)")).output);
    CHECK(lines.at(0) == lines.at(2));
}

TEST_CASE("a motion that cannot be finished has status and reason in place of numbers, and exit status 3",
          "[program][paper-algorithm]") {
    const Run run = run_program("integrate --json --start 1e308,1e308", scene_text("one"));
    CHECK(run.status == 3);
    const json a = json::parse(run.output);
    CHECK(a["status"] == "overflow");
    CHECK(a["reason"].get<std::string>().find("beyond the range") != std::string::npos);
    for (const char* absent : {"masses", "contact"}) CHECK_FALSE(a.contains(absent));
    CHECK(run.error.find("beyond the range") != std::string::npos);
    expect("3 integrate --samples 3 --start 1e308,1e308 < one");
}

TEST_CASE("the exact method has the modes of a system with a light mass", "[program][integrate]") {
    // With three digits of the first natural frequency the amplitude was 7 % off.
    const std::string at = R"( {"r": 0.7, "beta": 0.5})", command = "integrate --json --method exact";
    const json with = answer_of(command, "light mass" + at)["masses"],
               without = answer_of(command, "no light mass" + at)["masses"];
    for (const std::size_t k : {0, 1})
        CHECK(with[k]["amplitude"].get<double>() == Approx(without[k]["amplitude"].get<double>()).epsilon(1e-9));
}

// `denhartog integrate --history`, `"force": 0` and `static_load`: formats, units, refusals.

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
    expect(R"(2 integrate --start 1,0 --units ratios < free ! units must be scene where force is 0)");
    const std::string scene = scene_text("free");
    CHECK(run_program("integrate --start 1,0 --units scene", scene).output == run_program("integrate --start 1,0", scene).output);
}

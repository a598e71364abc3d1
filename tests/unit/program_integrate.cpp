// `denhartog integrate`: both methods, their agreement, samples, bad input, what cannot be finished.
#include <cmath>

#include "tests/catch.hpp"
#include "tests/unit/program_table.hpp"

using namespace denhartog::tests;
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
        2 integrate --samples -3              < one ! samples must be from 0
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

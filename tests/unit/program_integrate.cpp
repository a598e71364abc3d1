// `denhartog integrate`: both methods, their agreement, samples, bad input, what cannot be finished.
#include <cmath>
#include <sstream>

#include "tests/catch.hpp"
#include "tests/unit/program_runs.hpp"

using namespace denhartog::tests;
using nlohmann::json;

namespace {

std::string one_mass(const std::string& r, const std::string& beta, const std::string& mu = "1") {
    return R"({"mass_ratios": [1], "stiffness_ratios": [1], "damping_ratios": 0.05, "contact": 1, "load": 1, "mu": )" + mu +
           R"(, "r": )" + r + R"(, "beta": )" + beta + "}";
}

std::vector<std::string> keys_of(const nlohmann::ordered_json& object) {
    std::vector<std::string> keys;
    for (const auto& item : object.items()) keys.push_back(item.key());
    return keys;
}

} // namespace

TEST_CASE("integrate prints the same fields by both methods, and the numbers agree to the tolerance",
          "[program][paper-algorithm]") {
    const std::string scene = one_mass("0.1", "0.2");
    const Run by_paper = run_program("integrate --json --cycles 20", scene);
    const Run exactly = run_program("integrate - --json --cycles 20 --method exact", scene);
    REQUIRE(by_paper.status == 0);
    REQUIRE(exactly.status == 0);
    CHECK(by_paper.error.empty());
    const auto a = nlohmann::ordered_json::parse(by_paper.output), b = nlohmann::ordered_json::parse(exactly.output);
    CHECK(keys_of(a) == std::vector<std::string>{"method", "status", "r", "beta", "cycles", "absolute_tolerance",
                                                 "relative_tolerance", "regime", "contact", "masses", "stops_per_period", "stops",
                                                 "counters"});
    CHECK(keys_of(b) == std::vector<std::string>{"method", "status", "r", "beta", "cycles", "regime", "contact", "masses",
                                                 "stops_per_period", "stops", "counters"});
    CHECK(keys_of(a["counters"]) == std::vector<std::string>{"steps", "rejected_steps", "right_hand_sides", "phases"});
    CHECK(a["method"] == "paper");
    CHECK(a["status"] == "complete");
    CHECK(a["regime"] == "stick_slip");
    CHECK(a["relative_tolerance"] == 1e-6);
    CHECK(a["counters"]["phases"] == b["counters"]["phases"]);
    CHECK_FALSE(a["masses"][0].contains("phase"));
    REQUIRE(a["stops_per_period"] == a["stops"].size());
    REQUIRE(a["stops"].size() == b["stops"].size());
    for (std::size_t n = 0; n < a["stops"].size(); ++n)
        for (const char* key : {"start", "end", "x"})
            CHECK(std::abs(a["stops"][n][key].get<double>() - b["stops"][n][key].get<double>()) <= 3e-5);
    CHECK(std::abs(a["contact"]["amplitude"].get<double>() - b["contact"]["amplitude"].get<double>()) <= 1e-5);
}

TEST_CASE("integrate speaks in the units of a scene of masses, of its start and its samples too", "[program][paper-algorithm]") {
    const std::string scene = R"({"masses": [2, 1], "stiffnesses": [800, 200], "damping_ratios": [0.05, 0.05], "contact": 1,
                                  "load": 2, "force": 40, "friction": 6, "mu": 1.25, "frequency": 12})";
    const double length = 40.0 / 800, omega = 12;
    const Run in_ratios = run_program("integrate --json --method exact --cycles 2 --start 2,1,0.5,0", scene);
    const json ratios = json::parse(in_ratios.output), units = ratios["dimensional"];
    CHECK(units["force"] == 40);
    CHECK(units["friction"].get<double>() == Approx(6).epsilon(1e-15));
    CHECK(units["static_friction"].get<double>() == Approx(7.5).epsilon(1e-15));
    CHECK(units["static_over_kinetic_friction"] == 1.25);
    for (std::size_t k = 0; k < 2; ++k)
        CHECK(units["masses"][k]["amplitude"].get<double>() ==
              Approx(length * ratios["masses"][k]["amplitude"].get<double>()).epsilon(1e-15));
    // The same start in metres and metres per second.
    const std::string start = " --start 0.1,0.05,0.3,0 --units scene";
    const json same = json::parse(run_program("integrate --json --method exact --cycles 2" + start, scene).output);
    CHECK(same["masses"][0]["amplitude"].get<double>() == Approx(ratios["masses"][0]["amplitude"].get<double>()).epsilon(1e-13));
    const std::string samples = "integrate --samples 2 --method exact --cycles 2";
    const std::vector<std::string> csv = lines_of(run_program(samples + start, scene).output),
                                   plain = lines_of(run_program(samples + " --start 2,1,0.5,0", scene).output);
    CHECK(csv[0].substr(0, 5) == "t,x_1");
    const auto second = [](const std::string& line, int column) {
        std::istringstream cells(line);
        std::string cell;
        for (int n = 0; n <= column; ++n) std::getline(cells, cell, ',');
        return std::stod(cell);
    };
    CHECK(second(csv[2], 0) == Approx(second(plain[2], 0) / omega).epsilon(1e-14));
    CHECK(second(csv[2], 1) == Approx(length * second(plain[2], 1)).epsilon(1e-12));
    CHECK(second(csv[2], 3) == Approx(length * omega * second(plain[2], 3)).epsilon(1e-12));
    CHECK(run_program("integrate --units scene", one_mass("1", "0.55", "2")).status == 2);
}

TEST_CASE("integrate starts where it is told to", "[program][paper-algorithm]") {
    const std::string scene = one_mass("1", "0.55", "2");
    for (const char* method : {"paper", "exact"}) {
        const std::string command = std::string("integrate --json --method ") + method;
        const json rest = json::parse(run_program(command, scene).output);
        CHECK(rest["regime"] == "permanent_sticking");
        CHECK(rest["contact"]["amplitude"] == 0);
        CHECK_FALSE(rest.contains("stops"));
        const json slides = json::parse(run_program(command + " --start 5,0", scene).output);
        CHECK(slides["regime"] == "continuous");
        CHECK(slides["stops_per_period"] == 0);
        CHECK(std::abs(slides["contact"]["phase"].get<double>() - 1.5533) <= 1e-4);
    }
}

TEST_CASE("samples are the last period as CSV, by both methods the same", "[program][paper-algorithm]") {
    const std::string scene = one_mass("0.4", "0.3");
    std::vector<std::vector<std::string>> both;
    for (const char* method : {"paper --absolute-tolerance 1e-10", "exact"}) {
        const Run run = run_program(std::string("integrate --samples 16 --cycles 30 --method ") + method, scene);
        REQUIRE(run.status == 0);
        both.push_back(lines_of(run.output));
        REQUIRE(both.back().size() == 17);
        CHECK(both.back().front() == "tau,x_1,v_1");
    }
    for (std::size_t n = 1; n <= 16; ++n) {
        const std::vector<double> a = numbers_of(both[0][n]), b = numbers_of(both[1][n]);
        REQUIRE(a.size() == 3);
        for (std::size_t c = 0; c < 3; ++c) CHECK(std::abs(a[c] - b[c]) <= 1e-8);
    }
}

TEST_CASE("integrate answers bad input with the quantity, the rule and status 2", "[program][bad-input][paper-algorithm]") {
    const std::string scene = one_mass("0.4", "0.3");
    for (const auto& [option, message] :
         {std::pair<std::string, std::string>{"--cycles 0", "cycles must be from 1 to 1000000, but is 0"},
          {"--cycles 1.5", "--cycles"},
          {"--method exact --cycles 0", "cycles must be from 1"},
          {"--absolute-tolerance -1", "absolute_tolerance must be positive and below 1, but is -1"},
          {"--relative-tolerance nan", "relative_tolerance must be zero or positive and below 1, but is nan"},
          {"--method ode45", "method must be paper or exact, but is ode45"},
          {"--start 1", "start must have 2 numbers"},
          {"--start 1,x", "start must be written as a number, but is x"},
          {"--samples -3", "samples must be from 0"},
          {"--samples 3 --json", "samples must not be given with --json"}}) {
        const Run run = run_program("integrate " + option, scene);
        INFO(option << ": " << run.error);
        CHECK(run.status == 2);
        CHECK(run.output.empty());
        CHECK(run.error.find(message) != std::string::npos);
    }
    const Run missing = run_program("integrate", R"({"mass_ratios": [1], "stiffness_ratios": [1], "damping_ratios": 0.05,
        "contact": 1, "load": 1, "r": 1})");
    CHECK(missing.status == 2);
    CHECK(missing.error.find("beta must be given") != std::string::npos);
    const Run lines = run_program("integrate --json --cycles 3", scene + "\n" + one_mass("-1", "0.3") + "\n" + scene + "\n");
    CHECK(lines.status == 2);
    REQUIRE(lines_of(lines.output).size() == 3);
    CHECK(json::parse(lines_of(lines.output)[1])["error"]["quantity"] == "r");
    CHECK(lines_of(lines.output)[0] == lines_of(lines.output)[2]);
}

TEST_CASE("a motion that cannot be finished has status and reason in place of numbers, and exit status 3",
          "[program][paper-algorithm]") {
    const Run run = run_program("integrate --json --start 1e308,1e308", one_mass("0.4", "0.3"));
    CHECK(run.status == 3);
    const json a = json::parse(run.output);
    CHECK(a["status"] == "overflow");
    CHECK(a["reason"].get<std::string>().find("beyond the range") != std::string::npos);
    CHECK_FALSE(a.contains("masses"));
    CHECK_FALSE(a.contains("contact"));
    CHECK(run.error.find("beyond the range") != std::string::npos);
    const Run samples = run_program("integrate --samples 3 --start 1e308,1e308", one_mass("0.4", "0.3"));
    CHECK(samples.status == 3);
    CHECK(samples.output.empty());
}

TEST_CASE("the exact method has the modes of a system with a light mass", "[program][integrate]") {
    // Double alone has the first natural frequency of this matrix to three digits, and the amplitude was 7 % off.
    const std::string of_both = R"("damping_ratios": 0.01, "contact": 1, "load": 2, "r": 0.7, "beta": 0.5})";
    const Run light = run_program("integrate --json --method exact", R"({"mass_matrix": [[1, 0, 0], [0, 2.1, 0], [0, 0, 1e-13]],
        "stiffness_matrix": [[1.9, -0.1, -0.8], [-0.1, 1.1, -0.3], [-0.8, -0.3, 2.2]], )" +
                                                                         of_both);
    const json K{{1.9 - 0.64 / 2.2, -0.1 - 0.24 / 2.2}, {-0.1 - 0.24 / 2.2, 1.1 - 0.09 / 2.2}};
    const Run condensed = run_program("integrate --json --method exact",
                                      R"({"mass_matrix": [[1, 0], [0, 2.1]], "stiffness_matrix": )" + K.dump() + ", " + of_both);
    REQUIRE(light.status == 0);
    REQUIRE(condensed.status == 0);
    const json a = json::parse(light.output).at("masses"), b = json::parse(condensed.output).at("masses");
    for (const std::size_t k : {0, 1})
        CHECK(a[k].at("amplitude").get<double>() == Approx(b[k].at("amplitude").get<double>()).epsilon(1e-9));
}

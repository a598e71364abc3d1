// `denhartog integrate --history`, `"force": 0` and `static_load`: formats, units, refusals.
#include <cmath>
#include <cstring>

#include "tests/catch.hpp"
#include "tests/unit/program_runs.hpp"

using namespace denhartog::tests;
using nlohmann::json;

namespace {

const std::string stopping = R"({"masses": [2, 1], "stiffnesses": [800, 200], "damping_ratios": [0.05, 0.05], "contact": 1,
    "load": 2, "force": 40, "friction": 30, "mu": 1.25, "frequency": 6})";
const std::string free_mass = R"({"masses": 2, "stiffnesses": 50, "damping_ratios": 0, "contact": 1, "force": 0, "friction": 3})";

} // namespace

TEST_CASE("a history is CSV or NPY with the columns of motion and whether the contact sticks", "[program][history]") {
    const std::string command = "integrate --history 2 --cycles 6 --samples 8 --units scene";
    const Run run = run_program(command, stopping);
    REQUIRE(run.status == 0);
    const std::vector<std::string> lines = lines_of(run.output);
    REQUIRE(lines.size() == 17);
    CHECK(lines[0] == "t,x_1,x_2,v_1,v_2,direction");
    const std::string file = (scratch() / "history.npy").string();
    REQUIRE(run_program(command + " --output " + file, stopping).status == 0);
    const std::string bytes = content_of(file);
    CHECK(bytes.substr(1, 5) == "NUMPY");
    const std::size_t header = 10 + static_cast<unsigned char>(bytes[8]) + 256 * static_cast<unsigned char>(bytes[9]);
    REQUIRE(bytes.size() == header + 16 * (5 * 8 + 1));
    CHECK(bytes.find("('direction', '|i1')") != std::string::npos);
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
    const std::string as_csv = (scratch() / "history.csv").string();
    REQUIRE(run_program(command + " --output " + as_csv, stopping).status == 0);
    CHECK(content_of(as_csv) == run.output);
}

TEST_CASE("the history in JSON has every stop, in ratios and in the units of the scene", "[program][history]") {
    const json a = json::parse(run_program("integrate --history all --cycles 6 --json", stopping).output);
    CHECK(a["method"] == "exact");
    CHECK(a["history"]["periods"] == 6);
    CHECK(a["history"]["from"] == 0);
    const json &ratios = a["history"]["stops"], units = a["dimensional"]["history"]["stops"];
    REQUIRE(ratios.size() == units.size());
    CHECK(ratios.size() >= a["stops"].size() + 5);
    for (std::size_t n = 0; n < ratios.size(); ++n) {
        CHECK(units[n]["start"].get<double>() == Approx(ratios[n]["start"].get<double>() / 6));
        CHECK(units[n]["x"].get<double>() == Approx(ratios[n]["x"].get<double>() * 40 / 800));
        CHECK(units[n].contains("end") == ratios[n].contains("end"));
    }
    const json plain = json::parse(run_program("integrate --cycles 6 --json --method exact", stopping).output);
    CHECK_FALSE(plain.contains("history"));
    json without = a;
    without.erase("history");
    without["dimensional"].erase("history");
    CHECK(without == plain);
    CHECK(run_program("integrate --history 2 --cycles 6", stopping).output.find("history of 2 periods from") !=
          std::string::npos);
}

TEST_CASE("without a force the answer is where the masses come to rest, in the units of the scene, with bounds",
          "[program][free-decay]") {
    const json a = json::parse(run_program("integrate --start 1,0 --json", free_mass).output);
    CHECK(a["status"] == "at_rest");
    CHECK(a["proved"] == true);
    CHECK(a["half_cycles"] == 8); // each takes 2 F / k = 0.12 m, until F holds the spring
    CHECK(a["rest"]["x"].get<double>() == Approx(0.04).epsilon(1e-14));
    CHECK(a["rest"]["from"].get<double>() == Approx(8 * std::acos(-1.0) / 5).epsilon(1e-15));
    CHECK(a["rest"]["error_bound"].get<double>() < 1e-15);
    CHECK_FALSE(a["rest"].contains("others"));
    REQUIRE(a["turns"].size() == 8);
    for (int n = 1; n <= 8; ++n) {
        CHECK(std::abs(a["turns"][n - 1]["x"].get<double>()) == Approx(1 - 0.12 * n).epsilon(1e-13));
        CHECK(a["turns"][n - 1]["t"].get<double>() == Approx(n * std::acos(-1.0) / 5).epsilon(1e-15));
    }
    // A frequency of the load counts for nothing but what is called a period.
    json with_frequency = json::parse(free_mass);
    with_frequency["frequency_hz"] = 0.25;
    with_frequency["load"] = 1;
    const Run same = run_program("integrate --start 1,0 --json", with_frequency.dump());
    CHECK(json::parse(same.output) == a);
    const std::vector<std::string> lines =
        lines_of(run_program("integrate --start 1,0 --cycles 3 --samples 4", with_frequency.dump()).output);
    REQUIRE(lines.size() == 13);
    CHECK(lines[0] == "t,x_1,v_1,direction");
    for (std::size_t n = 0; n < 12; ++n) CHECK(numbers_of(lines[n + 1])[0] == Approx(static_cast<double>(n)).margin(1e-14));
    CHECK(numbers_of(lines[12])[1] == Approx(0.04));
    // A weight moves it all.
    json heavy = json::parse(free_mass);
    heavy["static_load"] = {20};
    const json b = json::parse(run_program("integrate --start 1.4,0 --json", heavy.dump()).output);
    CHECK(b["rest"]["x"].get<double>() == Approx(0.44).epsilon(1e-13));
    CHECK(b["half_cycles"] == 8);
    const json some = json::parse(run_program("integrate --start 1,0 --json --cycles 1", with_frequency.dump()).output);
    CHECK(some["status"] == "in_motion");
    CHECK_FALSE(some.contains("rest"));
    CHECK(some["half_cycles"] == 6); // of 0.628 s each, in 4 s
    CHECK(run_program("integrate --start 1,0", free_mass).output.find("after 8 half-cycles") != std::string::npos);
}

TEST_CASE("solve and response say where a constant load holds the masses, and answer as without it", "[program][static-load]") {
    json loaded = json::parse(stopping);
    loaded["static_load"] = {10, -4};
    for (const char* command : {"solve --json", "response --json"}) {
        json a = json::parse(run_program(command, loaded.dump()).output);
        const json plain = json::parse(run_program(command, stopping).output);
        REQUIRE(a["place_of_rest"].size() == 2);
        const json& units = a["dimensional"]["place_of_rest"]; // 800 x_1 = 10 - 4, 200 (x_2 - x_1) = -4
        CHECK(units[0]["x"].get<double>() == Approx(0.0075).epsilon(1e-14));
        CHECK(units[1]["x"].get<double>() == Approx(-0.0125).epsilon(1e-14));
        CHECK(units[0]["error_bound"].get<double>() < 1e-16);
        CHECK(a["place_of_rest"][0]["x"].get<double>() == Approx(0.15).epsilon(1e-14));
        a.erase("place_of_rest");
        a["dimensional"].erase("place_of_rest");
        CHECK(a == plain);
    }
    CHECK(run_program("solve", loaded.dump()).output.find("displacements count from the place of rest") != std::string::npos);
    const Run ratios =
        run_program("solve --json", R"({"mass_ratios": [1], "stiffness_ratios": [1], "damping_ratios": 0.05, "contact": 1,
        "load": 1, "r": 0.5, "beta": 0.25, "static_load": ["0.1"]})");
    CHECK(json::parse(ratios.output)["place_of_rest"][0]["x"] == 0.1);
}

TEST_CASE("what a history, a free motion or a constant load cannot be is refused by name", "[program][bad-input][history]") {
    const auto refused = [](const std::string& command, const std::string& scene, const std::string& message) {
        const Run run = run_program(command, scene);
        INFO(command << ": " << run.error);
        CHECK(run.status == 2);
        CHECK(run.output.empty());
        CHECK(run.error.find(message) != std::string::npos);
    };
    for (const char* history : {"0", "-2", "1.5", "x", "nan", "7"})
        refused(std::string("integrate --cycles 6 --history=") + history, stopping, "history must be all, or ");
    refused("integrate --history all --method paper", stopping, "--method exact");
    refused("integrate --history all --output a.npy", stopping, "output must be given with --samples");
    refused("integrate --history all --samples 4 --output a.txt", stopping, "output must end in .csv or .npy");
    refused("integrate", free_mass, "start must be given where force is 0");
    refused("integrate --start 1", free_mass, "start must have 2 numbers");
    refused("integrate --start 1,0 --cycles 0", free_mass, "cycles must be from 1");
    refused("integrate --start 1,0 --method paper", free_mass, "method must be exact");
    for (const char* command : {"solve", "response", "boundary", "motion", "map --r 1:2:3 --beta 0:1:3", "functions"})
        refused(command, free_mass, "force must be positive, except for `denhartog integrate`");
    json scene = json::parse(free_mass);
    scene["friction"] = 0;
    refused("integrate --start 1,0", scene.dump(), "friction must be positive");
    scene.erase("friction");
    refused("integrate --start 1,0", scene.dump(), "friction must be given");
    scene["base_motion"] = "with_wall";
    refused("integrate --start 1,0", scene.dump(), "base_motion must not be given where force is 0");
    scene.erase("base_motion");
    scene["base_acceleration"] = 1;
    refused("integrate --start 1,0", scene.dump(), "base_acceleration must not be given where force is 0");
    scene = json::parse(stopping);
    scene["static_load"] = {1};
    refused("solve", scene.dump(), "static_load must have as many values as there are masses (2), but is 1 (at /static_load)");
    scene["static_load"] = {1, "x"};
    refused("solve", scene.dump(), "/static_load/1");
    scene["static_load"] = 1;
    refused("solve", scene.dump(), "static_load must have as many values");
    scene["static_load"] = {1, 2};
    scene.erase("force");
    scene.erase("friction");
    refused("boundary", scene.dump(), "force must be given");
}

TEST_CASE("a free motion has no ratios", "[program][integrate][bad-input]") {
    const std::string text =
        R"({"masses": [1], "stiffnesses": [1], "damping_ratios": 0, "contact": 1, "force": 0, "friction": 0.1})";
    const Run refused = run_program("integrate --start 1,0 --units ratios", text);
    CHECK(refused.status == 2);
    CHECK(refused.error.find("units must be scene where force is 0") != std::string::npos);
    CHECK(run_program("integrate --start 1,0 --units scene", text).output == run_program("integrate --start 1,0", text).output);
}

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <tuple>

#include "tests/catch.hpp"
#include "tests/unit/program_runs.hpp"

using namespace denhartog::tests;

namespace {

const std::string scene = R"({"mass_ratios": [1, 1], "stiffness_ratios": [1, 1], "damping_ratios": [0.03125, 0.0625],
                              "contact": 2, "load": 1})";

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
    return cells;
}

double number_at(const std::string& bytes, std::size_t place) {
    double x = 0;
    std::memcpy(&x, bytes.data() + place, sizeof x);
    return x;
}

} // namespace

TEST_CASE("a map is a table, a line a point", "[program][map][threads]") {
    const Run run = run_program("map --r 0.5:2:4 --beta 0:1:3", scene);
    REQUIRE(run.status == 0);
    CHECK(run.error.empty());
    const std::vector<std::string> lines = lines_of(run.output);
    REQUIRE(lines.size() == 13);
    CHECK(lines[0] == "r,beta,regime,stops_per_period,periods,amplitude_2,status");
    const std::vector<std::string> first = cells_of(lines[1]), last = cells_of(lines[12]);
    CHECK(first[0] == "0.5");
    CHECK(first[1] == "0");
    CHECK(first[2] == "continuous");
    CHECK(first[6] == "answered");
    CHECK(last[0] == "2");
    CHECK(last[1] == "1");
    CHECK(cells_of(lines[5])[1] == "0.5");
    CHECK(run_program("map --r 0.5:2:4 --beta 0:1:3 --threads 3", scene).output == run.output);
}

TEST_CASE("the scene of a map may come after the masses", "[program][map]") {
    const std::string file = file_with("scene_after_masses", scene).string();
    const Run before = run_program("map '" + file + "' --r 0.5:2:4 --beta 0:1:3 --mass 1");
    const Run after = run_program("map --r 0.5:2:4 --beta 0:1:3 --mass 1 '" + file + "'");
    REQUIRE(after.status == 0);
    CHECK(after.output == before.output);
}

TEST_CASE("a map as NPY has a header that NumPy reads and the numbers of the CSV", "[program][map]") {
    const auto file = scratch() / "map.npy";
    const Run csv = run_program("map --r 0.5:2:4 --beta 0:1:3 --mass 1 --mass 2", scene);
    REQUIRE(run_program("map --r 0.5:2:4 --beta 0:1:3 --mass 1 --mass 2 --output '" + file.string() + "'", scene).status == 0);
    const std::string bytes = content_of(file);
    REQUIRE(bytes.substr(0, 8) == std::string("\x93NUMPY\x01\x00", 8));
    const std::size_t length = static_cast<unsigned char>(bytes[8]) + 256U * static_cast<unsigned char>(bytes[9]);
    CHECK((10 + length) % 64 == 0);
    CHECK(bytes[9 + length] == '\n');
    const std::string header = bytes.substr(10, length);
    CHECK(header.find("'shape': (4, 3, )") != std::string::npos);
    CHECK(header.find("('amplitude_1', '<f8')") != std::string::npos);
    const std::size_t record = 8 + 8 + 1 + 4 + 4 + 8 + 8 + 1;
    REQUIRE(bytes.size() == 10 + length + 12 * record);
    const std::vector<std::string> lines = lines_of(csv.output);
    for (std::size_t point = 0; point < 12; ++point) {
        const std::vector<std::string> cells = cells_of(lines[point + 1]);
        const std::size_t at = 10 + length + point * record;
        CHECK(number_at(bytes, at) == std::stod(cells[0]));
        CHECK(number_at(bytes, at + 8) == std::stod(cells[1]));
        CHECK(number_at(bytes, at + 25) == std::stod(cells[5]));
        CHECK(number_at(bytes, at + 33) == std::stod(cells[6]));
        CHECK(static_cast<int>(bytes[at + 16]) == (cells[2] == "continuous" ? 0 : cells[2] == "stick_slip" ? 1 : 2));
        CHECK(bytes[at + 41] == 0);
    }
}

TEST_CASE("a point without numbers has none in the files", "[program][map][domain]") {
    const std::string undamped = R"({"mass_ratios": [1], "stiffness_ratios": [1], "damping_ratios": 0, "contact": 1, "load": 1})";
    const Run run = run_program("map --r 1:1:1 --beta 0.125:0.125:1", undamped);
    REQUIRE(run.status == 0);
    CHECK(lines_of(run.output)[1] == "1,0.125,,nan,nan,nan,at_a_pole");
}

TEST_CASE("the boundaries over r are a table", "[program][map]") {
    const Run run = run_program("map --boundaries --r 0.5:2:4", scene);
    REQUIRE(run.status == 0);
    const std::vector<std::string> lines = lines_of(run.output);
    REQUIRE(lines.size() == 5);
    CHECK(lines[0] == "r,exact,paper,approximate,sticking,status");
    const std::vector<std::string> cells = cells_of(lines[1]);
    CHECK(std::stod(cells[2]) <= std::stod(cells[1]));
    CHECK(std::stod(cells[1]) <= std::stod(cells[3]));
}

namespace {

// Two masses in kilograms, newtons per metre and newtons; what follows is the load and the point.
const std::string in_si = R"({"masses": [2, 3], "stiffnesses": [800, 500], "damping_ratios": [0.03125, 0.0625], "contact": 2, )";
const std::string pushed = in_si + R"("load": 1, "force": 5})",
                  shaken = in_si + R"("base_motion": "with_wall", "base_displacement": 0.002})";

// The rows of a CSV, each cell a number but those of regime and status.
std::vector<std::vector<std::string>> rows_of(const Run& run) {
    REQUIRE(run.status == 0);
    std::vector<std::vector<std::string>> rows;
    for (const std::string& line : lines_of(run.output)) rows.push_back(cells_of(line));
    return rows;
}

} // namespace

TEST_CASE("a map over hertz and newtons has the displacements that solve has in metres", "[program][map]") {
    for (const bool moves : {false, true}) {
        const auto rows =
            rows_of(run_program("map --frequency-hz 2:4:3 --friction 0.5:1.5:3 --mass 1 --mass 2", moves ? shaken : pushed));
        REQUIRE(rows.size() == 10);
        CHECK(rows[0] == std::vector<std::string>{"frequency_hz", "friction", "regime", "stops_per_period", "periods",
                                                  "amplitude_1", "amplitude_2", "status"});
        for (std::size_t n = 1; n < rows.size(); ++n) {
            std::string point = moves ? shaken : pushed;
            point.back() = ',';
            point += R"("frequency_hz": )" + rows[n][0] + R"(, "friction": )" + rows[n][1] + "}";
            INFO(point);
            const Run run = run_program("solve --json", point);
            REQUIRE(run.status == 0);
            const nlohmann::json answer = nlohmann::json::parse(run.output);
            CHECK(answer.at("regime") == rows[n][2]);
            for (std::size_t k = 0; k < 2; ++k)
                CHECK(std::stod(rows[n][5 + k]) ==
                      Approx(answer.at("dimensional").at("masses").at(k).at("amplitude").get<double>()).epsilon(1e-6));
        }
    }
}

TEST_CASE("boundaries over hertz are the forces that boundary tells", "[program][map]") {
    const auto rows = rows_of(run_program("map --boundaries --frequency-hz 2:4:3", shaken));
    REQUIRE(rows.size() == 4);
    CHECK(rows[0][0] == "frequency_hz");
    for (std::size_t n = 1; n < rows.size(); ++n) {
        std::string point = shaken;
        point.back() = ',';
        const Run run = run_program("boundary --json", point + R"("frequency_hz": )" + rows[n][0] + "}");
        REQUIRE(run.status == 0);
        const nlohmann::json of = nlohmann::json::parse(run.output).at("dimensional").at("friction_limit");
        CHECK(std::stod(rows[n][1]) == Approx(of.at("exact").get<double>()).epsilon(1e-6));
        CHECK(std::stod(rows[n][4]) == Approx(of.at("sticking").get<double>()).epsilon(1e-6));
    }
}

TEST_CASE("a motion in the units of the scene reaches the amplitudes of its answer", "[program]") {
    const double omega = 2 * 3.14159265358979 * 3, half_second = 0.5 / 3;
    for (const std::string friction : {"0.5", "1.5"}) {
        std::string point = shaken;
        point.back() = ',';
        point += R"("frequency_hz": 3, "friction": )" + friction + "}";
        const auto rows = rows_of(run_program("solve --samples 400 --units scene", point)),
                   in_tau = rows_of(run_program("solve --samples 400", point));
        REQUIRE(rows.size() == 401);
        CHECK(rows[0][0] == "t");
        CHECK(in_tau[0][0] == "tau");
        CHECK(std::stod(rows[201][0]) == Approx(half_second).epsilon(1e-12));
        const nlohmann::json answer = nlohmann::json::parse(run_program("solve --json", point).output);
        double largest = 0;
        for (std::size_t n = 1; n < rows.size(); ++n) {
            largest = std::max(largest, std::abs(std::stod(rows[n][2])));
            const double x = std::stod(in_tau[n][2]), v = std::stod(in_tau[n][4]);
            CHECK(std::stod(rows[n][4]) * x == Approx(std::stod(rows[n][2]) * v * omega).epsilon(1e-9).margin(1e-15));
        }
        CHECK(largest == Approx(answer.at("dimensional").at("masses").at(1).at("amplitude").get<double>()).epsilon(1e-4));
    }
}

TEST_CASE("a number that the units take beyond a double is no answer", "[program][map]") {
    const std::string huge = R"({"masses": [1e-200], "stiffnesses": [1e-200], "damping_ratios": [0.1], "contact": 1, "load": 1,
        "force": 1e200, "friction": 1e199, "frequency": 0.5})";
    const auto rows = rows_of(run_program("map --frequency-hz 0.1:0.1:1 --friction 1e199:1e199:1", huge));
    CHECK(rows.at(1) == std::vector<std::string>{"0.1", "1e+199", "", "nan", "nan", "nan", "failed"});
    const Run motion = run_program("solve --samples 2 --units scene", huge);
    CHECK(motion.status == 3);
    CHECK(motion.output.empty());
    CHECK(motion.error.find("beyond the range of a double") != std::string::npos);
}

TEST_CASE("units are refused where a scene has none", "[program][map][bad-input]") {
    const std::string faint = in_si + R"("load": 1, "force": 1e-10})";
    std::string without_force = in_si;
    without_force += R"("load": 1})";
    const std::string solved =
        R"({"mass_ratios": [1], "stiffness_ratios": [1], "damping_ratios": [0.1], "contact": 1, "load": 1, "r": 0.5, "beta": 0.1})";
    for (const auto& [arguments, input, name] :
         {std::tuple{"map --frequency-hz 1:2:2 --friction 0:1:2", scene, "frequency_hz"},
          std::tuple{"map --frequency-hz 1:2:2 --friction 0:1:2", without_force, "force"},
          std::tuple{"map --frequency-hz 0:2:2 --friction 0:1:2", pushed, "frequency_hz"},
          std::tuple{"map --frequency-hz 1:2:2 --friction -1:1:2", pushed, "friction"},
          std::tuple{"map --frequency-hz 1:2:2 --beta 0:1:2", pushed, "frequency_hz"},
          std::tuple{"map --frequency-hz 1:2:2", pushed, "friction"}, std::tuple{"map --friction 1:2:2", pushed, "frequency_hz"},
          std::tuple{"map --frequency-hz 1e200:1e200:1 --friction 1:1:1", shaken, "frequency_hz"},
          std::tuple{"map --frequency-hz 1:2:100000 --friction 0:1:10000", shaken, "the map"},
          std::tuple{"map --frequency-hz 1:2:2 --friction 1e308:1e308:1", faint, "friction"},
          std::tuple{"solve --samples 4 --units scene", solved, "units"}, std::tuple{"solve --units scene", solved, "units"},
          std::tuple{"motion --units scene", solved, "units"}}) {
        INFO(arguments << " of " << input);
        const Run run = run_program(arguments, input);
        CHECK(run.status == 2);
        CHECK(run.output.empty());
        CHECK(run.error.find(name) != std::string::npos);
        CHECK(lines_of(run.error).size() == 1);
    }
}

TEST_CASE("a bad grid, mass or output gives status 2, one line and no file", "[program][map]") {
    const auto file = (scratch() / "none" / "map.csv").string();
    for (const std::string arguments :
         {"--r 0:2:4 --beta 0:1:3", "--r -1:2:4 --beta 0:1:3", "--r 1:2 --beta 0:1:3", "--r 1:2:0 --beta 0:1:3",
          "--r 1:2:1.5 --beta 0:1:3", "--r 2:1:3 --beta 0:1:3", "--r 1:2:3 --beta -1:1:3", "--r 1:2:3",
          "--r 1:2:3 --beta 0:1:3 --mass 3", "--r 1:2:3 --beta 0:1:3 --mass 0", "--r 1:2:3 --beta 0:1:3 --mass 1 --mass 1",
          "--r 1:2:3 --beta 0:1:3 --output map.txt", "--r a:2:3 --beta 0:1:3", "--r 1:2:3 --beta 0:1:3 --start here"}) {
        INFO(arguments);
        const Run run = run_program("map " + arguments, scene);
        CHECK(run.status == 2);
        CHECK(run.output.empty());
        CHECK(lines_of(run.error).size() == 1);
    }
    const Run run = run_program("map --r 1:2:3 --beta 0:1:3 --output '" + file + "'", scene);
    CHECK(run.status == 2);
    CHECK(run.error.find("cannot be written") != std::string::npos);
    CHECK_FALSE(std::filesystem::exists(file));
}

TEST_CASE("an interruption leaves no file and says so", "[program][map][threads]") {
    const auto folder = scratch() / "interrupted";
    std::filesystem::create_directories(folder);
    const auto input = file_with("map_scene", scene);
    // Enough points for minutes of work.
    const char* program = std::getenv("DENHARTOG_PROGRAM");
    const std::string command = "'" + std::string(program) + "' map '" + input.string() +
                                "' --r 0.01:0.02:2000 --beta 0.1:1:2000 --output '" + (folder / "map.csv").string() + "' 2>'" +
                                (folder / "error").string() +
                                "' & sleep 0.3; while kill -INT $! 2>/dev/null; do sleep 0.1; done; wait $!";
    const int status = std::system(command.c_str());
    REQUIRE(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 130);
    CHECK(content_of(folder / "error").find("interrupted") != std::string::npos);
    for (const auto& entry : std::filesystem::directory_iterator(folder)) CHECK(entry.path().filename() == "error");
}

TEST_CASE("a map over the level of the load has the points that solve answers, with phases", "[program][map][units]") {
    const std::string rest = R"("masses": [2, 3], "stiffnesses": [800, 500], "damping_ratios": 0.02, "contact": 1, "load": 2,
                              "friction": 1.5)";
    const auto check = [&](const std::string& load, const std::string& options, const std::string& axis, double level) {
        const Run run = run_program("map - --frequency 12:18:2 --" + options + " --mass 2 --mass 1 --phases",
                                    "{" + rest + ", " + load + R"(, "frequency": 12})");
        INFO(load << run.error);
        REQUIRE(run.status == 0);
        const std::vector<std::string> lines = lines_of(run.output);
        CHECK(lines[0] ==
              "frequency," + axis + ",regime,stops_per_period,periods,amplitude_2,amplitude_1,phase_2,phase_1,status");
        REQUIRE(lines.size() == 5);
        for (std::size_t n = 1; n < lines.size(); ++n) {
            const std::vector<std::string> cells = cells_of(lines[n]);
            CHECK(std::stod(cells[1]) == (n % 2 == 1 ? level : 2 * level));
            const Run point = run_program("solve --json",
                                          "{" + rest + ", \"" + axis + "\": " + cells[1] + ", \"frequency\": " + cells[0] + "}");
            const auto answer = nlohmann::json::parse(point.output);
            for (const std::size_t k : {0, 1}) {
                const double amplitude = answer["dimensional"]["masses"][k]["amplitude"], phase = answer["masses"][k]["phase"];
                CHECK(std::stod(cells[6 - k]) == Approx(amplitude).epsilon(1e-9));
                CHECK(std::stod(cells[8 - k]) == Approx(phase).margin(1e-9));
            }
            CHECK(cells[2] == answer["regime"].get<std::string>());
        }
    };
    check(R"("force": 4)", "force 4:8:2", "force", 4);
    check(R"("unbalance": 0.02)", "unbalance 0.02:0.04:2", "unbalance", 0.02);
}

TEST_CASE("absolute phases of a map are those of solve", "[program][map][base]") {
    const std::string text = R"({"mass_ratios": [1, 2], "stiffness_ratios": [1, 0.75], "damping_ratios": 0.05, "contact": 2,
                               "base_motion": "with_wall", "r": 0.5, "beta": 0.25})";
    const Run run = run_program("map --r 0.5:0.5:1 --beta 0.25:0.25:1 --mass 1 --from-ground --phases", text);
    REQUIRE(run.status == 0);
    const std::vector<std::string> cells = cells_of(lines_of(run.output)[1]);
    const auto seen = nlohmann::json::parse(run_program("solve --json", text).output)["from_ground"]["masses"][0];
    CHECK(std::stod(cells[5]) == Approx(seen["amplitude"].get<double>()).epsilon(1e-9));
    CHECK(std::stod(cells[6]) == Approx(seen["phase"].get<double>()).epsilon(1e-9));
    const auto npy = scratch() / "phases.npy";
    REQUIRE(run_program("map --r 0.5:0.5:1 --beta 0.25:0.25:1 --phases --output '" + npy.string() + "'", text).status == 0);
    CHECK(content_of(npy).find("'phase_2', '<f8'") != std::string::npos);
}

TEST_CASE("levels of a load that a scene does not have are refused", "[program][map][bad-input]") {
    const std::string rest = R"({"masses": [1], "stiffnesses": [1], "damping_ratios": 0.1, "contact": 1, )";
    const std::string forced = rest + R"("load": 1, "force": 1, "friction": 0.5, "frequency": 2})",
                      turning = rest + R"("load": 1, "unbalance": 1, "friction": 0.5, "frequency": 2})";
    for (const auto& [options, text, says] :
         {std::tuple("--frequency 1:2:2 --force 1:2:2", turning, "vary unbalance"),
          {"--frequency 1:2:2 --unbalance 1:2:2", forced, "unbalance must be given in the scene"},
          {"--frequency 1:2:2 --force 0:2:2", forced, "force must be positive"},
          {"--frequency 1:2:2 --force 1:2:2 --friction 0:1:2", forced, "must not be given together with friction"},
          {"--frequency 1:2:2 --frequency-hz 1:2:2 --force 1:2:2", forced, "must not be given together"},
          {"--r 1:2:2 --force 1:2:2", forced, "must not be given together with r and beta"},
          {"--frequency 1:2:2", forced, "friction must be given as FROM:TO:COUNT"},
          {"--frequency 0:2:2 --force 1:2:2", forced, "frequency must be positive"},
          {"--frequency 1:2:2 --force 1:2:2 --phases --start sliding", forced, "start must be rest for phases"},
          {"--frequency 1:2:2 --force 1:2:2", rest + R"("base_motion": "alone", "base_displacement": 1, "friction": 0.5})",
           "must not be varied of a scene whose base or wall moves"},
          {"--frequency 1:2:2 --force 1:2:2", rest + R"("load": 1, "force": 1})", "friction must be given in the scene"},
          {"--r 1:2:2 --beta 0:1:2", rest + R"("load": 1, "unbalance": 1, "friction": 0.5})", "an unbalance depends on it"},
          {"--r 1:2:2 --beta 0:1:2", rest + R"("load": 1, "unbalance": 1, "force": 0.5})",
           "must not be given together with force"},
          {"--r 1:2:2 --beta 0:1:2", rest + R"("load": 1, "unbalance": 0})", "unbalance must be positive"}}) {
        const Run run = run_program(std::string("map - ") + options, text);
        INFO(options << text << run.error);
        CHECK(run.status == 2);
        CHECK(run.output.empty());
        CHECK(run.error.find(says) != std::string::npos);
    }
}

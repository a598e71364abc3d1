#include <cmath>
#include <cstring>

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

#include <algorithm>
#include <cmath>
#include <cstring>

#include "tests/catch.hpp"
#include "tests/unit/program_table.hpp"

using namespace denhartog::tests;

namespace {

const std::string grid = R"(two {"r": null, "beta": null})";

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
    return cells;
}

// The rows of a CSV, each cell a number but those of regime and status.
std::vector<std::vector<std::string>> rows_of(const std::string& arguments, const std::string& scene) {
    const Run run = run_program(arguments, scene_text(scene));
    REQUIRE(run.status == 0);
    std::vector<std::vector<std::string>> rows;
    for (const std::string& line : lines_of(run.output)) rows.push_back(cells_of(line));
    return rows;
}

// A scene in units at a frequency and a friction in newtons.
std::string at(const std::string& name, const std::string& frequency_hz, const std::string& friction) {
    return name + R"( {"frequency_hz": )" + frequency_hz + R"(, "friction": )" + friction + "}";
}

double number_at(const std::string& bytes, std::size_t place) {
    double x = 0;
    std::memcpy(&x, bytes.data() + place, sizeof x);
    return x;
}

} // namespace

TEST_CASE("a map is a table, a line a point", "[program][map][threads]") {
    const auto rows = rows_of("map --r 0.5:2:4 --beta 0:1:3", grid);
    expect("0 map --r 0.5:2:4 --beta 0:1:3 < " + grid +
           "\n | # 13 \n | r,beta,regime,stops_per_period,periods,amplitude_2,status");
    REQUIRE(rows.size() == 13);
    CHECK(std::vector(rows[1].begin(), rows[1].begin() + 3) == std::vector<std::string>{"0.5", "0", "continuous"});
    CHECK(rows[1][6] == "answered");
    CHECK(std::vector(rows[12].begin(), rows[12].begin() + 2) == std::vector<std::string>{"2", "1"});
    CHECK(rows[5][1] == "0.5");
    for (const std::string threads : {"3", "0"})
        CHECK(rows_of("map --r 0.5:2:4 --beta 0:1:3 --threads " + threads, grid) == rows);
    expect("0 map --help > and with 0, as many as the machine has");
}

TEST_CASE("the scene of a map may come after the masses", "[program][map]") {
    const std::string file = "'" + file_with("scene_after_masses", scene_text(grid)).string() + "'";
    CHECK(rows_of("map --r 0.5:2:4 --beta 0:1:3 --mass 1 " + file, "two") ==
          rows_of("map " + file + " --r 0.5:2:4 --beta 0:1:3 --mass 1", "two"));
}

TEST_CASE("a map as NPY has a header that NumPy reads and the numbers of the CSV", "[program][map]") {
    const auto file = scratch() / "map.npy";
    const Run csv = run_program("map --r 0.5:2:4 --beta 0:1:3 --mass 1 --mass 2", scene_text(grid));
    REQUIRE(
        run_program("map --r 0.5:2:4 --beta 0:1:3 --mass 1 --mass 2 --output '" + file.string() + "'", scene_text(grid)).status ==
        0);
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
    expect(R"(
        0 map --r 1:1:1 --beta 0.125:0.125:1 < undamped
          | r,beta,regime,stops_per_period,periods,amplitude_1,status
          | 1,0.125,,nan,nan,nan,at_a_pole
    )");
}

TEST_CASE("the boundaries over r are a table", "[program][map]") {
    const auto rows = rows_of("map --boundaries --r 0.5:2:4", grid);
    REQUIRE(rows.size() == 5);
    CHECK(rows[0] == std::vector<std::string>{"r", "exact", "paper", "approximate", "sticking", "status"});
    CHECK(std::stod(rows[1][2]) <= std::stod(rows[1][1]));
    CHECK(std::stod(rows[1][1]) <= std::stod(rows[1][3]));
}

TEST_CASE("a map over hertz and newtons has the displacements that solve has in metres", "[program][map]") {
    for (const std::string scene : {"pushed", "shaken"}) {
        const auto rows = rows_of("map --frequency-hz 2:4:3 --friction 0.5:1.5:3 --mass 1 --mass 2", scene);
        REQUIRE(rows.size() == 10);
        CHECK(rows[0] == std::vector<std::string>{"frequency_hz", "friction", "regime", "stops_per_period", "periods",
                                                  "amplitude_1", "amplitude_2", "status"});
        for (std::size_t n = 1; n < rows.size(); ++n) {
            const nlohmann::json answer = answer_of("solve --json", at(scene, rows[n][0], rows[n][1]));
            INFO(scene << " " << rows[n][0] << " " << rows[n][1]);
            CHECK(answer.at("regime") == rows[n][2]);
            for (std::size_t k = 0; k < 2; ++k)
                CHECK(std::stod(rows[n][5 + k]) ==
                      Approx(answer.at("dimensional").at("masses").at(k).at("amplitude").get<double>()).epsilon(1e-6));
        }
    }
}

TEST_CASE("boundaries over hertz are the forces that boundary tells", "[program][map]") {
    const auto rows = rows_of("map --boundaries --frequency-hz 2:4:3", "shaken");
    REQUIRE(rows.size() == 4);
    CHECK(rows[0][0] == "frequency_hz");
    for (std::size_t n = 1; n < rows.size(); ++n) {
        const nlohmann::json of =
            answer_of("boundary --json", R"(shaken {"frequency_hz": )" + rows[n][0] + "}").at("dimensional").at("friction_limit");
        CHECK(std::stod(rows[n][1]) == Approx(of.at("exact").get<double>()).epsilon(1e-6));
        CHECK(std::stod(rows[n][4]) == Approx(of.at("sticking").get<double>()).epsilon(1e-6));
    }
}

TEST_CASE("a motion in the units of the scene reaches the amplitudes of its answer", "[program]") {
    const double omega = 2 * 3.14159265358979 * 3, half_second = 0.5 / 3;
    for (const std::string friction : {"0.5", "1.5"}) {
        const auto rows = rows_of("solve --samples 400 --units scene", at("shaken", "3", friction)),
                   in_tau = rows_of("solve --samples 400", at("shaken", "3", friction));
        REQUIRE(rows.size() == 401);
        CHECK(rows[0][0] == "t");
        CHECK(in_tau[0][0] == "tau");
        CHECK(std::stod(rows[201][0]) == Approx(half_second).epsilon(1e-12));
        double largest = 0;
        for (std::size_t n = 1; n < rows.size(); ++n) {
            largest = std::max(largest, std::abs(std::stod(rows[n][2])));
            const double x = std::stod(in_tau[n][2]), v = std::stod(in_tau[n][4]);
            CHECK(std::stod(rows[n][4]) * x == Approx(std::stod(rows[n][2]) * v * omega).epsilon(1e-9).margin(1e-15));
        }
        const nlohmann::json units = answer_of("solve --json", at("shaken", "3", friction)).at("dimensional");
        CHECK(largest == Approx(units.at("masses").at(1).at("amplitude").get<double>()).epsilon(1e-4));
    }
}

TEST_CASE("a number that the units take beyond a double is no answer", "[program][map]") {
    expect(R"(
        0 map --frequency-hz 0.1:0.1:1 --friction 1e199:1e199:1 < huge units
          | frequency_hz,friction,regime,stops_per_period,periods,amplitude_1,status
          | 0.1,1e+199,,nan,nan,nan,failed
        3 solve --samples 2 --units scene < huge units ! beyond the range of a double
    )");
}

TEST_CASE("a map in units takes a friction of zero", "[program][map]") {
    const auto rows = rows_of("map --frequency-hz 2:2:1 --friction 0:1:2 --mass 1", R"(pushed {"friction": null})");
    CHECK(rows.at(1).at(1) == "0");
    CHECK(rows.at(1).at(2) == "continuous");
    CHECK(rows.at(1).back() == "answered");
}

TEST_CASE("units are refused where a scene has none", "[program][map][bad-input]") {
    expect(R"(
        2 map --frequency-hz 1:2:2 --friction 0:1:2           < two {"r": null, "beta": null} ! frequency_hz
        2 map --frequency-hz 1:2:2 --friction 0:1:2           < pushed {"force": null}  ! force
        2 map --frequency-hz 0:2:2 --friction 0:1:2           < pushed                  ! frequency_hz
        2 map --frequency-hz 1:2:2 --friction -1:1:2          < pushed                  ! friction
        2 map --frequency-hz 1:2:2 --beta 0:1:2               < pushed                  ! frequency_hz
        2 map --frequency-hz 1:2:2                            < pushed                  ! friction
        2 map --friction 1:2:2                                < pushed                  ! frequency_hz
        2 map --frequency-hz 1e200:1e200:1 --friction 1:1:1   < shaken                  ! frequency_hz
        2 map --frequency-hz 1:2:100000 --friction 0:1:10000  < shaken                  ! the map
        2 map --frequency-hz 1:2:2 --friction 1e308:1e308:1   < pushed {"force": 1e-10} ! friction
        2 {solve --samples 4|solve|motion} --units scene      < one                     ! units
    )");
}

TEST_CASE("a bad grid, mass or output gives status 2, one line and no file", "[program][map]") {
    const auto file = (scratch() / "none" / "map.csv").string();
    expect("2 map {--r 0:2:4 --beta 0:1:3|--r -1:2:4 --beta 0:1:3|--r 1:2 --beta 0:1:3|--r 1:2:0 --beta 0:1:3|"
           "--r 1:2:1.5 --beta 0:1:3|--r 2:1:3 --beta 0:1:3|--r 1:2:3 --beta -1:1:3|--r 1:2:3|--r a:2:3 --beta 0:1:3} < " +
           grid + "\n 2 map --r {1:2|.5:1:2:3} --beta 0:1:3 < " + grid + " ! r must be FROM:TO:COUNT" + //
           "\n 2 map --r {.5|+1}:2:3 --beta 0:1:3 < " + grid + " ! r must be written as a number, but is {}" +
           "\n 2 map --r {:2:3|1::3|1:2:} --beta 0:1:3 < " + grid + " ! r must be FROM:TO:COUNT, three numbers, but is {}" +
           "\n 2 map --r 1:2:3 --beta 0:1:3 {--mass 3|--mass 0|--mass 1 --mass 1|--output map.txt|--start here} < " + grid +
           "\n 2 map --r 1:2:3 --beta 0:1:3 --output '" + file + "' < " + grid + " ! cannot be written");
    CHECK_FALSE(std::filesystem::exists(file));
}

TEST_CASE("an interruption leaves no file and says so", "[program][map][threads]") {
    const auto folder = scratch() / "interrupted";
    std::filesystem::create_directories(folder);
    const auto input = file_with("map_scene", scene_text(grid));
    // Enough points for minutes of work.
    const std::string command = quoted_program() + " map '" + input.string() +
                                "' --r 0.01:0.02:2000 --beta 0.1:1:2000 --output '" + (folder / "map.csv").string() + "' 2>'" +
                                (folder / "error").string() +
                                "' & sleep 0.3; while kill -INT $! 2>/dev/null; do sleep 0.1; done; wait $!";
    CHECK(run_shell(command).status == 130);
    CHECK(content_of(folder / "error").find("interrupted") != std::string::npos);
    for (const auto& entry : std::filesystem::directory_iterator(folder)) CHECK(entry.path().filename() == "error");
}

TEST_CASE("a map over the level of the load has the points that solve answers, with phases", "[program][map][units]") {
    const auto check = [&](const std::string& scene, const std::string& axis, const std::string& range, double level) {
        const auto rows = rows_of("map --frequency 12:18:2 --" + axis + " " + range + " --mass 2 --mass 1 --phases", scene);
        CHECK(rows[0] ==
              cells_of("frequency," + axis + ",regime,stops_per_period,periods,amplitude_2,amplitude_1,phase_2,phase_1,status"));
        REQUIRE(rows.size() == 5);
        for (std::size_t n = 1; n < rows.size(); ++n) {
            const std::vector<std::string>& cells = rows[n];
            CHECK(std::stod(cells[1]) == (n % 2 == 1 ? level : 2 * level));
            const auto answer =
                answer_of("solve --json", "at levels {\"" + axis + "\": " + cells[1] + ", \"frequency\": " + cells[0] + "}");
            for (const std::size_t k : {0, 1}) {
                const double amplitude = answer["dimensional"]["masses"][k]["amplitude"], phase = answer["masses"][k]["phase"];
                CHECK(std::stod(cells[6 - k]) == Approx(amplitude).epsilon(1e-9));
                CHECK(std::stod(cells[8 - k]) == Approx(phase).margin(1e-9));
            }
            CHECK(cells[2] == answer["regime"].get<std::string>());
        }
    };
    check(R"(at levels {"force": 4})", "force", "4:8:2", 4);
    check(R"(at levels {"unbalance": 0.02})", "unbalance", "0.02:0.04:2", 0.02);
}

TEST_CASE("absolute phases of a map are those of solve", "[program][map][base]") {
    const std::string asked = "map --r 0.5:0.5:1 --beta 0.25:0.25:1 --phases ",
                      scene = R"(pair on a base {"r": 0.5, "beta": 0.25})";
    const std::vector<std::string> cells = rows_of(asked + "--mass 1 --from-ground", scene)[1];
    const auto seen = answer_of("solve --json", scene)["from_ground"]["masses"][0];
    CHECK(std::stod(cells[5]) == Approx(seen["amplitude"].get<double>()).epsilon(1e-9));
    CHECK(std::stod(cells[6]) == Approx(seen["phase"].get<double>()).epsilon(1e-9));
    const auto npy = scratch() / "phases.npy";
    expect("0 " + asked + "--output '" + npy.string() + "' < " + scene);
    CHECK(content_of(npy).find("'phase_2', '<f8'") != std::string::npos);
}

TEST_CASE("without friction the ratio of static to kinetic friction makes no difference to a map with phases", "[program][map]") {
    const std::string asked = "map --r 0.61:0.61:1 --beta 0:0:1 --phases";
    expect("0 " + asked + R"( < unequal undamped {"mu": 1.15} > continuous,0,1)");
    CHECK(rows_of(asked, R"(unequal undamped {"mu": 1.15})") == rows_of(asked, "unequal undamped"));
}

TEST_CASE("levels of a load that a scene does not have are refused", "[program][map][bad-input]") {
    expect(R"(
        2 map --frequency 1:2:2 --force 1:2:2                    < turning ! vary unbalance
        2 map --frequency 1:2:2 --unbalance 1:2:2                < forced  ! unbalance must be given in the scene
        2 map --frequency 1:2:2 --force 0:2:2                    < forced  ! force must be positive
        2 map --frequency 1:2:2 --boundaries --unbalance 1:2:2   < turning ! must not be given together with boundaries
        2 map --frequency 1:2:2 --boundaries --phases            < forced  ! must not be given together with boundaries
        2 map --frequency 1:2:2 --boundaries --friction 0:1:2    < forced  ! must not be given together with boundaries
        2 map --r 1:2:2 --boundaries {--beta 0:1:2|--beta foo|--mass 1|--start sliding}
          < two ! must not be given together with boundaries
        2 map --frequency 1:2:2 --force 1:2:2 --friction 0:1:2   < forced  ! must not be given together with friction
        2 map --frequency 1:2:2 --frequency-hz 1:2:2 --force 1:2:2 < forced ! must not be given together
        2 map --r 1:2:2 --force 1:2:2                            < forced  ! must not be given together with r and beta
        2 map --frequency 1:2:2                                  < forced  ! friction must be given as FROM:TO:COUNT
        2 map --frequency 0:2:2 --force 1:2:2                    < forced  ! frequency must be positive
        2 map --frequency 1:2:2 --force 1:2:2 --phases --start sliding < forced ! start must be rest for phases
        2 map --frequency 1:2:2 --force 1:2:2
          < forced {"load": null, "force": null, "frequency": null, "base_motion": "alone", "base_displacement": 1}
          ! must not be varied of a scene whose base or wall moves
        2 map --frequency 1:2:2 --force 1:2:2 < forced {"friction": null, "frequency": null} ! friction must be given in the scene
        2 map --r 1:2:2 --beta 0:1:2          < turning {"frequency": null}                  ! an unbalance depends on it
        2 map --r 1:2:2 --beta 0:1:2          < turning {"friction": null, "frequency": null, "force": 0.5}
          ! must not be given together with force
        2 map --r 1:2:2 --beta 0:1:2          < turning {"friction": null, "frequency": null, "unbalance": 0}
          ! unbalance must be positive
    )");
    // The frequency of the scene is not used, and need not be given.
    const std::string levels = "map --frequency 1:2:2 --unbalance 1:2:2";
    CHECK(rows_of(levels, R"(turning {"frequency": null})") == rows_of(levels, "turning"));
}

// Input that is far too large, or not meant for a terminal: one short line of printable text, whatever came in.
#include "denhartog/scene/limits.hpp"
#include "tests/catch.hpp"
#include "tests/unit/program_table.hpp"

using namespace denhartog;
using namespace denhartog::tests;
using namespace std::string_literals;

namespace {

std::string equal_chain(std::size_t N) {
    std::string ones = "1";
    for (std::size_t i = 1; i < N; ++i) ones += ",1";
    return R"({"mass_ratios": [)" + ones + R"(], "stiffness_ratios": [)" + ones +
           R"(], "damping_ratios": 0.125, "contact": 2, "load": 1, "r": 0.5, "beta": 0.0625})";
}

} // namespace

TEST_CASE("a zero byte in the text of a scene is refused by every command, with its place", "[program][input]") {
    const std::string scene = scene_text("unequal");
    const std::string place = "but is a zero byte (at line 1, column " + std::to_string(scene.size() + 1) + ")";
    for (const std::string command :
         {"solve --json", "response", "motion", "boundary", "functions", "integrate --cycles 1", "map --r 1:2:2 --beta 0:1:2"})
        for (const std::string& text : {scene + "\0garbage {"s, scene + "\0"s + scene})
            check_refused(run_program(command, text), 2, place);
}

TEST_CASE("a zero byte in a line of JSON Lines is that line's fault alone", "[program][input]") {
    const std::string scene = scene_text("unequal");
    const Run run = run_program("boundary --json", scene + "\n" + scene + "\0{}\n"s + scene + "\n");
    CHECK(run.status == 2);
    const std::vector<std::string> lines = lines_of(run.output);
    REQUIRE(lines.size() == 3);
    CHECK(lines[0] == lines[2]);
    const nlohmann::json error = nlohmann::json::parse(lines[1]).at("error");
    CHECK(error.at("value") == "a zero byte");
    CHECK(error.at("place") == "line 2, column " + std::to_string(scene.size() + 1));
}

TEST_CASE("keys, values and names of files are printed without what a terminal obeys, and shortened", "[program][input]") {
    const auto with_key = [](const std::string& key) { return "{\"" + key + "\": 1, " + scene_text("unequal").substr(1); };
    check_refused(run_program("solve", with_key("\\u001b[31mred")), 2, "\\x1B[31mred is no key of a scene");
    check_refused(run_program("solve", with_key(std::string(1'000'000, 'k'))), 2, "kkk...kkk");
    check_refused(run_program("solve", with_key("\xFF\xC2\x9B")), 2, "");
    expect(
        "2 solve '/no/such/\x1b[2J\xFF' ! /no/such/\\x1B[2J\\xFF cannot be read\n"
        "2 {'\x1b[2J'|solve --no-such-\x1b[2J|map --r '1:2:\x1b[2J' --beta 0:1:2|map --r 1:2:2 --beta 0:1:2 --output '\x1b[2J'|"
        "equations --ledger '/no/such/\x1b[2J'} < unequal ! \\x1B[2J");
    const Run json =
        run_program("solve --json", with_key("\\u001b" + std::string(100'000, 'k')) + "\n" + scene_text("unequal") + "\n");
    CHECK(json.status == 2);
    CHECK(lines_of(json.output).front().size() < 2500); // with all keys of a scene
}

TEST_CASE("more masses than can be computed are refused by name, rule and number", "[program][input][limits]") {
    const std::string rule = "mass_ratios must have at most " + std::to_string(most_masses) + " values, one a mass, but is ";
    check_refused(run_program("solve", equal_chain(most_masses + 1)), 2, rule + std::to_string(most_masses + 1));
    check_refused(run_program("boundary", equal_chain(1'000'000)), 2, rule + "1000000");
    std::string rows = "[]";
    for (int n = 1; n < 200'000; ++n) rows += ",[]";
    check_refused(run_program("boundary", R"({"mass_matrix": [)" + rows +
                                              R"(], "stiffness_ratios": [1], "damping_ratios": 0,)"
                                              R"( "contact": 1, "load": 1, "r": 1})"),
                  2, "mass_matrix must have at most 1000 rows, one a mass, but is 200000");
}

TEST_CASE("more samples or points than can be held are refused by name, rule and number", "[program][input][limits]") {
    expect("2 {motion|solve} --samples 10000001 < unequal ! samples must be from 1 to 10000000, but is 10000001\n"
           "2 {motion|solve|integrate} --samples 2000000 << " +
           equal_chain(100) +
           " ! samples must be from 1 to 1000000 for 100 masses, but is 2000000\n"
           "2 map --r 1:2:1000000 --beta 0:1:1000000 < unequal ! the map must have at most");
}

TEST_CASE("what the system or memory refuse is told in words of the program", "[program][input][limits]") {
    expect("2 solve /proc/self/mem ! /proc/self/mem cannot be read (");
    if (with_address_sanitizer) return; // which needs more memory than that before it starts
    const std::string large = file_with("large-map.json", scene_text("unequal")).string();
    const Run run =
        run_program("--version >/dev/null; ( ulimit -v 200000; exec '" + std::string(std::getenv("DENHARTOG_PROGRAM")) +
                    "' map --r 1:2:20000 --beta 0:1:10000 '" + large + "' )");
    check_refused(run, 3, "memory must hold the scene and what is asked of it");
    CHECK(run.error.find("bad_alloc") == std::string::npos);
}

TEST_CASE("numbers as far apart as their type allows are answered, or refused in words of the program",
          "[program][input][limits]") {
    expect(R"(
        3 functions < unequal {"stiffness_ratios": [1, 1e300], "damping_ratios": [1, 1], "load": 2, "r": 3}
          ! the reference does not prove it
        3 solve < long period ! are beyond the range of the number type
        3 solve --json < unequal + long period + unequal
          | # 3
          = {"1": {"error": {"rule": "has the functions (23), (28), (29) of mode 1 at R = 1e-323 are beyond the range"}}}
    )");
    CHECK(run_program("solve", scene_text("long period")).error.find("boost") == std::string::npos);
    const std::vector<std::string> lines =
        lines_of(run_program("solve --json", scene_text("unequal + long period + unequal")).output);
    const nlohmann::json error = nlohmann::json::parse(lines.at(1)).at("error");
    CHECK(error.at("message") == error.at("rule")); // a sentence: its quantity is no part of it
    CHECK(lines.at(0) == lines.at(2));
}

TEST_CASE("work that is spent is told with status 3, and work that is no number of operations with status 2",
          "[program][effort]") {
    expect(R"(
        0 solve < many stops
        0 solve --effort 1e8 < many stops
        3 solve --effort 2000 < many stops ! the work allowed is spent
        2 {solve|response|boundary|functions|motion} --effort {0|-1|1e19|nan} < unequal ! effort must be from 1 to 1e18 operations
        0 map --r 0.3:0.3:1 --beta 0.4:0.4:1 --effort 2000 < many stops > not_converged
    )");
}

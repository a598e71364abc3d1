// Input that is far too large, or not meant for a terminal: one short line of printable text, whatever came in.
#include "denhartog/scene/limits.hpp"
#include "tests/catch.hpp"
#include "tests/unit/program_runs.hpp"

using namespace denhartog;
using namespace denhartog::tests;
using namespace std::string_literals;

namespace {

const std::string plain_scene = R"({"mass_ratios": [1, 2], "stiffness_ratios": [1, 3], "damping_ratios": [0.25, 0.125], )"
                                R"("contact": 2, "load": 1, "mu": 1.5, "r": 0.5, "beta": 0.0625})";

std::string chain_of(std::size_t N) {
    std::string ones = "1";
    for (std::size_t i = 1; i < N; ++i) ones += ",1";
    return R"({"mass_ratios": [)" + ones + R"(], "stiffness_ratios": [)" + ones +
           R"(], "damping_ratios": 0.125, "contact": 2, "load": 1, "r": 0.5, "beta": 0.0625})";
}

/// One short line of printable text on standard error, and nothing else.
void refused(const Run& run, int status, const std::string& piece) {
    INFO("status " << run.status << ": " << run.error.substr(0, 2000));
    CHECK(run.status == status);
    CHECK(run.output.empty());
    CHECK(lines_of(run.error).size() == 1);
    CHECK(run.error.size() < 2000);
    CHECK(run.error.find(piece) != std::string::npos);
    for (const char c : run.error) CHECK((c == '\n' || (c >= ' ' && c != '\x7F')));
}

} // namespace

TEST_CASE("a zero byte in the text of a scene is refused by every command, with its place", "[program][input]") {
    const std::string place = "but is a zero byte (at line 1, column " + std::to_string(plain_scene.size() + 1) + ")";
    for (const std::string command :
         {"solve --json", "response", "motion", "boundary", "functions", "integrate --cycles 1", "map --r 1:2:2 --beta 0:1:2"})
        for (const std::string& text : {plain_scene + "\0garbage {"s, plain_scene + "\0"s + plain_scene})
            refused(run_program(command, text), 2, place);
}

TEST_CASE("a zero byte in a line of JSON Lines is that line's fault alone", "[program][input]") {
    const Run run = run_program("boundary --json", plain_scene + "\n" + plain_scene + "\0{}\n"s + plain_scene + "\n");
    CHECK(run.status == 2);
    const std::vector<std::string> lines = lines_of(run.output);
    REQUIRE(lines.size() == 3);
    CHECK(lines[0] == lines[2]);
    const nlohmann::json error = nlohmann::json::parse(lines[1]).at("error");
    CHECK(error.at("value") == "a zero byte");
    CHECK(error.at("place") == "line 2, column " + std::to_string(plain_scene.size() + 1));
}

TEST_CASE("keys, values and names of files are printed without what a terminal obeys, and shortened", "[program][input]") {
    const auto with_key = [](const std::string& key) { return "{\"" + key + "\": 1, " + plain_scene.substr(1); };
    refused(run_program("solve", with_key("\\u001b[31mred")), 2, "\\x1B[31mred is no key of a scene");
    refused(run_program("solve", with_key(std::string(1'000'000, 'k'))), 2, "kkk...kkk");
    refused(run_program("solve", with_key("\xFF\xC2\x9B")), 2, "");
    refused(run_program("solve '/no/such/\x1b[2J\xFF'"), 2, "/no/such/\\x1B[2J\\xFF cannot be read");
    refused(run_program("'\x1b[2J'"), 2, "\\x1B[2J");
    refused(run_program("solve --no-such-\x1b[2J", plain_scene), 2, "\\x1B[2J");
    refused(run_program("map --r '1:2:\x1b[2J' --beta 0:1:2", plain_scene), 2, "\\x1B[2J");
    refused(run_program("map --r 1:2:2 --beta 0:1:2 --output '\x1b[2J'", plain_scene), 2, "\\x1B[2J");
    refused(run_program("equations --ledger '/no/such/\x1b[2J'"), 2, "\\x1B[2J");
    const Run json = run_program("solve --json", with_key("\\u001b" + std::string(100'000, 'k')) + "\n" + plain_scene + "\n");
    CHECK(json.status == 2);
    CHECK(lines_of(json.output).front().size() < 2500); // with all keys of a scene
}

TEST_CASE("more masses than can be computed are refused by name, rule and number", "[program][input][limits]") {
    const std::string rule = "mass_ratios must have at most " + std::to_string(most_masses) + " values, one a mass, but is ";
    refused(run_program("solve", chain_of(most_masses + 1)), 2, rule + std::to_string(most_masses + 1));
    refused(run_program("boundary", chain_of(1'000'000)), 2, rule + "1000000");
    std::string rows = "[]";
    for (int n = 1; n < 200'000; ++n) rows += ",[]";
    refused(run_program("boundary", R"({"mass_matrix": [)" + rows +
                                        R"(], "stiffness_ratios": [1], "damping_ratios": 0,)"
                                        R"( "contact": 1, "load": 1, "r": 1})"),
            2, "mass_matrix must have at most 1000 rows, one a mass, but is 200000");
}

TEST_CASE("more samples or points than can be held are refused by name, rule and number", "[program][input][limits]") {
    refused(run_program("motion --samples 10000001", plain_scene), 2, "samples must be from 1 to 10000000, but is 10000001");
    refused(run_program("solve --samples 10000001", plain_scene), 2, "samples must be from 1 to 10000000, but is 10000001");
    refused(run_program("motion --samples 2000000", chain_of(100)), 2,
            "samples must be from 1 to 1000000 for 100 masses, but is 2000000");
    refused(run_program("solve --samples 2000000", chain_of(100)), 2, "samples must be from 1 to 1000000 for 100 masses");
    refused(run_program("integrate --samples 2000000", chain_of(100)), 2, "samples must be from 1 to 1000000 for 100 masses");
    refused(run_program("map --r 1:2:1000000 --beta 0:1:1000000", plain_scene), 2, "the map must have at most");
}

TEST_CASE("what the system or memory refuse is told in words of the program", "[program][input][limits]") {
    const char* program = std::getenv("DENHARTOG_PROGRAM");
    REQUIRE(program != nullptr);
    refused(run_program("solve /proc/self/mem"), 2, "/proc/self/mem cannot be read (");
    if (with_address_sanitizer) return; // which needs more memory than that before it starts
    const std::string large = file_with("large-map.json", plain_scene).string();
    const Run run = run_program("--version >/dev/null; ( ulimit -v 200000; exec '" + std::string(program) +
                                "' map --r 1:2:20000 --beta 0:1:10000 '" + large + "' )");
    refused(run, 3, "memory must hold the scene and what is asked of it");
    CHECK(run.error.find("bad_alloc") == std::string::npos);
}

TEST_CASE("numbers as far apart as their type allows are answered, or refused in words of the program",
          "[program][input][limits]") {
    const std::string stiff =
        R"({"mass_ratios": [1, 2], "stiffness_ratios": [1, 1e300], "damping_ratios": [1, 1], "contact": 2, )"
        R"("load": 2, "r": 3, "beta": 0})";
    refused(run_program("functions", stiff), 3, "the reference does not prove it");
    const std::string slow =
        R"({"mass_ratios": [1, 1], "stiffness_ratios": [1, 1], "damping_ratios": [0.05, 0.05], "contact": 1, )"
        R"("load": 1, "r": 5e-324, "beta": 0.5})";
    refused(run_program("solve", slow), 3, "are beyond the range of the number type");
    CHECK(run_program("solve", slow).error.find("boost") == std::string::npos);
    const Run among = run_program("solve --json", plain_scene + "\n" + slow + "\n" + plain_scene + "\n");
    CHECK(among.status == 3);
    const std::vector<std::string> lines = lines_of(among.output);
    REQUIRE(lines.size() == 3);
    CHECK(lines[0] == lines[2]);
    CHECK(nlohmann::json::parse(lines[1]).at("error").at("rule").get<std::string>().starts_with("the functions (23), (28), (29) of mode 1 at R = 1e-323 are beyond the range"));
}

TEST_CASE("work that is spent is told with status 3, and work that is no number of operations with status 2",
          "[program][effort]") {
    const std::string stops =
        R"({"mass_ratios":[1,1],"stiffness_ratios":[1,1],"damping_ratios":[0.001,0.001],"contact":2,"load":1,)"
        R"("mu":2.5,"r":0.3,"beta":0.4})";
    CHECK(run_program("solve", stops).status == 0);
    CHECK(run_program("solve --effort 1e8", stops).status == 0);
    refused(run_program("solve --effort 2000", stops), 3, "the work allowed is spent");
    for (const std::string command : {"solve", "response", "boundary", "functions", "motion"})
        for (const std::string wrong : {"0", "-1", "1e19", "nan"})
            refused(run_program(command + " --effort " + wrong, plain_scene), 2, "effort must be from 1 to 1e18 operations");
    const Run map = run_program("map --r 0.3:0.3:1 --beta 0.4:0.4:1 --effort 2000", stops);
    CHECK(map.status == 0);
    CHECK(map.output.find("not_converged") != std::string::npos);
}

#include <sys/stat.h>

#include "denhartog/scene/limits.hpp"
#include "tests/catch.hpp"
#include "tests/unit/program_table.hpp"

using namespace denhartog::tests;
using namespace denhartog;
using namespace std::string_literals;

TEST_CASE("a table finds every kind of claim that is wrong", "[program]") {
    const std::string right = R"(
        0 solve --json < two > "regime"
          = {"regime": "stick_slip", "r": 0.5, "rest_interval": null, "method": "keys model precision proved why",
             "masses": "# 2"}
          = {"contact": {"amplitude": "> 0"}, "stops": {"*": {"start": ">= 0"}, "0": {"end": "< 7"}}, "beta": "~ 0.5 1e-9"}
          = {"regime": "longer 9", "r": "number", "method": {"model": "has exact"}}
        0 solve --samples 4 < two
          | # 5
          | tau,x_1,x_2,v_1,v_2
        2 solve --ask {colour|weight} < two ! {}
        2 solve --json < two + two {"r": -1}
          = {"0": {"regime": "text"}, "1": {"error": {"quantity": "r"}}}
    )";
    CHECK(faults_of(right).empty());
    using Pair = std::pair<std::string, std::string>;
    for (const auto& [from, to] : {Pair{"0 solve --json", "3 solve --json"},
                                   {"> \"regime\"", "> \"regimes\""},
                                   {"\"stick_slip\"", "\"continuous\""},
                                   {"\"r\": 0.5", "\"r\": 0.75"},
                                   {"\"rest_interval\"", "\"stops\""},
                                   {"keys model precision", "keys precision model"},
                                   {"\"# 2\"", "\"# 3\""},
                                   {"\"> 0\"", "\"> 9\""},
                                   {"\">= 0\"", "\">= 9\""},
                                   {"\"< 7\"", "\"< 0\""},
                                   {"~ 0.5", "~ 0.6"},
                                   {"longer 9", "longer 99"},
                                   {"\"number\"", "\"text\""},
                                   {"has exact", "has closed"},
                                   {"| # 5", "| # 6"},
                                   {"| tau", "| t"},
                                   {"2 solve --ask", "0 solve --ask"},
                                   {"! {}", "! sound"},
                                   {"\"quantity\": \"r\"", "\"quantity\": \"mu\""},
                                   {"\"*\"", "\"9\""},
                                   {"solve --ask {colour|weight}", "solve --ask {colour|regime}"}}) {
        std::string wrong = right;
        REQUIRE(wrong.find(from) != std::string::npos);
        wrong.replace(wrong.find(from), from.size(), to);
        INFO(to);
        CHECK_FALSE(faults_of(wrong).empty());
    }
    CHECK_FALSE(faults_of("0 solve --samples 4 < restless").empty()); // the run prints an error that the row does not state
}

TEST_CASE("a bad scene gives one line that names quantity and rule, status 2 and no output", "[program][input]") {
    // Every rule, and what is said of it, stands in scene_json.cpp; here is one of each kind.
    expect(R"(
        2 < unequal {"mass_ratios": []}                       ! mass_ratios
        2 < unequal {"stiffness_ratios": [1, -3]}             ! stiffness_ratios ! -3
        2 < unequal {"stiffness_ratios": [1]}                 ! stiffness_ratios ! 2
        2 < unequal {"r": -0.5}                               ! r must           ! -0.5
        2 < unequal {"r": "half"}                             ! r must           ! half
        2 < unequal {"r": null}                               ! r must be given
        2 < unequal {"mu": null, "mue": 1.5}                  ! mue
        2 < unequal {"contact": 1.5}                          ! contact          ! 1.5
        2 < unequal {"beta": "nan"}                           ! beta             ! nan
        2 < matrices {"mass_matrix": [[1, 2], [2, 1]]}        ! mass_matrix      ! positive definite
        2 << {"mu": 1.5, "mu": 1.5}                           ! mu               ! once
        2 << {"mass_ratios": [1], "r": 1e999}                 ! r must           ! 1e999
        2 << {"mass_ratios": [1, 2], "stiffness_ra            ! scene            ! JSON
        2 << [1, 2]                                           ! scene
        2                                                     ! scene
    )",
           "{response --json|response|motion|boundary --json|functions --json}");
    expect("0 response < unequal");
}

TEST_CASE("a file that cannot be read is named", "[program][input]") {
    expect("2 response " + (scratch() / "missing.json").string() + " ! missing.json cannot be read\n" + //
           "2 response " + scratch().string() + " ! cannot be read\n" +                                 //
           "0 response < unequal");
    const std::string output =
        run_program("response --json '" + file_with("good.json", scene_text("unequal")).string() + "'").output;
    CHECK(output.size() > 100);
    for (const char* standard_input : {"response --json -", "response --json"})
        CHECK(run_program(standard_input, scene_text("unequal")).output == output);
}

TEST_CASE("an output that cannot be written is an error", "[program][input]") {
    expect("2 {response|response --json|boundary|functions|motion|motion --output /dev/full|--help} >/dev/full < unequal ! "
           "cannot be written\n"
           "2 motion --output " +
           (scratch() / "no" / "such" / "file").string() + " < unequal ! cannot be written");
}

TEST_CASE("a file is written whole or not at all", "[program][input]") {
    const auto file = scratch() / "motion.csv";
    expect("0 motion --output '" + file.string() + "' < unequal");
    const std::string before = content_of(file);
    CHECK(lines_of(before).size() == 401);
    expect("2 motion --output '" + file.string() + "' < unequal {\"beta\": 100}");
    CHECK(content_of(file) == before);
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(scratch()))
        files += entry.path().string().find("motion.csv") != std::string::npos;
    CHECK(files == 1);
}

TEST_CASE("wrong usage has status 2 and one line", "[program][input]") {
    expect("2 {|respond|response --no-such-option|response --digits many|response --digits 0|response --digits 100001|"
           "motion --samples many|response one two} < unequal");
    expect("2 motion --digits {0|16} < unequal ! digits must be from 1 to 15, but is {}");
}

TEST_CASE("help and version are everywhere", "[program]") {
    expect(R"(
        0 {response|motion|boundary|functions|equations|derive} --help > Usage: denhartog {}
        0 --help    > Usage: denhartog
        0 --version > denhartog  > built by
    )");
}

TEST_CASE("at a pole of a mode without damping the fault is the scene's r", "[program][domain]") {
    expect(
        "2 {response --json|boundary|functions|motion} < undamped {\"r\": 1, \"beta\": 0.125} ! mode 1 has no damping and R = 1");
}

// Input that is far too large, or not meant for a terminal: one short line of printable text, whatever came in.

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
    const Run run = run_program("--version >/dev/null; ( ulimit -v 200000; exec " + quoted_program() +
                                " map --r 1:2:20000 --beta 0:1:10000 '" + large + "' )");
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
        0 map --r 0.3:0.3:1 --beta 0.4:0.4:1 --effort 300 < many stops > not_converged
    )");
}

// Files that the program writes: whole, in their own place, and through nobody else's links.

namespace fs = std::filesystem;

namespace {

/// An empty folder with nothing in it but what a test puts there.
fs::path empty_folder(const std::string& name) {
    const fs::path folder = scratch() / name;
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
}

int motion_to(const fs::path& file, const std::string& before = "") {
    const std::string scene = file_with("scene-of-files", scene_text("unequal")).string();
    return run_shell(before + " " + quoted_program() + " motion --samples 8 --output '" + file.string() + "' '" + scene + "'")
        .status;
}

std::size_t count_in(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

unsigned permissions_of(const fs::path& file) {
    struct stat found {};
    return ::stat(file.c_str(), &found) == 0 ? found.st_mode & 07777U : 0;
}

} // namespace

TEST_CASE("a symbolic link stays and the file that it leads to is replaced", "[program][output]") {
    const fs::path folder = empty_folder("links"), other = empty_folder("other");
    std::ofstream(other / "motion.csv") << "old";
    fs::create_symlink(other / "motion.csv", other / "absolute");
    fs::create_symlink("../other/absolute", folder / "relative.csv");
    CHECK(motion_to(folder / "relative.csv") == 0);
    CHECK(fs::is_symlink(folder / "relative.csv"));
    CHECK(fs::is_symlink(other / "absolute"));
    CHECK(fs::is_regular_file(fs::symlink_status(other / "motion.csv")));
    CHECK(lines_of(content_of(other / "motion.csv")).size() == 9);
    CHECK(count_in(folder) == 1);
    CHECK(count_in(other) == 2);
    fs::create_symlink("not-yet.csv", folder / "dangling.csv");
    CHECK(motion_to(folder / "dangling.csv") == 0);
    CHECK(fs::is_symlink(folder / "dangling.csv"));
    CHECK(lines_of(content_of(folder / "not-yet.csv")).size() == 9);
    fs::create_symlink("round.csv", folder / "round.csv");
    CHECK(motion_to(folder / "round.csv") == 2);
    CHECK(fs::is_symlink(folder / "round.csv"));
    CHECK(motion_to(folder) == 2);
}

TEST_CASE("nothing is written through a link that somebody has laid for the temporary file", "[program][output]") {
    const fs::path folder = empty_folder("trap");
    std::ofstream(folder / "victim") << "untouched";
    // The names that the shell's process and its next ones would have given.
    const std::string trap =
        "cd '" + folder.string() + "' && for n in $(seq $$ $(($$ + 200))); do ln -s victim out.csv.part$n; done;";
    CHECK(motion_to(folder / "out.csv", trap + " exec") == 0);
    CHECK(content_of(folder / "victim") == "untouched");
    CHECK(fs::is_regular_file(fs::symlink_status(folder / "out.csv")));
}

TEST_CASE("permissions are those of the file that was there, else those of a new file", "[program][output]") {
    const fs::path folder = empty_folder("permissions");
    CHECK(motion_to(folder / "new.csv", "umask 027;") == 0);
    CHECK(permissions_of(folder / "new.csv") == 0640);
    std::ofstream(folder / "old.csv") << "old";
    fs::permissions(folder / "old.csv", fs::perms(0604));
    CHECK(motion_to(folder / "old.csv", "umask 077;") == 0);
    CHECK(permissions_of(folder / "old.csv") == 0604);
    CHECK(lines_of(content_of(folder / "old.csv")).size() == 9);
    CHECK(count_in(folder) == 2);
}

TEST_CASE("a pipe is written directly, and a file beside which nothing can be made is refused", "[program][output]") {
    const fs::path folder = empty_folder("pipes");
    const fs::path pipe = folder / "pipe";
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    CHECK(motion_to(pipe, "cat '" + pipe.string() + "' > '" + (folder / "read").string() + "' &") == 0);
    CHECK(fs::is_fifo(pipe));
    for (int n = 0; n < 100 && lines_of(content_of(folder / "read")).size() < 9; ++n) ::usleep(20'000);
    CHECK(lines_of(content_of(folder / "read")).size() == 9);
    CHECK(motion_to("/dev/null") == 0);
    CHECK(motion_to("/proc/motion.csv") == 2);
    CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("a hang-up of a map leaves no file and is the status", "[program][map][output]") {
    const fs::path folder = empty_folder("hang-up");
    const std::string command = quoted_program() + " map '" + file_with("map-scene-of-files", scene_text("unequal")).string() +
                                "' --r 0.01:0.02:2000 --beta 0.1:1:2000 --output '" + (folder / "map.csv").string() +
                                "' 2>/dev/null & sleep 0.5; kill -HUP $!; wait $!";
    CHECK(run_shell(command).status == 129);
    CHECK(count_in(folder) == 0);
}

#include "tests/catch.hpp"
#include "tests/unit/program_runs.hpp"

using namespace denhartog::tests;

namespace {

/// One bad scene, the quantity that its message must name, and a piece of the rule or value.
struct Bad {
    std::string what, text, quantity, piece;
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::logic_error("the scene has no " + from);
    return text.replace(at, from.size(), to);
}

const std::string good = R"({"mass_ratios": [1, 2], "stiffness_ratios": [1, 3], "damping_ratios": [0.25, 0.125], )"
                         R"("contact": 2, "load": 1, "mu": 1.5, "r": 0.5, "beta": 0.0625})";

std::vector<Bad> bad_scenes() {
    const auto with = [](const std::string& from, const std::string& to) { return replaced(good, from, to); };
    return {
        {"no mass", with("\"mass_ratios\": [1, 2]", "\"mass_ratios\": []"), "mass_ratios", ""},
        {"a negative mass", with("[1, 2]", "[1, -2]"), "mass_ratios", "-2"},
        {"a zero mass", with("[1, 2]", "[1, 0]"), "mass_ratios", "positive"},
        {"a negative stiffness", with("[1, 3]", "[1, -3]"), "stiffness_ratios", "-3"},
        {"a zero stiffness", with("[1, 3]", "[1, 0]"), "stiffness_ratios", "positive"},
        {"r of zero", with("\"r\": 0.5", "\"r\": 0"), "r ", "positive"},
        {"r below zero", with("\"r\": 0.5", "\"r\": -0.5"), "r ", "-0.5"},
        {"negative damping", with("0.125]", "-0.125]"), "damping_ratios", "-0.125"},
        {"damping beyond the range", with("0.125]", "1e301]"), "damping_ratios", "at most 1e300"},
        {"infinite damping", with("0.125]", "\"inf\"]"), "damping_ratios", "inf"},
        {"mu below 1", with("\"mu\": 1.5", "\"mu\": 0.5"), "mu", "0.5"},
        {"negative beta", with("\"beta\": 0.0625", "\"beta\": -0.0625"), "beta", "-0.0625"},
        {"contact 0", with("\"contact\": 2", "\"contact\": 0"), "contact", "0"},
        {"contact beyond N", with("\"contact\": 2", "\"contact\": 3"), "contact", "3"},
        {"load beyond N", with("\"load\": 1", "\"load\": 3"), "load", "3"},
        {"contact not whole", with("\"contact\": 2", "\"contact\": 1.5"), "contact", "1.5"},
        {"too few springs", with("[1, 3]", "[1]"), "stiffness_ratios", "2"},
        {"too many damping ratios", with("[0.25, 0.125]", "[0.25, 0.125, 0.5]"), "damping_ratios", "2"},
        {"an unknown key", with("\"mu\"", "\"mue\""), "mue", ""},
        {"a duplicate key", with("\"mu\": 1.5", "\"mu\": 1.5, \"mu\": 1.5"), "mu", "once"},
        {"NaN", with("\"beta\": 0.0625", "\"beta\": NaN"), "scene", "JSON"},
        {"NaN as text", with("\"beta\": 0.0625", "\"beta\": \"nan\""), "beta", "nan"},
        {"infinity", with("\"r\": 0.5", "\"r\": 1e999"), "r ", "1e999"},
        {"infinity as text", with("\"r\": 0.5", "\"r\": \"inf\""), "r ", "inf"},
        {"text that is no number", with("\"r\": 0.5", "\"r\": \"half\""), "r ", "half"},
        {"a list for a number", with("\"r\": 0.5", "\"r\": [0.5]"), "r ", ""},
        {"truncated JSON", good.substr(0, 40), "scene", "JSON"},
        {"nothing", "", "scene", ""},
        {"no object", "[1, 2]", "scene", ""},
        {"no frequency ratio", with("\"r\": 0.5, ", ""), "r ", "given"},
        {"M not positive definite",
         R"({"mass_matrix": [[1, 2], [2, 1]], "stiffness_matrix": [[2, -1], [-1, 1]], "damping_ratios": 0.25, )"
         R"("contact": 1, "load": 1, "r": 0.5, "beta": 0})",
         "mass_matrix", "positive definite"},
        {"K singular",
         R"({"mass_matrix": [[1, 0], [0, 1]], "stiffness_matrix": [[1, -1], [-1, 1]], "damping_ratios": 0.25, )"
         R"("contact": 1, "load": 1, "r": 0.5, "beta": 0})",
         "stiffness_matrix", ""},
    };
}

} // namespace

TEST_CASE("a bad scene gives one line that names quantity and rule, status 2 and no output", "[program][input]") {
    for (const Bad& bad : bad_scenes())
        for (const std::string command : {"response --json", "response", "motion", "boundary --json", "functions --json"}) {
            if (bad.what == "negative beta" && command.starts_with("boundary")) continue; // refused there as well, checked below
            const Run run = run_program(command, bad.text);
            INFO(bad.what << ", " << command << ": status " << run.status << ", " << run.error);
            CHECK(run.status == 2);
            CHECK(run.output.empty());
            CHECK(lines_of(run.error).size() == 1);
            CHECK(run.error.find(bad.quantity) != std::string::npos);
            CHECK(run.error.find(bad.piece) != std::string::npos);
        }
    CHECK(run_program("boundary", replaced(good, "0.0625", "-0.0625")).status == 2);
    CHECK(run_program("response", good).status == 0);
}

TEST_CASE("a file that cannot be read is named", "[program][input]") {
    const Run missing = run_program("response " + (scratch() / "missing.json").string());
    CHECK(missing.status == 2);
    CHECK(missing.output.empty());
    CHECK(missing.error.find("missing.json cannot be read") != std::string::npos);
    const Run directory = run_program("response " + scratch().string());
    CHECK(directory.status == 2);
    CHECK(directory.error.find("cannot be read") != std::string::npos);
    const Run file = run_program("response --json '" + file_with("good.json", good).string() + "'");
    CHECK(file.status == 0);
    CHECK(file.output == run_program("response --json -", good).output);
    CHECK(file.output == run_program("response --json", good).output);
}

TEST_CASE("an output that cannot be written is an error", "[program][input]") {
    for (const std::string command :
         {"response", "response --json", "boundary", "functions", "motion", "motion --output /dev/full", "--help"}) {
        const Run run = run_program(command + " >/dev/full", good);
        INFO(command << ": " << run.error);
        CHECK(run.status == 2);
        CHECK(run.error.find("cannot be written") != std::string::npos);
    }
    const Run run = run_program("motion --output " + (scratch() / "no" / "such" / "file").string(), good);
    CHECK(run.status == 2);
    CHECK(run.error.find("cannot be written") != std::string::npos);
}

TEST_CASE("a file is written whole or not at all", "[program][input]") {
    const auto file = scratch() / "motion.csv";
    CHECK(run_program("motion --output '" + file.string() + "'", good).status == 0);
    const std::string before = content_of(file);
    CHECK(lines_of(before).size() == 401);
    CHECK(run_program("motion --output '" + file.string() + "'", replaced(good, "0.0625", "100")).status == 2);
    CHECK(content_of(file) == before);
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(scratch()))
        files += entry.path().string().find("motion.csv") != std::string::npos;
    CHECK(files == 1);
}

TEST_CASE("wrong usage has status 2 and one line", "[program][input]") {
    for (const std::string arguments :
         {"", "respond", "response --no-such-option", "response --digits many", "response --digits 0", "response --digits 100001",
          "motion --samples many", "response one two"}) {
        const Run run = run_program(arguments, good);
        INFO(arguments << ": " << run.error);
        CHECK(run.status == 2);
        CHECK(run.output.empty());
        CHECK(lines_of(run.error).size() == 1);
        CHECK(run.error.find("denhartog: ") == 0);
    }
}

TEST_CASE("help and version are everywhere", "[program]") {
    for (const std::string command : {"", "response ", "motion ", "boundary ", "functions ", "equations ", "derive "}) {
        const Run run = run_program(command + "--help");
        INFO(command);
        CHECK(run.status == 0);
        CHECK(run.output.find("Usage: denhartog " + command) != std::string::npos);
    }
    const Run version = run_program("--version");
    CHECK(version.status == 0);
    CHECK(version.output.find("denhartog ") == 0);
    CHECK(version.output.find("built by ") != std::string::npos);
}

TEST_CASE("at a pole of a mode without damping the fault is the scene's r", "[program][domain]") {
    const std::string pole =
        R"({"mass_ratios": [1], "stiffness_ratios": [1], "damping_ratios": 0, "contact": 1, "load": 1, "r": 1, "beta": 0.125})";
    for (const std::string command : {"response --json", "boundary", "functions", "motion"}) {
        const Run run = run_program(command, pole);
        CHECK(run.status == 2);
        CHECK(run.output.empty());
        CHECK(run.error.find("mode 1 has no damping and R = 1") != std::string::npos);
    }
}

// The subcommand as a user runs it: bytes that do not depend on who computed them, and what is left after accidents.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#include "tests/catch.hpp"
#include "tests/unit/program_runs.hpp"

using namespace denhartog::tests;
using Catch::Matchers::Contains;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

json study_json() {
    return json::parse(
        R"({"scene": {"mass_ratios": [1, 2], "stiffness_ratios": [1, 0.5], "damping_ratios": [0.03, 0.06],
                   "contact": 2, "load": 1},
        "axes": [{"quantity": "r", "from": 0.3, "to": 1.7, "count": 9}, {"quantity": "beta", "from": 0, "to": 1.5, "count": 6}],
        "answers": ["regime", "amplitudes", "stops"], "masses": [1, 2], "points_of_a_chunk": 12})");
}

// With samples, and with reductions that chunks have a part in and others that they have not.
json reduced_json() {
    json study = study_json();
    study["samples"] = {{"method", "sobol"}, {"count", 8}, {"seed", 5}};
    study["samples"]["variables"] = {
        {{"quantity", "zeta"}, {"as", "factor"}, {"lognormal", {{"median", 1}, {"log_standard_deviation", 0.3}}}},
        {{"quantity", "beta"}, {"as", "factor"}, {"uniform", {{"from", 0.8}, {"to", 1.2}}}}};
    study["reduce"] = {{{"name", "regimes"}, {"statistic", "share"}, {"over", {"sample"}}},
                       {{"name", "peak"}, {"statistic", "maximum"}, {"of", "amplitude_1"}, {"over", {"r"}}},
                       {{"name", "counts"},
                        {"statistic", "histogram"},
                        {"of", "amplitude_2"},
                        {"over", {"sample", "r"}},
                        {"bins", {{"from", 0.01}, {"to", 10}, {"count", 5}, {"scale", "logarithmic"}}}},
                       {{"name", "band"},
                        {"statistic", "quantiles"},
                        {"of", "amplitude_1"},
                        {"over", {"beta"}},
                        {"probabilities", {0.25, 0.75}}}};
    return study;
}

std::string planned(const std::string& name, const json& study) {
    const fs::path folder = scratch() / name;
    fs::remove_all(folder);
    const Run run = run_program("sweep plan --without-estimate - " + folder.string(), study.dump());
    INFO(run.error);
    REQUIRE(run.status == 0);
    return folder.string();
}

// Every file below a folder with its content.
std::map<std::string, std::string> tree(const std::string& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) files[fs::relative(entry.path(), folder).string()] = content_of(entry.path());
    return files;
}

std::string run_and_merge(const std::string& folder, const std::string& chunks) {
    const Run run = run_program("sweep run " + folder + " " + chunks);
    INFO(run.error);
    REQUIRE(run.status == 0);
    const Run merged = run_program("sweep merge " + folder + " --to " + folder + "/result.nc");
    INFO(merged.error);
    REQUIRE(merged.status == 0);
    return folder;
}

std::map<std::string, std::string> reference() {
    static const std::map<std::string, std::string> files =
        tree(run_and_merge(planned("reference", reduced_json()), "--all") + "/result.zarr");
    return files;
}

template <class T>
std::vector<T> numbers_in(const std::string& bytes) {
    std::vector<T> numbers(bytes.size() / sizeof(T));
    std::memcpy(numbers.data(), bytes.data(), bytes.size());
    return numbers;
}

} // namespace

TEST_CASE("the results have the same bytes for any number of workers and any order of the chunks", "[sweep]") {
    CHECK(tree(run_and_merge(planned("jobs", reduced_json()), "--all --jobs 3") + "/result.zarr") == reference());
    CHECK(tree(run_and_merge(planned("order", reduced_json()), "30-39 0-9 20-29 10-19 --jobs 2") + "/result.zarr") ==
          reference());
}

TEST_CASE("the results do not depend on how a study is divided", "[sweep]") {
    // The order and the type of the numbers in the file of NetCDF do not depend on chunks; its header tells of them.
    const auto data_with = [](std::size_t points) {
        json study = reduced_json();
        study["points_of_a_chunk"] = points;
        const std::string folder = run_and_merge(planned("divided", study), "--all");
        return content_of(folder + "/result.nc");
    };
    const std::string small = data_with(6), large = data_with(1000);
    constexpr std::size_t header = 8192; // at most
    REQUIRE(std::min(small.size(), large.size()) > 2 * header);
    const std::size_t data = std::min(small.size(), large.size()) - header;
    CHECK(small.substr(small.size() - data) == large.substr(large.size() - data));
}

TEST_CASE("the points of a sweep are those of map, to the last bit", "[sweep]") {
    json study = study_json();
    study["points_of_a_chunk"] = 1000;
    const std::string folder = run_and_merge(planned("as-map", study), "--all");
    const Run map = run_program("map - --r 0.3:1.7:9 --beta 0:1.5:6 --mass 1 --mass 2", study["scene"].dump());
    const std::vector<std::string> lines = lines_of(map.output);
    REQUIRE(lines.size() == 55);
    const auto files = tree(folder + "/result.zarr");
    const auto first = numbers_in<double>(files.at("amplitude_1/0.0")), second = numbers_in<double>(files.at("amplitude_2/0.0"));
    const auto regime = numbers_in<std::int8_t>(files.at("regime/0.0"));
    const auto stops = numbers_in<std::int32_t>(files.at("stops_per_period/0.0"));
    const std::vector<std::string> regimes{"continuous", "stick_slip", "permanent_sticking"};
    for (std::size_t n = 0; n < 54; ++n) {
        std::vector<std::string> cells;
        std::istringstream in(lines[n + 1]);
        for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
        INFO(lines[n + 1]);
        CHECK(cells[2] == regimes.at(static_cast<std::size_t>(regime[n])));
        CHECK(std::stoi(cells[3]) == stops[n]);
        CHECK(std::stod(cells[5]) == first[n]);
        CHECK(std::stod(cells[6]) == second[n]);
    }
}

TEST_CASE("a sweep in hertz and newtons is the map in hertz and newtons", "[sweep]") {
    const json scene = json::parse(
        R"({"masses": [12.0, 11.5], "stiffnesses": [18500, 17200], "damping_ratios": 0.01,
            "contact": 2, "base_motion": "with_wall", "base_displacement": 0.002})");
    json study{{"scene", scene},
               {"axes",
                {{{"quantity", "frequency_hz"}, {"from", 2}, {"to", 4}, {"count", 5}},
                 {{"quantity", "friction"}, {"values", {0, 3, 8}}}}}};
    const std::string folder = run_and_merge(planned("units", study), "--all");
    const auto amplitude = numbers_in<double>(tree(folder + "/result.zarr").at("amplitude_2/0.0"));
    const Run map = run_program("map - --frequency-hz 2:4:5 --friction 3:3:1", scene.dump());
    const std::vector<std::string> lines = lines_of(map.output);
    REQUIRE(lines.size() == 6);
    for (std::size_t n = 0; n < 5; ++n) {
        std::vector<std::string> cells;
        std::istringstream in(lines[n + 1]);
        for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
        // A column of a map may start from the motion at the friction before; both have 6 digits.
        CHECK(amplitude[3 * n + 1] == Approx(std::stod(cells[5])).epsilon(1e-6));
    }
}

TEST_CASE("phases of a sweep are those of solve", "[sweep]") {
    json study = study_json();
    study["axes"][0]["values"] = {0.7};
    for (const char* key : {"from", "to", "count"}) study["axes"][0].erase(key);
    study["axes"][1] = {{"quantity", "beta"}, {"values", {0.1, 0.4, 20}}};
    study["answers"] = {"phases"};
    const auto phases =
        numbers_in<double>(tree(run_and_merge(planned("phases", study), "--all") + "/result.zarr").at("phase_2/0.0"));
    REQUIRE(phases.size() == 3);
    for (std::size_t n = 0; n < 2; ++n) {
        json scene = study["scene"];
        scene["r"] = 0.7;
        scene["beta"] = study["axes"][1]["values"][n];
        const json answer = json::parse(run_program("solve - --json", scene.dump()).output);
        CHECK(phases[n] == Approx(answer["contact"]["phase"].get<double>()).epsilon(1e-6));
    }
    CHECK(std::isnan(phases[2])); // it rests
}

TEST_CASE("a sample whose numbers make no scene has points that say so", "[sweep]") {
    json study = study_json();
    study["samples"] = {{"method", "sobol"},
                        {"count", 16},
                        {"seed", 1},
                        {"variables", {{{"quantity", "mu"}, {"normal", {{"mean", 1}, {"standard_deviation", 0.1}}}}}}};
    study["start"] = "sliding";
    const std::string folder = run_and_merge(planned("no-scene", study), "--all");
    const json status = json::parse(run_program("sweep status --json " + folder).output);
    CHECK(status["points_by_status"]["no_scene"] == 8 * 54);
    CHECK(status["points_done"] == 16 * 54);
}

TEST_CASE("a chunk that is run again is found done, and merge tells the chunks that are missing", "[sweep]") {
    const std::string folder = planned("again", reduced_json());
    CHECK(run_program("sweep run " + folder + " 0-3").output == "chunks: 4 computed, 0 done before\n");
    CHECK(run_program("sweep run " + folder + " 2-5").output == "chunks: 2 computed, 2 done before\n");
    const Run merged = run_program("sweep merge " + folder);
    CHECK(merged.status == 1);
    CHECK_THAT(merged.error, Contains("chunks that are not done: 6-39"));
    CHECK_THAT(run_program("sweep status " + folder).output,
               Contains("[######") && Contains("6 of 40 chunks") && Contains("6-39"));
    CHECK(json::parse(run_program("sweep status --json " + folder).output)["done"] == 6);
}

TEST_CASE("a truncated chunk is found by merge and computed again by run", "[sweep]") {
    const std::string folder = planned("truncated", reduced_json());
    REQUIRE(run_program("sweep run " + folder + " --all --jobs 2").status == 0);
    const std::string file = folder + "/result.zarr/amplitude_1/3.2.0";
    REQUIRE(fs::exists(file));
    const std::string whole = content_of(file);
    for (const std::string& damaged : {whole.substr(0, whole.size() / 2), "x" + whole.substr(1), std::string()}) {
        std::ofstream(file, std::ios::binary) << damaged;
        const Run merged = run_program("sweep merge " + folder);
        CHECK(merged.status == 1);
        CHECK_THAT(merged.error, Contains("result.zarr/amplitude_1/3.2.0"));
        CHECK(merged.output.empty());
        const Run again = run_program("sweep run " + folder + " --all");
        CHECK(again.output == "chunks: 1 computed, 39 done before\n");
        CHECK_THAT(again.error, Contains("is computed again"));
    }
    fs::resize_file(folder + "/done/7.json", 30);
    CHECK_THAT(run_program("sweep merge " + folder).error, Contains("chunk 7: its record cannot be read"));
    CHECK(tree(run_and_merge(folder, "--all") + "/result.zarr") == reference());
}

TEST_CASE("a chunk of another version is never put together with others", "[sweep]") {
    const std::string folder = planned("version", reduced_json());
    REQUIRE(run_program("sweep run " + folder + " --all").status == 0);
    json record = json::parse(content_of(folder + "/done/5.json"));
    record["fingerprint"] = std::string(64, '0');
    std::ofstream(folder + "/done/5.json") << record;
    const Run merged = run_program("sweep merge " + folder);
    CHECK(merged.status == 1);
    CHECK_THAT(merged.error, Contains("chunk 5: it was left by another program or another study"));
    CHECK_THAT(run_program("sweep status " + folder).output, Contains("to be run again: 5"));
    CHECK(run_program("sweep run " + folder + " 5").output == "chunks: 1 computed, 0 done before\n");
    CHECK(run_program("sweep merge " + folder).status == 0);
    // The folder of another program is not touched.
    json plan = json::parse(content_of(folder + "/plan.json"));
    plan["fingerprint"] = std::string(64, '0');
    std::ofstream(folder + "/plan.json") << plan;
    for (const char* command : {"run --all ", "status ", "merge "}) {
        const Run refused = run_program(std::string("sweep ") + command + folder);
        CHECK(refused.status == 2);
        CHECK_THAT(refused.error, Contains("the same program and the same study"));
    }
    CHECK(run_program("sweep plan - " + folder, reduced_json().dump()).status == 2);
}

TEST_CASE("a file that no chunk wrote stands against merge", "[sweep]") {
    const std::string folder = planned("stranger", reduced_json());
    REQUIRE(run_program("sweep run " + folder + " --all").status == 0);
    std::ofstream(folder + "/done/40.json") << "{}";
    CHECK_THAT(run_program("sweep merge " + folder).error, Contains("done/40.json is a file that no chunk of this plan wrote"));
}

TEST_CASE("two runs of one chunk at once leave it once", "[sweep]") {
    const std::string folder = planned("twice", reduced_json());
    const char* program = std::getenv("DENHARTOG_PROGRAM");
    const std::string other = std::string("'") + program + "' sweep run " + folder + " --all >/dev/null 2>&1 & ";
    std::ofstream(scratch() / "twice.sh") << other << other << "'" << program << "' sweep run " << folder
                                          << " --all >/dev/null; s=$?; wait; exit $s\n";
    REQUIRE(std::system(("bash '" + (scratch() / "twice.sh").string() + "'").c_str()) == 0);
    CHECK(tree(run_and_merge(folder, "--all") + "/result.zarr") == reference());
}

namespace {

// One chunk that takes far longer than it is given.
json long_study() {
    json study = study_json();
    study["axes"][0]["count"] = 2000;
    study["axes"][1]["count"] = 200;
    study["points_of_a_chunk"] = 400000;
    return study;
}

int status_after(const std::string& signal, const std::string& folder) {
    const std::string program = std::getenv("DENHARTOG_PROGRAM");
    const std::string script = "'" + program + "' sweep run " + folder + " 0 2>/dev/null & p=$!; sleep 0.7; kill -" + signal +
                               " $p; wait $p 2>/dev/null; exit $?";
    std::ofstream(scratch() / "interrupt.sh") << "set -m\n" << script << "\n";
    const int status = std::system(("bash '" + (scratch() / "interrupt.sh").string() + "' 2>/dev/null").c_str());
    return WEXITSTATUS(status);
}

} // namespace

TEST_CASE("a sweep that is interrupted leaves no half chunk, and its status is the signal", "[sweep]") {
    const std::string folder = planned("interrupted", long_study());
    const auto before = tree(folder);
    CHECK(status_after("INT", folder) == 130);
    CHECK(tree(folder) == before);
    CHECK(status_after("TERM", folder) == 143);
    CHECK(tree(folder) == before);
}

TEST_CASE("a sweep that is killed leaves no chunk that counts as done", "[sweep]") {
    const std::string folder = planned("killed", long_study());
    CHECK(status_after("KILL", folder) == 137);
    CHECK(json::parse(run_program("sweep status --json " + folder).output)["done"] == 0);
    CHECK(run_program("sweep merge " + folder).status == 1);
}

TEST_CASE("a sweep on a full disk says so, leaves nothing half-written, and goes on when there is room", "[sweep]") {
    json study = reduced_json();
    study["axes"][1]["count"] = 400; // chunks of a few kilobytes
    study["axes"][1]["to"] = 0.1;
    study["points_of_a_chunk"] = 1200;
    const std::string folder = planned("full", study);
    const auto before = tree(folder);
    const std::string program = std::getenv("DENHARTOG_PROGRAM");
    std::ofstream(scratch() / "full.sh") << "trap '' XFSZ\nulimit -f 4\n'" << program << "' sweep run " << folder << " 0 2>'"
                                         << (scratch() / "full.txt").string() << "'\n";
    CHECK(WEXITSTATUS(std::system(("bash '" + (scratch() / "full.sh").string() + "'").c_str())) == 2);
    CHECK_THAT(content_of(scratch() / "full.txt"), Contains("cannot be written"));
    CHECK(json::parse(run_program("sweep status --json " + folder).output)["done"] == 0);
    for (const auto& [name, bytes] : tree(folder)) CHECK_THAT(name, !Contains(".part"));
    run_and_merge(folder, "--all");
    CHECK(tree(folder + "/result.zarr") == tree(run_and_merge(planned("room", study), "--all") + "/result.zarr"));
    CHECK(run_program("sweep status " + folder + " >/dev/full").status == 2);
    CHECK(before.size() < tree(folder).size());
}

TEST_CASE("what a sweep is asked for wrongly is refused", "[sweep]") {
    const std::string folder = planned("wrong", study_json());
    const auto fault = [&](const std::string& arguments) {
        const Run run = run_program("sweep " + arguments);
        CHECK(run.status == 2);
        CHECK(run.output.empty());
        return run.error;
    };
    CHECK_THAT(fault("run " + folder), Contains("--all"));
    CHECK_THAT(fault("run " + folder + " 99"), Contains("from 0 to 4") && Contains("99"));
    CHECK_THAT(fault("run " + folder + " 3-1"), Contains("must not end below its start"));
    CHECK_THAT(fault("run " + folder + " --all --jobs 0"), Contains("jobs"));
    CHECK_THAT(fault("run " + folder + "-none --all"), Contains("sweep plan"));
    CHECK_THAT(fault("merge " + folder + " --to x.h5"), Contains(".nc"));
    CHECK_THAT(fault("status " + folder + " --workers 0"), Contains("workers"));
}

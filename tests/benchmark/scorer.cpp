// The scorer of the benchmark: what it makes of right, wrong and bad results. The table in the repository is what solvers give.
#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/conformance/shell.hpp"

namespace denhartog::tests {
namespace {

using Json = nlohmann::ordered_json;
using Row = std::vector<std::string>;

const Json& pack() {
    static const Json all = Json::parse(content_of(source_file("tests/benchmark/pack/scenes.json")));
    return all;
}

Run score(const std::string& results) {
    return run_shell("python3 '" + source_file("tests/benchmark/score.py") + "' score '" +
                     file_with("results", results).string() + "'");
}

// Cells of a line of CSV in which commas stand only between quotes.
Row cells_of(const std::string& line) {
    Row cells(1);
    bool quoted = false;
    for (const char c : line)
        if (c == '"')
            quoted = !quoted;
        else if (c == ',' && !quoted)
            cells.emplace_back();
        else
            cells.back() += c;
    return cells;
}

std::map<std::string, Row> by_scene(const std::string& scores, const std::string& method, const std::string& setting) {
    std::map<std::string, Row> rows;
    for (const std::string& line : lines_of(scores))
        if (const Row cells = cells_of(line); cells[0] == method && cells[1] == setting) rows[cells[2]] = cells;
    return rows;
}

// The pack itself as a results file, its displacements changed.
std::string results_of_pack(double offset, double factor) {
    std::string text = R"({"method":"the pack","setting":"itself"})"
                       "\n";
    for (const Json& s : pack()) {
        Json line{{"scene", s["scene"]}, {"seconds", 1}, {"x", s["x"]}, {"v", s["v"]}};
        for (Json& row : line["x"])
            for (Json& x : row) x = factor * x.get<double>() + offset;
        text += line.dump() + "\n";
    }
    return text;
}

constexpr std::size_t answered = 3, error = 5, velocity_error = 6, stops = 7;

} // namespace

TEST_CASE("the scorer finds no error in the benchmark's own numbers, and the error of altered ones") {
    if (!is_there_or_skipped("python3")) return;
    const auto right = by_scene(score(results_of_pack(0, 1)).output, "the pack", "itself");
    const auto moved = by_scene(score(results_of_pack(0, 1.01)).output, "the pack", "itself");
    REQUIRE(right.size() == pack().size());
    for (const Json& s : pack()) {
        const Row &a = right.at(s["scene"]), &b = moved.at(s["scene"]);
        INFO(s["scene"]);
        CHECK(a[answered] == "yes");
        CHECK(std::stod(a[error]) == 0);
        CHECK(std::stod(a[velocity_error]) == 0);
        double scale = 0, largest = 0;
        for (const Json& X : s["amplitude"]) scale = std::max(scale, X.get<double>());
        for (const Json& row : s["x"])
            for (const Json& x : row) largest = std::max(largest, std::abs(x.get<double>()));
        if (scale > 0) CHECK(std::stod(b[error]) == Approx(0.01 * largest / scale).epsilon(0.06)); // two digits are written
    }
}

TEST_CASE("a scene that is left out of a results file is not answered") {
    if (!is_there_or_skipped("python3")) return;
    const auto lines = lines_of(results_of_pack(0, 1));
    const auto rows = by_scene(score(lines[0] + "\n" + lines[1] + "\n").output, "the pack", "itself");
    REQUIRE(rows.size() == pack().size());
    CHECK(std::ranges::count_if(rows, [](const auto& row) { return row.second[answered] == "yes"; }) == 1);
}

TEST_CASE("the scorer refuses bad results with place and rule, and writes nothing") {
    if (!is_there_or_skipped("python3")) return;
    const std::string head = R"({"method":"m","setting":"s"})"
                             "\n";
    std::string x = "[[0";
    for (int n = 1; n < 64; ++n) x += ",0";
    const auto with = [&](const std::string& members) { return head + R"({"scene":"one-01",)" + members + "}\n"; };
    const std::vector<std::pair<std::string, std::string>> bad{
        {"", "there is no scene in it"},
        {head, "there is no scene in it"},
        {"not JSON\n", "line 1"},
        {"[1]\n", "must be a JSON object"},
        {R"({"method":"m"})"
         "\n",
         "must have method and setting"},
        {head + R"({"scene":"six-01","failure":"none"})"
                "\n",
         "is not in the pack"},
        {head + R"({"scene":"one-01","failure":"a"})"
                "\n"
                R"({"scene":"one-01","failure":"a"})"
                "\n",
         "is there twice"},
        {with(R"("seconds":1)"), "x is missing"},
        {with(R"("x":[[1,2]])"), "must be a list of 64 numbers"},
        {with(R"("x":[])"), "must be a list of 1"},
        {with(R"("x":[null])"), "must be a list of 64 numbers"},
        {with("\"x\":" + x + "],[0]]"), "must be a list of 1"},
        {with("\"x\":" + x.substr(0, x.size() - 1) + "NaN]]"), "NaN is no number"},
        {with("\"x\":" + x.substr(0, x.size() - 1) + "1e999]]"), "must be a finite number"},
        {with("\"x\":" + x.substr(0, x.size() - 1) + "true]]"), "must be a finite number"},
        {with("\"x\":" + x + "]],\"stops\":[[2,1]]"), "must end after its start"},
        {with("\"x\":" + x + "]],\"stops\":[1]"), "must be a pair"},
        {with("\"x\":" + x + "]],\"y\":1"), "is none of"}};
    for (const auto& [text, reason] : bad) {
        const Run run = score(text);
        INFO(text.substr(0, 120) << '\n' << run.error);
        CHECK(run.status == 2);
        CHECK(run.output.empty());
        CHECK(run.error.find(reason) != std::string::npos);
        CHECK(run.error.find("Traceback") == std::string::npos);
    }
    CHECK(run_shell("python3 '" + source_file("tests/benchmark/score.py") + "' table '" +
                    file_with("scores", "a,b\n1,2\n").string() + "'")
              .status == 2);
}

TEST_CASE("the scores in the repository are what the solvers give") {
    if (!is_there_or_skipped("python3")) return;
    const std::string stored = content_of(source_file("tests/benchmark/scores.csv"));
    const std::string scenes = " '" + source_file("tests/benchmark/pack/scenes.json") + "'";
    const std::string solver = quoted_program("benchmark-solver");
    struct Sample {
        std::string command, method, setting;
    };
    std::vector<Sample> samples{{solver + " solve 10" + scenes, "denhartog, solve", "10 digits"},
                                {solver + " paper 1e-6" + scenes + " --every 9", "the paper's Runge-Kutta", "tolerance 1e-6"},
                                {solver + " tanh 1e-2" + scenes + " --every 9", "tanh(v/width), Dormand-Prince", "width 1e-2"},
                                {solver + " harmonic-balance 15" + scenes + " --every 9", "harmonic balance", "15 harmonics"}};
    const auto add_if_built = [&](const char* name, const char* arguments, const char* method, const char* setting) {
        if (is_built_or_skipped(name))
            samples.push_back({quoted_program(name) + " " + arguments + scenes + " --every 6", method, setting});
    };
    add_if_built("benchmark-cvode", "1e-9", "SUNDIALS CVODE", "tolerance 1e-9");
    add_if_built("benchmark-siconos", "256", "Siconos, Moreau-Jean", "256 steps a period");
    const std::string python = run_shell("python3 -c 'import scipy'").status == 0 ? "python3" : "/usr/bin/python3";
    if (run_shell(python + " -c 'import scipy'").status == 0)
        samples.push_back({python + " '" + source_file("tests/benchmark/solvers/solve_ivp.py") + "' 1e-6 16" + scenes + " 60 12",
                           "scipy solve_ivp with events, RK45", "rtol 1e-06, max_step T/16"});
    else
        SKIPPED("scipy is not there");
    for (const Sample& sample : samples) {
        const Run run = run_shell(sample.command);
        REQUIRE(run.status == 0);
        const auto now = by_scene(score(run.output).output, sample.method, sample.setting);
        const auto then = by_scene(stored, sample.method, sample.setting);
        CHECK(then.size() == pack().size());
        int compared = 0;
        for (const auto& [scene, row] : now) {
            if (row[answered] != "yes") continue;
            INFO(sample.method << ' ' << scene << ": " << row[error] << " now, " << then.at(scene)[error] << " then");
            CHECK(then.at(scene)[answered] == "yes");
            CHECK(row[stops] == then.at(scene)[stops]);
            const double a = std::max(std::stod(row[error]), 1e-13), b = std::max(std::stod(then.at(scene)[error]), 1e-13);
            CHECK(std::abs(std::log10(a / b)) < 0.3);
            ++compared;
        }
        CHECK(compared >= 3);
    }
}

TEST_CASE("the picture of the benchmark is drawn from the scores in the repository") {
    if (!is_there_or_skipped("python3")) return;
    const std::string benchmark = source_file("tests/benchmark");
    const Run run = run_shell("python3 '" + benchmark + "/score.py' picture '" + benchmark + "/scores.csv'");
    CHECK(run.output == content_of(source_file("paper-figures/beyond/benchmark_work_precision.dat")));
}

} // namespace denhartog::tests

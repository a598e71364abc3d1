// The chart: every method on every scene, time of an answered question against digits got. Writes CSV and the data of the
// pictures, prints the front, the failures by name and the work of `solve`.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "tests/speed_accuracy/chart_survey.hpp"
#include "tests/speed_accuracy/peers/peers.hpp"

using namespace denhartog::tests;

namespace {

std::vector<Peer> all_peers() {
    std::vector<Peer> all;
    for (const auto& some :
         {own_peers(), monoharmonic_peers(), harmonic_balance_peers(), plain_integrator_peers(), cvode_peers(), siconos_peers()})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

bool write(const std::filesystem::path& path, const std::string& text) {
    std::filesystem::create_directories(path.parent_path());
    std::ofstream file(path);
    file << text;
    file.close();
    if (!file) std::fprintf(stderr, "%s cannot be written\n", path.c_str());
    return static_cast<bool>(file);
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app{"Speed against accuracy, every method on every scene", "chart"};
    ChartRun run{17, "not given", DENHARTOG_COMPILER, processor_name()};
    std::string output = ".", figures = ".";
    int points = 8;
    double budget = 2.5;
    app.add_option("--output", output, "Directory for the CSV");
    app.add_option("--figures", figures, "Directory for the data of the pictures");
    app.add_option("--seed", run.seed, "Seed of the points");
    app.add_option("--points", points, "Points a scene")->check(CLI::PositiveNumber);
    app.add_option("--budget", budget, "Seconds for a method at one setting on one scene")->check(CLI::PositiveNumber);
    app.add_option("--version-of-source", run.version, "What the CSV names as the version");
    CLI11_PARSE(app, argc, argv);

    std::vector<ChartGround> grounds;
    std::vector<ChartRow> rows;
    for (const ChartScene& scene : chart_scenes(run.seed, points)) {
        grounds.push_back(ground_of(scene));
        std::printf("%s: %zu points\n", scene.name.c_str(), scene.points.size());
        std::string last;
        for (const Peer& peer : all_peers()) {
            rows.push_back(measure(peer, grounds.back(), budget));
            if (peer.method != last)
                std::printf("  %s%s\n", peer.method.c_str(), peer.prepare ? "" : (": skipped, " + peer.setting).c_str());
            std::fflush(stdout);
            last = peer.method;
        }
    }
    std::string tables;
    for (const Table& table : {front_table(rows, true), front_table(rows, false), solve_work_table(grounds), failure_table(rows)})
        tables += markdown(table);
    std::fputs(tables.c_str(), stdout);
    const std::filesystem::path directory(output), pictures(figures);
    const std::string data = picture_data(rows, grounds);
    const bool written = write(directory / "chart.csv", csv(rows, run)) && write(directory / "points.csv", csv(grounds, run)) &&
                         write(directory / "tables.md", tables) && write(pictures / "speed_against_accuracy.dat", data) &&
                         write(pictures / "tolerance_against_error.dat", data);
    return written ? 0 : 1;
}

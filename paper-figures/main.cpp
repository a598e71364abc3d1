// The program of the figures: computes the data of those that are named, or of all.
#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>

#include "figure.hpp"

using namespace denhartog::figures;

namespace {

void compute(const std::string& name, const std::string& folder) {
    const std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    Figure figure(folder, name);
    const Record record = listed_figures().at(name)(figure);
    figure.write(record, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app{"Computes the data of figures"};
    std::string folder = ".";
    std::vector<std::string> names;
    app.add_option("--output", folder, "folder for the data")->capture_default_str();
    app.add_option("NAME", names, "the figures; all of them where none is named")->check(CLI::IsMember(listed_figures()));
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : 2;
    }
    if (names.empty())
        for (const auto& [name, make] : listed_figures()) names.push_back(name);
    int status = 0;
    for (const std::string& name : names) try {
            compute(name, folder);
        } catch (const std::exception& e) {
            std::cerr << name << ": " << e.what() << "\n";
            status = 1;
        }
    return status;
}

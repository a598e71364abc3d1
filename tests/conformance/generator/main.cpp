#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>

#include "denhartog/number/errors.hpp"
#include "tests/conformance/generator/vector_files.hpp"

namespace {

using namespace denhartog::conformance::generator;

int write(const std::string& folder, const std::set<std::string>& groups) {
    const std::string schema = bytes_of(std::filesystem::path(folder) / "schema.json");
    std::vector<denhartog::conformance::Vector> others; // stay as they are
    if (!groups.empty()) others = stored_but(folder, groups);
    Certified all = certify_all(folder, groups);
    std::ranges::move(others, std::back_inserter(all.vectors));
    for (const Refusal& r : all.refusals) std::cout << "no vector " << r.id << ": " << r.why << '\n';
    if (!all.refusals.empty()) { // the files alone hold the questions: none is left out unseen
        std::cout << "nothing is written: take these lines out, or mend them\n";
        return 1;
    }
    const auto files = files_of(all.vectors, schema);
    std::size_t size = 0;
    for (const auto& [name, bytes] : files) { // the questions stand nowhere else: no file goes before the new ones are complete
        std::ofstream stream(std::filesystem::path(folder) / (name + ".part"), std::ios::binary);
        stream << bytes;
        if (!stream.flush()) throw denhartog::InputError("file", "must be writable", name);
        size += bytes.size();
    }
    for (const auto& [name, bytes] : files)
        std::filesystem::rename(std::filesystem::path(folder) / (name + ".part"), std::filesystem::path(folder) / name);
    for (const auto& entry : std::filesystem::directory_iterator(folder)) // groups that are no more
        if (entry.path().extension() == ".jsonl" && files.count(entry.path().filename().string()) == 0)
            std::filesystem::remove(entry.path());
    std::cout << all.vectors.size() << " vectors, " << size << " bytes; the routes agree on at least " << all.least[0]
              << " of 50 and " << all.least[1] << " of 100 digits\n";
    return 0;
}

int check(const std::string& folder, int every, int from) {
    std::vector<std::string> faults = manifest_faults(folder);
    for (const std::string& difference : differences(folder, every, from)) faults.push_back(difference);
    for (const std::string& fault : faults) std::cout << fault << '\n';
    return faults.empty() ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app{"Writes the certified vectors of the conformance kit, or computes them anew and compares"};
    app.require_subcommand(1);
    std::string folder;
    std::vector<std::string> groups;
    int every = 1, from = 0;
    CLI::App* writing = app.add_subcommand(
        "write", "Compute all vectors of a folder from the questions in its lines, and write them with their manifest");
    CLI::App* checking = app.add_subcommand("check", "Compute vectors anew; a byte that differs is an error");
    for (CLI::App* command : {writing, checking}) command->add_option("folder", folder, "Folder of the vectors")->required();
    writing->add_option("--group", groups, "Compute these groups alone, and take the others from the folder")->delimiter(',');
    checking->add_option("--every", every, "Every how many vectors")->check(CLI::PositiveNumber);
    checking->add_option("--from", from, "The first, from 0")->check(CLI::NonNegativeNumber);
    CLI11_PARSE(app, argc, argv);
    try {
        return *writing ? write(folder, {groups.begin(), groups.end()}) : check(folder, every, from);
    } catch (const std::exception& e) {
        std::cerr << e.what() << '\n';
        return 2;
    }
}

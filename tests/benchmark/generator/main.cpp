// Computes the benchmark's pack anew, for the scenes in its `scenes.json`: `benchmark-pack FOLDER`.
#include <filesystem>
#include <fstream>
#include <iostream>

#include "denhartog/number/errors.hpp"
#include "tests/benchmark/generator/pack.hpp"

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: benchmark-pack FOLDER\n";
        return 2;
    }
    try {
        const auto scenes = denhartog::benchmark::certify_all(argv[1], true);
        for (const auto& [name, bytes] : denhartog::benchmark::files_of(scenes)) {
            std::ofstream file(std::filesystem::path(argv[1]) / name, std::ios::binary);
            file << bytes;
            if (!file.flush()) throw denhartog::InputError("file", "must be writable", name);
        }
    } catch (const std::exception& e) {
        std::cerr << e.what() << '\n';
        return 1;
    }
}

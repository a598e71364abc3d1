// `proofs FILE`: decides claims that need no solver, before the library is built, and leaves its findings for `derivation run`.
#include <fstream>
#include <iostream>
#include <thread>

#include "derivation/claims/findings.hpp"

using namespace denhartog::derivation;

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: proofs FILE\n";
        return 2;
    }
    try {
        const Findings found = findings_of(claims(), {}, std::thread::hardware_concurrency(), std::cout);
        std::ofstream file(argv[1], std::ios::binary);
        file << nlohmann::json(found) << std::flush;
        if (!file) throw std::runtime_error(std::string("cannot write ") + argv[1]);
        return 0;
    } catch (const std::exception& e) {
        std::cerr << "proofs: " << e.what() << "\n";
        return 1;
    }
}

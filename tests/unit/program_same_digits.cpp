#include <cstdlib>

#include "tests/catch.hpp"
#include "tests/unit/program_runs.hpp"

using namespace denhartog::tests;

namespace {

// What the program prints where the system leaves out code paths of its functions, as if the processor were an older one.
Run run_on_older(const std::string& without, const std::string& arguments, const std::string& scenes) {
    const std::string file = file_with("scenes-of-same-digits.jsonl", scenes).string();
    return run_program("--version >/dev/null; GLIBC_TUNABLES=glibc.cpu.hwcaps=" + without + " exec '" +
                       std::string(std::getenv("DENHARTOG_PROGRAM")) + "' " + arguments + " '" + file + "'");
}

const std::string three_masses =
    R"({"mass_ratios": [1, 2.5, 0.75], "stiffness_ratios": [1, 0.625, 1.875], "damping_ratios": [0.03, 0.6, 0.09], )"
    R"("contact": 2, "load": 1, "mu": 1.375, "r": 1.125, "beta": 0.15625})";
const std::string pair_with_dashpots =
    R"({"mass_ratios": [1, 2], "stiffness_ratios": [1, 0.5], "damping_matrix": [[0.1, -0.05], [-0.05, 0.05]], )"
    R"("contact": [2, 1], "load": 1, "r": 0.71875, "beta": 0.4375})";
const std::string heavily_damped =
    R"({"mass_ratios": [1, 1.5], "stiffness_ratios": [1, 0.75], "damping_ratios": [0.75, 1.25], "contact": 1, "load": 2, )"
    R"("r": 0.40625, "beta": 0.0625})";

} // namespace

TEST_CASE("the digits are the same whichever code paths of its functions the system takes", "[program]") {
    REQUIRE(std::getenv("DENHARTOG_PROGRAM") != nullptr);
    const std::string all = three_masses + "\n" + pair_with_dashpots + "\n" + heavily_damped + "\n";
    for (const std::string without : {"-FMA", "-AVX2", "-AVX512F", "-AVX2,-FMA,-AVX512F"}) {
        INFO(without);
        for (const std::string arguments : {"solve --json --digits 6", "solve --json --digits 13", "solve --json --digits 30"}) {
            INFO(arguments);
            const Run here = run_on_older("", arguments, all), there = run_on_older(without, arguments, all);
            CHECK(here.status == 0);
            CHECK(here.output.size() > 1000);
            CHECK(here.output == there.output);
        }
        const std::string map = "map --threads 1 --r 0.21:2.7:24 --beta 0.01:1.5:24";
        for (const std::string& scene : {three_masses, heavily_damped}) {
            const Run here = run_on_older("", map, scene), there = run_on_older(without, map, scene);
            CHECK(here.status == there.status);
            CHECK(here.output.size() > 10000);
            CHECK(here.output == there.output);
        }
    }
}

TEST_CASE("the program says that its digits are the same on every machine", "[program]") {
    CHECK(run_program("--version").output.find("The digits are the same on every machine") != std::string::npos);
}

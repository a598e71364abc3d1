// Parts of a report besides verdicts: groups of answers, missing digits, the known mistakes.
#include "conformance/mistakes/mistake.hpp"
#include "tests/catch.hpp"
#include "tests/conformance/runner_fixtures.hpp"

using namespace denhartog;
using namespace denhartog::conformance;
using namespace denhartog::tests;

namespace {

constexpr int asked = 12; // more than are told one by one

// A folder of amplitudes, the first few overdamped.
const std::string& amplitudes() {
    static const std::string folder = [] {
        std::vector<Vector> vectors;
        for (int n = 0; n < asked; ++n) {
            vectors.push_back(vector_of("amplitude-" + std::to_string(n), "amplitude", {1}));
            if (n < 5) vectors.back().question.damping_ratios = {0.125, 1.5};
        }
        return folder_of("amplitudes", vectors);
    }();
    return folder;
}

Run graded(const std::string& value_first, const std::string& value_after) {
    std::string answers = "id,value\n";
    for (int n = 0; n < asked; ++n)
        answers += "amplitude-" + std::to_string(n) + "," + (n < 5 ? value_first : value_after) + "\n";
    return conform("grade " + with_vectors(amplitudes(), file_with("amplitudes.csv", answers).string()));
}

} // namespace

TEST_CASE("many wrong answers are told in groups", "[conformance][program]") {
    const Run r = graded("nan", "3");
    INFO(r.output << r.error);
    CHECK(r.status == 1);
    CHECK(contains(r.output, "Wrong answers, 2 of 12:\n"));
    CHECK(contains(r.output, "  5 not finite, overdamped, continuous\n"));
    CHECK(contains(r.output, "  7 wrong, continuous\n"));
}

TEST_CASE("where digits alone are missing, that is said, with how many are left and where", "[conformance][program]") {
    const Run r = graded("1.00001", "1.0001");
    INFO(r.output << r.error);
    CHECK(r.status == 1);
    CHECK(
        contains(r.output, "Digits are missing in 12 answers, and nothing else is wrong. The worst has 4.0 digits: amplitude-"));
    CHECK(contains(r.output, ", amplitude.\n"));
    CHECK_FALSE(contains(graded("1.00001", "3").output, "Digits are missing"));
    CHECK_FALSE(contains(graded("1", "1").output, "Digits are missing"));
}

TEST_CASE("the known mistakes are listed with equation and what to look at", "[conformance][program][mistake]") {
    const Run r = conform("list --mistakes");
    CHECK(r.status == 0);
    const std::vector<std::string> lines = lines_of(r.output);
    REQUIRE(lines.size() == mistakes().size() + 1);
    for (std::size_t n = 0; n < mistakes().size(); ++n) {
        const Mistake& mistake = mistakes()[n];
        const std::string& line = lines[n + 1];
        INFO(line);
        CHECK(contains(line, " " + mistake.name + " "));
        CHECK(contains(line, mistake.told + " Look at: " + mistake.look_at));
        if (!mistake.equation.empty()) CHECK(contains(line, " " + mistake.equation + " "));
    }
}

TEST_CASE("the Python adapter says in a sentence that numpy is missing", "[conformance][program]") {
    const std::filesystem::path source = std::getenv("DENHARTOG_SOURCE_DIR");
    const auto error = file_with("numpy.error", "");
    // -S leaves out the packages of the system, and -E those of the environment.
    const std::string command = "python3 -S -E '" + (source / "tests/conformance/adapters/python/adapter.py").string() +
                                "' </dev/null >/dev/null 2>'" + error.string() + "'";
    if (std::system("python3 -S -E -c 'import numpy' 2>/dev/null") == 0) return; // numpy stands where Python itself does
    CHECK(std::system(command.c_str()) != 0);
    std::ifstream file(error);
    const std::string told{std::istreambuf_iterator<char>(file), {}};
    INFO(told);
    CHECK(told.starts_with("numpy is missing: "));
    CHECK(lines_of(told).size() == 1);
}

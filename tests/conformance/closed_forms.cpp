// The implementations that users start from are short. What they answer is for score_adapters.py.
#include <algorithm>
#include <filesystem>

#include "tests/catch.hpp"
#include "tests/unit/program_runs.hpp"

using namespace denhartog::tests;

namespace {

// Files of a folder that are longer than they may be: a closed form, all its files together, an adapter, a line.
std::vector<std::string> too_long(const std::filesystem::path& folder) {
    std::vector<std::string> found;
    std::size_t closed_form = 0;
    for (const auto& file : std::filesystem::directory_iterator(folder)) {
        const std::string name = file.path().filename().string();
        const std::vector<std::string> lines = lines_of(content_of(file.path()));
        for (const std::string& line : lines)
            if (line.size() > 130) found.push_back(name + ": " + std::to_string(line.size()) + " columns");
        if (name.starts_with("closed_form.")) closed_form += lines.size();
        if (name.find("adapter.") != std::string::npos && lines.size() > 60)
            found.push_back(name + ": " + std::to_string(lines.size()) + " lines");
    }
    if (closed_form == 0 || closed_form > 200) found.push_back("closed_form: " + std::to_string(closed_form) + " lines");
    std::sort(found.begin(), found.end());
    return found;
}

} // namespace

TEST_CASE("a closed form to start from has at most 200 lines and its adapter at most 60", "[conformance][documentation]") {
    for (const char* language : {"c", "fortran", "javascript", "octave", "python"}) {
        INFO(language);
        CHECK(too_long(source_file("tests/conformance/adapters/" + std::string(language))).empty());
    }
    const std::filesystem::path folder = scratch() / "lengths";
    std::filesystem::create_directories(folder);
    file_with("lengths/adapter.x", std::string(61, '\n'));
    file_with("lengths/closed_form.x", std::string(150, '\n'));
    file_with("lengths/closed_form.y", std::string(50, '\n') + std::string(131, '!'));
    CHECK(too_long(folder) ==
          std::vector<std::string>{"adapter.x: 61 lines", "closed_form.y: 131 columns", "closed_form: 201 lines"});
}
